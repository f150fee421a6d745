// The metadata items of a label map's raster: the text that stands under a name, empty where there is none.
#pragma once

#include <functional>
#include <string>

namespace waybreaker::labels {

using MetadataItems = std::function<std::string(const char* item)>;

}  // namespace waybreaker::labels
