#include "city/city_import.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <memory>
#include <set>
#include <utility>

#include "city/cell_runs.hpp"
#include "city/data_area.hpp"
#include "city/footprints.hpp"
#include "city/ground_map.hpp"
#include "city/import_notes.hpp"
#include "city/import_window.hpp"
#include "city/label_raster.hpp"
#include "city/merge_touching.hpp"
#include "city/off_road.hpp"
#include "city/survey.hpp"
#include "geotiff/gdal_scope.hpp"
#include "site/described_map.hpp"
#include "site/split.hpp"
#include "site/unknown_ground.hpp"
#include "waybreaker/error.hpp"

namespace waybreaker::city {
namespace {

using Kind = site::ObstacleKind;

constexpr double usual_section = 20;  // metres

// A footprint as a window sees it.
struct Seen {
    const Footprint* footprint;
    double area;  // inside the window
    Inheritance inherited = {};
};

// For each cell the number, from 1, of the footprint that covers its centre, 0 for none; barriers before buildings,
// else the first in the source's order.
std::vector<std::uint32_t> rasterise(const std::vector<Seen>& seen, const CellWindow& window) {
    std::vector<std::uint32_t> labels(std::size_t(window.width) * std::size_t(window.height), 0);
    std::vector<Paint> paints;
    for (const bool barriers : {false, true}) {
        for (std::size_t i = seen.size(); i-- > 0;) {
            const Footprint& footprint = *seen[i].footprint;
            if ((footprint.kind == Kind::barrier) == barriers) {
                paints.push_back({footprint.shape.get(), std::uint32_t(i + 1)});
            }
        }
    }
    paint(paints, Cover::centre, window, labels);
    return labels;
}

bool is_sheltered(const Seen& seen, const ObstacleChoice& choice) {
    return seen.footprint->sheltered || any_fits(seen.inherited.tags, choice.shelter);
}

// Its own tags, and those that it inherits.
std::set<std::string> tags_of(const Seen& seen) {
    std::set<std::string> tags(seen.footprint->tags.begin(), seen.footprint->tags.end());
    for (const PremisesTag& tag : seen.inherited.tags) tags.insert(tag.key + "=" + tag.value);
    return tags;
}

ObstacleAttributes attributes_of(const Seen& seen, const ObstacleChoice& choice) {
    ObstacleAttributes attributes = seen.footprint->attributes;
    if (is_sheltered(seen, choice) || any_fits(seen.inherited.tags, choice.protect)) attributes.destructible = false;
    if (choice.weight.of == "area") attributes.weight = seen.area * choice.weight.factor;
    if (choice.breach_time.of == "area") attributes.breach_time = seen.area * choice.breach_time.factor;
    return attributes;
}

// One label for each footprint.
site::LabelLayer labelled(const std::vector<Seen>& seen, const CellWindow& window, const ObstacleChoice& choice,
                          std::vector<std::uint32_t> labels) {
    site::LabelLayer result{.width = window.width,
                            .height = window.height,
                            .labels = std::move(labels),
                            .attributes = std::vector<ObstacleAttributes>(1)};
    for (const Seen& one : seen) {
        const auto label = std::uint32_t(result.attributes.size());
        const std::string& name = one.footprint->name.empty() ? one.inherited.name : one.footprint->name;
        if (!name.empty()) result.names.emplace(label, name);
        result.kinds.emplace(label, one.footprint->kind);
        for (const std::string& tag : tags_of(one)) result.tags[tag].push_back(label);
        result.attributes.push_back(attributes_of(one, choice));
    }
    return result;
}

// Barriers would join all houses of a street, and what is sheltered would shelter its neighbours.
std::vector<bool> joins(const std::vector<Seen>& seen, const ObstacleChoice& choice) {
    std::vector<bool> result(1, false);
    for (const Seen& one : seen) {
        result.push_back(one.footprint->kind != Kind::barrier && !is_sheltered(one, choice));
    }
    return result;
}

// Frees the cells that ways open, and those that the ground blocks for ever: these belong to the ground whatever stands
// on them.
void clear_for(const GroundMap& ground, const std::vector<Seen>& seen, std::vector<std::uint32_t>& labels) {
    for (std::size_t i = 0; i < ground.blocked.size(); ++i) {
        if (labels[i] == 0) continue;
        const bool barrier = seen[labels[i] - 1].footprint->kind == Kind::barrier;
        const bool open =
            ground.opened[i] == GroundMap::everything || (ground.opened[i] == GroundMap::barriers && barrier);
        if (open || ground.blocked[i] != 0) labels[i] = 0;
    }
}

// Who chooses obstacles wants them as the paper had them.
Profile profile_of(const ImportOptions& options) {
    return options.profile.value_or(options.choice.obstacles.empty() ? Profile::rover : Profile::paper);
}

// As maps keep it.
std::optional<Profile> who_drives(const ImportOptions& options) {
    const Profile profile = profile_of(options);
    return profile == Profile::paper ? std::nullopt : std::optional(profile);
}

// In cells; 0 for whole obstacles.
int section_side(const ImportOptions& options) {
    const double metres = options.section.value_or(profile_of(options) == Profile::paper ? 0 : usual_section);
    if (metres == 0) return 0;
    if (metres < options.cell) {
        throw OptionError("section",
                          fmt::format("{}: cells have {} m; give at least that, or none", metres, options.cell));
    }
    return int(std::round(std::min(metres / options.cell, double(max_side))));
}

// Puts what the ground blocks on cells that are free for it.
void append_ground(const GroundMap& ground, const std::vector<GroundPiece>& pieces, site::LabelLayer& cells) {
    if (ground.blocked.empty()) return;
    const auto first = std::uint32_t(cells.attributes.size());
    for (const GroundPiece& piece : pieces) {
        const auto label = std::uint32_t(cells.attributes.size());
        if (!piece.name.empty()) cells.names.emplace(label, piece.name);
        cells.kinds.emplace(label, piece.use.kind);
        if (piece.use.kind == Kind::unknown) cells.tags[site::unknown_tag].push_back(label);
        cells.attributes.push_back({.destructible = false, .source_id = piece.source_id});
    }
    for (std::size_t i = 0; i < ground.blocked.size(); ++i) {
        if (ground.blocked[i] != 0) cells.labels[i] = first + ground.blocked[i] - 1;
    }
}

std::string title_of(const std::string& source, const CellWindow& window, double cell) {
    std::string name = std::filesystem::path(source).filename().string();
    name.resize(std::min(name.find('.'), name.size()));
    const std::string size = window.width == window.height
                                 ? fmt::format("{:.0f} m", window.width * cell)
                                 : fmt::format("{:.0f} x {:.0f} m", window.width * cell, window.height * cell);
    return fmt::format("{}, {} around {:.4f}, {:.4f}", name, size, window.center[0], window.center[1]);
}

// A source, read.
struct Material {
    Footprints footprints;
    Survey survey;
    std::vector<GroundPiece> unknown = {};        // of the survey, what bars nobody as the user wants it free
    std::unique_ptr<OGRGeometry> data = nullptr;  // where it has any
    double covered = 1;                           // the share of the window that lies in there
};

// Barriers are obstacles like buildings.
void move_barriers(Ground& ground, const Window& window, std::vector<Footprint>& footprints) {
    std::erase_if(ground.pieces, [&](GroundPiece& piece) {
        if (piece.use.layer != GroundLayer::barrier) return false;
        const double area = area_inside(*piece.shape, window.bounds);
        if (area > 0) {
            footprints.push_back({.shape = std::move(piece.shape),
                                  .area = area,
                                  .attributes = {.destructible = piece.destructible, .source_id = piece.source_id},
                                  .name = piece.name,
                                  .kind = piece.use.kind,
                                  .sheltered = piece.sheltered,
                                  .tags = piece.tags});
        }
        return true;
    });
}

// What the profile says about the choice of obstacles.
ImportOptions with_profile(ImportOptions options) {
    ObstacleChoice& choice = options.choice;
    const Profile profile = profile_of(options);
    choice.only_in_the_way = profile != Profile::paper;
    choice.premises = protection(profile).filters;
    if (choice.destructible.empty() && choice.protect.empty()) choice.shelter = protection(profile).filters;
    return options;
}

// Out of the ground, those pieces of which nobody knows what is there.
std::vector<GroundPiece> take_unknown(Ground& ground) {
    std::vector<GroundPiece> unknown;
    std::erase_if(ground.pieces, [&unknown](GroundPiece& piece) {
        if (!bars(piece.use) || piece.use.kind != Kind::unknown) return false;
        unknown.push_back(std::move(piece));
        return true;
    });
    return unknown;
}

Material read(const std::string& source, const Window& window, const ImportOptions& options) {
    Material material{.footprints = read_footprints(source, window, options.choice, options.cell), .survey = {}};
    if (options.background || profile_of(options) != Profile::paper) {
        material.survey = read_survey(source, window,
                                      {.scenery = options.background,
                                       .profile = profile_of(options),
                                       .cell = options.cell,
                                       .choice = options.choice,
                                       .data = material.footprints.extent});
    }
    material.data = data_area(material.footprints, material.survey);
    material.covered = share_of(material.data.get(), window.bounds);
    const bool chosen = !options.choice.obstacles.empty();
    Ground& ground = material.survey.ground;
    if (chosen) std::erase_if(ground.pieces, [](const auto& piece) { return piece.use.layer == GroundLayer::barrier; });
    if (options.unknown_free) material.unknown = take_unknown(ground);
    move_barriers(ground, window, material.footprints.list);
    const bool anything = !material.footprints.list.empty() ||
                          std::ranges::any_of(ground.pieces, [](const GroundPiece& piece) { return bars(piece.use); });
    if (!anything) throw nothing_in_window(source, options.choice);
    return material;
}

// Of other sources nobody knows where they end: a box around a few buildings says nothing of what lies beside.
bool says_where_it_ends(const Material& material, const ImportOptions& options) {
    return material.footprints.data && profile_of(options) != Profile::paper;
}

// The cells that the user wants free though nobody knows what is there.
std::vector<site::CellRun> unknown_and_free(const Material& material, const CellWindow& window,
                                            const ImportOptions& options) {
    if (!options.unknown_free) return {};
    return unknown_cells(says_where_it_ends(material, options) ? material.data.get() : nullptr, material.unknown,
                         window);
}

// Walls and fences are what they say of themselves: that of a hospital may be opened.
void inherit(const std::vector<Premises>& premises, const std::vector<std::uint32_t>& labels, const CellWindow& window,
             const ImportOptions& options, std::vector<Seen>& seen) {
    if (premises.empty()) return;
    std::vector<const OGRGeometry*> heirs;
    for (const Seen& one : seen) {
        heirs.push_back(one.footprint->kind == Kind::barrier ? nullptr : one.footprint->shape.get());
    }
    std::vector<Inheritance> found = inherited(heirs, labels, window, premises, premises_filters(options.choice));
    for (std::size_t i = 0; i < seen.size(); ++i) seen[i].inherited = std::move(found[i]);
}

ImportReport report_of(const Material& material, std::vector<Seen> seen, const CellWindow& window,
                       const std::string& source, const ImportOptions& options) {
    const std::vector<GroundPiece>& pieces = material.survey.ground.pieces;
    const GroundMap ground = ground_map(pieces, window, profile_of(options), options.cell);
    std::vector<std::uint32_t> labels = rasterise(seen, window);
    inherit(material.survey.premises, labels, window, options, seen);
    clear_for(ground, seen, labels);
    site::LabelLayer cells = labelled(seen, window, options.choice, std::move(labels));
    if (options.merge_touching) cells = merged(cells, joins(seen, options.choice), !options.choice.weight.of.empty());
    append_ground(ground, pieces, cells);
    append_off_road(ground, window, options.cell, cells);
    const bool unknown_beyond = says_where_it_ends(material, options) && !options.unknown_free;
    if (unknown_beyond) append_unknown(material.data.get(), window, cells);
    if (!options.names) cells.names.clear();
    if (profile_of(options) == Profile::paper) {
        cells.kinds.clear();
        cells.tags.clear();
    }
    site::DescribedMap described =
        site::described(std::move(cells),
                        {.title = title_of(source, window, options.cell),
                         .profile = who_drives(options),
                         .attribution = material.footprints.from_osm ? "(c) OpenStreetMap contributors, ODbL 1.0" : "",
                         .background = background_within(material.survey.scenery, window.window.bounds, options.cell)});
    if (const int side = section_side(options); side > 0) {
        described = site::split(described.map, described.annotations, {.side = side});
    }
    described.annotations.bridges = open_parts(ground.bridges, described.map);
    described.annotations.ways = open_parts(ground.ways, described.map);
    described.annotations.unknown = open_parts(unknown_and_free(material, window, options), described.map);
    std::vector<OverlayReport> overlays;
    for (const OverlaySource& overlay : options.overlays) {
        overlays.push_back(
            lay_over(overlay, window.georeference, {options.choice.weight, options.choice.breach_time}, described));
    }
    std::vector<std::string> notes = import_notes(material.footprints, material.survey);
    described.annotations.notes = notes;
    const double covered = share_of(material.data.get(), window.window.bounds);
    if (std::string gaps = note_of_gaps(covered); !unknown_beyond && !gaps.empty()) {
        described.annotations.notes.push_back(std::move(gaps));
    }
    geotiff::LabelTiff tiff{.map = std::move(described.map),
                            .cell_size = options.cell,
                            .georeference = window.georeference,
                            .annotations = std::move(described.annotations)};
    ImportReport report{.tiff = std::move(tiff),
                        .covered = material.covered,
                        .unknown_beyond = unknown_beyond,
                        .profile = profile_of(options),
                        .notes = std::move(notes),
                        .overlays = std::move(overlays)};
    for (const Seen& one : seen) {
        if (is_sheltered(one, options.choice)) ++report.sheltered;
        if (one.footprint->kind == Kind::barrier) continue;
        ++report.buildings;
        report.area += one.area;
    }
    return report;
}

std::vector<Seen> seen_in(const Footprints& footprints, const OGREnvelope& bounds) {
    const geotiff::GdalScope gdal;
    std::vector<Seen> seen;
    for (const Footprint& footprint : footprints.list) {
        const double area = area_inside(*footprint.shape, bounds);
        if (area > 0) seen.push_back({&footprint, area});
    }
    return seen;
}

}  // namespace

std::array<int, 2> import_cells(const ImportOptions& options) {
    const CellWindow window = import_window(options);
    return {window.width, window.height};
}

ImportReport import_city(const std::string& source, const ImportOptions& given) {
    const ImportOptions options = with_profile(given);
    const CellWindow window = import_window(options);
    const Material material = read(source, window.window, options);
    std::vector<Seen> seen;
    for (const Footprint& footprint : material.footprints.list) seen.push_back({&footprint, footprint.area});
    return report_of(material, std::move(seen), window, source, options);
}

std::size_t import_tiles(const std::string& source, const ImportOptions& given, double side,
                         const std::function<void(const ImportTile&)>& visit) {
    const ImportOptions options = with_profile(given);
    const CellWindow window = import_window(options);
    const double cells = std::round(side / options.cell);
    const int least = std::min(window.width, window.height);
    if (!(cells >= 1 && cells <= least)) {
        throw OptionError("tile",
                          fmt::format("{}: the window has {} x {} m, and cells have {} m: no such tile fits", side,
                                      window.width * options.cell, window.height * options.cell, options.cell));
    }
    const Material material = read(source, window.window, options);
    const int tile = int(cells);
    for (int row = 0; row < window.height / tile; ++row) {
        for (int column = 0; column < window.width / tile; ++column) {
            const CellWindow part = part_of(window, column * tile, row * tile, tile, tile);
            std::vector<Seen> seen = seen_in(material.footprints, part.window.bounds);
            if (seen.empty() && material.survey.ground.pieces.empty()) continue;
            const ImportReport report = report_of(material, std::move(seen), part, source, options);
            const Map& map = report.tiff.map;
            const auto unknown = site::unknown_obstacles(map, report.tiff.annotations.tags);
            const auto known = map.obstacles().size() - std::size_t(std::ranges::count(unknown, true));
            if (known > 0) visit({column, row, report});
        }
    }
    return std::size_t(window.width / tile) * std::size_t(window.height / tile);
}

}  // namespace waybreaker::city
