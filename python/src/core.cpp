// waybreaker._core: maps, missions and plans for Python, as documents. The package around it gives them their names.
#include <pybind11/functional.h>
#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <tuple>
#include <utility>
#include <vector>

#include "interruptible.hpp"
#include "io/check_report.hpp"
#include "io/labels_digest.hpp"
#include "io/map_with_edits.hpp"
#include "io/mission_json.hpp"
#include "io/plan_file.hpp"
#include "io/plan_geojson.hpp"
#include "io/plan_json.hpp"
#include "io/sha256.hpp"
#include "io/state_json.hpp"
#include "labels/label_map.hpp"
#include "labels/obstacle_names.hpp"
#include "render/picture.hpp"
#include "render/plan_picture.hpp"
#include "revision/revised_file.hpp"
#include "site/unknown_ground.hpp"
#include "waybreaker/error.hpp"
#include "waybreaker/movingai.hpp"
#include "waybreaker/planner.hpp"

namespace py = pybind11;

namespace waybreaker::python {
namespace {

constexpr double usual_seconds = 10;  // as the command has it

struct KnownMap {
    std::shared_ptr<const io::MapFile> file;
    Connectivity connectivity = Connectivity::four;
};

// What every map is called, whatever it is made of.
struct Identity {
    std::string source;
    std::string digest;
    std::optional<double> cell_size;
};

Identity identity(std::string source, std::string digest, std::optional<double> cell_size) {
    if (cell_size && !(*cell_size >= io::least_cell_size && *cell_size <= io::most_cell_size)) {
        throw InputError("cell_size must be a number of metres from 1e-6 to 1e6");
    }
    return {std::move(source), std::move(digest), cell_size};
}

Connectivity connectivity_of(int neighbours) {
    if (neighbours != 4 && neighbours != 8) throw InputError("connectivity must be 4 or 8");
    return neighbours == 4 ? Connectivity::four : Connectivity::eight;
}

KnownMap known(io::MapFile file, Identity identity, Connectivity connectivity = Connectivity::four) {
    file.source = std::move(identity.source);
    file.digest = std::move(identity.digest);
    file.cell_size = identity.cell_size.value_or(file.cell_size);
    file.cell_size_given = identity.cell_size.has_value();
    return {std::make_shared<const io::MapFile>(std::move(file)), connectivity};
}

KnownMap map_of_movingai(const std::string& bytes, const std::string& name, const std::string& digest,
                         std::optional<double> cell_size, int connectivity) {
    Identity called = identity(name, digest, cell_size);
    const Connectivity neighbours = connectivity_of(connectivity);
    const py::gil_scoped_release release;
    return known({.map = Map(read_movingai_map(bytes, name), neighbours), .format = "MovingAI map"}, std::move(called),
                 neighbours);
}

using Labels = py::array_t<std::uint32_t, py::array::c_style | py::array::forcecast>;

std::vector<std::uint32_t> cells_of(const Labels& labels) {
    return {labels.data(), labels.data() + labels.size()};
}

// Rows and columns of an array; the package hands in none of other dimensions.
std::pair<int, int> size_of(const Labels& labels) {
    constexpr auto most = py::ssize_t(max_side);
    if (labels.ndim() != 2 || labels.shape(0) > most || labels.shape(1) > most) {
        throw InputError("labels must be an array of height x width, of at most 32768 each");
    }
    return {int(labels.shape(1)), int(labels.shape(0))};
}

// Of a label: whether it can be destroyed, source id, weight, breach time, name.
using LabelAttributes = std::tuple<bool, std::int64_t, double, double, std::string>;

KnownMap map_of_labels(const Labels& labels, const std::vector<std::pair<std::uint32_t, LabelAttributes>>& attributes,
                       const std::string& name, std::optional<double> cell_size) {
    const auto [width, height] = size_of(labels);
    site::LabelLayer layer{.width = width, .height = height, .labels = cells_of(labels)};
    for (const auto& [label, described] : attributes) {
        const auto& [destructible, source_id, weight, breach_time, called] = described;
        if (layer.attributes.size() <= label) layer.attributes.resize(std::size_t(label) + 1);
        layer.attributes[label] = {destructible, source_id, weight, breach_time};
        if (!called.empty()) layer.names.emplace(label, called);
    }
    Identity own = identity(name, "", cell_size);
    site::DescribedMap described = site::described(std::move(layer));
    own.digest = io::labels_digest(described.map);
    return known({.map = std::move(described.map), .annotations = std::move(described.annotations)}, std::move(own));
}

// Kind, as MapEdit has it, obstacle, cells, and what is known of an obstacle that is added.
using Edit = std::tuple<int, std::uint32_t, std::vector<std::array<int, 2>>, LabelAttributes>;

MapEdit edit_of(const Edit& edit) {
    const auto& [kind, obstacle, places, described] = edit;
    std::vector<Cell> cells;
    for (const auto& [x, y] : places) cells.push_back({x, y});
    switch (MapEdit::Kind(kind)) {
        case MapEdit::Kind::remove:
            return MapEdit::remove({obstacle});
        case MapEdit::Kind::add: {
            const auto& [destructible, source_id, weight, breach_time, called] = described;
            return MapEdit::add(std::move(cells), {destructible, source_id, weight, breach_time});
        }
        case MapEdit::Kind::extend:
            return MapEdit::extend({obstacle}, std::move(cells));
        case MapEdit::Kind::free:
            break;
    }
    return MapEdit::free(std::move(cells));
}

KnownMap with_edits(const KnownMap& map, const std::vector<Edit>& edits) {
    std::vector<MapEdit> all;
    std::transform(edits.begin(), edits.end(), std::back_inserter(all), edit_of);
    io::MapFile file = io::with_edits(*map.file, all);
    site::ObstacleNames& names = file.annotations.names;
    std::size_t next = map.file->map.obstacles().size();
    for (const auto& [kind, obstacle, cells, described] : edits) {
        if (MapEdit::Kind(kind) != MapEdit::Kind::add) continue;
        ++next;
        const std::string& called = std::get<std::string>(described);
        if (called.empty()) continue;
        names.resize(std::max(names.size(), next + 1));
        names[next] = labels::clean_name(called);
    }
    return {std::make_shared<const io::MapFile>(std::move(file)), map.connectivity};
}

// Kind, type, name, shape, and parts as arrays of points.
using Points = py::array_t<double, py::array::c_style | py::array::forcecast>;
using Feature = std::tuple<std::string, std::string, std::string, std::string, std::vector<Points>>;

template <class Words>
std::size_t place_of(const std::string& word, const Words& words) {
    return std::size_t(std::ranges::find(words, word) - words.begin());
}

site::Background background_of(const std::vector<Feature>& features) {
    site::Background background;
    for (const auto& [kind, type, name, shape, parts] : features) {
        const std::size_t number = place_of(kind, site::background_kinds);
        if (number == site::background_kinds.size()) throw InputError("the map's background has no kind " + kind);
        site::Background::Feature feature{.kind = site::Background::Kind(number),
                                          .type = labels::clean_name(type),
                                          .name = labels::clean_name(name),
                                          .shape = site::Background::Shape(place_of(shape, site::background_shapes))};
        for (const Points& part : parts) {
            const auto points = part.unchecked<2>();
            std::vector<Point> line;
            for (py::ssize_t i = 0; i < points.shape(0); ++i) line.emplace_back(points(i, 0), points(i, 1));
            feature.parts.push_back(std::move(line));
        }
        background.features.push_back(std::move(feature));
    }
    return background;
}

using Inflate = std::function<py::bytes(const std::string& digits, std::size_t most)>;

KnownMap map_of_raster(const Labels& labels, const std::map<std::string, std::string>& items, double cell_size,
                       const std::string& crs, const std::optional<std::array<double, 6>>& transform,
                       const Inflate& inflate, const std::vector<Feature>& background, const std::string& name,
                       const std::string& digest, int connectivity) {
    const auto [width, height] = size_of(labels);
    const auto item = [&](const char* called) {
        const auto found = items.find(called);
        return found == items.end() ? std::string() : found->second;
    };
    const auto inflated = [&](std::string_view digits, std::size_t most) {
        const std::string bytes = inflate(std::string(digits), most);
        return std::vector<std::uint8_t>(bytes.begin(), bytes.end());
    };
    labels::LabelRaster raster = labels::read_items(item, width, height, transform, inflated, name);
    raster.layer.labels = cells_of(labels);
    raster.annotations.background = background_of(background);
    Identity own = identity(name, digest, cell_size);
    own.cell_size.reset();  // the file says it, not the user
    const Connectivity neighbours = connectivity_of(connectivity);
    const py::gil_scoped_release release;
    labels::LabelMap read = labels::label_map(std::move(raster), neighbours);
    io::MapFile file{.map = std::move(read.described.map),
                     .format = read.mask ? "GeoTIFF occupancy map" : "GeoTIFF label map",
                     .cell_size = cell_size,
                     .annotations = std::move(read.described.annotations)};
    if (transform) file.georeference = site::Georeference{crs, *transform};
    file.unknown = site::unknown_cells(file.map, file.annotations.tags);
    return known(std::move(file), std::move(own), neighbours);
}

py::array labels_of(const KnownMap& map) {
    const Map& grid = map.file->map;
    // The array keeps the map alive, and looks at its labels.
    auto* owner = new std::shared_ptr<const io::MapFile>(map.file);
    const py::capsule keeper(owner, [](void* kept) { delete static_cast<std::shared_ptr<const io::MapFile>*>(kept); });
    py::array_t<std::uint32_t> labels({grid.height(), grid.width()}, grid.labels().data(), keeper);
    labels.attr("setflags")(py::arg("write") = false);
    return labels;
}

// Id, cells, bounds (left, top, right, bottom), whether it can be destroyed, source id, weight, breach time, name.
py::list obstacles_of(const KnownMap& map) {
    py::list obstacles;
    for (const Obstacle& o : map.file->map.obstacles()) {
        obstacles.append(py::make_tuple(
            o.id.value, o.cells, py::make_tuple(o.bounds.min.x, o.bounds.min.y, o.bounds.max.x, o.bounds.max.y),
            o.destructible, o.source_id, o.weight, o.breach_time, std::string(map.file->annotations.name_of(o.id))));
    }
    return obstacles;
}

struct Planned {
    KnownMap map;
    io::MissionDocument asked;
    Plan plan;
    std::vector<Plan> front = {};
    io::ImageReading image = {};
    std::string supersedes = {};

