// Faces: the parts into which lines that run to the edge of the data cut what lies within it.
#pragma once

#include <ogr_geometry.h>

#include <cstddef>
#include <memory>
#include <vector>

#include "city/line_work.hpp"

namespace waybreaker::city {

// What is near the edge for a line that ends before it, in metres: ways end at their last point within an extract.
double reach_of(const OGRPolygon& edge);

// Where the edge is nearest to a point, a little beyond it, so that a line to there cuts it.
Point just_beyond(const OGRPolygon& edge, const Point& from);

// Where exactly one line ends; in the order of their coordinates.
std::vector<Point> loose_ends(const std::vector<Line>& lines);

bool lies_within(const OGRPolygon& edge, const Point& point);

class Faces {
  public:
    static constexpr std::size_t none = std::size_t(-1);

    // The edge must be convex.
    Faces(const std::vector<Line>& lines, const OGRPolygon& edge);

    std::size_t size() const { return faces_.size(); }
    const OGRGeometry& operator[](std::size_t number) const { return *faces_[number].shape; }
    // The number of the face that holds a point, or none.
    std::size_t at(const Point& point) const;

  private:
    struct Face {
        std::unique_ptr<OGRGeometry> shape;
        OGREnvelope box;
        OGRPreparedGeometryUniquePtr prepared;
    };

    std::vector<Face> faces_;
};

// A segment of a line that bounds faces, or none where it runs outside of the edge.
struct Border {
    std::size_t left;
    std::size_t right;
    double length;
};
std::vector<Border> borders(const Faces& faces, const std::vector<Line>& lines);

}  // namespace waybreaker::city
