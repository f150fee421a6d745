#include "service/map_store.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <optional>
#include <set>
#include <utility>
#include <vector>

#include "http/problem.hpp"
#include "io/map_memory.hpp"
#include "io/output_file.hpp"
#include "mapfile/digest.hpp"
#include "mapfile/map_reader.hpp"
#include "mapfile/ros_map.hpp"
#include "service/built_in_maps.hpp"
#include "service/memory_account.hpp"
#include "waybreaker/error.hpp"

namespace waybreaker::service {
namespace {

namespace fs = std::filesystem;

const std::set<std::string> extensions{".map", ".xml", ".tif", ".tiff", ".yaml", ".png", ".pgm", ".pbm", ".ppm"};

// Whether a path lies in a folder after following links. Precondition: the folder's own path has no links.
bool lies_in(const fs::path& path, const fs::path& folder) {
    std::error_code error;
    const fs::path real = fs::canonical(path, error);
    if (error) return false;
    return std::mismatch(folder.begin(), folder.end(), real.begin(), real.end()).first == folder.end();
}

// A ROS map names its image, which must not lie outside the folder.
void require_image_inside(const std::string& yaml, const fs::path& path, const fs::path& folder) {
    const fs::path image = path.parent_path() / mapfile::parse_ros_yaml(yaml, path.filename().string()).image;
    if (!lies_in(image, folder)) throw InputError(path.filename().string(), 0, "its image is not in the maps folder");
}

std::optional<MapStore::Entry> entry_of(const fs::directory_entry& file, const fs::path& folder) {
    const std::string name = file.path().filename().string();
    if (!MapStore::is_id(name) || !extensions.contains(file.path().extension().string())) return std::nullopt;
    std::error_code error;
    if (!file.is_regular_file(error) || !lies_in(file.path(), folder)) return std::nullopt;
    return MapStore::Entry{.id = name};
}

http::Problem no_such_map() {
    return {http::not_found, "there is no map of that name; GET /api/v1/maps lists those there are", "map-not-found"};
}

}  // namespace

std::string MapStore::id_of(const std::string& bytes, Connectivity connectivity) {
    constexpr std::size_t digest_characters = 16;
    const std::string digest = mapfile::sha256_digest(bytes);
    const std::string hex = digest.substr(digest.find(':') + 1, digest_characters);
    return "upload-" + hex + (connectivity == Connectivity::eight ? "-8" : "");
}

bool MapStore::is_id(const std::string& text) {
    constexpr std::size_t most = 100;
    constexpr auto letters = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789._-";
    return !text.empty() && text.size() <= most && text.front() != '.' &&
           text.find_first_not_of(letters) == std::string::npos;
}

// Memory for a map, from before it is read.
class MapStore::Reservation {
  public:
    // `uploaded`: whether a client that sent too much is to blame.
    Reservation(MapStore& store, bool uploaded)
        : store_(store), uploaded_(uploaded), share_(store.budget_, MemoryBudget::Use::map) {}
    Reservation(const Reservation&) = delete;
    Reservation& operator=(const Reservation&) = delete;

    // Limits that reserve what they admit; this object must outlive them.
    MapLimits limits() {
        return {.cells = uploaded_ ? store_.limits_.map_cells : max_cells,
                .admit = [this](std::size_t bytes) { admit(bytes); }};
    }
    // Leaves the map what it takes.
    SharedMap settled(StoredMap map) {
        const std::size_t bytes = io::memory_of(map.file) + map.bytes.capacity();
        share_.shrink_to(bytes);
        if (bytes > share_.bytes()) admit(bytes - share_.bytes());
        map.memory = std::move(share_);
        return std::make_shared<const StoredMap>(std::move(map));
    }

  private:
    void admit(std::size_t bytes) {
        if (share_.grow(bytes)) return;
        if (share_.bytes() + bytes <= store_.budget_.most()) {
            throw http::Problem(http::unavailable, "what others use leaves no memory for this map; ask again",
                                "no-memory");
        }
        const std::string detail =
            fmt::format("the map would take {} MB of memory, all that is at work may take {} MB (--max-memory)",
                        (share_.bytes() + bytes) >> 20U, store_.budget_.most() >> 20U);
        throw uploaded_ ? http::Problem(http::too_large, detail, "map-too-large")
                        : http::Problem(http::unprocessable, detail, "map-beyond-memory");
    }

