// Which cells of a map are ways for whom it was made.
#include <gtest/gtest.h>

#include <string>

#include "city/town_ground.hpp"

namespace waybreaker::city {
namespace {

class Ways : public TownGround {
  protected:
    // = for ways, else as the ground is drawn.
    std::string ways(std::optional<Profile> profile = {}) const {
        ImportOptions options = town_window;
        options.profile = profile;
        const geotiff::LabelTiff tiff = import(drawing_, options).tiff;
        std::string text = picture(tiff);
        for (const auto& [first, length] : tiff.annotations.ways) {
            const std::size_t begin = std::size_t(first.y) * std::size_t(tiff.map.width() + 1) + std::size_t(first.x);
            for (std::size_t i = begin; i < begin + std::size_t(length); ++i) {
                EXPECT_EQ(text.at(i), '.') << i;
                text[i] = '=';
            }
        }
        return text;
    }
};

TEST_F(Ways, are_as_wide_as_they_are_and_car_parks) {
    drawing_.way("highway=residential|width=6", {{-1, 2}, {14, 2}});
    drawing_.way("highway=path|width=1", {{3, 2}, {3, 14}});
    drawing_.way("highway=service|access=private|width=6", {{-1, 12}, {1, 12}});
    drawing_.area("amenity=parking", box(7.6, 4.6, 11.4, 6.4));
    drawing_.area("building=yes", box(9.6, 5.6, 11.4, 6.4));
    EXPECT_EQ(ways(),
              "B.............\n"
              "==============\n"
              "==============\n"
              "==============\n"
              "...=..........\n"
              "...=....====..\n"
              "...=....==BB..\n"
              "...=..........\n"
              "...=..........\n"
              "...=..........\n"
              "...=..........\n"
              "xxx=..........\n"
              "xxx=..........\n"
              "xxx=..........\n");
}

TEST_F(Ways, lead_over_bridges_and_through_houses) {
    drawing_.area("natural=water", box(-1, 4.6, 14, 8.4));
    drawing_.way("highway=residential|bridge=yes|width=6", {{6, 2}, {6, 11}});
    drawing_.area("building=yes", box(0.6, 9.6, 4.4, 13.4));
    drawing_.way("highway=footway|tunnel=building_passage|width=1", {{-1, 12}, {6, 12}});
    const std::string bridge = "wwwww===wwwwww\n";
    const std::string seen = ways();
    EXPECT_EQ(seen.substr(5 * 15, 60), bridge + bridge + bridge + bridge) << seen;
    EXPECT_EQ(seen.substr(12 * 15, 6), "======") << seen;
    EXPECT_EQ(seen.substr(11 * 15, 4), ".BBB") << seen;
}

TEST_F(Ways, of_trucks_are_roads) {
    drawing_.way("highway=residential|width=6", {{-1, 2}, {14, 2}});
    drawing_.way("highway=footway", {{3, 2}, {3, 14}});
    const std::string seen = ways(Profile::truck);
    EXPECT_EQ(seen.substr(2 * 15, 15), "==============\n") << seen;
    EXPECT_EQ(seen.substr(12 * 15, 15), "--------------\n") << seen;
}

TEST_F(Ways, are_not_known_to_the_paper) {
    drawing_.way("highway=residential|width=6", {{-1, 2}, {14, 2}});
    ImportOptions options = town_window;
    options.profile = Profile::paper;
    EXPECT_TRUE(import(drawing_, options).tiff.annotations.ways.empty());
}

}  // namespace
}  // namespace waybreaker::city
