#include "geo/label_tiff.hpp"

#include "laws.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    waybreaker::read_or_refuse(data, size, [](std::string_view bytes) {
        const waybreaker::geo::LabelTiff tiff = waybreaker::geo::read_label_tiff(bytes, "input");
        waybreaker::law(tiff.cell_size > 0);
    });
    return 0;
}
