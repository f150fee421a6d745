// OpenStreetMap's data as features: which areas, which lines, in which order, and what is missing.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "osm/features.hpp"
#include "temporary_folder.hpp"

namespace waybreaker::osm {
namespace {

// XML of nodes at whole places of a grid: the node of column 3 in row 4 has the id 304.
class Town {
  public:
    Town& way(std::int64_t id, const std::vector<int>& nodes, const std::string& tags = "") {
        std::string refs;
        for (const int node : nodes) refs += "<nd ref='" + std::to_string(node) + "'/>";
        ways_ += "<way id='" + std::to_string(id) + "' version='1'>" + refs + xml(tags) + "</way>\n";
        for (const int node : nodes) add(node);
        return *this;
    }
    // Members such as "outer 1" or "inner 2".
    Town& relation(std::int64_t id, const std::vector<std::pair<std::string, int>>& ways, const std::string& tags) {
        std::string members;
        for (const auto& [role, way] : ways) {
            members += "<member type='way' ref='" + std::to_string(way) + "' role='" + role + "'/>";
        }
        relations_ += "<relation id='" + std::to_string(id) + "' version='1'>" + members +
                      xml("type=multipolygon|" + tags) + "</relation>\n";
        return *this;
    }
    Town& without(int node) {
        std::erase(nodes_, node);
        missing_.push_back(node);
        return *this;
    }
    std::string text() const {
        std::string nodes;
        for (const int node : nodes_) {
            nodes += "<node id='" + std::to_string(node) + "' version='1' lon='" + std::to_string(node / 100) +
                     "' lat='" + std::to_string(node % 100) + "'/>\n";
        }
        return "<osm version='0.6'>\n" + nodes + ways_ + relations_ + "</osm>\n";
    }

  private:
    void add(int node) {
        const bool known = std::ranges::find(nodes_, node) != nodes_.end();
        const bool missing = std::ranges::find(missing_, node) != missing_.end();
        if (!known && !missing) nodes_.push_back(node);
    }
    static std::string xml(const std::string& tags) {
        std::string text;
        for (std::size_t begin = 0; begin < tags.size();) {
            const std::size_t equals = tags.find('=', begin);
            const std::size_t end = std::min(tags.find('|', begin), tags.size());
            text += "<tag k='" + tags.substr(begin, equals - begin) + "' v='" +
                    tags.substr(equals + 1, end - equals - 1) + "'/>";
            begin = end + 1;
        }
        return text;
    }

    std::vector<int> nodes_;
    std::vector<int> missing_;
    std::string ways_;
    std::string relations_;
};

double area_of(const Line& ring) {
    double twice = 0;
    for (std::size_t i = 1; i < ring.size(); ++i) {
        twice += ring[i - 1].longitude * ring[i].latitude - ring[i].longitude * ring[i - 1].latitude;
    }
    return std::abs(twice) / 2;
}

// Square degrees.
double area_of(const Feature& feature) {
    double area = 0;
    for (const Polygon& polygon : feature.polygons) {
        area += area_of(polygon.front());
        for (std::size_t i = 1; i < polygon.size(); ++i) area -= area_of(polygon[i]);
    }
    return area;
}

struct Found {
    std::vector<Feature> features;
    std::vector<CutArea> cut;
    Report report;
};

class Visits : public TemporaryFolder {
  protected:
    static Query everything() { return {Keys(), Keys(), Keys()}; }

