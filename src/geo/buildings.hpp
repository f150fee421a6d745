// Buildings: the polygons of a vector source that stand in a window, in the window's coordinates.
#pragma once

#include <ogr_geometry.h>

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace waybreaker::geo {

// A square on the ground, its sides parallel to the axes of a projected coordinate system.
struct Window {
    OGRSpatialReference system;
    OGREnvelope bounds;
};

struct Building {
    std::unique_ptr<OGRGeometry> shape;  // in the window's system, not clipped
    double area = 0;                     // of its part inside the window, in square metres, > 0
    std::int64_t source_id = 0;          // OSM ways positive, relations negative; 0 = unknown
};

struct Buildings {
    std::vector<Building> buildings;  // in the source's order
    bool from_osm = false;            // the source is made of OpenStreetMap data
};

// Buildings are the polygons whose attribute `building` is set and not `no`; every polygon of a layer without that
// attribute. One scan of the source. Throws InputError if it cannot be read, holds no polygons, or none in the window:
// then says where its data lies.
Buildings read_buildings(const std::string& source, const Window& window);

}  // namespace waybreaker::geo
