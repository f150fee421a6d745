#include "io/map_document.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

#include "io/background_json.hpp"
#include "io/json_field.hpp"
#include "io/map_info.hpp"
#include "io/mission_json.hpp"
#include "io/obstacles_json.hpp"
#include "waybreaker/error.hpp"

namespace waybreaker::io {
namespace {

using Json = nlohmann::ordered_json;

constexpr const char* map_format = "waybreaker-map/1";
constexpr int document_depth = 10;
constexpr std::int64_t most_source_id = 1'000'000'000'000'000;

std::string dumped(const Json& json) {
    return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

Json runs_json(const std::vector<site::CellRun>& runs) {
    Json json = Json::array();
    for (const site::CellRun& run : runs) json.push_back({run.first.x, run.first.y, run.length});
    return json;
}

Json sections_json(const site::Sections& sections) {
    if (sections.empty()) return nullptr;
    Json structures = Json::array();
    for (const site::Structure& structure : sections.structures) {
        structures.push_back({{"kind", site::obstacle_kind_words[std::size_t(structure.kind)]},
                              {"source_id", structure.source_id},
                              {"name", structure.name}});
    }
    return {{"structures", std::move(structures)}, {"parts", sections.parts}};
}

// What planning and writing need beside what the service answers.
Json rest_json(const DocumentedMap& map) {
    const MapFile& file = map.file;
    Json json{{"metres", file.has_metres()},
              {"frame_crs", map.place.frame_crs},
              {"ways", runs_json(file.annotations.ways)},
              {"bridges", runs_json(file.annotations.bridges)},
              {"unknown", runs_json(file.annotations.unknown)},
              {"sections", sections_json(file.annotations.sections)},
              {"georeference", nullptr}};
    if (file.georeference) {
        json["georeference"] = {{"crs", file.georeference->crs}, {"transform", file.georeference->transform}};
    }
    return json;
}

// A text that may hold anything.
std::string any_text(const JsonField& field) {
    if (!field.json().is_string()) field.fail("is not a text");
    return field.json().get<std::string>();
}

template <std::size_t count>
std::array<double, count> numbers(const JsonField& field) {
    const std::vector<JsonField> items = field.items();
    if (items.size() != count) field.fail("does not have " + std::to_string(count) + " numbers");
    std::array<double, count> result{};
    std::transform(items.begin(), items.end(), result.begin(), [](const JsonField& item) { return item.number(); });
    return result;
}

std::vector<std::uint32_t> labels(const JsonField& runs, std::size_t cells) {
    std::vector<std::uint32_t> result;
    result.reserve(cells);
    const nlohmann::json& list = runs.json();  // there can be millions
    if (!list.is_array() || list.size() % 2 != 0) runs.fail("is no list of labels and lengths");
    for (std::size_t i = 0; i < list.size(); i += 2) {
        if (!list[i].is_number_unsigned() || !list[i + 1].is_number_unsigned()) runs.fail("holds what is no number");
        const auto label = list[i].get<std::uint64_t>();
        const auto length = list[i + 1].get<std::uint64_t>();
        if (label > cells || length > cells - result.size()) runs.fail("goes beyond the map");
        result.insert(result.end(), std::size_t(length), std::uint32_t(label));
    }
    if (result.size() != cells) runs.fail("ends before the map does");
    return result;
}

std::vector<site::CellRun> cell_runs(const JsonField& field, const Map& map) {
    std::vector<site::CellRun> result;
    for (const JsonField& item : field.items()) {
        const std::vector<JsonField> parts = item.items();
        if (parts.size() != 3) item.fail("is not a run of cells, [x, y, length]");
        const auto x = int(parts[0].whole_number(0, map.width() - 1));
        const auto y = int(parts[1].whole_number(0, map.height() - 1));
        result.push_back({{x, y}, int(parts[2].whole_number(1, map.width() - x))});
    }
    return result;
}

// What is known of each obstacle.
Map read_obstacles(const JsonField& field, site::Annotations& annotations) {
    const auto width = int(field["width"].whole_number(1, max_side));
    const auto height = int(field["height"].whole_number(1, max_side));
    const std::size_t cells = std::size_t(width) * std::size_t(height);
    if (cells > max_cells) field.fail("has more than " + std::to_string(max_cells) + " cells");
    const std::vector<JsonField> obstacles = field["obstacles"].items();
    std::vector<ObstacleAttributes> attributes(obstacles.size() + 1);
    for (const JsonField& obstacle : obstacles) {
        const auto id = std::size_t(obstacle["id"].whole_number(1, std::int64_t(obstacles.size())));
        ObstacleAttributes& known = attributes[id];
        known.destructible = obstacle["destructible"].truth();
        known.source_id = obstacle["source_id"].whole_number(-most_source_id, most_source_id);
        known.weight = obstacle["weight"].number();
        known.breach_time = obstacle["breach_time"].number();
        if (std::string name = any_text(obstacle["name"]); !name.empty()) {
            annotations.names.resize(attributes.size());
            annotations.names[id] = std::move(name);
        }
        if (const auto kind = obstacle.find("kind")) {
            annotations.kinds.resize(attributes.size());
            annotations.kinds[id] = site::kind_called(any_text(*kind));
        }
        const auto tags = obstacle.find("tags");
        if (!tags) continue;
        for (const JsonField& tag : tags->items()) {
            annotations.tags[any_text(tag)].push_back(ObstacleId{std::uint32_t(id)});
        }
    }
    Map map = Map::from_labels(width, height, labels(field["runs"], cells), attributes);
    if (map.obstacles().size() != obstacles.size()) field["obstacles"].fail("does not describe all obstacles");
    return map;
}

site::Sections read_sections(const JsonField& field, const Map& map) {
    site::Sections sections;
    for (const JsonField& structure : field["structures"].items()) {
        sections.structures.push_back(
            {.kind = site::kind_called(any_text(structure["kind"])),
             .source_id = structure["source_id"].whole_number(-most_source_id, most_source_id),
             .name = any_text(structure["name"])});
    }
    const auto last = std::int64_t(sections.structures.size()) - 1;
    for (const JsonField& parts : field["parts"].items()) {
        std::vector<std::uint32_t>& of_obstacle = sections.parts.emplace_back();
        for (const JsonField& part : parts.items()) of_obstacle.push_back(std::uint32_t(part.whole_number(0, last)));
    }
    if (sections.parts.size() != map.obstacles().size() + 1) field["parts"].fail("does not fit the obstacles");
    return sections;
}

template <class Words>
std::size_t position_of(const JsonField& field, const Words& words) {
    const auto found = std::ranges::find(words, std::string_view(any_text(field)));
    if (found == words.end()) field.fail("is no word that is known here");
    return std::size_t(found - words.begin());
}

site::Background read_background(const JsonField& field) {
    using Background = site::Background;
    Background background;
    for (const JsonField& item : field["features"].items()) {
        Background::Feature feature{.kind = Background::Kind(position_of(item["kind"], site::background_kinds)),
                                    .type = any_text(item["class"]),
                                    .name = any_text(item["name"]),
                                    .shape = Background::Shape(position_of(item["shape"], site::background_shapes))};
        for (const JsonField& points : item["points"].items()) {
            std::vector<Point>& part = feature.parts.emplace_back();
            for (const JsonField& point : points.items()) {
                const auto [x, y] = numbers<2>(point);
                part.push_back({x, y});
            }
        }
        background.features.push_back(std::move(feature));
    }
    return background;
}

void read_description(const JsonField& field, DocumentedMap& map) {
    MapFile& file = map.file;
    map.connectivity = field["connectivity"].whole_number(4, 8) == 8 ? Connectivity::eight : Connectivity::four;
    file.source = any_text(field["source"]);
    file.format = any_text(field["format"]);
    file.digest = any_text(field["digest"]);
    file.cell_size = field["cell_size"].number();
    if (!(file.cell_size >= least_cell_size && file.cell_size <= most_cell_size)) {
        field["cell_size"].fail("is no side of a cell in metres");
    }
    file.unknown = std::uint64_t(field["unknown"].whole_number(0, std::int64_t(max_cells)));
    if (const auto origin = field.find("origin")) file.origin = numbers<2>(*origin);
    const auto start = field.find("start");
    const auto goal = field.find("goal");
    if (start || goal) {
        file.task.emplace();
        if (start) file.task->start = read_cell(*start);
        if (goal) file.task->goal = read_cell(*goal);
    }
    site::Annotations& annotations = file.annotations;
    annotations.title = any_text(field["title"]);
    annotations.attribution = any_text(field["attribution"]);
    for (const JsonField& note : field["notes"].items()) annotations.notes.push_back(any_text(note));
    if (const auto profile = field.find("profile")) annotations.profile = site::profile_called(any_text(*profile));
    if (const auto georeference = field.find("georeference")) {
        map.place.georeference = Json::object();
        for (const char* const key : {"crs", "crs_code", "center", "bbox", "to_lon_lat"}) {  // in the order written
            if (const auto member = georeference->find(key)) {
                map.place.georeference[key] = Json::parse(member->json().dump());
            }
        }
    }
}

void read_rest(const JsonField& field, DocumentedMap& map) {
    MapFile& file = map.file;
    map.place.frame_crs = any_text(field["frame_crs"]);
    file.annotations.ways = cell_runs(field["ways"], file.map);
    file.annotations.bridges = cell_runs(field["bridges"], file.map);
    file.annotations.unknown = cell_runs(field["unknown"], file.map);
    if (const auto sections = field.find("sections")) file.annotations.sections = read_sections(*sections, file.map);
    if (const auto place = field.find("georeference")) {
        file.georeference = {.crs = any_text((*place)["crs"]), .transform = numbers<6>((*place)["transform"])};
    }
    file.cell_size_given = field["metres"].truth() && !file.has_metres();
}

}  // namespace

Json map_description(const std::string& id, const MapFile& file, Connectivity connectivity, const Json& georeference) {
    Json json{{"id", id}, {"connectivity", connectivity == Connectivity::four ? 4 : 8}};
    json.update(map_info(file, georeference));
    return json;
}

std::string map_document(const std::string& id, const DocumentedMap& map) {
    std::string obstacles = obstacles_json(map.file);
    obstacles.pop_back();  // the end of its line
    return std::string("{\"format\":\"") + map_format +
           "\",\n\"description\":" + dumped(map_description(id, map.file, map.connectivity, map.place.georeference)) +
           ",\n\"obstacles\":" + obstacles + ",\n\"background\":" + background_json(map.file.annotations.background) +
           ",\n\"rest\":" + dumped(rest_json(map)) + "}\n";
}

DocumentedMap parse_map_document(std::string_view bytes, const std::string& name) {
    const JsonDocument document = parse_json(bytes, name, document_depth);
    const JsonField root(document);
    root.allow({"format", "description", "obstacles", "background", "rest"});
    root.require_format(map_format);
    site::Annotations annotations;
    Map map = read_obstacles(root["obstacles"], annotations);
    DocumentedMap result{.file = {.map = std::move(map), .annotations = std::move(annotations)}};
    read_description(root["description"], result);
    result.file.annotations.background = read_background(root["background"]);
    read_rest(root["rest"], result);
    return result;
}

}  // namespace waybreaker::io
