// Vector data of any kind GDAL knows, and the way from its coordinates to a window's.
#pragma once

#include <gdal_priv.h>
#include <ogrsf_frmts.h>

#include <memory>
#include <optional>
#include <string>

#include "waybreaker/error.hpp"

namespace waybreaker::geo {

// A rectangle on the ground, its sides parallel to the axes of a projected coordinate system.
struct Window {
    OGRSpatialReference system;
    OGREnvelope bounds;
};

InputError refusal(const std::string& source, const std::string& message);

// Also of gzipped files. Throws InputError if it cannot be read.
GDALDatasetUniquePtr open_source(const std::string& source);

bool is_area(OGRwkbGeometryType type);
bool is_line(OGRwkbGeometryType type);

// Throws InputError if the layer does not say it.
const OGRSpatialReference& system_of(OGRLayer& layer, const std::string& source);

using Transformation = std::unique_ptr<OGRCoordinateTransformation>;

// Between coordinates in (east, north) order, whatever order the system's authority prefers.
Transformation transformation(OGRSpatialReference from, OGRSpatialReference to);

// The smallest box that holds the transformed one; the whole breadth of the world if it crosses the date line.
std::optional<OGREnvelope> transformed(const OGREnvelope& box, const OGRSpatialReference& from,
                                       const OGRSpatialReference& to);

// The bounds of the window in the system of a layer. Throws InputError if there is no way between them.
OGREnvelope bounds_in(const OGRSpatialReference& system, const Window& window, const std::string& source);

OGRPolygon rectangle(const OGREnvelope& bounds);

}  // namespace waybreaker::geo
