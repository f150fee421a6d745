#include "mapfile/grey_image.hpp"

#include "waybreaker/error.hpp"

namespace waybreaker::mapfile {

GreyImage::Pixel GreyImage::Pixel::of_grey(int grey, int alpha) {
    return {std::uint16_t(3 * grey), std::uint8_t(grey), std::uint8_t(alpha)};
}

// GraphicsMagick, which nav2 reads images with, weighs the colours (Rec. 601) in 16 bits and then cuts them to 8.
GreyImage::Pixel GreyImage::Pixel::of_colour(int red, int green, int blue, int alpha) {
    constexpr int widened = 257;
    const int deep = (widened * (299 * red + 587 * green + 114 * blue) + 500) / 1000;
    return {std::uint16_t(red + green + blue), std::uint8_t(deep / widened), std::uint8_t(alpha)};
}

GreyImage read_image(std::string_view bytes, const std::string& name, std::size_t most_pixels) {
    if (is_png(bytes)) return read_png(bytes, name, most_pixels);
    if (is_netpbm(bytes)) return read_netpbm(bytes, name, most_pixels);
    throw InputError(name, 0, "is no image that can be read: give a PNG, PGM, PBM or PPM");
}

Grid grid_of(const GreyImage& image, double threshold) {
    Grid grid(image.width, image.height);
    const GreyImage::Pixel* pixel = image.pixels.data();
    for (int y = 0; y < image.height; ++y) {
        for (int x = 0; x < image.width; ++x, ++pixel) {
            const int dark = (765 - pixel->sum) * pixel->alpha;
            if (dark >= threshold * (765 * 255)) grid.set_blocked({x, y}, true);
        }
    }
    return grid;
}

}  // namespace waybreaker::mapfile
