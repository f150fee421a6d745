// What the page's Worker calls: the answers of the service to the same requests, without HTTP. Each call takes texts as
// address and size, and leaves a text: its answer, or one line that says what is wrong. For one thread.
#include <algorithm>
#include <map>
#include <new>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "io/check_report.hpp"
#include "io/map_document.hpp"
#include "io/mission_document.hpp"
#include "io/plan_file.hpp"
#include "io/plan_json.hpp"
#include "io/sha256.hpp"
#include "request/map_edits.hpp"
#include "request/plan_request.hpp"
#include "request/revision.hpp"
#include "waybreaker/error.hpp"
#include "waybreaker/movingai.hpp"
#include "waybreaker/planner.hpp"
#include "waybreaker/revise.hpp"
#include "web/export.hpp"

// From the page: a better plan or bound is known.
extern "C" __attribute__((import_module("page"), import_name("progress"))) void waybreaker_web_progress(double best,
                                                                                                        double bound);

namespace waybreaker::web {
namespace {

constexpr double most_seconds = 30;  // of a plan, as `waybreaker serve` has it

struct State {
    std::map<int, io::DocumentedMap> maps;
    int last_map = 0;
    Planner planner;
    std::string answer;
};

State& state() {
    static State all;
    return all;
}

// Leaves the text that `make` returns. Whether that went well.
template <class Make>
bool answered(Make make) {
    std::string& answer = state().answer;
    try {
        answer = make();
        return true;
    } catch (const InputError& error) {
        answer = error.what();
    } catch (const std::bad_alloc&) {
        answer = "there is not enough memory";
    }
    return false;
}

int kept(io::DocumentedMap map) {
    state().maps.emplace(++state().last_map, std::move(map));
    return state().last_map;
}

const io::DocumentedMap& map_called(int number) {
    const auto found = state().maps.find(number);
    if (found == state().maps.end()) throw InputError("there is no such map");
    return found->second;
}

// A map that no file holds is known by its content.
std::string named(io::DocumentedMap& map) {
    constexpr std::size_t scheme = 7;  // "sha256:"
    constexpr std::size_t digits = 16;
    if (map.file.digest.empty()) map.file.digest = io::sha256_digest(io::map_document("", map));
    return "upload-" + map.file.digest.substr(scheme, digits);
}

// The number of a new map, and its document.
std::string new_map(io::DocumentedMap map) {
    const std::string id = named(map);
    std::string document = io::map_document(id, map);
    return std::to_string(kept(std::move(map))) + "\n" + document;
}

void report(const Progress& progress) {
    waybreaker_web_progress(progress.best, progress.bound);
}

// A plan of a mission with these options on the map.
std::string plan_text(const io::DocumentedMap& map, const request::PlanRequest& asked,
                      const request::OptionsRequest& options) {
    request::MissionOnMap made = request::on_map(asked.mission, options, map.file);
    std::optional<io::MapFile> reweighted;
    if (made.reweighted) {
        reweighted = map.file;
        reweighted->map = std::move(*made.reweighted);
    }
    const io::MapFile& file = reweighted ? *reweighted : map.file;
    Limits& limits = made.asked.limits;
    limits.seconds = std::min(limits.seconds, most_seconds);
    limits.progress = report;
    io::validate_on(file, made.asked);
    const Plan plan = state().planner.plan(file.map, made.asked.mission, made.asked.method, limits);
    return io::plan_json(
        plan,
        {.map = file, .asked = made.asked, .connectivity = map.connectivity, .timing_fields = asked.timing_fields});
}

// What comes of a plan, of the map, after what has happened to it.
std::string revision_text(const io::DocumentedMap& map, const request::RevisionRequest& asked) {
    const io::PlanFile& before = asked.before;
    io::require_connectivity(before, map.connectivity, "the plan");
    io::MapFile known = revision::map_of(before, map.file, "the plan");
    const Limits limits{.seconds = std::min(asked.seconds, most_seconds)};
    Revision next = revise(state().planner, known.map, before.asked.mission, before.plan, asked.state, asked.reaction,
                           before.asked.method, limits);
    return request::revision_answer(asked, revision::next_file(before, std::move(known), std::move(next)));
}

}  // namespace
}  // namespace waybreaker::web

using namespace waybreaker;
using web::answered;

#define EXPORTED(name) extern "C" __attribute__((export_name(#name)))

EXPORTED(answer_data) const char* waybreaker_web_answer_data() {
    return web::state().answer.data();
}

EXPORTED(answer_size) std::size_t waybreaker_web_answer_size() {
    return web::state().answer.size();
}

// The number of the map.
EXPORTED(open_map) bool waybreaker_web_open_map(const char* document, std::size_t size) {
    return answered([&] { return std::to_string(web::kept(io::parse_map_document({document, size}, "the map"))); });
}

// The next two: the number of the map, an end of line, its document.
EXPORTED(read_map) bool waybreaker_web_read_map(const char* file, std::size_t size) {
    return answered([&] {
        const std::string_view bytes(file, size);
        io::DocumentedMap map{.file = {.map = Map(read_movingai_map(bytes, "the map"))}};
        map.file.format = "MovingAI map";
        map.file.digest = io::sha256_digest(bytes);
        map.file.source = web::named(map);  // as the service calls what is sent to it
        return web::new_map(std::move(map));
    });
}

EXPORTED(edit) bool waybreaker_web_edit(int map, const char* edits, std::size_t size) {
    return answered([&] {
        const io::DocumentedMap& before = web::map_called(map);
        io::MapFile file =
            request::edited_map(before.file, before.connectivity, request::parse_map_edits({edits, size})).file;
        return web::new_map({.file = std::move(file), .connectivity = before.connectivity, .place = before.place});
    });
}

EXPORTED(close_map) void waybreaker_web_close_map(int map) {
    web::state().maps.erase(map);
}

EXPORTED(plan) bool waybreaker_web_plan(int map, const char* asked, std::size_t size) {
    return answered([&] {
        const request::PlanRequest wanted = request::parse_plan_request({asked, size});
        return web::plan_text(web::map_called(map), wanted, wanted.options);
    });
}

EXPORTED(revise) bool waybreaker_web_revise(int map, const char* asked, std::size_t size) {
    return answered([&] {
        return web::revision_text(web::map_called(map), request::parse_revision_request({asked, size}));
    });
}

EXPORTED(check) bool waybreaker_web_check(int map, const char* plan, std::size_t size) {
    return answered([&] {
        return io::check_json(io::judge(io::parse_plan({plan, size}, "the plan"), web::map_called(map).file));
    });
}

EXPORTED(export_plan)
bool waybreaker_web_export(int map, const char* plan, std::size_t size, const char* format, std::size_t format_size) {
    return answered(
        [&] { return web::exported(web::map_called(map), std::string(plan, size), std::string(format, format_size)); });
}
