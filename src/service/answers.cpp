#include "service/answers.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <map>
#include <nlohmann/json.hpp>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "authors/plan_xml.hpp"
#include "geotiff/georeference.hpp"
#include "http/problem.hpp"
#include "io/check_report.hpp"
#include "io/map_document.hpp"
#include "io/option_words.hpp"
#include "io/plan_csv.hpp"
#include "io/plan_file.hpp"
#include "io/plan_geojson.hpp"
#include "io/plan_json.hpp"
#include "io/plan_ros_path.hpp"
#include "io/shortest_text.hpp"
#include "mapfile/map_info.hpp"
#include "mission/reach.hpp"
#include "raster/png.hpp"
#include "render/plan_picture.hpp"
#include "render/reach_json.hpp"
#include "service/responses.hpp"
#include "studio/plan_html.hpp"
#include "waybreaker/error.hpp"

namespace waybreaker::service {
namespace {

using Json = nlohmann::ordered_json;

// A validated mission; `reweighted` is a copy of the map, if the request sets weights of obstacles.
struct PreparedMission {
    io::MissionDocument asked;
    std::optional<io::MapFile> reweighted;
};

// The time limit of a request, shared by all its plans.
class TimeBudget {
  public:
    TimeBudget(const Task& task, const http::Worker& worker)
        : seconds_(std::min(task.request.options.asked.limits.seconds, task.seconds)) {
        worker.set_time_limit(seconds_);
    }

    // An equal share of the time left, for each of `plans` plans.
    double share(std::size_t plans) const {
        const std::chrono::duration<double> gone = std::chrono::steady_clock::now() - began_;
        constexpr double least = 1e-3;  // enough for a plan without proof
        return std::max(seconds_ - gone.count(), least) / double(plans);
    }

