// The documents that answer requests, made by the library and the writers of src/io and src/render.
#pragma once

#include <string>
#include <vector>

#include "server/job_queue.hpp"
#include "server/map_shelf.hpp"
#include "server/plan_request.hpp"

namespace waybreaker::server {

// A body and its media type.
struct Document {
    std::string type;
    std::string body;
};

inline constexpr auto json_type = "application/json";

std::string maps_json(const std::vector<MapShelf::Entry>& entries);
// As `waybreaker map info --json`, with id and connectivity.
std::string map_json(const std::string& id, const ShelvedMap& map);
// What to call the file of a map: its id, with an extension.
std::string file_name(const std::string& id, const ShelvedMap& map);

// What a worker plans with.
struct Task {
    SharedMap map;
    PlanRequest request;
    double seconds = 30;  // at most, whatever the request says
};

// Each throws Problem if the mission does not fit the map.
std::string plan_answer(const Task& task, const Workplace& place);
std::string front_answer(const Task& task, const Workplace& place);
std::string compare_answer(const Task& task, const Workplace& place);

// `plan` is the text of a plan file. Both throw Problem if it cannot be read; export if it is not valid for the map
// too.
std::string check_answer(const ShelvedMap& map, const std::string& plan);
Document export_answer(const ShelvedMap& map, const std::string& plan, const std::string& format);

// Whether export_answer knows it.
bool is_export_format(const std::string& format);
std::string media_type_of(const std::string& format);

}  // namespace waybreaker::server
