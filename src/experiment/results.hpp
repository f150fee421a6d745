// Results: a results file read again, for export, merging and the report.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "experiment/database.hpp"
#include "experiment/experiment.hpp"
#include "experiment/result.hpp"
#include "experiment/store.hpp"

namespace waybreaker::experiment {

class Results {
  public:
    // Throws InputError if this is not a valid results file, or a run is using it.
    explicit Results(const std::string& path);

    const std::string& path() const { return database_.path(); }
    // What was run: names, sets, maps (without paths), configurations. The missions are those of the shard.
    const Experiment& experiment() const { return experiment_; }
    const std::string& version() const { return version_; }
    Shard shard() const { return shard_; }

    // Jobs of the shard without a result.
    std::size_t missing();
    // How many results have each status.
    std::vector<std::pair<std::string, std::size_t>> statuses();

    // Each mission with its results by configuration, empty where there is none; in order.
    using Visit = std::function<void(const ExperimentMission&, std::span<const std::optional<Result>>)>;
    void for_each_mission(const Visit& visit);

    // One line a result, with all it depends on; without `timing` no measured seconds, so that equal runs give equal
    // bytes.
    std::string csv(bool timing);

  private:
    std::string property(const char* key);
    std::size_t number(const char* key);
    Mission mission(const std::string& document) const;
    void read();

    Database database_;
    Experiment experiment_;
    std::string version_;
    Shard shard_;
};

}  // namespace waybreaker::experiment
