#include <new>
#include <span>
#include <utility>
#include <vector>

#include "capi/handles.hpp"
#include "io/check_report.hpp"
#include "io/mission_json.hpp"
#include "io/plan_file.hpp"
#include "io/plan_json.hpp"
#include "render/plan_picture.hpp"

namespace waybreaker::capi {
namespace {

using Text = std::unique_ptr<waybreaker_text>;

constexpr double usual_seconds = 10;  // as the command has it

// Holds the lock of a planner.
class Lock {
  public:
    explicit Lock(waybreaker_planner& planner) : locked_(planner.locked) {
        while (locked_.test_and_set(std::memory_order_acquire)) continue;
    }
    ~Lock() { locked_.clear(std::memory_order_release); }
    Lock(const Lock&) = delete;
    Lock& operator=(const Lock&) = delete;

  private:
    std::atomic_flag& locked_;
};

// A call that others can stop, until it ends.
class Running {
  public:
    explicit Running(waybreaker_planner& planner) : planner_(planner) { set(source_); }
    ~Running() { set(std::nullopt); }
    Running(const Running&) = delete;
    Running& operator=(const Running&) = delete;
    StopToken token() const { return source_.get_token(); }

  private:
    void set(std::optional<StopSource> source) {
        const Lock lock(planner_);
        planner_.running.swap(source);
    }

    waybreaker_planner& planner_;
    StopSource source_;
};

// A mission on a map; the map to plan on is a copy where obstacles weigh something else.
struct MissionOnMap {
    io::MissionDocument asked;
    std::optional<io::MapFile> reweighed = {};
};

MissionOnMap mission_on(const io::MapFile& file, std::string_view document, const StopToken& stop) {
    MissionOnMap mission{.asked = io::parse_mission(document, "the mission", {.seconds = usual_seconds})};
    mission.asked.map.clear();  // it is for the map given
    if (std::optional<Map> other = io::settle(mission.asked, file)) {
        mission.reweighed = file;
        mission.reweighed->map = std::move(*other);
    }
    mission.asked.limits.stop = stop;
    io::validate_on(mission.reweighed ? *mission.reweighed : file, mission.asked);
    return mission;
}

// The document of the plans that `make` makes of the mission: one, or a front.
template <class Make>
Text document_of(waybreaker_planner& planner, const waybreaker_map& map, std::string_view mission_document,
                 bool timing_fields, Make make) {
    const Running running(planner);
    const MissionOnMap mission = mission_on(map.file, mission_document, running.token());
    const io::MapFile& file = mission.reweighed ? *mission.reweighed : map.file;
    if (!planner.kept) planner.kept.emplace();
    try {
        return text_of(make(*planner.kept, io::PlanContext{.map = file,
                                                           .asked = mission.asked,
                                                           .connectivity = map.connectivity,
                                                           .timing_fields = timing_fields}));
    } catch (...) {
        planner.kept.reset();  // it may have got half way
        throw;
    }
}

std::string plan_document(Planner& planner, const io::PlanContext& context) {
    const io::MissionDocument& asked = context.asked;
    return io::plan_json(planner.plan(context.map.map, asked.mission, asked.method, asked.limits), context);
}

std::string front_document(Planner& planner, const io::PlanContext& context) {
    io::MissionDocument asked = context.asked;
    const std::vector<Plan> front = planner.front(context.map.map, asked.mission, asked.method, asked.limits);
    asked.mission.rules.removals = io::removals_of(front, asked.mission.rules);
    return io::plan_json(front.back(), {.map = context.map,
                                        .asked = asked,
                                        .connectivity = context.connectivity,
                                        .timing_fields = context.timing_fields,
                                        .front = front});
}

io::PlanFile plan_on(const waybreaker_map& map, std::string_view document) {
    io::PlanFile plan = io::parse_plan(document, "the plan");
    if (plan.connectivity == map.connectivity) return plan;
    const char* const neighbours = plan.connectivity == Connectivity::eight ? "8" : "4";
    throw InputError(std::string("the plan is for a map of connectivity ") + neighbours + ": make the map with it");
}

std::string picture(const waybreaker_map& map, std::string_view document) {
    const io::PlanFile plan = plan_on(map, document);
    const std::vector<Violation> violations = io::judge(plan, map.file);
    if (!violations.empty()) throw InputError("the plan is not valid: " + violations.front().message);
    if (plan.plan.agents.empty()) throw InputError("the plan has no agents to draw");
    return render::plan_svg(map.file, plan);
}

}  // namespace
}  // namespace waybreaker::capi

namespace capi = waybreaker::capi;

waybreaker_planner* waybreaker_planner_new(void) {
    return new (std::nothrow) waybreaker_planner;
}

void waybreaker_planner_free(waybreaker_planner* planner) {
    delete planner;
}

void waybreaker_planner_stop(waybreaker_planner* planner) {
    if (planner == nullptr) return;
    const capi::Lock lock(*planner);
    if (planner->running) planner->running->request_stop();
}

waybreaker_status waybreaker_plan(waybreaker_planner* planner, const waybreaker_map* map, const char* mission,
                                  size_t mission_size, bool timing_fields, waybreaker_text** plan,
                                  waybreaker_text** error) {
    return capi::give(plan, error, [&] {
        return capi::document_of(capi::required(planner, "the planner"), capi::required(map, "the map"),
                                 capi::bytes_of(mission, mission_size, "the mission"), timing_fields,
                                 capi::plan_document);
    });
}

waybreaker_status waybreaker_front(waybreaker_planner* planner, const waybreaker_map* map, const char* mission,
                                   size_t mission_size, bool timing_fields, waybreaker_text** plan,
                                   waybreaker_text** error) {
    return capi::give(plan, error, [&] {
        return capi::document_of(capi::required(planner, "the planner"), capi::required(map, "the map"),
                                 capi::bytes_of(mission, mission_size, "the mission"), timing_fields,
                                 capi::front_document);
    });
}

waybreaker_status waybreaker_check(const waybreaker_map* map, const char* plan, size_t plan_size, bool* valid,
                                   waybreaker_text** report, waybreaker_text** error) {
    if (valid != nullptr) *valid = false;
    return capi::give(report, error, [&] {
        const waybreaker_map& on = capi::required(map, "the map");
        const std::vector<waybreaker::Violation> violations =
            waybreaker::io::judge(capi::plan_on(on, capi::bytes_of(plan, plan_size, "the plan")), on.file);
        capi::Text text = capi::text_of(waybreaker::io::check_json(violations));
        if (valid != nullptr) *valid = violations.empty();
        return text;
    });
}

waybreaker_status waybreaker_plan_svg(const waybreaker_map* map, const char* plan, size_t plan_size,
                                      waybreaker_text** svg, waybreaker_text** error) {
    return capi::give(svg, error, [&] {
        return capi::text_of(
            capi::picture(capi::required(map, "the map"), capi::bytes_of(plan, plan_size, "the plan")));
    });
}
