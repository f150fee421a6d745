#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <sstream>

#include "input_error.hpp"
#include "waybreaker/movingai.hpp"

namespace waybreaker {
namespace {

TEST(WriteScenarios, HasTheColumnsOfThePublishedFiles) {
    const Scenario scenario{.bucket = 3,
                            .map = "maps/Berlin_0_512.map",
                            .width = 512,
                            .height = 256,
                            .start = {1, 2},
                            .goal = {30, 4},
                            .optimal_length = 29.82842712};
    EXPECT_EQ(movingai_scenarios({&scenario, 1}),
              "version 1\n3\tmaps/Berlin_0_512.map\t512\t256\t1\t2\t30\t4\t29.82842712\n");
    EXPECT_EQ(movingai_scenarios({}), "version 1\n");
}

RC_GTEST_PROP(WriteScenarios, AreReadAsTheyWereWritten, ()) {
    const auto below = [](int limit) { return *rc::gen::inRange(0, limit); };
    std::vector<Scenario> scenarios(std::size_t(below(20)));
    for (Scenario& scenario : scenarios) {
        scenario.bucket = below(1000);
        scenario.map = *rc::gen::nonEmpty(rc::gen::container<std::string>(rc::gen::inRange('!', '~')));
        scenario.width = 1 + below(max_side);
        scenario.height = 1 + below(max_side);
        scenario.start = {below(scenario.width), below(scenario.height)};
        scenario.goal = {below(scenario.width), below(scenario.height)};
        scenario.optimal_length = below(1'000'000'000) / 1000.0;
    }
    const std::vector<Scenario> read = read_movingai_scenarios(movingai_scenarios(scenarios), "made.scen");
    RC_ASSERT(read.size() == scenarios.size());
    for (std::size_t i = 0; i < read.size(); ++i) {
        RC_ASSERT(read[i].bucket == scenarios[i].bucket);
        RC_ASSERT(read[i].map == scenarios[i].map);
        RC_ASSERT(read[i].width == scenarios[i].width);
        RC_ASSERT(read[i].height == scenarios[i].height);
        RC_ASSERT(read[i].start == scenarios[i].start);
        RC_ASSERT(read[i].goal == scenarios[i].goal);
        RC_ASSERT(std::abs(read[i].optimal_length - scenarios[i].optimal_length) <= 5e-9);
    }
}

TEST(WriteScenarios, RefuseNamesThatWouldNotBeReadAgain) {
    for (const char* name : {"", "old town.map", "a\tb.map", "a\nb.map"}) {
        Scenario scenario;
        scenario.map = name;
        EXPECT_THROW(movingai_scenarios({&scenario, 1}), InputError) << name;
    }
}

}  // namespace
}  // namespace waybreaker
