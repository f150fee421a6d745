#include "experiment/spec.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "experiment/places.hpp"
#include "input_error.hpp"
#include "small_experiment.hpp"

namespace waybreaker::experiment {
namespace {

TEST(Spec, MultipliesTheListsOfARun) {
    const Spec spec = parse_spec(
        "name = 'both'\nmissions = ['a.scen', 'b.scen']\ntime_limit = 2.5\n"
        "[[run]]\nmethods = ['paper', 'none']\nweights = [1, 2]\nremovals = [1, 3]\n"
        "[[run]]\nmethods = 'exact'\nremovals = 0\n",
        "s.toml");
    EXPECT_EQ(spec.name, "both");
    EXPECT_EQ(spec.missions, (std::vector<std::string>{"a.scen", "b.scen"}));
    EXPECT_EQ(spec.time_limit, 2.5);
    const std::vector<Configuration> expected{
        {Method::paper, Algorithm::theta, 1, 1},  {Method::paper, Algorithm::theta, 1, 3},
        {Method::paper, Algorithm::theta, 2, 1},  {Method::paper, Algorithm::theta, 2, 3},
        {Method::none, Algorithm::theta, 1, 0},   {Method::none, Algorithm::theta, 2, 0},
        {Method::exact, Algorithm::optimal, 1, 0}};
    EXPECT_EQ(spec.configurations, expected);
}

TEST(Spec, SaysWhatIsWrongAndWhere) {
    const auto message = [](const std::string& text) { return input_error([&] { parse_spec(text, "s.toml"); }); };
    const auto run = [&](const std::string& text) { return message("missions = 'a.scen'\n[[run]]\n" + text); };
    EXPECT_TRUE(message("missions = 'a.scen'\nname = \n").starts_with("s.toml:2: not TOML: "));
    EXPECT_EQ(message("mission = 'a.scen'\n"),
              "s.toml:1: unknown key 'mission': use name, missions, time_limit, places, run");
    EXPECT_EQ(message("[[run]]\n"),
              "s.toml: 'missions' is missing: a list of scenario files or files of mission documents");
    EXPECT_EQ(message("missions = []\n"), "s.toml:1: 'missions' is an empty list");
    EXPECT_EQ(message("missions = 7\n"), "s.toml:1: the name of a file of missions must be a text, such as \"...\"");
    EXPECT_EQ(message("missions = ['a.scen', 'b.scen',\n'a.scen']\n"), "s.toml:2: 'a.scen' stands here twice");
    EXPECT_EQ(message("missions = 'a.scen'\nplaces = ['a*', '']\n"),
              "s.toml:2: a place, a pattern of the names of its maps, must be a text, such as \"...\"");
    EXPECT_EQ(message("missions = 'a.scen'\n"), "s.toml: it has no [[run]]: say which methods with how many removals");
    EXPECT_EQ(message("missions = 'a.scen'\nrun = 3\n"), "s.toml:2: 'run' must be tables, each under its [[run]]");
    EXPECT_EQ(message("missions = 'a.scen'\ntime_limit = 0\n"),
              "s.toml:2: 'time_limit' must be a number from 0.001 to 86400");
    EXPECT_EQ(run("removals = 1\n"), "s.toml:2: a [[run]] needs 'methods', such as [\"paper\", \"exact\"]");
    EXPECT_EQ(run("methods = 'exact'\n"), "s.toml:2: this [[run]] needs 'removals', such as [1, 2, 3]");
    EXPECT_EQ(run("methods = 'best'\nremovals = 1\n"),
              "s.toml:3: this must be one of \"paper\", \"exact\", \"greedy\", \"none\"");
    EXPECT_EQ(run("methods = 'exact'\nremovals = [1, -1]\n"),
              "s.toml:4: a number of removals must be a whole number from 0 to 100");
    EXPECT_EQ(run("methods = 'exact'\nremovals = 1.5\n"),
              "s.toml:4: a number of removals must be a whole number from 0 to 100");
    EXPECT_EQ(run("methods = 'paper'\nremovals = 1\nweights = nan\n"),
              "s.toml:5: a weight must be a number from 1 to 1000");
    EXPECT_EQ(run("methods = 'paper'\nremovals = 1\nplanners = 'optimal'\n"),
              "s.toml:2: the paper's method counts hits, which the optimal planner cannot: use theta");
    EXPECT_EQ(run("methods = 'greedy'\nremovals = 1\nplanners = 'theta'\n"),
              "s.toml:2: the greedy method drives by the optimal planner only");
    EXPECT_EQ(run("methods = 'exact'\nremovals = 1\nweights = 2\n"),
              "s.toml:2: the planner optimal has no heuristic that a weight could change");
    EXPECT_EQ(run("methods = 'exact'\nremovals = [1, 1]\n"),
              "s.toml:2: exact with optimal, weight 1 and 1 removals stands here twice");
}

RC_GTEST_PROP(Spec, SurvivesAnyBytes, (const std::string& bytes)) {
    try {
        parse_spec(bytes, "s.toml");
    } catch (const InputError&) {
    }
}

using ReadExperiment = SmallExperiment;

TEST_F(ReadExperiment, FindsMapsFromTheScenarioFile) {
    ASSERT_EQ(experiment.maps.size(), 2U);
    EXPECT_EQ(experiment.maps[1].name, "yard.map");
    EXPECT_EQ(experiment.maps[1].path, path("yard.map"));
    EXPECT_EQ(experiment.maps[1].digest.substr(0, 7), "sha256:");
    ASSERT_EQ(experiment.missions.size(), 6U);
    EXPECT_EQ(experiment.missions[2].map, 1U);
    EXPECT_EQ(experiment.missions[5].map, 0U);
    EXPECT_EQ(experiment.missions[5].start(), (Cell{6, 1}));
    EXPECT_EQ(experiment.sets, std::vector<std::string>{"cities"});
    EXPECT_EQ(experiment.configurations.size(), 12U);
}

TEST_F(ReadExperiment, DigestsWhatDecidesTheResults) {
    const auto digest = [&](const std::string& text) { return read_experiment(put("other.toml", text)).digest; };
    const std::string text = spec;
    EXPECT_EQ(digest("# a comment\n" + text), experiment.digest);
    EXPECT_EQ(digest("name = 'other'\n" + text.substr(text.find('\n') + 1)), experiment.digest);
    EXPECT_EQ(digest("places = '*'\n" + text), experiment.digest);
    EXPECT_NE(digest("time_limit = 1\n" + text), experiment.digest);
    EXPECT_NE(digest(text + "[[run]]\nmethods = 'exact'\nremovals = 3\n"), experiment.digest);
    put("yard.map",
        "type octile\nheight 5\nwidth 7\nmap\n" + std::string("......@\n.......\n.......\n.......\n.......\n"));
    EXPECT_NE(digest(text), experiment.digest);
}

TEST_F(ReadExperiment, SaysWhatIsMissing) {
    const auto message = [&](const std::string& scenarios) {
        put("cities.scen", scenarios);
        return input_error([&] { read_experiment(path("small.toml")); });
    };
    EXPECT_EQ(message("version 1\n"), path("small.toml") + ": its files hold no mission");
    EXPECT_EQ(message("1 none.map 7 5 0 0 1 1 2\n"), "cannot read " + path("none.map") + ": No such file or directory");
    EXPECT_EQ(message("1 yard.map 7 5 0 0 1 1 2\n1 yard.map 8 5 0 0 1 1 2\n"),
              path("cities.scen") + ": gives yard.map two sizes");
}

TEST_F(ReadExperiment, SharesMapsOutAmongPlaces) {
    const auto with = [&](const std::string& places) { return "places = " + places + "\n" + spec; };
    const auto places = [&](const std::string& text) {
        const Experiment one = read_experiment(put("other.toml", with(text)));
        return places_of(one, "");
    };
    using Of = std::vector<std::size_t>;
    EXPECT_EQ(places_of(experiment, "").of_map, (Of{0, 1}));
    EXPECT_EQ(places("'*.map'").of_map, (Of{0, 0}));
    EXPECT_EQ(places("'*.map'").count, 1U);
    EXPECT_EQ(places("['yard*', 'str*t.map']").of_map, (Of{1, 0}));
    EXPECT_EQ(places("'yard.map'").of_map, (Of{1, 0}));
    EXPECT_EQ(places("'yard.map'").count, 2U);
    const auto message = [&](const std::string& text) {
        return input_error([&] { read_experiment(put("other.toml", with(text))); });
    };
    EXPECT_EQ(message("'city-*'"), path("other.toml") + ": the place 'city-*' holds none of the maps");
    EXPECT_EQ(message("['*', 'y*']"), path("other.toml") + ": the places '*' and 'y*' both hold yard.map");
}

constexpr const char* of_team =
    R"({"format": "waybreaker-mission/1", "map": "street.map", "agents": [)"
    R"({"id": "a", "kind": "ground", "start": [1, 3], "goal": [11, 3], "speed": 2},)"
    R"({"id": "b", "kind": "ground", "start": [0, 6], "goal": [6, 5]},)"
    R"({"id": "x", "kind": "air", "start": [1, 3], "goal": [1, 3]}], "rules": {"objective": "flowtime", "breach_time": 2}})"
    "\n";

TEST_F(ReadExperiment, TakesMissionDocumentsAsRows) {
    put("teams.jsonl", std::string(of_team) + "\n" + of_team);
    const Experiment teams = read_experiment(
        put("teams.toml", "missions = ['teams.jsonl']\n[[run]]\nmethods = ['exact', 'none']\nremovals = 1\n"));
    ASSERT_EQ(teams.missions.size(), 2U);
    ASSERT_EQ(teams.maps.size(), 1U);
    EXPECT_EQ(teams.maps[0].width, 12);
    const ExperimentMission& mission = teams.missions[1];
    EXPECT_EQ(mission.count(AgentKind::ground), 2U);
    EXPECT_EQ(mission.count(AgentKind::air), 1U);
    EXPECT_EQ(mission.start(), (Cell{1, 3}));
    EXPECT_EQ(mission.mission.agents[0].speed, 2);
    EXPECT_EQ(mission.mission.rules.objective, Objective::flowtime);
    EXPECT_EQ(mission.mission.rules.breach_time.per_obstacle, 2);
    EXPECT_FALSE(mission.octile.has_value());
}

TEST_F(ReadExperiment, SaysWhatRowsCannotBe) {
    const auto message = [&](const std::string& lines, const std::string& run) {
        put("teams.jsonl", lines);
        put("teams.toml", "missions = 'teams.jsonl'\n[[run]]\n" + run);
        return input_error([&] { read_experiment(path("teams.toml")); });
    };
    const std::string exact = "methods = 'exact'\nremovals = 1\n";
    const std::string rows = path("teams.jsonl");
    const auto changed = [](const std::string& from, const std::string& to) {
        std::string text = of_team;
        return text.replace(text.find(from), from.size(), to);
    };
    EXPECT_TRUE(message(std::string(of_team) + "{\n", exact).starts_with(rows + ", line 2:1"));
    EXPECT_EQ(message(changed(R"("map": "street.map", )", ""), exact), rows + ":1: does not say its map");
    EXPECT_EQ(message(changed(R"("breach_time": 2)", R"("budget_m2": 2)"), exact),
              rows + ":1: budget_m2 is not for experiments; weigh the map's obstacles and give budget");
    EXPECT_EQ(message(R"({"format": "waybreaker-mission/1", "map": "street.map", "agents": []})", exact),
              rows + ", line 1:1:67: agents names nobody: a mission has at least one ground agent");
    EXPECT_EQ(message(of_team, "methods = 'paper'\nremovals = 1\n"),
              path("teams.toml") +
                  ": teams are planned by exact and none, without planners and weights: give a spec of its own to the "
                  "rest");
}

}  // namespace
}  // namespace waybreaker::experiment
