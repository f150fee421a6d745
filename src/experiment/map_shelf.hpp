// Map shelf: the maps that jobs are at work on, each read once and gone when nobody needs it.
#pragma once

#include <cstddef>
#include <memory>
#include <mutex>
#include <vector>

#include "experiment/experiment.hpp"
#include "io/map_file.hpp"
#include "mapfile/map_reader.hpp"
#include "waybreaker/error.hpp"

namespace waybreaker::experiment {

class MapShelf {
  public:
    explicit MapShelf(const std::vector<ExperimentMap>& maps) : maps_(maps), places_(maps.size()) {}

    // Any thread may ask. Throws InputError if the file cannot be read, or is not what it was.
    std::shared_ptr<const Map> take(std::size_t index) {
        Place& place = places_[index];
        const std::scoped_lock lock(place.mutex);
        std::shared_ptr<const Map> map = place.map.lock();
        if (!map) place.map = map = read(maps_[index]);
        return map;
    }

  private:
    static std::shared_ptr<const Map> read(const ExperimentMap& wanted) {
        io::MapFile file = mapfile::read_map_file(wanted.path);
        if (file.digest != wanted.digest) throw InputError(wanted.path, 0, "has changed since the run began");
        if (file.map.width() != wanted.width || file.map.height() != wanted.height) {
            throw InputError(wanted.path, 0,
                             "has another size than the scenario file says: " + std::to_string(file.map.width()) +
                                 " x " + std::to_string(file.map.height()) + " cells");
        }
        return std::make_shared<const Map>(std::move(file.map));
    }

    struct Place {
        std::mutex mutex;
        std::weak_ptr<const Map> map;
    };
    const std::vector<ExperimentMap>& maps_;
    std::vector<Place> places_;
};

}  // namespace waybreaker::experiment
