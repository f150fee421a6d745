#include "geotiff/label_tiff.hpp"

#include <cmath>

#include "laws.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    waybreaker::read_or_refuse(data, size, [](std::string_view bytes) {
        const waybreaker::geotiff::LabelTiff tiff = waybreaker::geotiff::read_label_tiff(bytes, "input");
        waybreaker::law(tiff.cell_size > 0);
        waybreaker::law(!tiff.origin ||
                        (!tiff.georeference && std::isfinite(tiff.origin->at(0)) && std::isfinite(tiff.origin->at(1))));
        waybreaker::law(tiff.annotations.names.empty() ||
                        tiff.annotations.names.size() == tiff.map.obstacles().size() + 1);
        for (const auto& feature : tiff.annotations.background.features) {
            waybreaker::law(!feature.parts.empty());
            for (const auto& part : feature.parts) {
                waybreaker::law(!part.empty());
                for (const auto& point : part) waybreaker::law(std::isfinite(point.x) && std::isfinite(point.y));
            }
        }
    });
    return 0;
}
