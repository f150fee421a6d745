#include "laws.hpp"
#include "mapfile/grey_image.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    waybreaker::read_or_refuse(data, size, [](std::string_view bytes) {
        const waybreaker::mapfile::GreyImage image = waybreaker::mapfile::read_image(bytes, "input");
        const std::size_t pixels = std::size_t(image.width) * std::size_t(image.height);
        waybreaker::law(pixels > 0 && image.pixels.size() == pixels);
        for (const auto& pixel : image.pixels) waybreaker::law(pixel.sum <= 765);
    });
    return 0;
}
