// Vector data in any format GDAL reads, and the transformation from its coordinates to a window's.
#pragma once

#include <gdal_priv.h>
#include <ogrsf_frmts.h>

#include <cstddef>
#include <memory>
#include <optional>
#include <string>

#include "geotiff/gdal_scope.hpp"
#include "site/background.hpp"
#include "waybreaker/error.hpp"

namespace waybreaker::city {

// A rectangle on the ground, its sides parallel to the axes of a projected coordinate system.
struct Window {
    OGRSpatialReference system;
    OGREnvelope bounds;
};

InputError refusal(const std::string& source, const std::string& message);

// The first bytes of a source, unpacked if it is packed with gzip under any name.
std::string head_of(const std::string& source, std::size_t bytes);
bool is_gzip(const std::string& source);
// Whether its gzip data is cut off.
bool ends_early(const std::string& source);

// Of what is not OpenStreetMap's own data; also of gzipped files. Throws InputError if it cannot be read.
GDALDatasetUniquePtr open_source(const std::string& source);

// Throws InputError if GDAL has failed while it read the source.
void require_read(const geotiff::GdalScope& gdal, const std::string& source);

bool is_area(OGRwkbGeometryType type);
bool is_line(OGRwkbGeometryType type);
// Empty if it is none of these, or any.
std::optional<site::Background::Shape> shape_of(OGRwkbGeometryType type);

// Throws InputError if the layer does not state it.
const OGRSpatialReference& system_of(OGRLayer& layer, const std::string& source);

using Transformation = std::unique_ptr<OGRCoordinateTransformation>;

// Between coordinates in (east, north) order, whatever order the system's authority prefers.
Transformation transformation(OGRSpatialReference from, OGRSpatialReference to);

// The smallest box that holds the transformed one; the full range of longitudes if it crosses the date line.
std::optional<OGREnvelope> transformed(const OGREnvelope& box, const OGRSpatialReference& from,
                                       const OGRSpatialReference& to);

// The bounds of the window in the system of a layer. Throws InputError if there is no way between them.
OGREnvelope bounds_in(const OGRSpatialReference& system, const Window& window, const std::string& source);

// Throws InputError unless the box lies on the globe. Longitudes may go on past 180, as those of the Pacific do.
void require_degrees(const OGREnvelope& box, const std::string& source);

OGRPolygon rectangle(const OGREnvelope& bounds);

// The outline of a box in another system, in which its sides bend; null if there is no way to it.
std::unique_ptr<OGRGeometry> outline_of(const OGREnvelope& box, const OGRSpatialReference& from,
                                        const OGRSpatialReference& to);

}  // namespace waybreaker::city
