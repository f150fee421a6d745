// PNG, row by row through libpng's push reader: it stops at the first byte that is more than the header's pixels need,
// where its simplified reader would unpack it all.
#include <png.h>

#include <array>
#include <csetjmp>
#include <cstring>

#include "mapfile/grey_image.hpp"
#include "waybreaker/error.hpp"
#include "waybreaker/grid.hpp"

namespace waybreaker::mapfile {
namespace {

constexpr std::string_view magic = "\x89PNG\r\n\x1a\n";

// Deflate compresses at most 1032 bytes into one, and a byte holds at most 8 pixels.
constexpr std::size_t most_pixels_per_byte = std::size_t{1032} * 8;

struct Size {
    std::size_t width = 0;
    std::size_t height = 0;
};

InputError damaged(const std::string& name, const std::string& reason) {
    return {name, 0, "cannot be read as PNG: " + reason};
}

// What the first chunk says, which must be the header.
Size size_of(std::string_view bytes, const std::string& name) {
    constexpr std::size_t at = 16;
    if (bytes.size() < at + 8 || bytes.substr(12, 4) != "IHDR") throw damaged(name, "it has no header");
    const auto number = [&](std::size_t first) {
        return std::size_t(png_get_uint_32(reinterpret_cast<png_const_bytep>(bytes.data() + first)));
    };
    return {number(at), number(at + 4)};
}

void require_size(const Size& size, std::size_t bytes, const std::string& name, std::size_t most_pixels) {
    const auto [width, height] = size;
    if (width > unsigned(max_side) || height > unsigned(max_side) || width * height > most_pixels) {
        throw SizeError(name, 0,
                        "an image of " + std::to_string(width) + " x " + std::to_string(height) +
                            " pixels is too large for a map: cut a piece out of it");
    }
    if (width * height > most_pixels_per_byte * bytes) {
        throw InputError(name, 0, "is damaged or cut short: it has fewer bytes than so many pixels need");
    }
}

// Reads into an image whose pixels are there already, so that no callback of libpng has reason to throw.
class Decoder {
  public:
    explicit Decoder(GreyImage& image) : image_(image) {}
    Decoder(const Decoder&) = delete;
    Decoder& operator=(const Decoder&) = delete;
    ~Decoder() { png_destroy_read_struct(&png_, &info_, nullptr); }

    // Empty on success, else the reason.
    const char* decode(std::string_view bytes) {
        png_ = png_create_read_struct(PNG_LIBPNG_VER_STRING, this, &Decoder::fail, &Decoder::warn);
        info_ = png_ != nullptr ? png_create_info_struct(png_) : nullptr;
        if (info_ == nullptr) return "there is no memory for it";
        if (setjmp(png_jmpbuf(png_)) != 0) return reason_.data();
        // Texts, colour profiles and the like can decompress to gigabytes.
        png_set_keep_unknown_chunks(png_, PNG_HANDLE_CHUNK_NEVER, nullptr, -1);
        png_set_progressive_read_fn(png_, this, &Decoder::begin, &Decoder::take_row, &Decoder::end);
        auto* const first = reinterpret_cast<png_bytep>(const_cast<char*>(bytes.data()));
        png_process_data(png_, info_, first, bytes.size());
        return ended_ && pixels_ == image_.pixels.size() ? nullptr : "it ends too early";
    }

  private:
    static Decoder& self(png_structp png) { return *static_cast<Decoder*>(png_get_progressive_ptr(png)); }

    [[noreturn]] static void fail(png_structp png, png_const_charp reason) {
        auto& kept = static_cast<Decoder*>(png_get_error_ptr(png))->reason_;  // libpng's own text ends with its call
        std::strncpy(kept.data(), reason, kept.size() - 1);
        png_longjmp(png, 1);
    }
    // libpng only warns of faults in the pixel data; they are errors here. Other faults do not matter.
    static void warn(png_structp png, png_const_charp reason) {
        if (std::string_view(reason).find("IDAT") != std::string_view::npos) {
            fail(png, "it holds other pixels than its header says");
        }
    }

    // Rows come as grey, or red, green and blue, 8 bits each, and alpha if there is any.
    static void begin(png_structp png, png_infop info) {
        png_set_expand(png);
        png_set_scale_16(png);
        png_read_update_info(png, info);
        Decoder& decoder = self(png);
        decoder.channels_ = png_get_channels(png, info);
        decoder.interlaced_ = png_get_interlace_type(png, info) != PNG_INTERLACE_NONE;
        decoder.image_.transparency = decoder.channels_ % 2 == 0;
    }

    static void take_row(png_structp png, png_bytep row, png_uint_32 y, int pass) {
        if (row != nullptr) self(png).take_row(row, y, unsigned(pass));
    }
    // A pass of an interlaced image has every so many of its rows and columns.
    void take_row(const png_byte* sample, png_uint_32 row, unsigned pass) {
        const auto width = png_uint_32(image_.width);
        const png_uint_32 y = interlaced_ ? PNG_ROW_FROM_PASS_ROW(row, pass) : row;
        const png_uint_32 first = interlaced_ ? PNG_PASS_START_COL(pass) : 0;
        const png_uint_32 step = interlaced_ ? png_uint_32(PNG_PASS_COL_OFFSET(pass)) : 1;
        if (y >= png_uint_32(image_.height)) return;
        GreyImage::Pixel* const pixels = &image_.pixels[std::size_t(y) * width];
        for (png_uint_32 x = first; x < width; x += step, sample += channels_, ++pixels_) {
            const int alpha = image_.transparency ? sample[channels_ - 1] : 255;
            pixels[x] = channels_ > 2 ? GreyImage::Pixel::of_colour(sample[0], sample[1], sample[2], alpha)
                                      : GreyImage::Pixel::of_grey(sample[0], alpha);
        }
    }
    static void end(png_structp png, png_infop) { self(png).ended_ = true; }

    GreyImage& image_;
    png_structp png_ = nullptr;
    png_infop info_ = nullptr;
    unsigned channels_ = 1;
    bool interlaced_ = false;
    std::size_t pixels_ = 0;  // received so far
    bool ended_ = false;
    std::array<char, 200> reason_{};
};

// RAII wrapper of the image of libpng's simplified writer.
struct Picture {
    Picture() { image.version = PNG_IMAGE_VERSION; }
    Picture(const Picture&) = delete;
    Picture& operator=(const Picture&) = delete;
    ~Picture() { png_image_free(&image); }
    png_image image{};
};

}  // namespace

bool is_png(std::string_view bytes) {
    return bytes.starts_with(magic);
}

GreyImage read_png(std::string_view bytes, const std::string& name, std::size_t most_pixels) {
    const Size size = size_of(bytes, name);
    require_size(size, bytes.size(), name, most_pixels);
    GreyImage image{int(size.width), int(size.height), false, {}};
    image.pixels.resize(size.width * size.height);
    Decoder decoder(image);
    if (const char* const reason = decoder.decode(bytes)) throw damaged(name, reason);
    return image;
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

}  // namespace waybreaker::mapfile
