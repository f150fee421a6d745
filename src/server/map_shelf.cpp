#include "server/map_shelf.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <optional>
#include <set>
#include <utility>

#include "io/map_memory.hpp"
#include "io/output_file.hpp"
#include "mapfile/digest.hpp"
#include "mapfile/map_reader.hpp"
#include "mapfile/ros_map.hpp"
#include "server/built_in_maps.hpp"
#include "server/problem.hpp"
#include "waybreaker/error.hpp"

namespace waybreaker::server {
namespace {

namespace fs = std::filesystem;

const std::set<std::string> extensions{".map", ".xml", ".tif", ".tiff", ".yaml", ".png", ".pgm", ".pbm", ".ppm"};

// Whether a path, links followed, lies in a folder that has no links in it.
bool lies_in(const fs::path& path, const fs::path& folder) {
    std::error_code error;
    const fs::path real = fs::canonical(path, error);
    if (error) return false;
    return std::mismatch(folder.begin(), folder.end(), real.begin(), real.end()).first == folder.end();
}

// A ROS map names its image, which must not lead anywhere else.
void require_image_inside(const std::string& yaml, const fs::path& path, const fs::path& folder) {
    const fs::path image = path.parent_path() / mapfile::parse_ros_yaml(yaml, path.filename().string()).image;
    if (!lies_in(image, folder)) throw InputError(path.filename().string(), 0, "its image is not in the maps folder");
}

std::optional<MapShelf::Entry> entry_of(const fs::directory_entry& file, const fs::path& folder) {
    const std::string name = file.path().filename().string();
    if (!MapShelf::is_id(name) || !extensions.contains(file.path().extension().string())) return std::nullopt;
    std::error_code error;
    if (!file.is_regular_file(error) || !lies_in(file.path(), folder)) return std::nullopt;
    return MapShelf::Entry{.id = name};
}

Problem no_such_map() {
    return {not_found, "there is no map of that name; GET /api/v1/maps lists those there are", "map-not-found"};
}

constexpr std::size_t digest_characters = 16;

std::string upload_id(const std::string& bytes, Connectivity connectivity) {
    const std::string digest = mapfile::sha256_digest(bytes);
    const std::string hex = digest.substr(digest.find(':') + 1, digest_characters);
    return "upload-" + hex + (connectivity == Connectivity::eight ? "-8" : "");
}

}  // namespace

bool MapShelf::is_id(const std::string& text) {
    constexpr std::size_t most = 100;
    constexpr auto letters = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789._-";
    return !text.empty() && text.size() <= most && text.front() != '.' &&
           text.find_first_not_of(letters) == std::string::npos;
}

MapShelf::MapShelf(const std::string& folder, const ServiceLimits& limits) : limits_(limits) {
    if (folder.empty()) return;
    std::error_code error;
    const fs::path real = fs::canonical(folder, error);
    if (error || !fs::is_directory(real)) throw InputError(folder, 0, "is not a folder; --maps names one with maps");
    folder_ = real.string();
}

std::string MapShelf::path_of(const std::string& id) const {
    if (folder_.empty() || !is_id(id)) return "";
    const fs::directory_entry file(fs::path(folder_) / id);
    return entry_of(file, folder_) ? file.path().string() : "";
}

std::vector<MapShelf::Entry> MapShelf::list() const {
    std::map<std::string, Entry> entries;
    for (const BuiltInMap& map : built_in_maps) entries[std::string(map.name)] = {.id = std::string(map.name)};
    std::error_code error;
    if (!folder_.empty()) {
        for (const fs::directory_entry& file : fs::directory_iterator(folder_, error)) {
            if (const auto entry = entry_of(file, folder_)) entries[entry->id] = *entry;
        }
    }
    const std::scoped_lock lock(mutex_);
    for (const auto& [id, place] : places_) {
        if (place->map && (place->uploaded || entries.contains(id))) entries[id] = {id, place->uploaded, true};
    }
    std::vector<Entry> list;
    for (auto& [id, entry] : entries) list.push_back(std::move(entry));
    return list;
}

std::shared_ptr<MapShelf::Place> MapShelf::place_of(const std::string& id) {
    const std::scoped_lock lock(mutex_);
    const auto known = places_.find(id);
    if (known != places_.end()) return known->second;
    if (path_of(id).empty() && !built_in_map(id)) throw no_such_map();
    return places_[id] = std::make_shared<Place>();
}

SharedMap MapShelf::held(Place& place) {
    const std::scoped_lock lock(mutex_);
    place.used = ++uses_;
    return place.map;
}

std::size_t MapShelf::taken() const {
    std::size_t bytes = reserved_;
    for (const auto& [id, place] : places_) bytes += place->bytes;
    for (const Lent& lent : lent_) bytes += lent.map.expired() ? 0 : lent.bytes;
    return bytes;
}

std::size_t MapShelf::memory() const {
    const std::scoped_lock lock(mutex_);
    return taken();
}

void MapShelf::take_down(const std::string& id) {
    std::erase_if(lent_, [](const Lent& lent) { return lent.map.expired(); });
    const auto place = places_.find(id);
    if (place->second->map.use_count() > 1) lent_.push_back({place->second->map, place->second->bytes});
    places_.erase(place);
}

// Whether there was a map to take down.
bool MapShelf::make_way(const Place* spared) {
    const auto rank = [](const auto& entry) { return std::pair(!entry.second->uploaded, entry.second->used); };
    auto first = places_.end();
    for (auto entry = places_.begin(); entry != places_.end(); ++entry) {
        if (!entry->second->map || entry->second.get() == spared) continue;
        if (first == places_.end() || rank(*entry) < rank(*first)) first = entry;
    }
    if (first == places_.end()) return false;
    take_down(std::string(first->first));
    return true;
}

MapLimits MapShelf::Reservation::limits() {
    const auto admit = [this](std::size_t bytes) {
        const std::size_t most = shelf_.limits_.memory;
        if (bytes > most) {
            const std::string detail =
                fmt::format("the map would take {} MB of memory, all maps together may take {} MB (--max-memory)",
                            bytes >> 20U, most >> 20U);
            throw uploaded_ ? Problem(too_large, detail, "map-too-large")
                            : Problem(unprocessable, detail, "map-beyond-memory");
        }
        const std::scoped_lock lock(shelf_.mutex_);
        while (shelf_.taken() + bytes > most) {
            if (!shelf_.make_way()) {
                throw Problem(unavailable, "the maps in use leave no memory for this one; ask again", "no-memory");
            }
        }
        shelf_.reserved_ += bytes;
        bytes_ += bytes;
    };
    return {.cells = uploaded_ ? shelf_.limits_.map_cells : max_cells, .admit = admit};
}

void MapShelf::Reservation::release() {
    const std::scoped_lock lock(shelf_.mutex_);
    shelf_.reserved_ -= std::exchange(bytes_, 0);
}

void MapShelf::hold(Place& place, SharedMap map, Reservation& reservation) {
    const std::size_t bytes = io::memory_of(map->file) + map->bytes.capacity();
    reservation.release();
    const std::scoped_lock lock(mutex_);
    place.map = std::move(map);
    place.used = ++uses_;
    place.bytes = bytes;
    const auto held = [this] {
        return std::size_t(
            std::count_if(places_.begin(), places_.end(), [](const auto& entry) { return entry.second->map; }));
    };
    while ((held() > limits_.maps || taken() > limits_.memory) && make_way(&place)) {
    }
}

ShelvedMap MapShelf::read(const std::string& id, const MapLimits& limits) const {
    const std::string path = path_of(id);
    const BuiltInMap* const built_in = path.empty() ? built_in_map(id) : nullptr;
    std::string bytes = built_in ? std::string(built_in->bytes()) : io::read_whole(path);
    if (fs::path(path).extension() == ".yaml" && mapfile::is_ros_yaml(bytes)) {
        require_image_inside(bytes, path, folder_);
        return {.file = mapfile::read_map_file(path)};
    }
    io::MapFile file = mapfile::parse_map(bytes, id, Connectivity::four, {}, limits);
    bytes.shrink_to_fit();  // they are kept, and were read into more room than they need
    return {.file = std::move(file), .bytes = std::move(bytes)};
}

SharedMap MapShelf::at_hand(const std::string& id) {
    return held(*place_of(id));
}

SharedMap MapShelf::take(const std::string& id) {
    const std::shared_ptr<Place> place = place_of(id);
    const std::scoped_lock reading(place->reading);
    SharedMap map = held(*place);
    if (map) return map;
    Reservation reservation(*this, false);
    try {
        map = std::make_shared<const ShelvedMap>(read(id, reservation.limits()));
    } catch (const InputError&) {
        throw Problem(unprocessable, id + " is not a map that can be read",
                      "map-unreadable");  // the reason would name our folders
    }
    hold(*place, map, reservation);
    return map;
}

std::optional<MapShelf::Upload> MapShelf::kept(const std::string& id) {
    const std::scoped_lock lock(mutex_);
    const auto known = places_.find(id);
    if (known == places_.end() || !known->second->map) return std::nullopt;
    known->second->used = ++uses_;
    return Upload{id, known->second->map, false};
}

MapShelf::Upload MapShelf::add(std::string bytes, Connectivity connectivity) {
    if (const auto known = kept(upload_id(bytes, connectivity))) return *known;
    try {
        return add([&](const MapLimits& limits) -> ShelvedMap {
            io::MapFile file = mapfile::parse_map(bytes, "the map", connectivity, {}, limits);
            return {.file = std::move(file), .connectivity = connectivity, .bytes = std::move(bytes)};
        });
    } catch (const SizeError& error) {
        throw Problem(too_large, error.what(), "map-too-large");
    } catch (const InputError& error) {
        throw Problem(unprocessable, error.what(), "map-unreadable");
    }
}

MapShelf::Upload MapShelf::add(const std::function<ShelvedMap(const MapLimits&)>& make) {
    const std::scoped_lock adding(adding_);
    Reservation reservation(*this, true);
    return keep(make(reservation.limits()), reservation);
}

MapShelf::Upload MapShelf::keep(ShelvedMap map, Reservation& reservation) {
    const std::string id = upload_id(map.bytes, map.connectivity);
    if (const auto known = kept(id)) return *known;
    map.file.source = id;
    const auto shared = std::make_shared<const ShelvedMap>(std::move(map));
    const auto place = std::make_shared<Place>();
    place->uploaded = true;
    {
        const std::scoped_lock lock(mutex_);
        places_[id] = place;
    }
    hold(*place, shared, reservation);  // others may have to go
    return {id, shared, true};
}

void MapShelf::remove(const std::string& id) {
    const std::scoped_lock lock(mutex_);
    const auto known = places_.find(id);
    if (known != places_.end() && known->second->uploaded) {
        take_down(id);
    } else if (known != places_.end() || !path_of(id).empty() || built_in_map(id)) {
        throw Problem(forbidden, "only maps that were sent here can be deleted", "map-not-removable");
    } else {
        throw no_such_map();
    }
}

}  // namespace waybreaker::server
