#include <gtest/gtest.h>
#include <sys/wait.h>

#include <algorithm>
#include <atomic>
#include <csignal>
#include <thread>

#include "core/random.hpp"
#include "experiment/evaluate.hpp"
#include "experiment/merge.hpp"
#include "input_error.hpp"
#include "small_experiment.hpp"

namespace waybreaker::experiment {
namespace {

class RunExperiment : public SmallExperiment {
  protected:
    // Evaluates as usual, but calls `before` first.
    template <class Before>
    static std::function<Evaluate()> evaluators(Before before) {
        return [before] {
            return [before, usual = std::make_shared<Evaluator>()](const Map& map, const ExperimentMission& mission,
                                                                   const Configuration& one, const StopToken& stop) {
                before(mission, one, stop);
                return usual->evaluate(map, mission, one, stop);
            };
        };
    }

    // Runs `act` in a process of its own; gives what ended it.
    template <class Act>
    static int status_of_child(Act act) {
        const pid_t child = fork();
        if (child == 0) {
            act();
            _exit(0);
        }
        int status = 0;
        waitpid(child, &status, 0);
        return status;
    }

    std::size_t count(const std::string& name, const std::string& status) {
        for (const auto& [word, number] : Results(path(name)).statuses()) {
            if (word == status) return number;
        }
        return 0;
    }
};

TEST_F(RunExperiment, StoresAResultForEveryJob) {
    const RunProgress progress = run_into("r.db");
    EXPECT_EQ(progress.jobs, 6 * 12U);
    EXPECT_EQ(progress.stored, progress.jobs);
    EXPECT_EQ(Results(path("r.db")).missing(), 0U);
    // What ends in a wall fails in every configuration, and says why.
    EXPECT_EQ(count("r.db", "failed"), 12U);
    EXPECT_EQ(progress.unsolved, 12U);
    EXPECT_NE(csv_of("r.db").find("goal 4,2 lies inside obstacle 1"), std::string::npos);
    // To the closed yard there is no way without removal: twice `none`, and exact and greedy with n = 0.
    EXPECT_EQ(count("r.db", "no plan"), 4U);
}

TEST_F(RunExperiment, StoresWhatThePlannerSays) {
    run_into("r.db");
    Results results(path("r.db"));
    Planner planner;
    Grid grid(12, 7);
    for (const int x : {3, 4, 8, 9}) {
        for (int y = 1; y < (x < 5 ? 6 : 5); ++y) grid.set_blocked({x, y}, true);
    }
    const Map map(std::move(grid));
    std::size_t mission_number = 0;
    results.for_each_mission([&](const ExperimentMission& mission, std::span<const std::optional<Result>> row) {
        if (mission_number++ != 0) return;
        for (std::size_t i = 0; i < row.size(); ++i) {
            const Configuration& one = results.experiment().configurations[i];
            if (one.method != Method::paper && one.method != Method::exact) continue;
            Mission asked = ground_and_air(mission.start(), mission.goal());
            asked.rules.removals = one.removals;
            waybreaker::Method how{.weight = one.weight};
            if (one.method == Method::paper) follow_paper(asked.rules, how);
            const Plan plan = planner.plan(map, asked, how);
            const Result& stored = row[i].value();
            EXPECT_EQ(stored.after.makespan, plan.after.makespan) << i;
            EXPECT_EQ(stored.before.flowtime, plan.before.flowtime) << i;
            EXPECT_EQ(stored.after.expanded, plan.after.ground().expanded) << i;
            EXPECT_EQ(stored.after.air, plan.after.air().length.value()) << i;
            EXPECT_EQ(stored.bound, plan.bound) << i;
        }
    });
    EXPECT_EQ(mission_number, 6U);
}

TEST_F(RunExperiment, GreedyLiesBetweenNothingAndTheProvenBest) {
    run_into("r.db");
    Results results(path("r.db"));
    const auto index = [&](Method method, int removals) {
        const auto& all = results.experiment().configurations;
        return std::size_t(std::ranges::find(all, Configuration{method, Algorithm::optimal, 1, removals}) -
                           all.begin());
    };
    results.for_each_mission([&](const ExperimentMission&, std::span<const std::optional<Result>> row) {
        for (const int n : {0, 1, 2}) {
            const Result& greedy = row[index(Method::greedy, n)].value();
            const Result& exact = row[index(Method::exact, n)].value();
            ASSERT_EQ(greedy.status, exact.status);
            if (greedy.status != ResultStatus::solved) continue;
            EXPECT_GE(*greedy.after.makespan, *exact.after.makespan - 1e-9);
            EXPECT_LE(*greedy.after.makespan, greedy.before.makespan.value_or(1e9) + 1e-9);
            if (n == 2) continue;  // one step is proven
            EXPECT_NEAR(*greedy.after.ground, *exact.after.ground, 1e-9);
        }
    });
}

TEST_F(RunExperiment, IsTheSameForAnyNumberOfThreadsAndShards) {
    run_into("one.db", {.threads = 1});
    run_into("four.db", {.threads = 4});
    EXPECT_EQ(csv_of("one.db"), csv_of("four.db"));
    for (const std::uint32_t count : {2U, 4U, 6U}) {
        std::vector<std::string> shards;
        for (std::uint32_t index = count; index >= 1; --index) {
            const std::string name = std::to_string(index) + "-" + std::to_string(count) + ".db";
            run_into(name, {}, {index, count});
            shards.push_back(path(name));
        }
        const std::string merged = "merged-" + std::to_string(count) + ".db";
        merge(shards, path(merged));
        EXPECT_EQ(csv_of(merged), csv_of("one.db"));
        EXPECT_EQ(Results(path(merged)).shard(), (Shard{1, 1}));
        EXPECT_EQ(run_into(merged).begun_with, 72U) << "a merged file is one that a run can take up";
    }
}

TEST_F(RunExperiment, ContinuesAfterAStop) {
    run_into("whole.db");
    std::atomic<int> left = 20;
    StopSource stop;
    const auto count_down = [&](auto&...) {
        if (--left > 0) return;
        stop.request_stop();
        std::this_thread::sleep_for(std::chrono::milliseconds(100));
    };
    const RunProgress first =
        run_into("r.db", {.threads = 2, .stop = stop.get_token(), .evaluators = evaluators(count_down)});
    EXPECT_LT(first.stored, first.jobs);
    const RunProgress second = run_into("r.db");
    EXPECT_EQ(second.begun_with, first.stored);
    EXPECT_EQ(second.stored, second.jobs);
    EXPECT_EQ(csv_of("r.db"), csv_of("whole.db"));
    EXPECT_EQ(run_into("r.db").begun_with, second.jobs);
}

TEST_F(RunExperiment, SurvivesBeingKilledAtAnyTime) {
    run_into("whole.db");
    Random random(3);
    int killed = 0;
    // 72 jobs of at least 40 ms on two threads; stored every half second.
    while (killed < 100) {
        const pid_t child = fork();
        if (child == 0) {
            run_into("r.db", {.threads = 2, .evaluators = evaluators([](auto&...) {
                                                std::this_thread::sleep_for(std::chrono::milliseconds(40));
                                            })});
            _exit(0);
        }
        std::this_thread::sleep_for(std::chrono::milliseconds(5 + random.below(900)));
        kill(child, SIGKILL);
        int status = 0;
        waitpid(child, &status, 0);
        if (WIFEXITED(status)) break;
        ++killed;
    }
    EXPECT_GT(killed, 0);
    EXPECT_EQ(run_into("r.db").stored, 72U);
    EXPECT_EQ(csv_of("r.db"), csv_of("whole.db"));
}

TEST_F(RunExperiment, RecordsWhatTakesTooLong) {
    experiment.time_limit = 0.2;
    const auto dawdle = [](const ExperimentMission& mission, const Configuration& one, const StopToken& stop) {
        if (mission.map != 1 || one.removals != 2) return;
        while (!stop.stop_requested()) std::this_thread::sleep_for(std::chrono::milliseconds(5));
    };
    run_into("r.db", {.threads = 4, .evaluators = evaluators(dawdle)});
    // On that map two missions, the third fails anyway; two weights of the paper's method, exact and greedy.
    EXPECT_EQ(count("r.db", "timed out"), 8U);
    EXPECT_EQ(Results(path("r.db")).missing(), 0U);
}

TEST_F(RunExperiment, RecordsAJobThatTakesTheProgramDownTwice) {
    const auto crash = [](const ExperimentMission& mission, const Configuration& one, const StopToken&) {
        if (mission.start() == Cell{6, 1} && one.method == Method::greedy && one.removals == 1) std::abort();
    };
    const auto attempt = [&] {
        return status_of_child([&] { run_into("r.db", {.threads = 2, .evaluators = evaluators(crash)}); });
    };
    for (int i = 0; i < 2; ++i) {
        const int status = attempt();
        ASSERT_TRUE(WIFSIGNALED(status));
        EXPECT_EQ(WTERMSIG(status), SIGABRT);
    }
    EXPECT_EQ(attempt(), 0);
    EXPECT_EQ(count("r.db", "crashed"), 1U);
    EXPECT_EQ(Results(path("r.db")).missing(), 0U);
    EXPECT_FALSE(std::filesystem::exists(path("r.db.crashes")));
}

TEST_F(RunExperiment, TakesMapsOfSeveralFiles) {
    put("floor.pgm", "P5 3 1 255\n" + std::string("\xfe\xfe\xfe"));
    put("floor.yaml",
        "image: floor.pgm\nresolution: 0.05\norigin: [0, 0, 0]\nnegate: 0\noccupied_thresh: 0.65\nfree_thresh: "
        "0.196\n");
    put("cities.scen", "0\tfloor.yaml\t3\t1\t0\t0\t2\t0\t2\n");
    experiment = read_experiment(path("small.toml"));
    EXPECT_EQ(run_into("r.db").unsolved, 0U);
}

TEST_F(RunExperiment, StopsAtAMapThatIsNotWhatItWas) {
    put("yard.map", "type octile\nheight 1\nwidth 1\nmap\n.\n");
    EXPECT_EQ(input_error([&] { run_into("r.db"); }), path("yard.map") + ": has changed since the run began");
    std::filesystem::remove(path("yard.map"));
    EXPECT_EQ(input_error([&] { run_into("r.db"); }),
              "cannot read " + path("yard.map") + ": No such file or directory");
}

}  // namespace
}  // namespace waybreaker::experiment