    Found found_in(const Town& town, const Query& query = everything()) const {
        put("town.osm", town.text());
        return found_in(File{path("town.osm"), "osm"}, query);
    }
    static Found found_in(const File& file, const Query& query = everything()) {
        Found found;
        found.report = visit(file, query,
                             {[&](Feature feature) { found.features.push_back(std::move(feature)); },
                              [&](CutArea area) { found.cut.push_back(std::move(area)); }});
        return found;
    }
    // "area 7 9.0" or "line 7" for each feature.
    static std::vector<std::string> words_of(const Found& found) {
        std::vector<std::string> words;
        for (const Feature& feature : found.features) {
            const std::string id = std::to_string(feature.source_id);
            words.push_back(feature.shape == Shape::area   ? "area " + id + " " + std::to_string(int(area_of(feature)))
                            : feature.shape == Shape::line ? "line " + id
                                                           : "point " + id);
        }
        return words;
    }
};

using Words = std::vector<std::string>;

const std::vector<int> square{101, 104, 404, 401, 101};  // of 9 square degrees

TEST_F(Visits, ClosedWaysAreAreasOrLinesByTheirTags) {
    const auto shapes = [this](const std::string& tags) {
        std::string letters;
        for (const Feature& feature : found_in(Town().way(7, square, tags)).features) {
            letters += feature.shape == Shape::area ? 'a' : 'l';
        }
        return letters;
    };
    for (const char* const area : {"building=yes",
                                   "natural=water",
                                   "landuse=forest",
                                   "leisure=park",
                                   "amenity=school",
                                   "waterway=riverbank",
                                   "waterway=dock",
                                   "waterway=boatyard",
                                   "waterway=dam",
                                   "man_made=pier",
                                   "man_made=storage_tank",
                                   "area=yes",
                                   "highway=pedestrian|area=yes",
                                   "highway=service|area=yes",
                                   "barrier=hedge|area=yes",
                                   "landuse=basin|barrier=fence",
                                   "public_transport=platform|railway=platform",
                                   "aeroway=runway",
                                   "power=substation",
                                   "historic=castle"}) {
        EXPECT_EQ(shapes(area), "a") << area;
    }
    for (const char* const line :
         {"highway=residential", "highway=pedestrian", "railway=rail", "waterway=river", "waterway=ditch",
          "natural=coastline", "natural=cliff", "barrier=wall", "barrier=fence", "man_made=embankment", "leisure=track",
          "landuse=forest|area=no", "historic=citywalls", "building=no", "name=Ring", "highway=service|emergency=yes",
          "highway=residential|emergency=designated"}) {
        EXPECT_EQ(shapes(line), "l") << line;
    }
    for (const char* const both : {"highway=footway|leisure=park", "natural=water|waterway=river"}) {
        EXPECT_EQ(shapes(both), "al") << both;
    }
    EXPECT_EQ(words_of(found_in(Town().way(7, {101, 104, 404, 401}, "building=yes"))), Words{"line 7"});
}

TEST_F(Visits, WaysCloseAlsoWhereTwoNodesAreInOnePlace) {
    std::string text = Town().way(7, {101, 104, 404, 401, 2020}, "building=yes").text();
    const std::string last = "lon='20' lat='20'";
    text.replace(text.find(last), last.size(), "lon='1' lat='1'");
    EXPECT_EQ(words_of(found_in(File{put("place.osm", text), "osm"})), Words{"area 7 9"});
}

TEST_F(Visits, RelationsComeFirstThenWaysInTheirOrder) {
    const Town town = Town()
                          .way(9, {501, 504, 804, 801, 501}, "building=yes")
                          .way(1, {101, 104, 404})
                          .way(2, {404, 401, 101})
                          .way(8, {901, 902, 903}, "highway=path")
                          .relation(6, {{"outer", 1}, {"outer", 2}}, "natural=water")
                          .relation(5, {{"outer", 9}}, "landuse=grass");
    EXPECT_EQ(words_of(found_in(town)), (Words{"area -6 9", "area -5 9", "area 9 9", "line 1", "line 2", "line 8"}));
    // Also where ways come before their nodes.
    std::string text = town.text();
    const std::size_t ways = text.find("<way");
    const std::size_t end = text.find("<relation");
    const std::string moved = text.substr(ways, end - ways);
    text.erase(ways, end - ways).insert(text.find("<node"), moved);
    EXPECT_EQ(words_of(found_in(File{put("moved.osm", text), "osm"})), words_of(found_in(town)));
}

TEST_F(Visits, HolesTouchingRingsAndSeveralOuterRings) {
    Town town;
    town.way(1, {101, 110, 1010, 1001, 101});     // 81
    town.way(2, {202, 204, 404, 402, 202});       // a hole of 4
    town.way(3, {404, 406, 606, 604, 404});       // another, which touches it
    town.way(4, {606, 608, 808, 806, 606});       // and one whose role is wrong
    town.way(5, {2001, 2003, 2203, 2201, 2001});  // another outer ring of 4
    town.relation(7, {{"outer", 1}, {"inner", 2}, {"inner", 3}, {"outer", 4}, {"", 5}}, "natural=water");
    const Found found = found_in(town, {.areas = Keys{{"natural"}}});
    EXPECT_EQ(words_of(found), Words{"area -7 73"});
    EXPECT_EQ(found.features.at(0).polygons.size(), 2U);
}

TEST_F(Visits, MembersOfOtherRolesBoundNothing) {
    const Town town = Town()
                          .way(1, square, "building=yes")
                          .way(2, {101, 102, 402, 401, 101}, "building:part=yes")
                          .relation(7, {{"outer", 1}, {"part", 2}, {"outline", 4711}}, "building=yes");
    EXPECT_EQ(words_of(found_in(town, {.areas = Keys{{"building"}}})), Words{"area -7 9"});
}

TEST_F(Visits, RingsThatCrossAreFilledByTurns) {
    const Town town = Town().way(1, {101, 404, 401, 104, 101}).relation(7, {{"outer", 1}}, "natural=water");
    const Found found = found_in(town, {.areas = Keys{{"natural"}}});
    ASSERT_EQ(words_of(found).size(), 1U);
    EXPECT_EQ(found.features.at(0).polygons.at(0).size(), 1U);
    EXPECT_TRUE(found.cut.empty());
    EXPECT_EQ(found.report.defects.crossing, std::vector<std::int64_t>{-7});
    EXPECT_TRUE(found_in(town, {.areas = Keys{{"building"}}}).report.defects.crossing.empty());
}

TEST_F(Visits, RelationsSpeakForTheirOuterWays) {
    const Query areas{.areas = Keys()};
    const auto of = [&](const std::string& way, const std::string& relation) {
        return words_of(found_in(Town().way(1, square, way).relation(7, {{"outer", 1}}, relation), areas));
    };
    const Words only{"area -7 9"};
    const Words both{"area -7 9", "area 1 9"};
    EXPECT_EQ(of("building=yes", "source=survey"), only);  // as they were drawn once
    EXPECT_EQ(of("building=yes", "building=school"), only);
    EXPECT_EQ(of("natural=water", "natural=water"), only);
    EXPECT_EQ(of("building=yes", "landuse=retail"), both);
    EXPECT_EQ(of("natural=water", "natural=wood"), both);
    EXPECT_EQ(of("building=yes|amenity=school", "building=yes"), both);
    const Found found = found_in(Town().way(1, square, "building=yes").relation(7, {{"outer", 1}}, ""), areas);
    EXPECT_EQ(found.features.at(0).tags, (Tags{{"building", "yes"}}));
}

TEST_F(Visits, RelationsThatAreCutGiveTheirLines) {
    const Town town = Town()
                          .way(1, {101, 104, 404})
                          .way(2, {201, 202, 302})
                          .way(3, {601, 604, 904})
                          .relation(7, {{"outer", 1}, {"outer", 4711}, {"inner", 2}}, "natural=water|name=Elbe")
                          .relation(8, {{"outer", 3}}, "natural=water");  // all there, and open
    const Found found = found_in(town, {.areas = Keys{{"natural"}}});
    EXPECT_TRUE(found.features.empty());
    ASSERT_EQ(found.cut.size(), 2U);
    EXPECT_EQ(found.cut[0].source_id, -7);
    ASSERT_EQ(found.cut[0].outer.size(), 1U);
    EXPECT_EQ(found.cut[0].outer[0].front().latitude, 1);  // in the direction of the source
    EXPECT_EQ(found.cut[0].outer[0].back().longitude, 4);
    EXPECT_EQ(found.cut[0].inner.size(), 1U);
    EXPECT_EQ(found.cut[1].source_id, -8);
    EXPECT_TRUE(found_in(town, {.areas = Keys{{"building"}}}).cut.empty());
}

TEST_F(Visits, WaysThatLackNodesAreWhatIsLeftAndReported) {
    const Found found = found_in(Town().without(404).way(7, square, "building=yes").way(8, {701, 702}, "highway=path"));
    EXPECT_EQ(words_of(found), (Words{"area 7 4", "line 8"}));  // 4.5
    EXPECT_EQ(found.report.defects.lacking_nodes, std::vector<std::int64_t>{7});
    // Where the first one is missing the ring closes all the same.
    const Found first = found_in(Town().without(101).way(7, square, "building=yes"));
    EXPECT_EQ(words_of(first), Words{"area 7 4"});
}

TEST_F(Visits, OnlyWhatIsAskedFor) {
    const Town town = Town()
                          .way(1, square, "building=yes")
                          .way(2, {2001, 2004, 2304, 2301, 2001}, "building=yes")
                          .way(3, {0, 3030}, "highway=path")
                          .way(4, {2001, 2002, 2102}, "natural=cliff");
    EXPECT_EQ(words_of(found_in(town, {.areas = Keys{{"building"}}})), (Words{"area 1 9", "area 2 9"}));
    EXPECT_EQ(words_of(found_in(town, {.lines = Keys{{"highway", "waterway"}}})), Words{"line 3"});
    Query near = everything();
    near.box = Box{2, 2, 3, 3};  // within the square, and without a node of what crosses it
    EXPECT_EQ(words_of(found_in(town, near)), (Words{"area 1 9", "line 3"}));
}

TEST_F(Visits, WhatIsDeletedInJosmIsLeftOut) {
    const auto found_by = [this](const std::string& generator) {
        std::string text = Town().way(1, square, "building=yes").way(2, square, "natural=water").text();
        const auto replace = [&](const std::string& was, const std::string& is) {
            text.replace(text.find(was), was.size(), is);
        };
        replace("<way id='2'", "<way id='2' action='delete' visible='true'");
        replace("<way id='1'", "<way id='1' action='modify' visible='true'");
        replace("<node id='404'", "<node id='404' action='delete'");
        replace("<osm ", "<osm generator='" + generator + "' ");
        put("edited.osm", text);
        return words_of(found_in(File{path("edited.osm"), "osm"}));
    };
    EXPECT_EQ(found_by("JOSM"), Words{"area 1 4"});  // without its deleted node
    EXPECT_EQ(found_by("another"), (Words{"area 1 9", "area 2 9"}));
}

TEST_F(Visits, DamagedFilesAreErrors) {
    const std::string text = Town().way(1, square, "building=yes").text();
    const auto fails = [&](const std::string& bytes, const std::string& format) {
        EXPECT_THROW(found_in(File{put("bad", bytes), format}), ReadError) << bytes.substr(0, 60);
    };
    fails(text.substr(0, text.size() / 2), "osm");
    fails("<osm version='0.5'></osm>", "osm");
    fails("<osm version='0.6'><node id='x'/></osm>", "osm");
    fails("<osm version='0.6'><node id='1' lat='1' lon='east'/></osm>", "osm");
    fails("<osm version='0.6'><node id='99999999999999999999'/></osm>", "osm");
    fails("<osm version='0.6'><node id='1' version='1'><tag k='name' v='" + std::string(5000, 'x') + "'/></node></osm>",
          "osm");
    fails(std::string("\0\0\0\x0d\x0a\x09OSMHeader\x18\x7f", 17) + std::string(300, '\xfe'), "pbf");
    fails("\xff\xe0\x04o5m2\xff\x10\x7f", "o5m");
    // Coordinates that lie nowhere are none.
    EXPECT_TRUE(found_in(File{put("far.osm",
                                  "<osm version='0.6'><node id='1' version='1' lat='99' lon='1'><tag k='place' "
                                  "v='town'/></node></osm>"),
                              "osm"})
                    .features.empty());
}

}  // namespace
}  // namespace waybreaker::osm
