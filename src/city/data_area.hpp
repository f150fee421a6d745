// Where a source has data, and what maps say of the ground beyond.
#pragma once

#include <ogr_geometry.h>

#include <memory>
#include <vector>

#include "city/footprints.hpp"
#include "city/import_window.hpp"
#include "city/survey.hpp"
#include "site/described_map.hpp"

namespace waybreaker::city {

// The part of the world that the source has data of, in the window's system: what an
// OpenStreetMap file has, else the box that the source states, else the one
// around what was found; null if there is neither.
std::unique_ptr<OGRGeometry> data_area(const Footprints& footprints, const Survey& survey);

// The share of the bounds that the area covers.
double share_of(const OGRGeometry* area, const OGREnvelope& bounds);

// Makes obstacles that cannot be destroyed, with the tag of unknown ground, of the free cells whose centres the area
// does not cover: one of each connected set.
void append_unknown(const OGRGeometry* area, const CellWindow& window, site::LabelLayer& cells);

// The cells whose centres the area does not cover, or one of these pieces does, row by row; of no area the pieces'
// only.
std::vector<site::CellRun> unknown_cells(const OGRGeometry* area, const std::vector<GroundPiece>& pieces,
                                         const CellWindow& window);

}  // namespace waybreaker::city
