// PNG from any SVG of ours.
#pragma once

#include <string>

namespace waybreaker::raster {

// The bytes of a PNG file, `scale` pixels for one of the SVG's.
std::string png_of(const std::string& svg, double scale = 1);

}  // namespace waybreaker::raster
