// Tags of obstacles: which the import keeps, what they protect, and how files hold them.
#include <gdal_priv.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "city/city_import.hpp"
#include "city/osm_drawing.hpp"
#include "geotiff/gdal_scope.hpp"
#include "input_error.hpp"
#include "temporary_folder.hpp"

namespace waybreaker::city {
namespace {

class Tags : public TemporaryFolder {
  protected:
    // A small building in the corner.
    OsmDrawing drawing_ = OsmDrawing(town_window).area("building=yes", box(-0.2, -0.2, 0.2, 0.2));

    ImportReport import(const OsmDrawing& drawing, ImportOptions options = town_window) const {
        return import_city(put("town.osm", drawing.xml()), options);
    }
};

TEST_F(Tags, of_heritage_protect_a_wall) {
    drawing_.way("barrier=wall|historic=citywalls", {{2, 4}, {6, 4}}).way("barrier=wall", {{8, 4}, {12, 4}});
    const ImportReport report = import(drawing_);
    std::string text;
    for (const Obstacle& o : report.tiff.map.obstacles()) text += o.destructible ? 'd' : '-';
    EXPECT_EQ(text, "d-d");  // house, old wall, wall
    EXPECT_EQ(report.sheltered, 1U);
    EXPECT_EQ(report.buildings, 1U);
}

// A square beside a school and a house: what goes leaves every cell of the school.
TEST_F(Tags, that_protect_a_building_keep_it_out_of_sections) {
    drawing_.area("building=yes", box(3.6, 2.6, 6.4, 8.4));
    drawing_.area("building=school", box(6.6, 2.6, 9.4, 8.4));
    ImportOptions options = town_window;
    options.section = 10;
    const ImportReport report = import(drawing_, options);
    const Map& map = report.tiff.map;
    std::vector<ObstacleId> all;
    for (const Obstacle& o : map.obstacles()) {
        if (o.destructible) all.push_back(o.id);
    }
    const OpenedMap opened(map, all);
    const auto& schools = report.tiff.annotations.tags.at("building=school");
    ASSERT_EQ(schools.size(), 1U);
    EXPECT_EQ(map.obstacle(schools[0]).cells, 3U * 6U);
    for (Cell c; c.y < map.height(); ++c.y) {
        for (c.x = 0; c.x < map.width(); ++c.x) EXPECT_EQ(opened.blocked(c), map.obstacle_at(c) == schools[0]);
    }
}

TEST_F(Tags, that_are_kept_are_some) {
    drawing_.area("building=church|amenity=place_of_worship|colour=red|heritage=no", box(3.6, 2.6, 6.4, 3.4));
    drawing_.way("barrier=hedge|height=2", {{2, 8}, {6, 8}});
    const site::ObstacleTags expected{{"amenity=place_of_worship", {{2}}},
                                      {"barrier=hedge", {{3}}},
                                      {"building=church", {{2}}},
                                      {"building=yes", {{1}}}};
    EXPECT_EQ(import(drawing_).tiff.annotations.tags, expected);
    ImportOptions options = town_window;
    options.profile = Profile::paper;
    EXPECT_TRUE(import(drawing_, options).tiff.annotations.tags.empty());
    options.profile = Profile::rover;
    options.merge_touching = true;
    EXPECT_EQ(import(drawing_, options).tiff.annotations.tags, expected);
}

// A file of the cells 5, 70000 and 0 with that item.
std::string file_with(const char* item) {
    GDALAllRegister();
    const geotiff::MemoryFile memory;
    GDALDatasetUniquePtr file(
        GetGDALDriverManager()->GetDriverByName("GTiff")->Create(memory.path().c_str(), 3, 1, 1, GDT_UInt32, nullptr));
    std::vector<std::uint32_t> cells{5, 70000, 0};
    EXPECT_EQ(file->GetRasterBand(1)->RasterIO(GF_Write, 0, 0, 3, 1, cells.data(), 3, 1, GDT_UInt32, 0, 0, nullptr),
              CE_None);
    file->SetMetadataItem("WAYBREAKER_TAGS", item);
    file.reset();
    return memory.bytes();
}

site::ObstacleTags read(const char* item) {
    return geotiff::read_label_tiff(file_with(item), "city.tif").annotations.tags;
}

TEST(TagsOfFiles, come_back) {
    geotiff::LabelTiff town{.map = Map::from_labels(3, 1, {1, 2, 3})};
    town.annotations.tags = {{"amenity=café <old>", {{1}, {3}}}, {"building=yes", {{1}}}};
    EXPECT_EQ(geotiff::read_label_tiff(geotiff::label_tiff_bytes(town), "town.tif").annotations.tags,
              town.annotations.tags);
}

TEST(TagsOfFiles, are_those_of_obstacles_that_are_there) {
    EXPECT_EQ(read("a=b\t5 70000 5 8\nc=d=e\t6"), (site::ObstacleTags{{"a=b", {{1}, {2}}}}));
    EXPECT_EQ(read("c=d e\t70000"), (site::ObstacleTags{{"c=d e", {{2}}}}));
    EXPECT_EQ(read(""), site::ObstacleTags{});
}

TEST(TagsOfFiles, are_refused_by_their_line) {
    const std::string what =
        " of its metadata item WAYBREAKER_TAGS is no tag and the numbers of its obstacles; drop the item with "
        "'gdal_edit.py -mo WAYBREAKER_TAGS=' or import the map anew";
    EXPECT_EQ(input_error([&] { read("a=b\t5\na=b"); }), "city.tif: line 2" + what);
    for (const char* bad : {"a\t5", "a=b\tx", "a=b\t0", "a=b\t5  70000"}) {
        EXPECT_EQ(input_error([&] { read(bad); }), "city.tif: line 1" + what) << bad;
    }
}

}  // namespace
}  // namespace waybreaker::city
