// Source store: map data that clients have sent, to import maps from. It is kept in memory, in at most a quarter of the
// budget, and forgotten an hour after its last use, or, the least recently used before others, when other sources need
// its room.
#pragma once

#include <chrono>
#include <cstdint>
#include <map>
#include <memory>
#include <mutex>
#include <string>

#include "city/extract.hpp"
#include "service/importer.hpp"
#include "service/map_store.hpp"
#include "service/memory_budget.hpp"
#include "waybreaker/limits.hpp"

namespace waybreaker::service {

struct StoredSource {
    std::string name;  // of its file
    std::string bytes;
    city::Extract extract;
    MemoryBudget::Share memory;
};
using SharedSource = std::shared_ptr<const StoredSource>;

class SourceStore {
  public:
    // Keeps the references.
    SourceStore(const Importer& importer, MemoryBudget& budget) : importer_(importer), budget_(budget) {}

    struct Added {
        std::string id;
        SharedSource source;
        bool is_new = false;
    };
    // Reads what the source covers, until a stop. The same bytes of the same name get the same id. Throws Problem if
    // they cannot be read as map data with buildings, or there is no room for them.
    Added add(std::string bytes, const std::string& name, const StopToken& stop);

    // Throw Problem if there is no such source.
    SharedSource find(const std::string& id);
    void remove(const std::string& id);

    // Forgets what nobody has used for an hour.
    void forget_expired();

    // Whether a text can be the name of a source's file.
    static bool is_name(const std::string& text) { return MapStore::is_id(text); }

  private:
    using Clock = std::chrono::steady_clock;
    struct Slot {
        SharedSource source;
        Clock::time_point used;
    };
    SharedSource existing(const std::string& id);
    MemoryBudget::Share make_room(std::size_t bytes);
    // The least recently used that nobody is reading. Whether there was one.
    bool forget_one();

    const Importer& importer_;
    MemoryBudget& budget_;
    std::mutex mutex_;
    std::map<std::string, Slot> slots_;
};

// The description of a source.
std::string source_json(const std::string& id, const StoredSource& source);

}  // namespace waybreaker::service
