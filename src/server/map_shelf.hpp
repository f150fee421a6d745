// Map shelf: the maps a server knows, those of a folder, the one built in and those sent to it. Each is read once and
// shared, read-only, by all who plan on it.
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "io/map_file.hpp"
#include "server/limits.hpp"

namespace waybreaker::server {

// A map, how its obstacles were told apart, and the bytes it was read from (none of a ROS map, which is two files).
struct ShelvedMap {
    io::MapFile file;
    Connectivity connectivity = Connectivity::four;
    std::string bytes = {};
};
using SharedMap = std::shared_ptr<const ShelvedMap>;

class MapShelf {
  public:
    // `folder` may be empty. Throws InputError if it is not a folder.
    MapShelf(const std::string& folder, const Limits& limits);

    struct Entry {
        std::string id;
        bool uploaded = false;
        bool loaded = false;  // a map of the folder is read when it is first asked for
    };
    // By id. What is in the folder now, where a file of its name stands in for the built-in map; files with names that
    // could not be ids, or that lead outside, are passed over.
    std::vector<Entry> list() const;

    // Throws Problem: there is none of that name, or it cannot be read. Any thread may ask.
    SharedMap take(const std::string& id);

    struct Upload {
        std::string id;
        SharedMap map;
        bool is_new = false;
    };
    // Keeps a map in memory. The same bytes get the same id. Throws Problem if they are no map, or too large a one.
    Upload add(std::string bytes, Connectivity connectivity);
    // The same for a map that has been read already.
    Upload keep(ShelvedMap map);

    // Forgets a map that was sent; who plans on it keeps it for so long. Throws Problem for others.
    void remove(const std::string& id);

    // Whether a text can be the id of a map: letters, digits, dots, dashes and underscores, no dot first.
    static bool is_id(const std::string& text);

  private:
    struct Place {
        std::mutex reading;
        SharedMap map;  // guarded by mutex_ of the shelf
        bool uploaded = false;
        std::uint64_t used = 0;
    };
    std::string path_of(const std::string& id) const;
    ShelvedMap read(const std::string& id) const;
    std::shared_ptr<Place> place_of(const std::string& id);
    std::optional<Upload> kept(const std::string& id);
    SharedMap held(Place& place);
    void hold(Place& place, SharedMap map);

    std::string folder_;
    Limits limits_;
    mutable std::mutex mutex_;
    std::mutex adding_;  // one upload is read at a time: reading needs several times the memory of the map
    std::map<std::string, std::shared_ptr<Place>> places_;
    std::uint64_t uses_ = 0;
};

}  // namespace waybreaker::server
