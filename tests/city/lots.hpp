// Features one by one, each drawn across a small town, imported, and driven at from the north to the south.
#pragma once

#include <gtest/gtest.h>

#include <array>
#include <string>
#include <vector>

#include "city/city_import.hpp"
#include "city/osm_drawing.hpp"
#include "temporary_folder.hpp"

namespace waybreaker::city {

// For rover, truck and walker: `.` gets through, `d` only if something is destroyed, `x` never.
struct Row {
    const char* tags;
    const char* fate;
};

// Lots in rows on one map, a feature on each.
inline constexpr int lots = 8;    // in a row
inline constexpr int pitch = 22;  // cells from one to the next
inline const ImportOptions lots_window{
    .longitude = 13.4, .latitude = 52.52, .size = 2.0 * lots * pitch, .cell = 2, .section = 0, .background = false};

// A square of 14 cells, on which things reach from edge to edge.
class Lot {
  public:
    Lot(OsmDrawing& drawing, int number)
        : drawing_(&drawing), corner_{4 + number % lots * pitch, 4 + number / lots * pitch} {}

    // A multipolygon, which is an area whatever its tags are.
    Lot& area(const std::string& tags, double north = 4.6, double south = 8.4) {
        drawing_->area("", box(x(-2), y(north), x(15), y(south)));
        drawing_->relation(tags, {drawing_->last()});
        return *this;
    }
    Lot& line(const std::string& tags) {
        drawing_->way(tags, {{x(-2), y(6)}, {x(2), y(6)}, {x(15), y(6)}});
        return *this;
    }
    Lot& way(const std::string& tags) {
        drawing_->way(tags, {{x(6), y(-2)}, {x(6), y(6)}, {x(6), y(15)}});
        return *this;
    }
    // In the middle of line and way.
    Lot& point(const std::string& tags) {
        drawing_->point(tags, {x(6), y(6)}, true);
        return *this;
    }
    // Where trucks may drive as well, but no way that opens anything.
    Lot& car_park() { return area("amenity=parking", -2, 15); }

    char fate(const Map& map) const {
        if (gets_through([&](Cell c) { return !map.obstacle_at(c); })) return '.';
        const auto opened = [&](Cell c) {
            return !map.obstacle_at(c) || map.obstacle(map.obstacle_at(c)).destructible;
        };
        return gets_through(opened) ? 'd' : 'x';
    }

  private:
    double x(double column) const { return corner_.x + column; }
    double y(double row) const { return corner_.y + row; }

    // From the upper edge to the lower one, by sides of cells.
    template <class Open>
    bool gets_through(Open open) const {
        std::array<std::array<bool, town_side>, town_side> seen{};
        std::vector<Cell> front;
        const auto reach = [&](Cell c) {
            if (c.x < 0 || c.y < 0 || c.x >= town_side || c.y >= town_side) return;
            bool& known = seen.at(std::size_t(c.y)).at(std::size_t(c.x));
            if (known || !open(Cell{corner_.x + c.x, corner_.y + c.y})) return;
            known = true;
            front.push_back(c);
        };
        for (int column = 0; column < town_side; ++column) reach({column, 0});
        while (!front.empty()) {
            const Cell c = front.back();
            front.pop_back();
            if (c.y == town_side - 1) return true;
            for (const Cell next : {Cell{c.x - 1, c.y}, Cell{c.x + 1, c.y}, Cell{c.x, c.y - 1}, Cell{c.x, c.y + 1}}) {
                reach(next);
            }
        }
        return false;
    }

    OsmDrawing* drawing_;
    Cell corner_;
};

class GroundRulesTable : public TemporaryFolder {
  protected:
    template <class Draw>
    void expect(const std::vector<Row>& rows, Draw draw) const {
        ASSERT_LE(rows.size(), std::size_t(lots * lots));
        // A house, so that there is something to import.
        OsmDrawing town = OsmDrawing(lots_window).area("building=yes", box(-0.2, -0.2, 0.2, 0.2));
        std::vector<Lot> drawn;
        for (const Row& row : rows) {
            Lot lot(town, int(drawn.size()));
            draw(lot, row.tags);
            drawn.push_back(lot);
        }
        const std::string path = put("town.osm", town.xml());
        std::vector<std::string> fates(rows.size());
        for (const Profile profile : {Profile::rover, Profile::truck, Profile::walker}) {
            ImportOptions options = lots_window;
            options.profile = profile;
            const Map map = import_city(path, options).tiff.map;
            for (std::size_t i = 0; i < rows.size(); ++i) fates[i] += drawn[i].fate(map);
        }
        for (std::size_t i = 0; i < rows.size(); ++i) EXPECT_EQ(fates[i], rows[i].fate) << rows[i].tags;
    }
};

}  // namespace waybreaker::city
