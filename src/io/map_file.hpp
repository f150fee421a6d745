// Any map file waybreaker reads, told apart by its content.
#pragma once

#include <optional>
#include <string>

#include "geo/label_tiff.hpp"
#include "io/authors_xml.hpp"
#include "waybreaker/map.hpp"

namespace waybreaker::io {

struct MapFile {
    Map map;
    std::string source;    // file name without folders
    std::string format;    // for people: "MovingAI map", "authors' XML", "GeoTIFF label map"
    std::string digest;    // "sha256:..." of the file's bytes
    double cell_size = 1;  // metres per cell
    double label_seconds = 0;
    std::optional<geo::Georeference> georeference;
    std::string attribution;
    std::string title;
    std::optional<XmlTask> task;  // start, goal and options, where the file holds them
};

// Throws InputError. `connectivity` applies to formats without a label layer.
MapFile read_map_file(const std::string& path, Connectivity connectivity = Connectivity::four);

}  // namespace waybreaker::io
