#include <png.h>

#include "io/grey_image.hpp"
#include "waybreaker/error.hpp"
#include "waybreaker/grid.hpp"

namespace waybreaker::io {
namespace {

constexpr std::string_view magic = "\x89PNG\r\n\x1a\n";

// Deflate packs at most 1032 bytes into one, and a byte holds at most 8 pixels.
constexpr std::size_t most_pixels_per_byte = 1032 * 8;

// libpng's picture, released when it goes.
struct Picture {
    Picture() { image.version = PNG_IMAGE_VERSION; }
    Picture(const Picture&) = delete;
    Picture& operator=(const Picture&) = delete;
    ~Picture() { png_image_free(&image); }
    png_image image{};
};

InputError damaged(const std::string& name, const png_image& image) {
    return {name, 0, std::string("cannot be read as PNG: ") + image.message};
}

}  // namespace

bool is_png(std::string_view bytes) {
    return bytes.starts_with(magic);
}

GreyImage read_png(std::string_view bytes, const std::string& name, std::size_t most_pixels) {
    Picture picture;
    png_image& image = picture.image;
    if (!png_image_begin_read_from_memory(&image, bytes.data(), bytes.size())) throw damaged(name, image);
    const std::size_t pixels = std::size_t{image.width} * image.height;
    if (image.width > unsigned(max_side) || image.height > unsigned(max_side) || pixels > most_pixels) {
        throw SizeError(name, 0,
                        "an image of " + std::to_string(image.width) + " x " + std::to_string(image.height) +
                            " pixels is too large for a map: cut a piece out of it");
    }
    if (pixels > most_pixels_per_byte * bytes.size()) {
        throw InputError(name, 0, "is damaged or cut short: it has fewer bytes than so many pixels need");
    }
    const bool colour = (image.format & PNG_FORMAT_FLAG_COLOR) != 0;
    GreyImage result{int(image.width), int(image.height), (image.format & PNG_FORMAT_FLAG_ALPHA) != 0, {}};
    image.format = colour ? PNG_FORMAT_RGBA : PNG_FORMAT_GA;
    std::vector<std::uint8_t> samples(pixels * (colour ? 4 : 2));
    if (!png_image_finish_read(&image, nullptr, samples.data(), 0, nullptr)) throw damaged(name, image);
    result.pixels.resize(pixels);
    const std::uint8_t* sample = samples.data();
    for (GreyImage::Pixel& pixel : result.pixels) {
        pixel.sum = std::uint16_t(colour ? sample[0] + sample[1] + sample[2] : 3 * sample[0]);
        pixel.alpha = sample[colour ? 3 : 1];
        sample += colour ? 4 : 2;
    }
    return result;
}

std::string png_bytes(int width, int height, const std::vector<std::uint8_t>& grey) {
    Picture picture;
    png_image& image = picture.image;
    image.width = png_uint_32(width);
    image.height = png_uint_32(height);
    image.format = PNG_FORMAT_GRAY;
    std::string bytes(PNG_IMAGE_PNG_SIZE_MAX(image), '\0');
    png_alloc_size_t size = bytes.size();
    if (!png_image_write_to_memory(&image, bytes.data(), &size, 0, grey.data(), 0, nullptr)) {
        throw InputError(std::string("cannot make a PNG: ") + image.message);
    }
    bytes.resize(size);
    return bytes;
}

}  // namespace waybreaker::io
