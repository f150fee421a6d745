// Source store: map data that clients have sent, to import maps from. It is kept in memory, within that of the maps and
// at most a quarter of it, and forgotten an hour after its last use, or, the least recently used before others, when
// other sources need its room.
#pragma once

#include <chrono>
#include <cstdint>
#include <map>
#include <memory>
#include <mutex>
#include <string>

#include "geo/extract.hpp"
#include "server/limits.hpp"
#include "server/map_store.hpp"
#include "waybreaker/limits.hpp"

namespace waybreaker::server {

struct StoredSource {
    std::string name;  // of its file
    std::shared_ptr<const std::string> bytes;
    geo::Extract extract;
    std::unique_ptr<MapStore::Reservation> room;
};
using SharedSource = std::shared_ptr<const StoredSource>;

class SourceStore {
  public:
    // Keeps the reference.
    SourceStore(MapStore& maps, const ServiceLimits& limits) : maps_(maps), limits_(limits) {}

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

    // Whether a text can be the name of a source's file.
    static bool is_name(const std::string& text) { return MapStore::is_id(text); }

  private:
    using Clock = std::chrono::steady_clock;
    struct Slot {
        SharedSource source;
        Clock::time_point used;
    };
    SharedSource existing(const std::string& id);
    std::unique_ptr<MapStore::Reservation> make_room(std::size_t bytes);
    // With mutex_ locked:
    void forget_expired();
    std::size_t bytes_held() const;

    MapStore& maps_;
    ServiceLimits limits_;
    std::mutex mutex_;
    std::mutex reading_;  // one source is read at a time: reading needs several times its memory
    std::map<std::string, Slot> slots_;
};

// The description of a source.
std::string source_json(const std::string& id, const StoredSource& source);

}  // namespace waybreaker::server
