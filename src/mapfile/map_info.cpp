#include "mapfile/map_info.hpp"

#include "geotiff/georeference.hpp"
#include "io/map_info.hpp"

namespace waybreaker::mapfile {

std::array<double, 2> center(const io::MapFile& file) {
    return geotiff::lon_lat_of(file.georeference)({(file.map.width() - 1) / 2.0, (file.map.height() - 1) / 2.0});
}

std::string frame_crs(const io::MapFile& file) {
    const bool in_metres = file.georeference && file.georeference->transform[1] == file.cell_size;
    return in_metres && !file.cell_size_given ? geotiff::crs_code(*file.georeference) : "";
}

nlohmann::ordered_json georeference_json(const io::MapFile& file) {
    using Json = nlohmann::ordered_json;
    if (!file.georeference) return nullptr;
    const auto affine = geotiff::affine_to_lon_lat(*file.georeference, file.map.width(), file.map.height());
    const auto box = geotiff::lon_lat_box(*file.georeference, file.map.width(), file.map.height());
    return {{"crs", geotiff::crs_name(*file.georeference)},
            {"crs_code", geotiff::crs_code(*file.georeference)},
            {"center", center(file)},
            {"bbox", box ? Json(*box) : Json()},
            {"to_lon_lat", affine ? Json(*affine) : Json()}};
}

std::string map_info_json(const io::MapFile& file) {
    return io::map_info(file, georeference_json(file))
               .dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) +
           "\n";
}

}  // namespace waybreaker::mapfile
