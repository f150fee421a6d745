// Run: all open jobs of an experiment, over several threads, into a store.
#pragma once

#include <cstddef>
#include <functional>

#include "experiment/experiment.hpp"
#include "experiment/store.hpp"

namespace waybreaker::experiment {

struct RunProgress {
    std::size_t jobs = 0;    // of the shard
    std::size_t stored = 0;  // of them, those before this run included
    std::size_t begun_with = 0;
    std::size_t unsolved = 0;  // of this run: timed out, failed or crashed
    double seconds = 0;        // since the run began
    double planning = 0;       // seconds of all threads together within planners
    unsigned threads = 0;
};

using Evaluate = std::function<Result(const Map&, const ExperimentMission&, const Configuration&, StopToken)>;

struct RunOptions {
    unsigned threads = 0;  // 0: all cores
    StopToken stop = {};
    std::function<void(const RunProgress&)> progress = {};  // called now and then, by the thread that called run()
    // Makes what evaluates jobs, one for each thread; by default an Evaluator.
    std::function<Evaluate()> evaluators = {};
};

// Runs the open jobs to the end, unless it is asked to stop, and returns the progress made. Stored results stay stored
// however this ends. Results do not depend on the number of threads, measured seconds aside. Throws InputError if a map
// cannot be read or has changed, or the store cannot be written.
RunProgress run(const Experiment& experiment, Store& store, const RunOptions& options = {});

}  // namespace waybreaker::experiment
