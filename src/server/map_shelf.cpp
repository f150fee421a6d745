#include "server/map_shelf.hpp"

#include <algorithm>
#include <filesystem>
#include <optional>
#include <set>
#include <utility>

#include "io/digest.hpp"
#include "io/output_file.hpp"
#include "io/ros_map.hpp"
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
    const fs::path image = path.parent_path() / io::parse_ros_yaml(yaml, path.filename().string()).image;
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
    const std::string digest = io::sha256_digest(bytes);
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

MapShelf::MapShelf(const std::string& folder, const Limits& limits) : limits_(limits) {
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

void MapShelf::hold(Place& place, SharedMap map) {
    const std::scoped_lock lock(mutex_);
    place.map = std::move(map);
    place.used = ++uses_;
    std::vector<std::pair<std::uint64_t, std::string>> by_use;
    for (const auto& [id, other] : places_) {
        if (other->map) by_use.emplace_back(other->used, id);
    }
    std::sort(by_use.begin(), by_use.end());
    const std::size_t surplus = by_use.size() - std::min(by_use.size(), limits_.maps);
    for (std::size_t i = 0; i < surplus; ++i) places_.erase(by_use[i].second);
}

ShelvedMap MapShelf::read(const std::string& id) const {
    const std::string path = path_of(id);
    const BuiltInMap* const built_in = path.empty() ? built_in_map(id) : nullptr;
    std::string bytes = built_in ? std::string(built_in->bytes()) : io::read_whole(path);
    if (fs::path(path).extension() == ".yaml" && io::is_ros_yaml(bytes)) {
        require_image_inside(bytes, path, folder_);
        return {.file = io::read_map_file(path)};
    }
    io::MapFile file = io::parse_map(bytes, id);
    return {.file = std::move(file), .bytes = std::move(bytes)};
}

SharedMap MapShelf::take(const std::string& id) {
    const std::shared_ptr<Place> place = place_of(id);
    const std::scoped_lock reading(place->reading);
    SharedMap map = held(*place);
    if (map) return map;
    try {
        map = std::make_shared<const ShelvedMap>(read(id));
    } catch (const InputError&) {
        throw Problem(unprocessable, id + " is not a map that can be read",
                      "map-unreadable");  // the reason would name our folders
    }
    hold(*place, map);
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
    const std::scoped_lock adding(adding_);
    if (const auto known = kept(upload_id(bytes, connectivity))) return *known;
    try {
        io::MapFile file = io::parse_map(bytes, "the map", connectivity, {}, limits_.map_cells);
        return keep({.file = std::move(file), .connectivity = connectivity, .bytes = std::move(bytes)});
    } catch (const SizeError& error) {
        throw Problem(too_large, error.what(), "map-too-large");
    } catch (const InputError& error) {
        throw Problem(unprocessable, error.what(), "map-unreadable");
    }
}

MapShelf::Upload MapShelf::keep(ShelvedMap map) {
    const std::string id = upload_id(map.bytes, map.connectivity);
    if (const auto known = kept(id)) return *known;
    map.file.source = id;
    const auto shared = std::make_shared<const ShelvedMap>(std::move(map));
    const auto place = std::make_shared<Place>();
    place->uploaded = true;
    place->map = shared;
    {
        const std::scoped_lock lock(mutex_);
        places_[id] = place;
    }
    hold(*place, shared);  // others may have to go
    return {id, shared, true};
}

void MapShelf::remove(const std::string& id) {
    const std::scoped_lock lock(mutex_);
    const auto known = places_.find(id);
    if (known != places_.end() && known->second->uploaded) {
        places_.erase(known);
    } else if (known != places_.end() || !path_of(id).empty() || built_in_map(id)) {
        throw Problem(forbidden, "only maps that were sent here can be deleted", "map-not-removable");
    } else {
        throw no_such_map();
    }
}

}  // namespace waybreaker::server
