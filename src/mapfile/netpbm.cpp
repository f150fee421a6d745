// The netpbm formats: "P" and a digit, width, height, for grey and colour the largest sample, then the samples.
#include <algorithm>
#include <charconv>
#include <optional>

#include "mapfile/grey_image.hpp"
#include "waybreaker/error.hpp"
#include "waybreaker/grid.hpp"

namespace waybreaker::mapfile {
namespace {

bool is_space(char c) {
    return c == ' ' || (c >= '\t' && c <= '\r');
}

// What a file holds, by the digit after its "P".
struct Kind {
    explicit Kind(char digit)
        : text(digit <= '3'), bits(digit == '1' || digit == '4'), samples((digit - '1') % 3 == 2 ? 3 : 1) {}
    bool text;    // numbers to read, not bytes
    bool bits;    // black or white
    int samples;  // a pixel
};

class Reader {
  public:
    Reader(std::string_view bytes, const std::string& name) : bytes_(bytes), name_(name) {}

    InputError error(const std::string& message) const {
        const auto line = 1 + std::count(bytes_.begin(), bytes_.begin() + std::ptrdiff_t(at_), '\n');
        return {name_, std::size_t(line), message};
    }

    // The next number of the header, or of the samples as text. Comments run from # to the end of a line.
    int number(int least, int most, const char* what) {
        skip_space();
        int value = 0;
        const char* const end = bytes_.data() + bytes_.size();
        const auto [rest, failure] = std::from_chars(bytes_.data() + at_, end, value);
        if (failure != std::errc() || value < least || value > most) {
            throw error(std::string(what) + " must be a number from " + std::to_string(least) + " to " +
                        std::to_string(most));
        }
        at_ = std::size_t(rest - bytes_.data());
        return value;
    }

    // A digit of a PBM as text, where no space is needed between them; true is black.
    bool digit() {
        skip_space();
        if (at_ == bytes_.size() || (bytes_[at_] != '0' && bytes_[at_] != '1'))
            throw error("a pixel is neither 0 nor 1");
        return bytes_[at_++] == '1';
    }

    // What follows the single space that ends the header.
    std::string_view binary() const { return bytes_.substr(std::min(at_ + 1, bytes_.size())); }
    std::size_t left() const { return bytes_.size() - at_; }

  private:
    void skip_space() {
        while (at_ < bytes_.size() && (is_space(bytes_[at_]) || bytes_[at_] == '#')) {
            at_ = bytes_[at_] == '#' ? std::min(bytes_.find('\n', at_), bytes_.size()) : at_ + 1;
        }
    }

    std::string_view bytes_;
    const std::string& name_;
    std::size_t at_ = 2;  // behind the magic number
};

InputError cut_off(const std::string& name) {
    return {name, 0, "ends before its last pixel: is the file cut off?"};
}

void read_bits(std::string_view bytes, GreyImage& image, const std::string& name) {
    const std::size_t row = (std::size_t(image.width) + 7) / 8;
    if (bytes.size() < row * std::size_t(image.height)) throw cut_off(name);
    for (int y = 0; y < image.height; ++y) {
        for (int x = 0; x < image.width; ++x) {
            const auto byte = static_cast<unsigned char>(bytes[std::size_t(y) * row + std::size_t(x) / 8]);
            const bool black = (byte >> (7 - x % 8) & 1) != 0;
            image.pixels.push_back(GreyImage::Pixel::of_grey(black ? 0 : 255));
        }
    }
}

// A sample of 0 to `largest` as one of 0 to 255.
std::uint16_t scaled(int sample, int largest) {
    return std::uint16_t((std::min(sample, largest) * 255 + largest / 2) / largest);
}

}  // namespace

bool is_netpbm(std::string_view bytes) {
    return bytes.size() > 2 && bytes[0] == 'P' && bytes[1] >= '1' && bytes[1] <= '6' &&
           (is_space(bytes[2]) || bytes[2] == '#');
}

GreyImage read_netpbm(std::string_view bytes, const std::string& name, std::size_t most_pixels) {
    if (!is_netpbm(bytes)) throw InputError(name, 0, "is no PBM, PGM or PPM image");
    const Kind kind(bytes[1]);
    Reader reader(bytes, name);
    GreyImage image;
    image.width = reader.number(1, max_side, "the width");
    image.height = reader.number(1, max_side, "the height");
    const int largest = kind.bits ? 1 : reader.number(1, 65535, "the largest sample");
    const std::size_t pixels = std::size_t(image.width) * std::size_t(image.height);
    if (pixels > most_pixels) {
        throw SizeError(reader.error("the image is too large for a map: cut a piece out of it").what());
    }

    const std::size_t bytes_a_sample = kind.text || largest < 256 ? 1 : 2;
    const std::size_t samples = pixels * std::size_t(kind.samples);
    const std::size_t least = kind.bits && !kind.text ? pixels / 8 : samples * bytes_a_sample;
    if (reader.left() < least) throw cut_off(name);
    image.pixels.reserve(pixels);
    if (kind.bits && !kind.text) {
        read_bits(reader.binary(), image, name);
        return image;
    }
    const std::string_view binary = reader.binary();
    if (!kind.text && binary.size() < samples * bytes_a_sample) throw cut_off(name);
    std::size_t at = 0;
    const auto sample = [&] {
        if (kind.bits) return reader.digit() ? 0 : 1;
        if (kind.text) return reader.number(0, largest, "a sample");
        int value = 0;
        for (std::size_t i = 0; i < bytes_a_sample; ++i) value = value << 8 | static_cast<unsigned char>(binary[at++]);
        return value;
    };
    for (std::size_t i = 0; i < pixels; ++i) {
        const int first = scaled(sample(), largest);
        if (kind.samples == 1) {
            image.pixels.push_back(GreyImage::Pixel::of_grey(first));
            continue;
        }
        const int green = scaled(sample(), largest);
        const int blue = scaled(sample(), largest);
        image.pixels.push_back(GreyImage::Pixel::of_colour(first, green, blue));
    }
    return image;
}

std::string pgm_bytes(int width, int height, const std::vector<std::uint8_t>& grey) {
    std::string bytes = "P5\n" + std::to_string(width) + " " + std::to_string(height) + "\n255\n";
    bytes.append(grey.begin(), grey.end());
    return bytes;
}

}  // namespace waybreaker::mapfile
