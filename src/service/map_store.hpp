// Map store: the maps of a server: those in its folder, the built-in ones and uploads. Each is read once and shared,
// read-only, by all requests that use it. The memory budget and ServiceLimits bound their memory and their number; to
// make room, those that nobody uses are evicted: uploads first, then maps of the folder, each in least recently used
// order.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "io/map_file.hpp"
#include "map/map_size.hpp"
#include "service/limits.hpp"
#include "service/map_archive.hpp"
#include "service/memory_budget.hpp"

namespace waybreaker::service {

// A map, the connectivity its obstacles were labelled with, and the bytes it was read from (empty for a ROS map, which
// is two files).
struct StoredMap {
    io::MapFile file;
    Connectivity connectivity = Connectivity::four;
    std::string bytes = {};
    std::optional<MemoryBudget::Share> memory = {};  // while it is in use, even if it is no longer in the store
};
using SharedMap = std::shared_ptr<const StoredMap>;

class MapStore {
  public:
    // `folder` may be empty. Keeps the references. Throws InputError if it is not a folder. Maps of the archive can
    // always be had, and not be removed while missions are on them.
    MapStore(const std::string& folder, const ServiceLimits& limits, MemoryBudget& budget,
             MapArchive* archive = nullptr);

    struct Entry {
        std::string id;
        bool uploaded = false;
        bool loaded = false;  // a map of the folder is read when it is first asked for
    };
    // Sorted by id. A file in the folder replaces the built-in map of the same name. Files whose names are not valid
    // ids and links that lead out of the folder are skipped.
    std::vector<Entry> list() const;
    // How many are in memory.
    std::size_t loaded() const;

    // The map if it is in memory, else null: load() has to read it, which takes time. Throws Problem if there is no
    // such map. Thread-safe.
    SharedMap if_loaded(const std::string& id);
    // Throws Problem if there is no such map, it cannot be read, or there is no memory for it. Thread-safe.
    SharedMap load(const std::string& id);

    struct Upload {
        std::string id;
        SharedMap map;
        bool is_new = false;
    };
    // Keeps a map in memory. The same bytes get the same id. Throws Problem if they are not a map, the map is too
    // large, the maps in use leave no memory for it, or another map has its id.
    Upload add(std::string bytes, Connectivity connectivity);
    // The same for the map that `make` returns; `make` must respect the limits. Holds no lock meanwhile.
    Upload add(const std::function<StoredMap(const MapLimits&)>& make);

    // Removes an uploaded map; requests that use it keep it until they are done. Throws Problem for other maps.
    void remove(const std::string& id);

    // What a map that is sent is called.
    static std::string id_of(const std::string& bytes, Connectivity connectivity);
    // Whether a text is a valid map id: letters, digits, dots, dashes and underscores, not starting with a dot.
    static bool is_id(const std::string& text);

  private:
    struct Slot {
        std::mutex reading;
        SharedMap map;  // guarded by MapStore::mutex_
        bool uploaded = false;
        std::uint64_t used = 0;
    };
    class Reservation;
    std::string path_of(const std::string& id) const;
    bool is_archived(const std::string& id) const { return archive_ != nullptr && archive_->holds(id); }
    StoredMap read(const std::string& id, const MapLimits& limits) const;
    StoredMap from_archive(const std::string& id, const MapLimits& limits) const;
    std::shared_ptr<Slot> slot_of(const std::string& id);
    std::optional<Upload> existing(const std::string& id, const std::string& bytes);
    SharedMap touch(Slot& slot);
    Upload insert(StoredMap map, Reservation& reservation);
    void share(const std::string& id, const StoredMap& map);
    void fill(Slot& slot, SharedMap map);
    // Whether there was a map that nobody uses.
    bool evict_unused();
    // With mutex_ locked; the map is to be released without it:
    std::size_t count_loaded() const;
    enum class Of { all, unused };
    SharedMap take_first(Of which, const Slot* except = nullptr);

    std::string folder_;
    ServiceLimits limits_;
    MemoryBudget& budget_;
    MapArchive* archive_;
    mutable std::mutex mutex_;
    std::map<std::string, std::shared_ptr<Slot>> slots_;
    std::uint64_t uses_ = 0;
};

}  // namespace waybreaker::service
