// The paper's method against the figures of its authors' program on city maps (reference/authors_program.csv).
//
// Rows of weight 1 are an oracle; of weight 2 only what comes before the removal (their second search inherits the
// first one's open list). Their flight can be longer than the paper's, never rightly shorter.
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <iostream>
#include <map>
#include <sstream>
#include <tuple>

#include "select/hits.hpp"
#include "share.hpp"
#include "shared_data.hpp"
#include "waybreaker/advanced/flight.hpp"
#include "waybreaker/advanced/search.hpp"
#include "waybreaker/movingai.hpp"

namespace waybreaker {
namespace {

namespace fs = std::filesystem;

struct Row {
    std::string map;
    Cell start;
    Cell goal;
    double weight = 1;
    int removals = 0;
    double ground_before = 0;
    double expanded_before = 0;
    double ground_after = 0;
    double air_after = 0;
    bool ok = false;
};

std::vector<Row> read_rows(const fs::path& file) {
    std::ifstream in(file);
    std::string line;
    std::getline(in, line);
    EXPECT_EQ(line,
              "map,start_x,start_y,goal_x,goal_y,weight,removals,ground_before,expanded_before,nodes_before,"
              "ground_after,uav_after,outcome");
    std::vector<Row> rows;
    while (std::getline(in, line)) {
        std::vector<std::string> fields;
        std::istringstream words(line);
        for (std::string field; std::getline(words, field, ',');) fields.push_back(field);
        if (fields.size() != 13) continue;
        const auto number = [&fields](std::size_t i) { return fields[i].empty() ? 0.0 : std::stod(fields[i]); };
        rows.push_back({.map = fields[0],
                        .start = {int(number(1)), int(number(2))},
                        .goal = {int(number(3)), int(number(4))},
                        .weight = number(5),
                        .removals = int(number(6)),
                        .ground_before = number(7),
                        .expanded_before = number(8),
                        .ground_after = number(10),
                        .air_after = number(11),
                        .ok = fields[12] == "ok"});
    }
    return rows;
}

bool within(double ours, double theirs, double percent) {
    return std::abs(ours - theirs) <= theirs * percent / 100;
}

// City maps and first searches, each made once.
class City {
  public:
    explicit City(const fs::path& folder) : folder_(folder) {}

    const Map& map(const std::string& name) {
        const auto known = maps_.find(name);
        if (known != maps_.end()) return known->second;
        const fs::path file = folder_ / (name + ".map");
        std::ifstream in(file, std::ios::binary);
        return maps_.emplace(name, Map(read_movingai_map(in, file.string()))).first->second;
    }

    const SearchResult& before(const Row& row) {
        const auto [known, is_new] = searches_.try_emplace({row.map, row.start, row.goal, row.weight});
        if (is_new) {
            known->second = searcher_.find(OpenedMap(map(row.map)), row.start, row.goal,
                                           {.weight = row.weight, .count_hits = true});
        }
        return known->second;
    }

    SearchResult after(const Row& row, std::span<const ObstacleId> removed) {
        return searcher_.find(OpenedMap(map(row.map), removed), row.start, row.goal, {.weight = row.weight});
    }

  private:
    fs::path folder_;
    std::map<std::string, Map> maps_;
    std::map<std::tuple<std::string, Cell, Cell, double>, SearchResult> searches_;
    Searcher searcher_;
};

TEST(AuthorsProgram, IsMatched) {
    const auto shared = shared_folder();
    if (!shared || !fs::exists(*shared / "reference" / "authors_program.csv")) GTEST_SKIP() << no_shared_folder;
    City city(*shared / "data" / "cities");
    Share before, expanded, after, nearest, optimal, before_weighted;
    for (const Row& row : read_rows(*shared / "reference" / "authors_program.csv")) {
        if (row.weight != 1 && !row.ok) continue;
        const SearchResult& first = city.before(row);
        if (row.weight != 1) {
            before_weighted.count(within(first.length, row.ground_before, 0.5));
            continue;
        }
        const std::vector<ObstacleId> removed = most_hit(city.map(row.map), first.hits, row.removals);
        before.count(within(first.length, row.ground_before, 0.1));
        expanded.count(within(double(first.expanded), row.expanded_before, 0.5));
        after.count(within(city.after(row, removed).length, row.ground_after, 0.1));
        const Map& map = city.map(row.map);
        nearest.count(fly_nearest(map, row.start, row.goal, removed).length <= row.air_after + 1e-3);
        optimal.count(fly_optimal(map, row.start, row.goal, removed).length <= row.air_after + 1e-3);
    }
    std::cout << "weight 1: length before within 0.1 %:    " << before << '\n'
              << "          expansions within 0.5 %:       " << expanded << '\n'
              << "          length after within 0.1 %:     " << after << '\n'
              << "          nearest flight not above:      " << nearest << '\n'
              << "          optimal flight not above:      " << optimal << '\n'
              << "weight 2: length before within 0.5 %:    " << before_weighted << '\n';
    EXPECT_EQ(before.percent(), 100);
    EXPECT_GE(expanded.percent(), 98);
    EXPECT_GE(after.percent(), 99);
    EXPECT_GE(nearest.percent(), 90);
    EXPECT_GE(optimal.percent(), 98);
    EXPECT_GE(before_weighted.percent(), 99);
}

}  // namespace
}  // namespace waybreaker
