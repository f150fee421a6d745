#include "service/import_worker.hpp"

#include <sys/prctl.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <csignal>
#include <fstream>
#include <memory>
#include <new>
#include <nlohmann/json.hpp>
#include <string_view>
#include <utility>

#include "city/city_import.hpp"
#include "city/overlay_source.hpp"
#include "city/sent_source.hpp"
#include "io/output_file.hpp"
#include "service/extract_json.hpp"
#include "service/import_request.hpp"
#include "service/sanitizer.hpp"
#include "waybreaker/error.hpp"

namespace waybreaker::service {
namespace {

using Json = nlohmann::ordered_json;

void set_limit(__rlimit_resource_t resource, rlim_t most) {
    const rlimit limit{most, most};
    setrlimit(resource, &limit);
}

// What the program has already.
std::size_t memory_of_program() {
    std::ifstream status("/proc/self/status");
    for (std::string word; status >> word;) {
        std::size_t kilobytes = 0;
        if (word == "VmData:" && status >> kilobytes) return kilobytes << 10U;
    }
    return 0;
}

// What a sanitizer adds to each block, and what it holds back of those that were freed.
constexpr std::size_t memory_of_sanitizer = sanitized ? std::size_t{1} << 30 : 0;

// GEOS would leave out a shape that it has no memory for, and go on.
void limit_memory(std::size_t bytes) {
    set_limit(RLIMIT_DATA, memory_of_program() + memory_of_sanitizer + bytes);
    set_limit(RLIMIT_CORE, 0);
    std::set_new_handler([] { _exit(worker_out_of_memory); });
}

std::string everything_said() {
    std::string all;
    constexpr std::size_t piece = std::size_t{1} << 20;
    while (true) {
        const std::size_t before = all.size();
        all.resize(before + piece);
        const ssize_t count = read(STDIN_FILENO, all.data() + before, piece);
        if (count < 0 && errno != EINTR) return "";
        all.resize(before + std::size_t(std::max<ssize_t>(count, 0)));
        if (count == 0) return all;
    }
}

Json problem(std::string_view kind, const std::string& detail) {
    return {{"problem", {{"kind", kind}, {"detail", detail}}}};
}

std::string answer_of(Json line, const std::string& file = "") {
    line["bytes"] = file.size();
    return line.dump(-1, ' ', false, Json::error_handler_t::replace) + "\n" + file;
}

std::string extract_answer(const city::SentSource& source) {
    try {
        return answer_of({{"extract", extract_json(city::read_extract(source.path()))}});
    } catch (const InputError& error) {
        return answer_of(problem("source-unreadable", source.named(error.what())));
    }
}

std::string import_answer(const city::SentSource& source, const Json& asked) {
    try {
        const ImportRequest request = parse_import_request(asked.at("request").get<std::string>());
        const city::Extract extract{.densest = asked.at("densest"), .side = asked.at("side")};
        const city::ImportReport report = city::import_city(source.path(), window_of(request, extract));
        return answer_of(Json::object(), geotiff::label_tiff_bytes(report.tiff));
    } catch (const InputError& error) {
        return answer_of(problem("import-unfit", source.named(worded(error))));
    }
}

// The things of the overlay, as a map of their own.
std::string overlay_answer(const city::SentSource& source, const Json& asked) {
    try {
        const site::Georeference place{asked.at("crs").get<std::string>(), asked.at("transform")};
        const auto* const use = std::ranges::find(site::overlay_use_words, asked.at("as").get<std::string>());
        city::ReadOverlay read = city::read_overlay({.file = source.path(),
                                                     .use = site::OverlayUse(use - site::overlay_use_words.begin()),
                                                     .width = asked.at("width")},
                                                    place, asked.at("columns"), asked.at("rows"));
        site::DescribedMap things = site::described(std::move(read.overlay.things));
        return answer_of({{"notes", read.report.notes}},
                         geotiff::label_tiff_bytes({.map = std::move(things.map),
                                                    .cell_size = place.transform[1],
                                                    .georeference = place,
                                                    .annotations = std::move(things.annotations)}));
    } catch (const InputError& error) {
        return answer_of(problem("source-unreadable", source.named(worded(error))));
    }
}

std::string answer_to(const city::SentSource& source, const Json& asked) {
    if (asked.at("task") == "overlay") return overlay_answer(source, asked);
    return asked.at("task") == "import" ? import_answer(source, asked) : extract_answer(source);
}

}  // namespace

int run_import_worker(const std::string& memory, const std::string& seconds) {
    prctl(PR_SET_PDEATHSIG, SIGKILL);  // who started it is gone: nobody wants the answer
    set_limit(RLIMIT_CPU, rlim_t(std::ceil(std::stod(seconds))));
    limit_memory(std::stoull(memory));
    std::string said = everything_said();
    const std::size_t end = said.find('\n');
    if (end == std::string::npos) return 1;
    const Json asked = Json::parse(said.substr(0, end));
    said.erase(0, end + 1);
    const city::SentSource source(asked.at("name"), std::make_shared<const std::string>(std::move(said)));
    io::write_whole("-", answer_to(source, asked));
    return 0;
}

}  // namespace waybreaker::service