    MapStore& store_;
    bool uploaded_;
    MemoryBudget::Share share_;
};

MapStore::MapStore(const std::string& folder, const ServiceLimits& limits, MemoryBudget& budget, MapArchive* archive)
    : limits_(limits), budget_(budget), archive_(archive) {
    budget_.when_short([this] { return evict_unused(); });
    if (folder.empty()) return;
    std::error_code error;
    const fs::path real = fs::canonical(folder, error);
    if (error || !fs::is_directory(real)) throw InputError(folder, 0, "is not a folder; --maps names one with maps");
    folder_ = real.string();
}

std::string MapStore::path_of(const std::string& id) const {
    if (folder_.empty() || !is_id(id)) return "";
    const fs::directory_entry file(fs::path(folder_) / id);
    return entry_of(file, folder_) ? file.path().string() : "";
}

std::vector<MapStore::Entry> MapStore::list() const {
    std::map<std::string, Entry> entries;
    for (const BuiltInMap& map : built_in_maps) entries[std::string(map.name)] = {.id = std::string(map.name)};
    std::error_code error;
    if (!folder_.empty()) {
        for (const fs::directory_entry& file : fs::directory_iterator(folder_, error)) {
            if (const auto entry = entry_of(file, folder_)) entries[entry->id] = *entry;
        }
    }
    if (archive_ != nullptr) {
        for (const std::string& id : archive_->sent()) entries[id] = {.id = id, .uploaded = true};
    }
    const std::scoped_lock lock(mutex_);
    for (const auto& [id, slot] : slots_) {
        if (slot->map && (slot->uploaded || entries.contains(id))) entries[id] = {id, slot->uploaded, true};
    }
    std::vector<Entry> list;
    for (auto& [id, entry] : entries) list.push_back(std::move(entry));
    return list;
}

std::shared_ptr<MapStore::Slot> MapStore::slot_of(const std::string& id) {
    {
        const std::scoped_lock lock(mutex_);
        const auto known = slots_.find(id);
        if (known != slots_.end()) return known->second;
    }
    const bool sent = path_of(id).empty() && !built_in_map(id);
    if (sent && !is_archived(id)) throw no_such_map();
    const auto slot = std::make_shared<Slot>();
    slot->uploaded = sent;
    const std::scoped_lock lock(mutex_);
    return slots_.try_emplace(id, slot).first->second;  // of another, if that was faster
}

SharedMap MapStore::touch(Slot& slot) {
    const std::scoped_lock lock(mutex_);
    slot.used = ++uses_;
    return slot.map;
}

SharedMap MapStore::take_first(Of which, const Slot* except) {
    const auto rank = [](const auto& entry) { return std::pair(!entry.second->uploaded, entry.second->used); };
    auto first = slots_.end();
    for (auto entry = slots_.begin(); entry != slots_.end(); ++entry) {
        const SharedMap& map = entry->second->map;
        if (!map || entry->second.get() == except || (which == Of::unused && map.use_count() > 1)) continue;
        if (first == slots_.end() || rank(*entry) < rank(*first)) first = entry;
    }
    if (first == slots_.end()) return nullptr;
    SharedMap map = std::move(first->second->map);
    slots_.erase(first);
    return map;
}

bool MapStore::evict_unused() {
    SharedMap evicted;  // released without the lock
    const std::scoped_lock lock(mutex_);
    evicted = take_first(Of::unused);
    return evicted != nullptr;
}

std::size_t MapStore::count_loaded() const {
    return std::size_t(std::ranges::count_if(slots_, [](const auto& entry) { return bool(entry.second->map); }));
}

std::size_t MapStore::loaded() const {
    const std::scoped_lock lock(mutex_);
    return count_loaded();
}

void MapStore::fill(Slot& slot, SharedMap map) {
    std::vector<SharedMap> evicted;  // released without the lock
    const std::scoped_lock lock(mutex_);
    slot.map = std::move(map);
    slot.used = ++uses_;
    while (count_loaded() > limits_.maps) {
        evicted.push_back(take_first(Of::all, &slot));
        if (!evicted.back()) return;
    }
}

StoredMap MapStore::read(const std::string& id, const MapLimits& limits) const {
    const std::string path = path_of(id);
    const BuiltInMap* const built_in = path.empty() ? built_in_map(id) : nullptr;
    if (path.empty() && !built_in) return from_archive(id, limits);
    std::error_code error;
    if (const std::uintmax_t size = fs::file_size(path, error); !error) limits.admit(size);
    std::string bytes = built_in ? std::string(built_in->bytes()) : mapfile::read_map_bytes(path);
    if (fs::path(path).extension() == ".yaml" && mapfile::is_ros_yaml(bytes)) {
        require_image_inside(bytes, path, folder_);
        return {.file = mapfile::read_map_file(path)};
    }
    io::MapFile file = mapfile::parse_map(bytes, id, Connectivity::four, {}, limits);
    bytes.shrink_to_fit();  // the bytes are kept, so free the spare capacity
    return {.file = std::move(file), .bytes = std::move(bytes)};
}

StoredMap MapStore::from_archive(const std::string& id, const MapLimits& limits) const {
    std::optional<ArchivedMap> archived = archive_ != nullptr ? archive_->read(id) : std::nullopt;
    if (!archived) throw no_such_map();
    limits.admit(archived->bytes.size());
    io::MapFile file = mapfile::parse_map(archived->bytes, id, archived->connectivity, {}, limits);
    return {.file = std::move(file), .connectivity = archived->connectivity, .bytes = std::move(archived->bytes)};
}

SharedMap MapStore::if_loaded(const std::string& id) {
    return touch(*slot_of(id));
}

SharedMap MapStore::load(const std::string& id) {
    const MemoryAccount::Scope none(nullptr);  // the limits count the map
    const std::shared_ptr<Slot> slot = slot_of(id);
    const std::scoped_lock reading(slot->reading);
    SharedMap map = touch(*slot);
    if (map) return map;
    Reservation reservation(*this, false);
    try {
        map = reservation.settled(read(id, reservation.limits()));
    } catch (const InputError&) {
        throw http::Problem(http::unprocessable, id + " is not a map that can be read",
                            "map-unreadable");  // the cause is left out: it would reveal paths of the server
    }
    fill(*slot, map);
    return map;
}

// The bytes decide: an id has a quarter of their digest, and with some effort two files of one id can be made.
std::optional<MapStore::Upload> MapStore::existing(const std::string& id, const std::string& bytes) {
    const std::scoped_lock lock(mutex_);
    const auto known = slots_.find(id);
    if (known == slots_.end() || !known->second->map) return std::nullopt;
    if (known->second->map->bytes != bytes) {
        throw http::Problem(http::unprocessable, "another map has the id " + id + " here; delete it first");
    }
    known->second->used = ++uses_;
    return Upload{id, known->second->map, false};
}

MapStore::Upload MapStore::add(std::string bytes, Connectivity connectivity) {
    const std::string id = id_of(bytes, connectivity);
    if (const auto known = existing(id, bytes)) {
        share(id, *known->map);
        return *known;
    }
    try {
        return add([&](const MapLimits& limits) -> StoredMap {
            const MemoryAccount::Scope none(nullptr);  // the limits count the map
            io::MapFile file = mapfile::parse_map(bytes, "the map", connectivity, {}, limits);
            return {.file = std::move(file), .connectivity = connectivity, .bytes = std::move(bytes)};
        });
    } catch (const SizeError& error) {
        throw http::Problem(http::too_large, error.what(), "map-too-large");
    } catch (const InputError& error) {
        throw http::Problem(http::unprocessable, error.what(), "map-unreadable");
    }
}

MapStore::Upload MapStore::add(const std::function<StoredMap(const MapLimits&)>& make) {
    Reservation reservation(*this, true);
    return insert(make(reservation.limits()), reservation);
}

// With the other servers of the archive.
void MapStore::share(const std::string& id, const StoredMap& map) {
    if (archive_ != nullptr) archive_->keep(id, map.connectivity, map.bytes);
}

MapStore::Upload MapStore::insert(StoredMap map, Reservation& reservation) {
    const std::string id = id_of(map.bytes, map.connectivity);
    share(id, map);
    if (const auto known = existing(id, map.bytes)) return *known;
    map.file.source = id;
    const SharedMap shared = reservation.settled(std::move(map));
    const auto slot = std::make_shared<Slot>();
    slot->uploaded = true;
    {
        const std::scoped_lock lock(mutex_);
        std::shared_ptr<Slot>& there = slots_[id];
        if (there && there->map) {  // made before, or by another at the same time
            there->used = ++uses_;
            return {id, there->map, false};
        }
        there = slot;
        slot->map = shared;
    }
    fill(*slot, shared);  // may evict others
    return {id, shared, true};
}

void MapStore::remove(const std::string& id) {
    const bool archived = is_archived(id);
    if (archived && !archive_->forget(id)) {
        throw http::Problem(http::forbidden, "live missions are on this map; delete them first", "map-not-removable");
    }
    std::shared_ptr<Slot> removed;  // released without the lock
    const std::scoped_lock lock(mutex_);
    const auto known = slots_.find(id);
    if (known != slots_.end() && known->second->uploaded) {
        removed = std::move(known->second);
        slots_.erase(known);
    } else if (known != slots_.end() || !path_of(id).empty() || built_in_map(id)) {
        throw http::Problem(http::forbidden, "only maps that were sent here can be deleted", "map-not-removable");
    } else if (!archived) {
        throw no_such_map();
    }
}

}  // namespace waybreaker::service
