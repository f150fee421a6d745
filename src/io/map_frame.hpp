// The frame that robots and GIS know a map in: metres, x to the right, y up.
#pragma once

#include "io/map_file.hpp"

namespace waybreaker::io {

class MapFrame {
  public:
    explicit MapFrame(const MapFile& map);

    // The lower-left corner of the map: as its file says, else in the metres of its coordinate system, else 0, 0.
    Point origin() const { return origin_; }

    // Of a point in cell units.
    Point metres(Point cell) const;
    // The cell that a point lies in, two whole numbers; of an edge, the cell to the right and above, as in ROS. It need
    // not be on the map.
    Point cell(Point metres) const;

  private:
    Point origin_;
    double cell_size_;
    int height_;
};

}  // namespace waybreaker::io
