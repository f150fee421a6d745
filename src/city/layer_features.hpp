// The layers of any format of vector data that GDAL reads, as features.
#pragma once

#include "city/features.hpp"

namespace waybreaker::city {

// As visit_features.
FeatureReport visit_layers(const std::string& source, const FeatureQuery& query,
                           const std::function<void(Feature)>& visit);

}  // namespace waybreaker::city
