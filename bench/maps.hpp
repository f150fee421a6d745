// The maps the benchmarks run on: MovingAI city maps beside the project (movingai.com, "street" maps), and mosaics.
#pragma once

#include <filesystem>
#include <string>

#include "waybreaker/grid.hpp"

namespace waybreaker::bench {

// The folder of shared data: environment variable WAYBREAKER_SHARED, else ../shared beside the project.
std::filesystem::path shared_folder();

// data/NAME.tif of the project.
std::filesystem::path city_in_data(const std::string& name);

// data/cities/NAME.map in the shared folder. Throws InputError if it is not there.
Grid read_city(const std::string& name);

// The tile repeated over a square map.
Grid mosaic(const Grid& tile, int side);

}  // namespace waybreaker::bench
