#include "experiment/report.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <map>

#include "core/random.hpp"
#include "experiment/estimate.hpp"
#include "experiment/figures.hpp"
#include "mapfile/map_reader.hpp"
#include "small_experiment.hpp"
#include "waybreaker/planner.hpp"

namespace waybreaker::experiment {
namespace {

TEST(Estimate, IsTheMeanWithTheIntervalOfItsMaps) {
    // One mission a map: the textbook interval, here mean 3, standard deviation 1.5811, 5 values, t = 2.7764.
    Estimator plain(7);
    for (const std::size_t i : {0U, 1U, 2U, 3U, 4U}) plain.add(i + 1, double(i) + 1);
    const Estimate estimate = plain.estimate();
    EXPECT_DOUBLE_EQ(estimate.mean, 3);
    EXPECT_NEAR(estimate.high - estimate.mean, 2.7764 * 1.58114 / std::sqrt(5), 1e-4);
    EXPECT_NEAR(estimate.mean - estimate.low, estimate.high - estimate.mean, 1e-12);
    EXPECT_EQ(estimate.count, 5U);
    // Repeating the same missions three times on each map adds no information.
    Estimator thrice(5);
    for (const std::size_t i : {0U, 1U, 2U, 3U, 4U}) {
        for (int k = 0; k < 3; ++k) thrice.add(i, double(i) + 1);
    }
    EXPECT_NEAR(thrice.estimate().high, estimate.high, 1e-12);
    Estimator one(1);
    one.add(0, 4);
    EXPECT_EQ(one.estimate().low, one.estimate().high);
    EXPECT_EQ(Estimator(3).estimate().count, 0U);
}

TEST(Estimate, CoversTheTruthInNinetyFiveOfAHundredCases) {
    Random random(11);
    int covered = 0;
    constexpr int cases = 2000;
    for (int i = 0; i < cases; ++i) {
        Estimator estimator(20);
        for (std::size_t map = 0; map < 20; ++map) {
            const double of_map = random.below(1001) - 500;  // mean 0, shared by the map's missions
            for (int k = 0; k < 8; ++k) estimator.add(map, of_map + random.below(101) - 50);
        }
        const Estimate estimate = estimator.estimate();
        covered += estimate.low <= 0 && 0 <= estimate.high ? 1 : 0;
    }
    EXPECT_NEAR(double(covered) / cases, 0.95, 0.02);
}

TEST(Estimate, KnowsStudentsDistribution) {
    EXPECT_NEAR(student_95(11), 2.2010, 1e-3);
    EXPECT_NEAR(student_95(30), 2.0423, 1e-3);
    EXPECT_NEAR(student_95(99), 1.9842, 1e-3);
    EXPECT_NEAR(student_95(1'000'000), 1.95996, 1e-4);
}

class Report : public SmallExperiment {
  protected:
    Report() {
        run_into("r.db");
        Results results(path("r.db"));
        files = report(summarise(results));
    }
    std::string file(const std::string& name) const {
        const auto found = std::ranges::find(files, name, &ReportFile::name);
        return found == files.end() ? "" : found->bytes;
    }
    // The part of the page on a figure.
    std::string section(const std::string& figure) const {
        const std::string page = file("index.html");
        const std::size_t begin = page.find("<h2 id=\"" + figure + "\"");
        return begin == std::string::npos ? "" : page.substr(begin, page.find("<h2", begin + 1) - begin);
    }
    std::string row(const std::string& figure, const std::string& series) const {
        const std::string text = section(figure);
        const std::size_t begin = text.find("<tr><td>" + series + "</td>");
        return begin == std::string::npos ? "" : text.substr(begin, text.find("</tr>", begin) - begin);
    }
    // The number in a cell of a row; the series' name stands before them.
    static double shown(const std::string& row, int number) {
        std::size_t at = row.find("<td>");
        for (int i = 0; i <= number && at != std::string::npos; ++i) at = row.find("<td>", at + 1);
        return at == std::string::npos ? NAN : std::strtod(row.c_str() + at + 4, nullptr);
    }

