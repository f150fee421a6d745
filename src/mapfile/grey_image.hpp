// Pictures as maps have them: a value from black to white for each cell, and where it is transparent.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "waybreaker/grid.hpp"

namespace waybreaker::mapfile {

struct GreyImage {
    struct Pixel {
        static Pixel of_grey(int grey, int alpha = 255);
        static Pixel of_colour(int red, int green, int blue, int alpha = 255);

        std::uint16_t sum = 0;     // of red, green and blue, which keeps the thirds of their mean: 0 to 765 (white)
        std::uint8_t luma = 0;     // how light they look, 0 to 255: GraphicsMagick's grey of a colour
        std::uint8_t alpha = 255;  // how opaque it is
        double brightness() const { return sum / 765.0; }
    };

    int width = 0;
    int height = 0;
    bool transparency = false;  // whether the file says how opaque its pixels are
    std::vector<Pixel> pixels;  // row by row, from the top
};

bool is_png(std::string_view bytes);
// PBM, PGM or PPM, as text or binary ("P1" to "P6").
bool is_netpbm(std::string_view bytes);

// Of a PNG of any kind, brought to 8 bits a channel. Throws InputError (name and remedy) if it is damaged, larger than
// the limits of grid.hpp, or claims more pixels than its bytes can hold.
GreyImage read_png(std::string_view bytes, const std::string& name, std::size_t most_pixels = max_cells);
// The same for the netpbm formats, with 8 or 16 bits a sample; the first image of the file. In PBM 1 is black.
GreyImage read_netpbm(std::string_view bytes, const std::string& name, std::size_t most_pixels = max_cells);

// Either of them, detected by the first bytes.
GreyImage read_image(std::string_view bytes, const std::string& name, std::size_t most_pixels = max_cells);

// Which cells of an image are blocked: those at least so dark, 0 (white) to 1 (black). What is transparent is white.
Grid grid_of(const GreyImage& image, double threshold);

// Writers take a byte a pixel, row by row.
std::string png_bytes(int width, int height, const std::vector<std::uint8_t>& grey);
std::string pgm_bytes(int width, int height, const std::vector<std::uint8_t>& grey);

}  // namespace waybreaker::mapfile
