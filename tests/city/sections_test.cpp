// Sections in imported maps, and in the files of label maps.
#include <gdal_priv.h>
#include <gtest/gtest.h>

#include <optional>
#include <string>
#include <vector>

#include "city/city_import.hpp"
#include "city/osm_drawing.hpp"
#include "geotiff/gdal_scope.hpp"
#include "input_error.hpp"
#include "site/split.hpp"
#include "temporary_folder.hpp"

namespace waybreaker::city {
namespace {

class ImportedSections : public TemporaryFolder {
  protected:
    // A house across the river, a fence along it, a church.
    const std::string source_ = put("town.osm", OsmDrawing(town_window)
                                                    .area("natural=water", box(-1, 4.6, 14, 8.4))
                                                    .area("building=yes|name=Mill", box(2, 2, 9, 12))
                                                    .area("building=church", box(10, 9, 13.5, 12))
                                                    .way("barrier=fence", {{1, 12.5}, {13, 12.5}})
                                                    .xml());

    geotiff::LabelTiff import(std::optional<double> section, std::optional<Profile> profile = {}) const {
        ImportOptions options = town_window;
        options.section = section;
        options.profile = profile;
        return import_city(source_, options).tiff;
    }
};

TEST_F(ImportedSections, are_those_of_the_whole_map_cut) {
    const geotiff::LabelTiff map = import(0);
    EXPECT_TRUE(map.annotations.sections.empty());
    for (const auto& [metres, cells] : std::vector<std::pair<std::optional<double>, int>>{{{}, 10}, {6.9, 3}, {2, 1}}) {
        const geotiff::LabelTiff cut = import(metres);
        const site::DescribedMap expected = site::split(map.map, map.annotations, {.side = cells});
        EXPECT_TRUE(std::equal(cut.map.labels().begin(), cut.map.labels().end(), expected.map.labels().begin()));
        EXPECT_EQ(cut.annotations.sections, expected.annotations.sections);
        EXPECT_EQ(cut.annotations.names, expected.annotations.names);
        EXPECT_EQ(cut.annotations.kinds, expected.annotations.kinds);
    }
}

TEST_F(ImportedSections, come_back_from_a_file) {
    const geotiff::LabelTiff cut = import(5);
    EXPECT_EQ(geotiff::read_label_tiff(geotiff::label_tiff_bytes(cut), "cut.tif").annotations.sections,
              cut.annotations.sections);
}

TEST_F(ImportedSections, are_none_for_the_paper_unless_asked_for) {
    EXPECT_TRUE(import({}, Profile::paper).annotations.sections.empty());
    EXPECT_FALSE(import(20, Profile::paper).annotations.sections.empty());
}

TEST_F(ImportedSections, have_the_side_of_a_cell_at_least) {
    EXPECT_EQ(input_error([&] { import(1.5); }), "section 1.5: cells have 2 m; give at least that, or none");
}

// A file of one cell with that item.
std::string file_with(const char* item) {
    GDALAllRegister();
    const geotiff::MemoryFile memory;
    GDALDatasetUniquePtr file(
        GetGDALDriverManager()->GetDriverByName("GTiff")->Create(memory.path().c_str(), 1, 1, 1, GDT_Byte, nullptr));
    file->SetMetadataItem("WAYBREAKER_SECTIONS", item);
    file.reset();
    return memory.bytes();
}

TEST(SectionsOfFiles, are_refused_by_their_line) {
    const auto refusal = [](const char* item) {
        return input_error([&] { geotiff::read_label_tiff(file_with(item), "bad.tif"); });
    };
    const std::string what =
        " of its metadata item WAYBREAKER_SECTIONS is no kind, source id and numbers of sections; drop the item with "
        "'gdal_edit.py -mo WAYBREAKER_SECTIONS=' or import the map anew";
    EXPECT_EQ(refusal("building 7 1 2\nbarrier 8"), "bad.tif: line 2" + what);
    for (const char* bad : {"building 7 0", "building x 1", "building 7 1 x", "building", "building 7\tMill"}) {
        EXPECT_EQ(refusal(bad), "bad.tif: line 1" + what) << bad;
    }
    EXPECT_EQ(refusal("building -7 4294967295 1 1\tMill\ncastle 8 1"), "") << "numbers and kinds that nobody knows";
}

}  // namespace
}  // namespace waybreaker::city
