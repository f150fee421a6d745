// The documents that responses carry, made by the library and the writers of src/io and src/render.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "http/job_queue.hpp"
#include "request/plan_request.hpp"
#include "request/revision.hpp"
#include "service/map_store.hpp"
#include "service/planner_pool.hpp"
#include "waybreaker/limits.hpp"
#include "waybreaker/plan.hpp"

namespace waybreaker::service {

// A body and its media type.
struct Document {
    std::string type;
    std::string body;
};

std::string maps_json(const std::vector<MapStore::Entry>& entries);
// As `waybreaker map info --json`, with id and connectivity.
std::string map_json(const std::string& id, const StoredMap& map);
// The file name of a map: its id, with an extension.
std::string file_name(const std::string& id, const StoredMap& map);

// What a worker plans.
struct Task {
    SharedMap map;
    request::PlanRequest request;
    PlannerPool& planners;
    double seconds = 30;  // upper limit, whatever the request says
    std::function<void(const Progress&)> report = {};
};

struct PlanDocument {
    Plan plan;
    std::string text;
};

// Each throws Problem if the mission does not fit the map.
PlanDocument plan_document(const Task& task, const http::Worker& worker);
std::string plan_answer(const Task& task, const http::Worker& worker);
std::string front_answer(const Task& task, const http::Worker& worker);
std::string compare_answer(const Task& task, const http::Worker& worker);

// `plan` is the text of a plan file. Both throw Problem if it cannot be read; export_answer also if the plan is not
// valid for the map.
std::string check_answer(const StoredMap& map, const std::string& plan);
Document export_answer(const StoredMap& map, const std::string& plan, const std::string& format);

// Of a plan and what has happened to it (request/revision.hpp). Throws Problem if the plan is of another map, or the
// state cannot be one of the plan.
std::string revise_answer(const SharedMap& map, const request::RevisionRequest& request, PlannerPool& planners,
                          double seconds, const http::Worker& worker);

// Whether export_answer supports the format.
bool is_export_format(const std::string& format);
std::string media_type_of(const std::string& format);

}  // namespace waybreaker::service
