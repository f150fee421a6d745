// Import worker: what the process does that an Importer starts. It reads from standard input what is to be done, as a
// line of JSON, and map data after it, and answers on standard output: a line of JSON, and the file of a map.
//
//     {"task": "extract", "name": "river.osm"}              {"extract": {...}, "bytes": 0}
//     {"task": "import", "name": "river.osm",               {"bytes": 1234}
//      "request": "{...}", "densest": [9, 50], "side": 60}
//     {"task": "overlay", "name": "flood.geojson",          {"notes": ["..."], "bytes": 1234}
//      "as": "water", "width": 0, "crs": "...",
//      "transform": [...], "columns": 500, "rows": 500}
//                                                           {"problem": {"kind": "import-unfit", "detail": "..."},
//                                                           "bytes": 0}
//
// `bytes` are those of the file.
#pragma once

#include <string>

namespace waybreaker::service {

// What programs call it that start themselves as one: PROGRAM import-worker MEMORY SECONDS.
inline constexpr auto import_worker_word = "import-worker";

// The status of a worker that needs more memory than it may take.
inline constexpr int worker_out_of_memory = 75;

// `arguments`: bytes of memory beyond those of the program itself, seconds of the processor. Returns the exit status.
int run_import_worker(const std::string& memory, const std::string& seconds);

}  // namespace waybreaker::service
