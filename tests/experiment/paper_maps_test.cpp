// The maps of the paper's experiment are what their index says, and its missions fit them.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <sstream>

#include "experiment/experiment.hpp"
#include "experiment/missions.hpp"
#include "io/map_file.hpp"
#include "mapfile/map_reader.hpp"
#include "project_folder.hpp"

namespace waybreaker::experiment {
namespace {

const std::filesystem::path folder = project_folder() / "data" / "paper-maps";

TEST(PaperMaps, AreWhatTheirIndexSays) {
    std::ifstream index(folder / "index.csv");
    std::string line;
    std::getline(index, line);
    EXPECT_EQ(line, "map,source,longitude,latitude,buildings,obstacles,blocked_percent");
    int count = 0;
    for (; std::getline(index, line); ++count) {
        const std::string name = line.substr(0, line.find(','));
        const io::MapFile file = mapfile::read_map_file(folder / (name + ".tif"));
        EXPECT_EQ(file.map.width(), 501) << name;
        EXPECT_EQ(file.map.height(), 501) << name;
        EXPECT_DOUBLE_EQ(file.cell_size, 2.4) << name;
        EXPECT_NE(file.annotations.attribution.find("OpenStreetMap contributors"), std::string::npos) << name;
        std::size_t blocked = 0;
        for (const Obstacle& obstacle : file.map.obstacles()) blocked += obstacle.cells;
        const std::string figures =
            fmt::format(",{},{:.1f}", file.map.obstacles().size(), 100.0 * double(blocked) / (501 * 501));
        EXPECT_TRUE(line.ends_with(figures)) << line << " should end with " << figures;
    }
    EXPECT_EQ(count, 100);
}

TEST(PaperMaps, HaveTheMissionsThatTheirCommandDraws) {
    const Experiment experiment = read_experiment(folder / "paper.toml");
    EXPECT_EQ(experiment.missions.size(), 2209U);
    const std::string name = "monaco-02.tif";
    std::vector<Cell> listed;
    for (const ExperimentMission& mission : experiment.missions) {
        if (experiment.maps[mission.map].name == name) listed.push_back(mission.start());
    }
    std::vector<Cell> drawn;
    for (const Scenario& mission : draw_missions(mapfile::read_map_file(folder / name).map, {}).kept) {
        drawn.push_back(mission.start);
    }
    EXPECT_EQ(listed, drawn);
    EXPECT_FALSE(drawn.empty());
}

}  // namespace
}  // namespace waybreaker::experiment
