#include "service/import_request.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <utility>
#include <vector>

#include "http/problem.hpp"
#include "io/json_field.hpp"
#include "request/plan_request.hpp"
#include "waybreaker/error.hpp"

namespace waybreaker::service {
namespace {

using io::JsonField;

constexpr int max_depth = 4;

double within(const JsonField& field, double least, double most) {
    const double value = field.number();
    if (!(value >= least && value <= most)) field.fail(fmt::format("is not a number from {} to {}", least, most));
    return value;
}

double metres(const JsonField& field) {
    return within(field, 0.001, 1e6);
}

template <std::size_t count>
std::array<double, count> degrees(const JsonField& field, const char* what) {
    const std::vector<JsonField> items = field.items();
    if (items.size() != count) field.fail(fmt::format("is not {}", what));
    std::array<double, count> result{};
    for (std::size_t i = 0; i < count; ++i) result[i] = within(items[i], -180, 180);
    return result;
}

void set_window(const JsonField& root, ImportRequest& request) {
    city::ImportOptions& options = request.options;
    if (const auto center = root.find("center")) {
        const auto [longitude, latitude] = degrees<2>(*center, "[longitude, latitude]");
        options.longitude = longitude;
        options.latitude = latitude;
        request.placed = true;
    }
    if (const auto box = root.find("bbox")) {
        if (request.placed) box->fail("is one window, center another; give one of them");
        options.box = degrees<4>(*box, "[west, south, east, north]");
        request.placed = true;
    }
    if (const auto size = root.find("size")) {
        if (options.box) size->fail("goes with center, not with bbox");
        options.size = metres(*size);
        request.sized = true;
    }
    if (const auto cell = root.find("cell")) options.cell = metres(*cell);
}

template <class Parse>
auto parsed(const JsonField& field, Parse parse) try {
    return parse(field.text());
} catch (const InputError& error) {
    field.fail(std::string("cannot be read: ") + error.what());
}

void set_filters(const JsonField& root, const char* key, std::vector<city::TagFilter>& filters) {
    if (const auto field = root.find(key)) filters = parsed(*field, city::parse_tag_filters);
}

void set_quantity(const JsonField& root, const char* key, city::Quantity& quantity) {
    if (const auto field = root.find(key)) quantity = parsed(*field, city::parse_quantity);
}

void set_choice(const JsonField& root, city::ObstacleChoice& choice) {
    set_filters(root, "obstacles", choice.obstacles);
    set_filters(root, "destructible", choice.destructible);
    set_filters(root, "protected", choice.protect);
    set_quantity(root, "obstacle_weight", choice.weight);
    set_quantity(root, "obstacle_breach_time", choice.breach_time);
    if (const auto layer = root.find("layer")) choice.layer = layer->text();
    if (const auto width = root.find("wall_width")) choice.wall_width = metres(*width);
}

// Who drives, and what one breach opens.
void set_vehicle(const JsonField& root, city::ImportOptions& options) {
    using enum city::Profile;
    if (const auto profile = root.find("profile")) {
        options.profile =
            profile->one_of<city::Profile>({{"rover", rover}, {"truck", truck}, {"walker", walker}, {"paper", paper}});
    }
    if (const auto section = root.find("section")) {
        options.section = section->json() == "none" ? 0 : within(*section, 0, 1e6);
    }
}

}  // namespace

ImportRequest parse_import_request(std::string_view bytes, const std::string& name) {
    if (bytes.size() > request::max_request_bytes) throw InputError(name, 0, "is too large");
    const auto document = io::parse_json(bytes, name, max_depth);
    const JsonField root(document);
    root.allow({"source", "center", "size", "bbox", "cell", "profile", "section", "obstacles", "destructible",
                "protected", "obstacle_weight", "obstacle_breach_time", "layer", "wall_width", "merge_touching",
                "names", "background", "unknown_free"});
    ImportRequest request{.source = root["source"].text(), .text = std::string(bytes), .options = {}};
    set_window(root, request);
    set_vehicle(root, request.options);
    set_choice(root, request.options.choice);
    if (const auto merge = root.find("merge_touching")) request.options.merge_touching = merge->truth();
    if (const auto names = root.find("names")) request.options.names = names->truth();
    if (const auto background = root.find("background")) request.options.background = background->truth();
    if (const auto free = root.find("unknown_free")) request.options.unknown_free = free->truth();
    return request;
}

city::ImportOptions window_of(const ImportRequest& request, const city::Extract& extract) {
    city::ImportOptions options = request.options;
    if (request.placed) return options;
    options.longitude = extract.densest[0];
    options.latitude = extract.densest[1];
    if (!request.sized) options.size = extract.side;
    return options;
}

std::size_t cells_of(const ImportRequest& request, const city::Extract& extract, std::size_t most) try {
    const auto [width, height] = city::import_cells(window_of(request, extract));
    const std::size_t cells = std::size_t(width) * std::size_t(height);
    if (cells <= most) return cells;
    throw http::Problem(
        http::too_large,
        fmt::format("the window has {} x {} cells, a map may have {} (--max-cells); make it smaller, or its "
                    "cells larger",
                    width, height, most),
        "map-too-large");
} catch (const InputError& error) {
    throw http::Problem(http::unprocessable, worded(error), "import-unfit");
}

std::string worded(const InputError& error) {
    if (error.error().code != ErrorCode::option) return error.what();
    std::string name = error.error().subject;
    std::ranges::replace(name, '-', '_');
    return name + " " + error.error().detail;
}

}  // namespace waybreaker::service
