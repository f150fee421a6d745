#include "service/importer.hpp"

#include <fmt/format.h>
#include <sys/wait.h>

#include <algorithm>
#include <array>
#include <csignal>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <utility>

#include "http/problem.hpp"
#include "service/child_process.hpp"
#include "service/extract_json.hpp"
#include "service/import_worker.hpp"
#include "service/problem_kind.hpp"

namespace waybreaker::service {
namespace {

using Json = nlohmann::ordered_json;

http::Problem too_long() {
    return {http::unprocessable,
            "it took too long: choose a smaller window or larger cells, or cut a piece out of the data",
            "import-too-long"};
}

// Why a worker has not answered.
http::Problem failure(const ChildEnd& end, std::size_t memory) {
    if (end.stopped || (WIFSIGNALED(end.status) && WTERMSIG(end.status) == SIGXCPU)) return too_long();
    const bool ran_out = WIFEXITED(end.status) ? WEXITSTATUS(end.status) == worker_out_of_memory
                                               : WTERMSIG(end.status) == SIGABRT || WTERMSIG(end.status) == SIGKILL;
    if (ran_out) {
        return {http::unprocessable,
                fmt::format("it takes more than the {} MB of memory that an import of its size may take: choose a "
                            "smaller window, or cut a piece out of the data",
                            memory >> 20U),
                "import-beyond-memory"};
    }
    throw std::runtime_error(WIFEXITED(end.status)
                                 ? fmt::format("an import ended with status {}", WEXITSTATUS(end.status))
                                 : fmt::format("an import was ended by signal {}", WTERMSIG(end.status)));
}

// Whether the worker came to the end of its answer.
bool is_whole(const Json& line, std::string_view file) {
    return line.is_object() && line.value("bytes", std::size_t{0}) == file.size();
}

// Throws the problem that an answer says there is.
void require_no_problem(const Json& line) {
    const auto problem = line.find("problem");
    if (problem == line.end()) return;
    const ProblemKind* const kind = kind_of(std::string_view(problem->at("kind").get_ref<const std::string&>()));
    if (kind == nullptr) throw std::runtime_error("an import has a problem that is none of ours");
    throw http::Problem(http::Status(kind->status), problem->at("detail"), kind->name);
}

}  // namespace

std::size_t import_memory(std::size_t bytes, std::size_t cells) {
    constexpr std::size_t least = std::size_t{96} << 20;
    constexpr std::size_t of_byte = 64;  // data of cities takes up to 33, packed as it comes
    constexpr std::size_t of_cell = 32;  // and up to 20
    return least + of_byte * bytes + of_cell * cells;
}

Importer::Importer(std::vector<std::string> worker, const ServiceLimits& limits, MemoryBudget& budget)
    : worker_(std::move(worker)), limits_(limits), budget_(budget) {}

Importer::Answer Importer::ask(const Json& task, std::string_view bytes, std::size_t memory,
                               const StopToken& stop) const {
    MemoryBudget::Share share(budget_, MemoryBudget::Use::importer);
    if (!share.grow(memory)) {
        if (memory <= budget_.most()) {
            throw http::Problem(http::unavailable, "what others use leaves no memory for this import; ask again",
                                "no-memory");
        }
        throw http::Problem(http::too_large,
                            fmt::format("to read it may take {} MB of memory, all that is at work may take {} MB "
                                        "(--max-memory)",
                                        memory >> 20U, budget_.most() >> 20U),
                            "source-too-large");
    }
    constexpr double grace = 1;  // the one who asks sees a limit of the processor's time later than his own
    std::vector<std::string> command = worker_;
    command.push_back(std::to_string(memory));
    command.push_back(fmt::format("{}", limits_.seconds + grace));
    const std::string head = task.dump() + "\n";
    const std::array<std::string_view, 2> input{head, bytes};
    const ChildEnd end = run_child(command, input, memory, stop);
    const std::size_t break_at = std::min(end.said.find('\n'), end.said.size());
    Answer answer{.line = Json::parse(end.said.substr(0, break_at), nullptr, false),
                  .file = end.said.substr(std::min(break_at + 1, end.said.size()))};
    if (end.stopped || !is_whole(answer.line, answer.file)) throw failure(end, memory);
    require_no_problem(answer.line);
    return answer;
}

city::Extract Importer::extract(const std::string& name, std::string_view bytes, const StopToken& stop) const {
    const Json task{{"task", "extract"}, {"name", name}};
    return extract_of(ask(task, bytes, import_memory(bytes.size(), 0), stop).line.at("extract"));
}

std::string Importer::import(const std::string& name, std::string_view bytes, const city::Extract& extract,
                             const ImportRequest& request, std::size_t most_cells, const StopToken& stop) const {
    const std::size_t cells = cells_of(request, extract, most_cells);
    const Json task{{"task", "import"},
                    {"name", name},
                    {"request", request.text},
                    {"densest", extract.densest},
                    {"side", extract.side}};
    return ask(task, bytes, import_memory(bytes.size(), cells), stop).file;
}

Importer::Overlay Importer::overlay(const city::OverlaySource& source, std::string_view bytes, const io::MapFile& map,
                                    const StopToken& stop) const {
    const site::Georeference& place = map.georeference.value();
    const Json task{{"task", "overlay"},
                    {"name", source.file},
                    {"as", site::overlay_use_words[std::size_t(source.use)]},
                    {"width", source.width},
                    {"crs", place.crs},
                    {"transform", place.transform},
                    {"columns", map.map.width()},
                    {"rows", map.map.height()}};
    Answer answer = ask(task, bytes, import_memory(bytes.size(), map.map.grid().cell_count()), stop);
    return {.tiff = std::move(answer.file), .notes = answer.line.at("notes")};
}

}  // namespace waybreaker::service
