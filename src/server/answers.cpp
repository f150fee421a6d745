#include "server/answers.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <map>
#include <nlohmann/json.hpp>
#include <span>
#include <utility>

#include "io/check_report.hpp"
#include "io/map_info.hpp"
#include "io/plan_csv.hpp"
#include "io/plan_file.hpp"
#include "io/plan_geojson.hpp"
#include "io/plan_json.hpp"
#include "io/plan_ros_path.hpp"
#include "io/plan_xml.hpp"
#include "render/picture.hpp"
#include "server/problem.hpp"
#include "waybreaker/error.hpp"

namespace waybreaker::server {
namespace {

using Json = nlohmann::ordered_json;

// A mission that has been put on its map.
struct Posed {
    Mission mission;
    MissionOptions options;
};

// The time that a request has for all its plans.
class Allowance {
  public:
    Allowance(const Task& task, const Workplace& place)
        : seconds_(std::min(task.request.options.options.time_limit, task.seconds)) {
        place.promise(seconds_);
    }

    // One of `plans` equal parts of what is left.
    double share(std::size_t plans) const {
        const std::chrono::duration<double> gone = std::chrono::steady_clock::now() - began_;
        constexpr double least = 1e-3;  // enough for a plan without proof
        return std::max(seconds_ - gone.count(), least) / double(plans);
    }

