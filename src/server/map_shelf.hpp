// Map shelf: the maps a server knows, those of a folder, the one built in and those sent to it. Each is read once and
// shared, read-only, by all who plan on it. All together they take no more memory than ServiceLimits say, and are no
// more: for a new one others go, those first that were sent, of these the one not used for longest.
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
    MapShelf(const std::string& folder, const ServiceLimits& limits);

    struct Entry {
        std::string id;
        bool uploaded = false;
        bool loaded = false;  // a map of the folder is read when it is first asked for
    };
    // By id. What is in the folder now, where a file of its name stands in for the built-in map; files with names that
    // could not be ids, or that lead outside, are passed over.
    std::vector<Entry> list() const;

    // A map if it is in memory; else null: take() has to read it, which takes time. Throws Problem if there is none of
    // that name. Any thread may ask.
    SharedMap at_hand(const std::string& id);
    // Throws Problem: there is none of that name, it cannot be read, or there is no memory for it. Any thread may ask.
    SharedMap take(const std::string& id);

    struct Upload {
        std::string id;
        SharedMap map;
        bool is_new = false;
    };
    // Keeps a map in memory. The same bytes get the same id. Throws Problem if they are no map, or too large a one, or
    // if those in use leave no memory for it.
    Upload add(std::string bytes, Connectivity connectivity);
    // The same for a map that `make` reads, minding the limits.
    Upload add(const std::function<ShelvedMap(const MapLimits&)>& make);

    // Forgets a map that was sent; who plans on it keeps it for so long. Throws Problem for others.
    void remove(const std::string& id);

    // What all maps take, in bytes: those that are gone, but in use, as well.
    std::size_t memory() const;

    // Whether a text can be the id of a map: letters, digits, dots, dashes and underscores, no dot first.
    static bool is_id(const std::string& text);

  private:
    struct Place {
        std::mutex reading;
        SharedMap map;  // guarded by mutex_ of the shelf
        bool uploaded = false;
        std::uint64_t used = 0;
        std::size_t bytes = 0;
    };
    // Memory of a map from before it is made.
    class Reservation {
      public:
        Reservation(MapShelf& shelf, bool uploaded) : shelf_(shelf), uploaded_(uploaded) {}
        Reservation(const Reservation&) = delete;
        Reservation& operator=(const Reservation&) = delete;
        ~Reservation() { release(); }
        MapLimits limits();
        void release();

      private:
        MapShelf& shelf_;
        bool uploaded_;
        std::size_t bytes_ = 0;
    };
    // What is no longer on the shelf, but in use.
    struct Lent {
        std::weak_ptr<const ShelvedMap> map;
        std::size_t bytes;
    };
    std::string path_of(const std::string& id) const;
    ShelvedMap read(const std::string& id, const MapLimits& limits) const;
    std::shared_ptr<Place> place_of(const std::string& id);
    std::optional<Upload> kept(const std::string& id);
    SharedMap held(Place& place);
    Upload keep(ShelvedMap map, Reservation& reservation);
    void hold(Place& place, SharedMap map, Reservation& reservation);
    // With mutex_ locked:
    std::size_t taken() const;
    bool make_way(const Place* spared = nullptr);
    void take_down(const std::string& id);

    std::string folder_;
    ServiceLimits limits_;
    mutable std::mutex mutex_;
    std::mutex adding_;  // one upload is read at a time: reading needs several times the memory of the map
    std::size_t reserved_ = 0;
    std::vector<Lent> lent_;
    std::map<std::string, std::shared_ptr<Place>> places_;
    std::uint64_t uses_ = 0;
};

}  // namespace waybreaker::server