    std::vector<ReportFile> files;
};

// Two maps of one place say nothing of how places differ; without places they are two.
TEST_F(Report, TakesPlacesForIndependent) {
    const auto flowtime = [&] {
        Results results(path("r.db"));
        const Summary summary = summarise(results);
        return std::pair(summary.all, *summary.all.series.front().of(Measure::flowtime, 0));
    };
    const auto [apart, of_maps] = flowtime();
    EXPECT_EQ(apart.maps, 2U);
    EXPECT_EQ(apart.places, 2U);
    EXPECT_LT(of_maps.low, of_maps.mean);
    EXPECT_EQ(file("index.html").find("places,"), std::string::npos);

    experiment = read_experiment(put("small.toml", "places = '*.map'\n" + std::string(spec)));
    EXPECT_EQ(run_into("r.db").begun_with, 72U) << "the results are the same";
    const auto [together, of_places] = flowtime();
    EXPECT_EQ(together.maps, 2U);
    EXPECT_EQ(together.places, 1U);
    EXPECT_EQ(of_places.mean, of_maps.mean);
    EXPECT_EQ(of_places.low, of_places.mean);
    Results results(path("r.db"));
    EXPECT_NE(report(summarise(results)).back().bytes.find("on 2 maps of one place,"), std::string::npos);
}

// Asked of the database itself, by its own means: over missions that no configuration left unsolved.
TEST_F(Report, SaysWhatTheDatabaseSays) {
    SQLite::Database sql(path("r.db"));
    const std::string compared =
        "mission NOT IN (SELECT mission FROM rows WHERE status != 'solved' OR before_makespan IS NULL)";
    EXPECT_EQ(sql.execAndGet("SELECT count(DISTINCT mission) FROM rows WHERE " + compared).getInt(), 4);
    const std::map<std::string, std::string> measures{
        {"figure-3-nodes", "_expanded"},
        {"figure-4-runtime", "_seconds * 1000"},
        {"figure-6-flowtime", "_flowtime"},
        {"figure-7-makespan",
         "_makespan * 100 / sqrt((goal_x - start_x) * (goal_x - start_x) + (goal_y - start_y) * (goal_y - start_y))"}};
    const std::map<std::string, std::string> series{{"paper, w = 1", "method = 'paper' AND weight = 1"},
                                                    {"paper, w = 2", "method = 'paper' AND weight = 2"},
                                                    {"exact", "method = 'exact'"},
                                                    {"greedy", "method = 'greedy'"}};
    int numbers = 0;
    for (const auto& [figure, column] : measures) {
        for (const auto& [name, condition] : series) {
            for (const int n : {0, 1, 2}) {
                const std::string query =
                    fmt::format("SELECT avg({}{}) FROM rows WHERE {} AND removals = {} AND {}",
                                n == 0 ? "before" : "after", column, condition, std::max(n, 1), compared);
                const double mean = sql.execAndGet(query).getDouble();
                // Times before removal were measured in every configuration; the page has those of the first.
                if (figure == "figure-4-runtime" && n == 0) continue;
                // Four digits are shown.
                EXPECT_NEAR(shown(row(figure, name), n), mean, 5.1e-4 * mean) << figure << " " << name << " " << n;
                ++numbers;
            }
        }
    }
    EXPECT_EQ(numbers, 44);
}

TEST_F(Report, IsOnePageAndTheFiguresAsPictures) {
    const std::string page = file("index.html");
    for (const char* figure : {"figure-3-nodes", "figure-4-runtime", "figure-4b-whole-mission", "figure-5-lengths",
                               "figure-6-flowtime", "figure-7-makespan"}) {
        EXPECT_TRUE(file(std::string(figure) + ".png").starts_with("\x89PNG")) << figure;
        // What the picture draws, without the title, which is the page's heading.
        const std::string svg = file(std::string(figure) + ".svg");
        EXPECT_NE(page.find(svg.substr(svg.find("</text>") + 7)), std::string::npos) << "the page holds " << figure;
    }
    EXPECT_EQ(files.size(), 13U) << "one set has no conjecture";
    for (const char* foreign : {"src=", "<link", "<script", "url("}) EXPECT_EQ(page.find(foreign), std::string::npos);
    EXPECT_NE(page.find("6 missions; every mean is over the 4 of them, on 2 maps"), std::string::npos);
    EXPECT_NE(page.find("3 to 4 removed obstacles are best"), std::string::npos);
    EXPECT_EQ(page.find(">Makespan, the longer path (figure 7)</text>"), std::string::npos) << "titles stand once";
}

TEST(FourDigits, AreAllThatIsShown) {
    const std::map<double, std::string> texts{{0, "0"},          {123.456, "123.5"},   {0.0123456, "0.01235"},
                                              {9999.6, "10000"}, {1234567, "1235000"}, {-5, "-5"},
                                              {1e-9, "1e-09"}};
    for (const auto& [value, text] : texts) EXPECT_EQ(four_digits(value), text);
}

TEST_F(Report, ComparesSetsOfMissions) {
    std::filesystem::copy(path("cities.scen"), path("mazes.scen"));
    const std::string text = spec;
    put("two.toml", "name = '<b>&'\nmissions = ['cities.scen', 'mazes.scen']\n" + text.substr(text.find("[[run]]")));
    experiment = read_experiment(path("two.toml"));
    run_into("two.db");
    Results results(path("two.db"));
    files = report(summarise(results));
    EXPECT_NE(section("conjecture").find("<th>cities</th><th>mazes</th>"), std::string::npos);
    EXPECT_NE(file("index.html").find("<h1>&lt;b&gt;&amp;</h1>"), std::string::npos);
}

TEST_F(Report, OfNothingIsStillAPage) {
    experiment.missions.resize(5);
    experiment.missions.erase(experiment.missions.begin(), experiment.missions.begin() + 4);  // ends in a wall
    experiment.digest = "one";
    run_into("one.db");
    Results results(path("one.db"));
    files = report(summarise(results));
    EXPECT_NE(file("index.html").find("1 missions; every mean is over the 0 of them"), std::string::npos);
    EXPECT_EQ(file("index.html").find("nan"), std::string::npos);
}

class TeamReport : public SmallExperiment {
  protected:
    TeamReport() {
        const auto row = [](const char* more) {
            return std::string(R"({"format": "waybreaker-mission/1", "map": "street.map", "agents": [)") +
                   R"({"id": "a", "kind": "ground", "start": [1, 3], "goal": [11, 3]},)" +
                   R"({"id": "b", "kind": "ground", "start": [0, 5], "goal": [11, 5]})" + more +
                   R"(], "rules": {"objective": "flowtime"}})" + "\n";
        };
        const char* const air = R"(,{"id": "x", "kind": "air", "start": [1, 3], "goal": [1, 3]})";
        const char* const in_wall = R"(,{"id": "c", "kind": "ground", "start": [3, 3], "goal": [11, 0]})";
        put("teams.jsonl", row(air) + row("") + row(in_wall));
        experiment = read_experiment(
            put("teams.toml", "missions = 'teams.jsonl'\n[[run]]\nmethods = ['exact', 'none']\nremovals = 1\n"));
        run_into("r.db");
    }
};

TEST_F(TeamReport, ShowsWhatTeamsReachByTheirSize) {
    Results results(path("r.db"));
    const Summary summary = summarise(results);
    const TeamSummary& teams = summary.teams;
    EXPECT_EQ(teams.sizes, (std::vector<std::string>{"2+0", "2+1", "3+0"}));
    EXPECT_EQ(teams.missions, 3U);
    EXPECT_EQ(teams.compared, 2U);
    ASSERT_EQ(teams.series.size(), 2U);
    EXPECT_EQ(teams.series[0].name, "exact, 1 removal");
    EXPECT_EQ(teams.series[1].name, "no removal");
    EXPECT_EQ(teams.series[0].of(TeamMeasure::solved, 1)->mean, 100);
    EXPECT_EQ(teams.series[0].of(TeamMeasure::solved, 2)->mean, 0) << "one starts in a wall";
    EXPECT_FALSE(teams.series[0].of(TeamMeasure::gap, 2).has_value());
    Mission mission = results.experiment().missions[0].mission;
    mission.rules.removals = 1;
    const Plan plan = Planner().plan(mapfile::read_map_file(path("street.map")).map, mission);
    ASSERT_EQ(plan.breaches.size(), 1U);
    EXPECT_NEAR(teams.series[0].of(TeamMeasure::flowtime, 1)->mean, 100 * *plan.after.flowtime / *plan.before.flowtime,
                1e-9);
    EXPECT_NEAR(teams.series[0].of(TeamMeasure::gap, 1)->mean, 100 * *plan.gap, 1e-9);
    EXPECT_NE(teams.series[0].of(TeamMeasure::flowtime, 1)->mean, teams.series[1].of(TeamMeasure::flowtime, 1)->mean);
    EXPECT_EQ(summary.all.missions, 0U) << "the paper's figures are of pairs";
    std::vector<std::string> names;
    for (const ReportFile& file : report(summary)) names.push_back(file.name);
    EXPECT_EQ(names, (std::vector<std::string>{"team-gap.svg", "team-gap.png", "team-time.svg", "team-time.png",
                                               "team-success.svg", "team-success.png", "team-flowtime.svg",
                                               "team-flowtime.png", "index.html"}));
}

}  // namespace
}  // namespace waybreaker::experiment
