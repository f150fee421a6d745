#include <new>
#include <span>
#include <utility>
#include <vector>

#include "capi/handles.hpp"
#include "io/check_report.hpp"
#include "io/mission_json.hpp"
#include "io/plan_file.hpp"
#include "io/plan_json.hpp"
#include "io/sha256.hpp"
#include "io/state_json.hpp"
#include "mission/reach.hpp"
#include "render/plan_picture.hpp"
#include "revision/revised_file.hpp"

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

// What `work` makes of the planner that is kept from call to call.
template <class Work>
auto with_kept(waybreaker_planner& planner, Work work) {
    if (!planner.kept) planner.kept.emplace();
    try {
        return work(*planner.kept);
    } catch (...) {
        planner.kept.reset();  // it may have got half way
        throw;
    }
}

// The document of the plans that `make` makes of the mission: one, or a front.
template <class Make>
Text document_of(waybreaker_planner& planner, const waybreaker_map& map, std::string_view mission_document,
                 bool timing_fields, Make make) {
    const Running running(planner);
    const MissionOnMap mission = mission_on(map.file, mission_document, running.token());
    const io::MapFile& file = mission.reweighed ? *mission.reweighed : map.file;
    return text_of(with_kept(planner, [&](Planner& kept) {
        return make(
            kept,
            io::PlanContext{
                .map = file, .asked = mission.asked, .connectivity = map.connectivity, .timing_fields = timing_fields});
    }));
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

io::PlanFile plan_on(const waybreaker_map& map, std::string_view document, const char* name = "the plan") {
    io::PlanFile plan = io::parse_plan(document, name);
    io::require_connectivity(plan, map.connectivity, name);
    return plan;
}

// What revises a plan, beside the planner.
struct Revising {
    std::string_view plan;
    std::string_view state;
    double reaction = 0;
    Limits limits = {};
    bool timing_fields = false;
};

std::string revised_document(Planner& planner, const waybreaker_map& map, const Revising& asked) {
    const io::PlanFile before = plan_on(map, asked.plan);
    const State state = io::parse_state(asked.state, "the state");
    const revision::Task task{.before = before,
                              .before_name = "the plan",
                              .digest = io::sha256_digest(asked.plan),
                              .map = map.file,
                              .state = state,
                              .state_name = "the state",
                              .reaction = asked.reaction};
    return revision::revise(planner, task, asked.limits).json(asked.timing_fields);
}

// Gives the report of a judgement, and what it comes to.
Text report_of(const std::vector<Violation>& violations, bool* valid) {
    Text text = text_of(io::check_json(violations));
    if (valid != nullptr) *valid = violations.empty();
    return text;
}

std::string picture(const waybreaker_map& map, std::string_view document) {
    const io::PlanFile plan = plan_on(map, document);
    const io::MapFile known = io::known_map(map.file, plan.plan);
    const std::vector<Violation> violations = io::judge(plan, known);
    if (!violations.empty()) throw InputError("the plan is not valid: " + violations.front().message);
    if (plan.plan.agents.empty()) throw InputError("the plan has no agents to draw");
    return render::plan_svg(known, plan, reach_of(known.map, plan.asked.mission, plan.plan));
}

}  // namespace
}  // namespace waybreaker::capi

namespace capi = waybreaker::capi;
namespace io = waybreaker::io;

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

waybreaker_status waybreaker_revise(waybreaker_planner* planner, const waybreaker_map* map, const char* plan,
                                    size_t plan_size, const char* state, size_t state_size, double reaction,
                                    double seconds, bool timing_fields, waybreaker_text** revised,
                                    waybreaker_text** error) {
    return capi::give(revised, error, [&] {
        waybreaker_planner& on = capi::required(planner, "the planner");
        const waybreaker_map& from = capi::required(map, "the map");
        const capi::Running running(on);
        const capi::Revising asked{.plan = capi::bytes_of(plan, plan_size, "the plan"),
                                   .state = capi::bytes_of(state, state_size, "the state"),
                                   .reaction = reaction,
                                   .limits = {.seconds = seconds, .stop = running.token()},
                                   .timing_fields = timing_fields};
        return capi::text_of(
            capi::with_kept(on, [&](waybreaker::Planner& kept) { return capi::revised_document(kept, from, asked); }));
    });
}

waybreaker_status waybreaker_check(const waybreaker_map* map, const char* plan, size_t plan_size, bool* valid,
                                   waybreaker_text** report, waybreaker_text** error) {
    if (valid != nullptr) *valid = false;
    return capi::give(report, error, [&] {
        const waybreaker_map& on = capi::required(map, "the map");
        const io::PlanFile judged = capi::plan_on(on, capi::bytes_of(plan, plan_size, "the plan"));
        return capi::report_of(io::judge(judged, io::known_map(on.file, judged.plan)), valid);
    });
}

waybreaker_status waybreaker_check_after(const waybreaker_map* map, const char* plan, size_t plan_size,
                                         const char* before, size_t before_size, const char* state, size_t state_size,
                                         bool* valid, waybreaker_text** report, waybreaker_text** error) {
    if (valid != nullptr) *valid = false;
    return capi::give(report, error, [&] {
        const waybreaker_map& on = capi::required(map, "the map");
        const io::PlanFile judged = capi::plan_on(on, capi::bytes_of(plan, plan_size, "the plan"));
        const io::PlanFile earlier =
            capi::plan_on(on, capi::bytes_of(before, before_size, "the plan before"), "the plan before");
        const waybreaker::State reported = io::parse_state(capi::bytes_of(state, state_size, "the state"), "the state");
        return capi::report_of(io::judge_after(judged, io::known_map(on.file, judged.plan), earlier, reported), valid);
    });
}

waybreaker_status waybreaker_plan_svg(const waybreaker_map* map, const char* plan, size_t plan_size,
                                      waybreaker_text** svg, waybreaker_text** error) {
    return capi::give(svg, error, [&] {
        return capi::text_of(
            capi::picture(capi::required(map, "the map"), capi::bytes_of(plan, plan_size, "the plan")));
    });
}
