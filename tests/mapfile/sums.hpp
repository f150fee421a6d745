#pragma once

#include <vector>

#include "mapfile/grey_image.hpp"

namespace waybreaker::mapfile {

// Red, green and blue of each pixel, added up.
inline std::vector<int> sums(const GreyImage& image) {
    std::vector<int> result;
    for (const GreyImage::Pixel& pixel : image.pixels) result.push_back(pixel.sum);
    return result;
}

}  // namespace waybreaker::mapfile