  private:
    std::chrono::steady_clock::time_point began_ = std::chrono::steady_clock::now();
    double seconds_;
};

Posed pose(const Task& task, const OptionsRequest& wanted, const Workplace& place, double seconds) try {
    const io::MapFile& file = task.map->file;
    Posed posed{mission_of(task.request.mission, file), options_of(wanted, file)};
    posed.options.search.stop = place.stop;
    posed.options.progress = place.tell;
    posed.options.time_limit = std::min(posed.options.time_limit, seconds);
    validate(file.map, posed.mission, posed.options);
    return posed;
} catch (const InputError& error) {
    throw Problem(unprocessable, error.what(), "mission-unfit");
}

io::PlanContext context_of(const Task& task, const Posed& posed, std::span<const Plan> front = {}) {
    return {.map = task.map->file,
            .mission = posed.mission,
            .options = posed.options,
            .connectivity = task.map->connectivity,
            .timing_fields = task.request.timing_fields,
            .front = front};
}

std::string plan_text(const Task& task, const OptionsRequest& wanted, const Workplace& place, double seconds) {
    const Posed posed = pose(task, wanted, place, seconds);
    const Plan plan = place.planner.plan(task.map->file.map, posed.mission, posed.options);
    return io::plan_json(plan, context_of(task, posed));
}

// Nothing removed, the paper's method and the proven choice.
std::vector<Method> usual_methods(const OptionsRequest& common) {
    Method none{"none", common};
    none.options.options.removals = 0;
    none.options.options.force.clear();
    Method paper{"paper", common};
    paper.options.options = paper_options(common.options);
    paper.options.planner_given = true;
    return {std::move(none), std::move(paper), Method{"exact", common}};
}

io::PlanFile plan_of(const ShelvedMap& map, const std::string& bytes) {
    io::PlanFile plan = [&] {
        try {
            return io::parse_plan(bytes, "the plan");
        } catch (const InputError& error) {
            throw Problem(bad_request, error.what());
        }
    }();
    if (plan.connectivity != map.connectivity || plan.image != io::ImageReading()) {
        throw Problem(unprocessable,
                      "the plan was made with another reading of the map (connectivity, threshold) than the server's",
                      "plan-invalid");
    }
    return plan;
}

Mission mission_of(const Plan& plan) {
    Mission mission;
    for (const AgentPlan& agent : plan.agents) {
        mission.agents.push_back({agent.id, agent.kind, agent.start, agent.goal, agent.speed});
    }
    return mission;
}

std::string picture(const io::MapFile& file, const io::PlanFile& plan, bool as_svg) {
    if (plan.plan.agents.empty()) throw Problem(unprocessable, "the plan has no agents to draw", "plan-invalid");
    const render::PictureOptions options{.cell_size = file.cell_size,
                                         .metres = file.georeference || file.cell_size != 1,
                                         .title = file.title.empty() ? file.source : file.title,
                                         .attribution = file.attribution,
                                         .objective = plan.rules.objective,
                                         .background = file.background};
    const Mission mission = mission_of(plan.plan);
    return as_svg ? render::svg(file.map, mission, plan.plan, options)
                  : render::png(file.map, mission, plan.plan, options);
}

const std::map<std::string, std::string> export_types{{"json", json_type},
                                                      {"geojson", "application/geo+json"},
                                                      {"csv", "text/csv; charset=utf-8"},
                                                      {"ros-path", "application/yaml"},
                                                      {"xml", "application/xml"},
                                                      {"svg", "image/svg+xml"},
                                                      {"png", "image/png"}};

std::string export_body(const io::MapFile& file, const io::PlanFile& plan, const std::string& bytes,
                        const std::string& format) {
    if (format == "geojson") return io::plan_geojson(plan.plan, file);
    if (format == "csv") return io::plan_csv(plan.plan, file);
    if (format == "ros-path") return io::plan_ros_path(plan.plan, file);
    if (format == "xml") return io::plan_xml(plan.plan, file, plan.search);
    if (format == "svg" || format == "png") return picture(file, plan, format == "svg");
    return bytes;
}

}  // namespace

std::string maps_json(const std::vector<MapShelf::Entry>& entries) {
    Json list = Json::array();
    for (const MapShelf::Entry& entry : entries) {
        list.push_back({{"id", entry.id}, {"uploaded", entry.uploaded}, {"loaded", entry.loaded}});
    }
    return Json{{"maps", list}}.dump() + "\n";
}

std::string map_json(const std::string& id, const ShelvedMap& map) {
    Json json{{"id", id}, {"connectivity", map.connectivity == Connectivity::four ? 4 : 8}};
    json.update(Json::parse(io::map_info_json(map.file)));
    return json.dump() + "\n";
}

std::string file_name(const std::string& id, const ShelvedMap& map) {
    if (id.find('.') != std::string::npos) return id;  // it is a file's name
    static const std::map<std::string, std::string> extensions{
        {"MovingAI map", ".map"},          {"authors' XML", ".xml"}, {"GeoTIFF label map", ".tif"},
        {"GeoTIFF occupancy map", ".tif"}, {"PNG image", ".png"},    {"netpbm image", ".pgm"}};
    const auto extension = extensions.find(map.file.format);
    return extension == extensions.end() ? id : id + extension->second;
}

std::string plan_answer(const Task& task, const Workplace& place) {
    return plan_text(task, task.request.options, place, Allowance(task, place).share(1));
}

std::string front_answer(const Task& task, const Workplace& place) {
    Posed posed = pose(task, task.request.options, place, Allowance(task, place).share(1));
    const std::vector<Plan> plans = place.planner.front(task.map->file.map, posed.mission, posed.options);
    posed.options.removals = int(plans.size() + posed.options.force.size()) - 1;
    return io::plan_json(plans.back(), context_of(task, posed, plans));
}

std::string compare_answer(const Task& task, const Workplace& place) {
    const std::vector<Method> methods =
        task.request.methods.empty() ? usual_methods(task.request.options) : task.request.methods;
    const Allowance allowance(task, place);
    std::size_t left = methods.size();
    std::string text;
    for (const Method& method : methods) {
        if (!text.empty()) text += ",\n";
        text += "{\"name\": " + Json(method.name).dump() +
                ", \"plan\": " + plan_text(task, method.options, place, allowance.share(left--)) + "}";
    }
    return "{\"format\": \"waybreaker-compare/1\", \"plans\": [\n" + text + "]}\n";
}

std::string check_answer(const ShelvedMap& map, const std::string& plan) {
    return io::check_json(io::judge(plan_of(map, plan), map.file));
}

Document export_answer(const ShelvedMap& map, const std::string& plan, const std::string& format) try {
    const io::PlanFile file = plan_of(map, plan);
    const std::vector<Violation> violations = io::judge(file, map.file);
    if (!violations.empty())
        throw Problem(unprocessable, "the plan is not valid: " + violations.front().message, "plan-invalid");
    return {media_type_of(format), export_body(map.file, file, plan, format)};
} catch (const InputError& error) {
    throw Problem(unprocessable, error.what());
}

bool is_export_format(const std::string& format) {
    return export_types.contains(format);
}

std::string media_type_of(const std::string& format) {
    return export_types.at(format);
}

}  // namespace waybreaker::server
