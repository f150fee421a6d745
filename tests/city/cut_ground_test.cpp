// Ground that the edge of the data cuts, drawn in cells.
#include <gtest/gtest.h>

#include <cstdint>
#include <string>
#include <vector>

#include "city/city_import.hpp"
#include "city/ground_picture.hpp"
#include "city/osm_drawing.hpp"
#include "temporary_folder.hpp"

namespace waybreaker::city {
namespace {

class CutGround : public TemporaryFolder {
  protected:
    // A small building in the corner, so that there is something to import.
    OsmDrawing drawing_ = OsmDrawing(town_window).area("building=yes", box(-0.2, -0.2, 0.2, 0.2));

    ImportReport import(const OsmDrawing& drawing) const {
        return import_city(put("town.osm", drawing.xml()), town_window);
    }
    std::string drawn() const { return picture(import(drawing_).tiff); }
};

TEST_F(CutGround, of_an_incomplete_relation_is_reported_and_its_line_is_a_strip) {
    drawing_.way("waterway=river", {{-1, 6}, {14, 6}});
    drawing_.relation("natural=water|water=river|name=Vltava", {drawing_.last(), 4711});
    // What is no ground, and what lies elsewhere, is of no interest.
    drawing_.way("", {{-1, 3}, {14, 3}});
    drawing_.relation("boundary=administrative|name=Praha", {drawing_.last(), 4711});
    drawing_.way("", {{300, 3}, {314, 3}});
    drawing_.relation("natural=water|name=Elbe", {drawing_.last(), 4711});
    const ImportReport report = import(drawing_);
    EXPECT_EQ(report.notes,
              std::vector<std::string>{"Vltava: left out, for the source has no more than a part of its outline"});
    EXPECT_NE(picture(report.tiff).find("wwwwwwwwwwwwww"), std::string::npos);
}

// Streets beside it say which side is land, and with it how far the data goes.
TEST_F(CutGround, of_a_river_reaches_from_bank_to_bank) {
    drawing_.way("highway=residential", {{-3, 2}, {17, 2}});
    drawing_.way("highway=residential", {{-3, 12}, {17, 12}});
    drawing_.way("", {{-2.5, 4.5}, {16.2, 4.5}});
    const std::int64_t north = drawing_.last();
    drawing_.way("", {{16.5, 8.5}, {-2.2, 8.5}});
    drawing_.relation("natural=water|name=Vltava", {north, drawing_.last(), 4711});
    const std::string free = "..............\n";
    const std::string water = "wwwwwwwwwwwwww\n";
    EXPECT_EQ(drawn(), "B.............\n" + free + free + free + free + water + water + water + water + free + free +
                           free + free + free);
    EXPECT_EQ(import(drawing_).notes, std::vector<std::string>{"Vltava: closed along the edge of the data"});
}

}  // namespace
}  // namespace waybreaker::city
