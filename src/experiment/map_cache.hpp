// Map cache: the maps that running jobs use, each read once and freed when no job needs it.
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

class MapCache {
  public:
    explicit MapCache(const std::vector<ExperimentMap>& maps) : maps_(maps), slots_(maps.size()) {}

    // Thread-safe. Throws InputError if the file cannot be read or has changed.
    std::shared_ptr<const Map> load(std::size_t index) {
        Slot& slot = slots_[index];
        const std::scoped_lock lock(slot.mutex);
        std::shared_ptr<const Map> map = slot.map.lock();
        if (!map) slot.map = map = read(maps_[index]);
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

    struct Slot {
        std::mutex mutex;
        std::weak_ptr<const Map> map;
    };
    const std::vector<ExperimentMap>& maps_;
    std::vector<Slot> slots_;
};

}  // namespace waybreaker::experiment
