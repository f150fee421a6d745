// Areas that the edge of the data cuts, closed along it.
#pragma once

#include <ogr_geometry.h>

#include <cstdint>
#include <memory>
#include <vector>

#include "city/line_work.hpp"
#include "city/tag_set.hpp"

namespace waybreaker::city {

// An area whose outline is not whole in the source, all in metres of the window's system.
struct CutArea {
    TagSet tags = {};
    std::int64_t source_id = 0;
    std::vector<Line> outer = {};  // the ways of its outline that the source has, each as the source runs it
    std::vector<Line> inner = {};  // of holes in it; whole, or cut like the outline
};

// What else the source has, to tell which side of an outline is the area's.
struct Evidence {
    std::vector<Line> within = {};   // lines that run inside of such areas: of rivers and canals for water
    std::vector<Line> outside = {};  // lines that do not: of streets without bridges and tunnels, outlines of buildings
};

struct ClosedArea {
    enum class How {
        closed,
        unknown  // the shape is where the area may be
    };
    How how = How::unknown;
    std::unique_ptr<OGRGeometry> shape;  // null if nothing of it can lie within the edge
};

// Open ends near the edge, which is convex, are taken to it; the evidence chooses among the faces that edge and outline
// make.
ClosedArea closed_along_edge(const CutArea& area, const OGRPolygon& edge, const Evidence& evidence);

// Of what a source has data of: the bounds it states, or the convex hull of its points if it states none, or if it is
// clearly smaller and the outlines end near it but not near the bounds, as those of extracts cut along a border. Null
// if there is neither.
std::unique_ptr<OGRPolygon> edge_of_data(const OGREnvelope& bounds, const std::vector<Point>& points,
                                         const std::vector<CutArea>& areas);

}  // namespace waybreaker::city
