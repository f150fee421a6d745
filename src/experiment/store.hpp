// Store: where a run puts its results, so that nothing is lost or done twice however it ends.
//
// Transactions are atomic and durable, even after kill -9 or a power cut.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "experiment/database.hpp"
#include "experiment/experiment.hpp"
#include "experiment/result.hpp"

namespace waybreaker::experiment {

// One of `count` parts of an experiment: missions number index - 1, index - 1 + count, ...
struct Shard {
    std::uint32_t index = 1;
    std::uint32_t count = 1;
    bool holds(std::size_t mission) const { return mission % count == index - 1; }
    friend bool operator==(const Shard&, const Shard&) = default;
};

class Store {
  public:
    // Begins the file, or takes it up again where it holds this shard of the same experiment, begun by the same version
    // of the program. Throws InputError if it holds anything else, or is in use.
    Store(const std::string& path, const Experiment& experiment, Shard shard, const std::string& version);

    // Jobs of the shard that have no result yet, in order.
    std::vector<std::uint64_t> open_jobs();
    // How many jobs the shard has.
    std::size_t job_count() const;
    // Stores all of them or, throwing InputError, none.
    void add(std::span<const Row> rows);

    const std::string& path() const { return database_.path(); }

  private:
    void begin(const std::string& version);
    void require_same(const std::string& version);
    void keep_spec();
    std::string property(const char* key);

    const Experiment& experiment_;
    Shard shard_;
    Database database_;
};

}  // namespace waybreaker::experiment
