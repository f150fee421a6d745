#include "page_planner.hpp"

#include <string_view>

#include "http/gzip.hpp"
#include "io/output_file.hpp"
#include "option.hpp"
#include "studio/studio_files.hpp"
#include "waybreaker/error.hpp"

namespace waybreaker::apps {

std::string page_planner(const std::string& file) {
    constexpr std::string_view magic{"\0asm", 4};
    if (file.empty()) {
        if (!studio::planner().empty()) return std::string(studio::planner());
        throw InputError(
            "this waybreaker was built without the planner for pages: build the preset wasm, and give its studio.wasm "
            "with --wasm, or with -DWAYBREAKER_WASM=FILE when waybreaker is configured");
    }
    std::string bytes = io::read_whole(file);
    if (!bytes.starts_with(magic)) throw InputError(file, 0, "is no WebAssembly");
    return bytes;
}

std::string packed_page_planner(const SteerableOptions& options) {
    constexpr int smallest = 9;
    return http::gzip(page_planner(options.wasm), smallest);
}

void add_steerable(CLI::App& command, SteerableOptions& options) {
    CLI::Option* const steerable = command.add_flag(
        "--steerable", options.asked,
        "The page of --html plans by itself: drag the start in a file that was mailed, and it plans anew (1 MB more)");
    steerable->needs("--html");
    add_file(command, "--wasm", options.wasm,
             "The planner of --steerable: studio.wasm of the preset wasm (default: the one that is built in)")
        ->needs(steerable);
}

}  // namespace waybreaker::apps
