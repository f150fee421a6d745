// Features: what a source of map data holds, as one stream, whether it is OpenStreetMap's own data or layers of another
// format. What comes after does not know which.
#pragma once

#include <ogr_geometry.h>
#include <ogr_spatialref.h>

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "city/cut_areas.hpp"
#include "city/obstacle_choice.hpp"
#include "city/tag_set.hpp"
#include "osm/features.hpp"
#include "site/background.hpp"

namespace waybreaker::city {

struct Feature {
    site::Background::Shape shape = site::Background::Shape::area;
    TagSet tags = {};
    std::int64_t source_id = 0;  // OpenStreetMap's ways positive, relations negative; 0 where the source does not say
    // In the system that was asked for. Null: it has no coordinates, or such as are no numbers.
    std::unique_ptr<OGRGeometry> geometry = {};
    bool of_building_layer = false;  // its layer cannot say what is a building, and so holds nothing else
};

struct FeatureQuery {
    OGRSpatialReference system;
    std::optional<OGREnvelope> bounds = {};  // in that system: only what may lie there
    // Features of a shape are wanted that may have one of the keys; of all keys if there are none. Others may come,
    // too.
    std::optional<std::vector<TagFilter>> points = {};
    std::optional<std::vector<TagFilter>> lines = {};
    std::optional<std::vector<TagFilter>> areas = {};
    // Of sources with layers.
    std::string layer = {};  // the only one; empty: all
    bool buildings = false;  // only those of buildings; if it is not clear which these are, the user must say it
    bool obstacles = false;  // each must say where it lies; else those that do not are passed over
};

struct FeatureReport {
    bool from_osm = false;   // the data is OpenStreetMap's
    bool any_layer = false;  // there is a layer that can hold what is wanted
    // What the source has data of, in the query's system; empty if it does not say, or obstacles were not asked for.
    OGREnvelope extent = {};
    // Of an OpenStreetMap file: beyond that it has nothing. What it states, or else a box around its nodes.
    std::unique_ptr<OGRGeometry> data = {};
    std::vector<CutArea> cut = {};  // their lines in the query's system
    osm::Defects defects = {};
};

// Visits, in the source's order, areas of relations before those of ways. Throws InputError if it cannot be read.
FeatureReport visit_features(const std::string& source, const FeatureQuery& query,
                             const std::function<void(Feature)>& visit);

// "key=value" for each of the tags that maps keep and that says something.
std::vector<std::string> kept_tags(const TagSet& tags);

}  // namespace waybreaker::city