    std::string json(bool timing) const {
        return io::plan_json(plan, {.map = *map.file,
                                    .asked = asked,
                                    .connectivity = map.connectivity,
                                    .timing_fields = timing,
                                    .image = image,
                                    .front = front,
                                    .supersedes = supersedes});
    }
    std::string svg() const {
        return render::svg(map.file->map, asked.mission, plan, render::picture_options(*map.file, asked, plan));
    }
    std::string geojson(const std::function<std::array<double, 2>(double, double)>& to_lon_lat) const {
        return io::plan_geojson(plan, *map.file, [&](Point p) { return to_lon_lat(p.x, p.y); },
                                {.in_seconds = asked.in_seconds});
    }
};

// The mission as it is planned, on the map that it gives: both as the command makes them.
struct Asked {
    KnownMap map;
    io::MissionDocument document;
};

Asked asked_of(const KnownMap& map, const std::string& mission, unsigned threads) {
    Asked asked{map, io::parse_mission(mission, "mission", Limits{.seconds = usual_seconds})};
    io::MissionDocument& document = asked.document;
    if (!document.overlays.empty()) {
        throw InputError("overlays are laid over a map by the command: 'waybreaker map overlay' makes a map of them");
    }
    document.map.clear();
    document.limits.threads = threads;
    if (std::optional<Map> weighed = io::settle(document, *map.file)) {
        io::MapFile file = *map.file;
        file.map = std::move(*weighed);
        asked.map.file = std::make_shared<const io::MapFile>(std::move(file));
    }
    return asked;
}

Planned plan(const KnownMap& map, const std::string& mission, unsigned threads) {
    return interruptible([&](const StopToken& stop) {
        Asked asked = asked_of(map, mission, threads);
        asked.document.limits.stop = stop;
        const io::MissionDocument& document = asked.document;
        Plan found = Planner().plan(asked.map.file->map, document.mission, document.method, document.limits);
        return Planned{std::move(asked.map), std::move(asked.document), std::move(found)};
    });
}

// One for each number of removals; the last one knows all of them.
std::vector<Planned> front(const KnownMap& map, const std::string& mission, unsigned threads) {
    return interruptible([&](const StopToken& stop) {
        Asked asked = asked_of(map, mission, threads);
        io::MissionDocument& document = asked.document;
        document.limits.stop = stop;
        std::vector<Plan> plans =
            Planner().front(asked.map.file->map, document.mission, document.method, document.limits);
        std::vector<Planned> planned;
        document.mission.rules.removals = int(document.mission.rules.force.size());
        for (const Plan& step : plans) {
            planned.push_back({asked.map, document, step});
            ++document.mission.rules.removals;
        }
        planned.back().front = std::move(plans);
        return planned;
    });
}

// What takes over from the plan of a document, by the document of a state.
Planned revise(const KnownMap& map, const std::string& plan, const std::string& state, double reaction, double seconds,
               unsigned threads) {
    return interruptible([&](const StopToken& stop) {
        const io::PlanFile before = io::parse_plan(plan, "plan");
        io::require_connectivity(before, map.connectivity, "plan");
        const State reported = io::parse_state(state, "state");
        const revision::Task task{.before = before,
                                  .before_name = "plan",
                                  .digest = io::sha256_digest(plan),
                                  .map = *map.file,
                                  .state = reported,
                                  .state_name = "state",
                                  .reaction = reaction};
        Planner planner;
        revision::RevisedFile next =
            revision::revise(planner, task, {.seconds = seconds, .threads = threads, .stop = stop});
        return Planned{.map = {std::make_shared<const io::MapFile>(std::move(next.map)), map.connectivity},
                       .asked = std::move(next.asked),
                       .plan = std::move(next.plan),
                       .image = next.image,
                       .supersedes = std::move(next.supersedes)};
    });
}

// The plan before, and the state that it was revised from, as documents.
using Continuity = std::pair<std::string, std::string>;

// The document of a check, of the document of a plan.
std::string check(const KnownMap& map, const std::string& plan, double tolerance, bool ignore_digest,
                  const std::optional<Continuity>& continuity) {
    return interruptible([&](const StopToken&) {
        const io::PlanFile file = io::parse_plan(plan, "plan");
        const io::MapFile known = io::known_map(*map.file, file.plan);
        const io::JudgeOptions options{.tolerance = tolerance, .ignore_digest = ignore_digest};
        if (!continuity) return io::check_json(io::judge(file, known, options));
        const auto& [after, state] = *continuity;
        return io::check_json(io::judge_after(file, known, io::parse_plan(after, "the plan before"),
                                              io::parse_state(state, "state"), options));
    });
}

}  // namespace

PYBIND11_MODULE(_core, module) {
    module.attr("__version__") = WAYBREAKER_PYTHON_VERSION;
    py::register_exception<InputError>(module, "InputError", PyExc_ValueError);

    py::class_<KnownMap>(module, "Map")
        .def_static("from_movingai", &map_of_movingai)
        .def_static("from_labels", &map_of_labels)
        .def_static("from_raster", &map_of_raster)
        .def_property_readonly("width", [](const KnownMap& map) { return map.file->map.width(); })
        .def_property_readonly("height", [](const KnownMap& map) { return map.file->map.height(); })
        .def_property_readonly("source", [](const KnownMap& map) { return map.file->source; })
        .def_property_readonly("title", [](const KnownMap& map) { return map.file->annotations.title; })
        .def_property_readonly("attribution", [](const KnownMap& map) { return map.file->annotations.attribution; })
        .def_property_readonly("digest", [](const KnownMap& map) { return map.file->digest; })
        .def_property_readonly("cell_size",
                               [](const KnownMap& map) {
                                   return map.file->has_metres() ? std::optional(map.file->cell_size) : std::nullopt;
                               })
        .def_property_readonly("labels", &labels_of)
        .def_property_readonly("obstacles", &obstacles_of)
        .def("with_edits", &with_edits);

    py::class_<Planned>(module, "Plan")
        .def("json", [](const Planned& planned, bool timing) { return py::bytes(planned.json(timing)); })
        .def("svg", &Planned::svg)
        .def("geojson", &Planned::geojson)
        .def_property_readonly("map", [](const Planned& planned) { return planned.map; });

    module.def("plan", &plan);
    module.def("front", &front);
    module.def("revise", &revise);
    module.def("check", &check);
}

}  // namespace waybreaker::python
