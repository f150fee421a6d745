// Importer: reads the map data of strangers in a process of its own for each, with limits on memory and time. So no
// shape, however hard, takes more than its share, the memory comes back, and what breaks a library does not break the
// service.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "city/extract.hpp"
#include "city/overlay_source.hpp"
#include "io/map_file.hpp"
#include "service/import_request.hpp"
#include "service/limits.hpp"
#include "service/memory_budget.hpp"
#include "waybreaker/limits.hpp"

namespace waybreaker::service {

// What an import may take: so much for data of that size and a window of so many cells, twice what
// cities take.
std::size_t import_memory(std::size_t bytes, std::size_t cells);

class Importer {
  public:
    // `worker`: a program and its arguments, which calls run_import_worker() with those that are added. Keeps the
    // reference.
    Importer(std::vector<std::string> worker, const ServiceLimits& limits, MemoryBudget& budget);

    // What map data covers. Throws Problem if it cannot be read, needs more memory than it may take or there is, or a
    // stop comes before it is read.
    city::Extract extract(const std::string& name, std::string_view bytes, const StopToken& stop) const;

    // The bytes of a GeoTIFF. Throws Problem in the same cases, and if there is no such map in it, or it has more cells
    // than `most_cells`.
    std::string import(const std::string& name, std::string_view bytes, const city::Extract& extract,
                       const ImportRequest& request, std::size_t most_cells, const StopToken& stop) const;

    struct Overlay {
        std::string tiff;
        std::vector<std::string> notes;  // what the user should know
    };
    // The things of an overlay, as a label map on the cells of a map that lies somewhere; `source.file` is what titles
    // and errors call it. Throws Problem if its data cannot be read, or as above.
    Overlay overlay(const city::OverlaySource& source, std::string_view bytes, const io::MapFile& map,
                    const StopToken& stop) const;

  private:
    struct Answer {
        nlohmann::ordered_json line;
        std::string file;
    };
    Answer ask(const nlohmann::ordered_json& task, std::string_view bytes, std::size_t memory,
               const StopToken& stop) const;

    std::vector<std::string> worker_;
    ServiceLimits limits_;
    MemoryBudget& budget_;
};

}  // namespace waybreaker::service