  private:
    std::chrono::steady_clock::time_point began_ = std::chrono::steady_clock::now();
    double seconds_;
};

const io::MapFile& map_of(const Task& task, const PreparedMission& prepared) {
    return prepared.reweighted ? *prepared.reweighted : task.map->file;
}

PreparedMission prepare(const Task& task, const request::OptionsRequest& wanted, const http::Worker& worker,
                        double seconds) try {
    const io::MapFile& file = task.map->file;
    request::MissionOnMap made = request::on_map(task.request.mission, wanted, file);
    PreparedMission prepared{std::move(made.asked), {}};
    if (made.reweighted) {
        prepared.reweighted = file;
        prepared.reweighted->map = std::move(*made.reweighted);
    }
    Limits& limits = prepared.asked.limits;
    limits.stop = worker.stop;
    limits.progress = task.report;
    limits.seconds = std::min(limits.seconds, seconds);
    io::validate_on(map_of(task, prepared), prepared.asked);
    return prepared;
} catch (const InputError& error) {
    throw http::Problem(http::unprocessable, error.what(), "mission-unfit");
}

io::PlanContext context_of(const Task& task, const PreparedMission& prepared, std::span<const Plan> front = {}) {
    return {.map = map_of(task, prepared),
            .asked = prepared.asked,
            .connectivity = task.map->connectivity,
            .timing_fields = task.request.timing_fields,
            .front = front};
}

PlanDocument planned(const Task& task, const request::OptionsRequest& wanted, const http::Worker& worker,
                     PlannerPool::Loan& planner, double seconds) {
    const PreparedMission prepared = prepare(task, wanted, worker, seconds);
    const io::MissionDocument& asked = prepared.asked;
    Plan plan = planner.plan(map_of(task, prepared).map, asked.mission, asked.method, asked.limits);
    std::string text = io::plan_json(plan, context_of(task, prepared));
    return {std::move(plan), std::move(text)};
}

// The default comparison: no removals, the paper's method, the exact method.
std::vector<request::Variant> usual_variants(const request::OptionsRequest& common) {
    request::Variant none{"none", common};
    none.options.asked.mission.rules.removals = 0;
    none.options.asked.mission.rules.force.clear();
    request::Variant paper{"paper", common};
    follow_paper(paper.options.asked.mission.rules, paper.options.asked.method);
    paper.options.planner_given = true;
    return {std::move(none), std::move(paper), request::Variant{"exact", common}};
}

// The options of the command that read a map as the plan does and the server does not.
std::string other_reading(const io::PlanFile& plan, const StoredMap& map) {
    std::vector<std::string> options;
    if (plan.connectivity != map.connectivity) {
        options.push_back(fmt::format("--connectivity {}", plan.connectivity == Connectivity::eight ? 8 : 4));
    }
    if (plan.image.threshold) options.push_back("--threshold " + io::shortest_text(*plan.image.threshold));
    if (plan.image.unknown_free) options.emplace_back("--unknown-free");
    if (plan.image.nav2 != io::Nav2()) {
        options.push_back(fmt::format("--nav2 {}", io::word_of(io::nav2_words, plan.image.nav2)));
    }
    return fmt::format("{}", fmt::join(options, ", "));
}

void require_same_reading(const io::PlanFile& plan, const StoredMap& map) {
    const std::string options = other_reading(plan, map);
    if (options.empty()) return;
    throw http::Problem(http::unprocessable,
                        "the plan was made with another reading of the map than the server's: " + options,
                        "plan-invalid");
}

// The map that the plan was made on.
io::MapFile map_of(const io::PlanFile& plan, const StoredMap& map) try {
    return revision::map_of(plan, map.file, "the plan");
} catch (const InputError& error) {
    throw http::Problem(http::unprocessable, error.what(), "plan-invalid");
}

io::PlanFile plan_of(const StoredMap& map, const std::string& bytes) {
    io::PlanFile plan = read_request([&] { return io::parse_plan(bytes, "the plan"); });
    require_same_reading(plan, map);
    return plan;
}

std::string drawn(const io::MapFile& file, const io::PlanFile& plan) {
    if (plan.plan.agents.empty())
        throw http::Problem(http::unprocessable, "the plan has no agents to draw", "plan-invalid");
    return render::plan_svg(file, plan, reach_of(file.map, plan.asked.mission, plan.plan));
}

const std::map<std::string, std::string> export_types{{"json", json_type},
                                                      {"geojson", "application/geo+json"},
                                                      {"csv", "text/csv; charset=utf-8"},
                                                      {"ros-path", "application/yaml"},
                                                      {"xml", "application/xml"},
                                                      {"svg", "image/svg+xml"},
                                                      {"png", "image/png"},
                                                      {"html", "text/html; charset=utf-8"},
                                                      {"reach", json_type}};

std::string export_body(const io::MapFile& file, const io::PlanFile& plan, const std::string& bytes,
                        const std::string& format) {
    const io::ExportUnits units{.in_seconds = plan.asked.in_seconds, .crs = mapfile::frame_crs(file)};
    if (format == "geojson") return io::plan_geojson(plan.plan, file, geotiff::lon_lat_of(file.georeference), units);
    if (format == "csv") return io::plan_csv(plan.plan, file, geotiff::lon_lat_of(file.georeference), units);
    if (format == "ros-path") return io::plan_ros_path(plan.plan, file);
    if (format == "xml")
        return authors::plan_xml(plan.plan, file, search_options(plan.asked.method, plan.asked.mission.ground_body()));
    if (format == "svg") return drawn(file, plan);
    if (format == "png") return raster::png_of(drawn(file, plan));
    if (format == "html") return studio::plan_html(file, std::array{studio::NamedPlan{"plan", bytes}});
    if (format == "reach") return render::reach_json(file, plan, reach_of(file.map, plan.asked.mission, plan.plan));
    return bytes;
}

}  // namespace

std::string maps_json(const std::vector<MapStore::Entry>& entries) {
    Json list = Json::array();
    for (const MapStore::Entry& entry : entries) {
        list.push_back({{"id", entry.id}, {"uploaded", entry.uploaded}, {"loaded", entry.loaded}});
    }
    return Json{{"maps", list}}.dump() + "\n";
}

std::string map_json(const std::string& id, const StoredMap& map) {
    return io::map_description(id, map.file, map.connectivity, mapfile::georeference_json(map.file))
               .dump(-1, ' ', false, Json::error_handler_t::replace) +
           "\n";
}

std::string file_name(const std::string& id, const StoredMap& map) {
    if (id.find('.') != std::string::npos) return id;  // already a file name
    static const std::map<std::string, std::string> extensions{
        {"MovingAI map", ".map"},          {"authors' XML", ".xml"}, {"GeoTIFF label map", ".tif"},
        {"GeoTIFF occupancy map", ".tif"}, {"PNG image", ".png"},    {"netpbm image", ".pgm"}};
    const auto extension = extensions.find(map.file.format);
    return extension == extensions.end() ? id : id + extension->second;
}

PlanDocument plan_document(const Task& task, const http::Worker& worker) {
    PlannerPool::Loan planner = task.planners.borrow(task.map);
    return planned(task, task.request.options, worker, planner, TimeBudget(task, worker).share(1));
}

std::string plan_answer(const Task& task, const http::Worker& worker) {
    return plan_document(task, worker).text;
}

std::string front_answer(const Task& task, const http::Worker& worker) {
    PreparedMission prepared = prepare(task, task.request.options, worker, TimeBudget(task, worker).share(1));
    io::MissionDocument& asked = prepared.asked;
    PlannerPool::Loan planner = task.planners.borrow(task.map);
    const std::vector<Plan> plans =
        planner.front(map_of(task, prepared).map, asked.mission, asked.method, asked.limits);
    asked.mission.rules.removals = io::removals_of(plans, asked.mission.rules);
    return io::plan_json(plans.back(), context_of(task, prepared, plans));
}

std::string compare_answer(const Task& task, const http::Worker& worker) {
    const std::vector<request::Variant> variants =
        task.request.variants.empty() ? usual_variants(task.request.options) : task.request.variants;
    const TimeBudget budget(task, worker);
    PlannerPool::Loan planner = task.planners.borrow(task.map);
    std::size_t left = variants.size();
    std::string text;
    for (const request::Variant& variant : variants) {
        if (!text.empty()) text += ",\n";
        text += "{\"name\": " + Json(variant.name).dump() +
                ", \"plan\": " + planned(task, variant.options, worker, planner, budget.share(left--)).text + "}";
    }
    return "{\"format\": \"waybreaker-compare/1\", \"plans\": [\n" + text + "]}\n";
}

std::string check_answer(const StoredMap& map, const std::string& plan) {
    return io::check_json(io::judge(plan_of(map, plan), map.file));
}

Document export_answer(const StoredMap& map, const std::string& plan, const std::string& format) try {
    const io::PlanFile file = plan_of(map, plan);
    const std::vector<Violation> violations = io::judge(file, map.file);
    if (!violations.empty())
        throw http::Problem(http::unprocessable, "the plan is not valid: " + violations.front().message,
                            "plan-invalid");
    return {media_type_of(format), export_body(map.file, file, plan, format)};
} catch (const InputError& error) {
    throw http::Problem(http::unprocessable, error.what());
}

std::string revise_answer(const SharedMap& map, const request::RevisionRequest& request, PlannerPool& planners,
                          double seconds, const http::Worker& worker) try {
    const io::PlanFile& before = request.before;
    require_same_reading(before, *map);
    const Limits limits{.seconds = std::min(request.seconds, seconds), .stop = worker.stop};
    worker.set_time_limit(limits.seconds);
    io::MapFile known = map_of(before, *map);
    PlannerPool::Loan planner = planners.borrow(map);
    Revision next = planner.revise(known.map, before.asked.mission, before.plan, request.state, request.reaction,
                                   before.asked.method, limits);
    return request::revision_answer(request, revision::next_file(before, std::move(known), std::move(next)));
} catch (const InputError& error) {
    throw http::Problem(http::unprocessable, error.what(), "report-unfit");
}

bool is_export_format(const std::string& format) {
    return export_types.contains(format);
}

std::string media_type_of(const std::string& format) {
    return export_types.at(format);
}

}  // namespace waybreaker::service
