// `waybreaker import`: a city map from map data, or a folder of them.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <filesystem>
#include <string_view>
#include <system_error>

#include "city/city_import.hpp"
#include "city/extract.hpp"
#include "city/ground_rules.hpp"
#include "city/no_fly.hpp"
#include "commands.hpp"
#include "help.hpp"
#include "import_summary.hpp"
#include "io/mission_json.hpp"
#include "io/output_file.hpp"
#include "io/zones_json.hpp"
#include "measure.hpp"
#include "named_files.hpp"
#include "note.hpp"
#include "option.hpp"
#include "overlay_options.hpp"
#include "progress.hpp"
#include "site/named_places.hpp"
#include "waybreaker/error.hpp"

namespace waybreaker::apps {
namespace {

constexpr Range lengths{0.001, 1e6};

struct ImportOptions {
    std::string source;
    std::string output;
    bool center = false;  // given
    std::string place;    // or its name
    bool sized = false;
    std::optional<double> tile;
    std::string zones;
    std::optional<double> clearance;
    OverlayOptions overlays;
    city::ImportOptions window;
};

city::ImportReport import_with_progress(const ImportOptions& options) {
    const Progress progress("reading " + options.source);
    return city::import_city(options.source, options.window);
}

const char* things_of(const ImportOptions& options) {
    return options.window.choice.obstacles.empty() ? "buildings" : "features";
}

// What the user should know of a source, whatever is made of it.
struct Noticed {
    std::vector<std::string> notes;
    double covered = 1;
    bool unknown_beyond = false;

    void see(const city::ImportReport& report) {
        notes = report.notes;
        covered = report.covered;
        unknown_beyond = report.unknown_beyond;
    }

    void say(const std::string& source) const {
        for (const std::string& one : notes) note(source, one);
        const double percent = 100 * covered;
        if (percent >= 99.5) return;
        warn(fmt::format(
            "{} covers only {:.2g} % of the window; the rest is {}", source, percent,
            unknown_beyond ? "unknown ground, which bars the way; --unknown-free makes it free" : "free on the map"));
    }
};

std::string zones_text(const std::vector<Zone>& zones, const geotiff::LabelTiff& map) {
    nlohmann::ordered_json json = io::zones_json(zones, geotiff::lon_lat_of(map.georeference));
    if (!map.annotations.attribution.empty()) json["attribution"] = map.annotations.attribution;
    return io::pretty(json) + "\n";
}

void import_one(const ImportOptions& options) {
    const city::ImportReport report = import_with_progress(options);
    Noticed noticed;
    noticed.see(report);
    noticed.say(options.source);
    note_overlays(report.overlays);
    std::string zones;
    if (!options.zones.empty()) {
        const std::vector<Zone> found =
            city::no_fly_zones(options.source, options.window, options.clearance.value_or(city::usual_clearance));
        io::write_whole(options.zones, zones_text(found, report.tiff));
        zones = zones_line(options.zones, found);
    }
    io::write_whole(options.output, geotiff::label_tiff_bytes(report.tiff));
    if (options.output == "-") return;
    io::write_whole("-", summary_line(options.output, report, things_of(options)) +
                             overlay_summary(report.overlays, report.tiff.cell_size) + zones);
}

// Files ROW_COLUMN.tif in a folder.
void import_folder(const ImportOptions& options, double tile_side) {
    namespace fs = std::filesystem;
    std::error_code failure;
    fs::create_directories(options.output, failure);
    if (failure || !fs::is_directory(options.output)) {
        throw InputError(fmt::format("cannot make the folder {}: {}", options.output, failure.message()));
    }
    std::string lines;
    std::size_t count = 0;
    Noticed noticed;
    const auto write = [&](const city::ImportTile& tile) {
        const std::string name = fmt::format("{:02}_{:02}.tif", tile.row, tile.column);
        io::write_whole((fs::path(options.output) / name).string(), geotiff::label_tiff_bytes(tile.report.tiff));
        lines += summary_line(name, tile.report, things_of(options));
        noticed.see(tile.report);
        ++count;
    };
    std::size_t all = 0;
    {
        const Progress progress("reading " + options.source);
        all = city::import_tiles(options.source, options.window, tile_side, write);
    }
    noticed.say(options.source);
    io::write_whole("-", lines + fmt::format("{}: {} maps; {} of {} tiles have no obstacle\n", options.output, count,
                                             all - count, all));
}

// The place of that name that an extract knows.
city::NamedPlace place_called(const std::string& name, const city::Extract& extract, const std::string& source) {
    const auto those_that = [&extract](auto holds) {
        std::vector<city::NamedPlace> found;
        for (const city::NamedPlace& place : extract.places) {
            if (holds(site::plain_text(place.name))) found.push_back(place);
        }
        return found;
    };
    const std::string wanted = site::plain_text(name);
    std::vector<city::NamedPlace> found = those_that([&](const std::string& plain) { return plain == wanted; });
    if (found.empty()) found = those_that([&](const std::string& plain) { return plain.starts_with(wanted); });
    if (found.size() == 1) return found.front();
    std::vector<std::string> names;
    for (const city::NamedPlace& place : found.empty() ? extract.places : found) names.push_back(place.name);
    throw InputError(fmt::format(
        "--center '{}' {} of {}; {}", shown(name),
        found.empty() ? "is the name of no town or quarter" : "is the name of several places", source,
        names.empty() ? "it names none: give LON,LAT" : fmt::format("it names {}", fmt::join(names, ", "))));
}

// Around the place that is named, or where the source is built up most.
void place_window(ImportOptions& options) {
    const city::Extract extract = [&options] {
        const Progress progress("looking through " + options.source);
        return city::read_extract(options.source);
    }();
    city::ImportOptions& window = options.window;
    const bool named = !options.place.empty();
    std::array<double, 2> center = extract.densest;
    std::string what = "where it is built up most";
    if (named) {
        const city::NamedPlace place = place_called(options.place, extract, options.source);
        center = place.at;
        what = place.name;
    } else if (!options.sized) {
        window.size = extract.side;
    }
    window.longitude = center[0];
    window.latitude = center[1];
    note(options.source, fmt::format("the window lies around {:.6g},{:.6g}, {}", center[0], center[1], what));
}

void validate_zones_file(const ImportOptions& options) {
    if (options.zones.empty()) {
        if (options.clearance) throw InputError("--clearance is for --zones FILE");
        return;
    }
    if (options.zones == "-") throw InputError("--zones writes a file: give its name");
    if (options.zones == options.output) throw InputError("--output and --zones cannot both write to " + options.zones);
    if (options.tile) throw InputError("--zones is for one map: leave --tile out");
    require_ending("--zones", options.zones, {".geojson", ".json"}, "");
}

void run(const ImportOptions& given) {
    ImportOptions options = given;
    options.window.overlays = overlays_of(given.overlays);
    NamedFiles inputs{{"SOURCE", options.source}};
    for (const city::OverlaySource& overlay : options.window.overlays) inputs.emplace_back("--also", overlay.file);
    keep_inputs({{"--output", options.output}, {"--zones", options.zones}}, inputs);
    validate_zones_file(options);
    if (options.center && options.window.box) {
        throw InputError("give the window either by --center (and --size) or by --bbox");
    }
    const bool stated = options.window.box || (options.center && options.place.empty());
    if (!stated) place_window(options);
    if (!options.tile) {
        require_ending("--output", options.output, {".tif", ".tiff"},
                       "; waybreaker map convert then writes that map in other formats");
        return import_one(options);
    }
    if (options.output == "-") throw InputError("--tile writes a folder: give its name as --output");
    import_folder(options, *options.tile);
}

void add_filters(CLI::App& command, const std::string& name, std::vector<city::TagFilter>& filters,
                 const std::string& text) {
    command
        .add_option_function<std::string>(
            name,
            [name, &filters](const std::string& given) {
                try {
                    for (city::TagFilter& filter : city::parse_tag_filters(given)) filters.push_back(std::move(filter));
                } catch (const InputError& error) {
                    throw CLI::ValidationError(name, error.what());
                }
            },
            text)
        ->type_name("TAG,...")
        ->trigger_on_parse();
}

void add_window_options(CLI::App& command, const std::shared_ptr<ImportOptions>& options) {
    city::ImportOptions& window = options->window;
    add_lon_lat(command, "--center", window.longitude, window.latitude,
                "Centre of the window, in degrees east and north, or the name of a town or quarter in the map data "
                "(default: where it is built up most)")
        ->transform([options](const std::string& given) {
            options->place = is_name(given) ? given : "";
            return options->place.empty() ? given : "0,0";
        })
        ->each([options](const std::string&) { options->center = true; })
        ->type_name("LON,LAT|NAME");
    add_number(
        command, "--size",
        [options](double size) {
            options->window.size = size;
            options->sized = true;
        },
        lengths, "METRES", fmt::format("Side of the window around the centre (default: {})", window.size));
    add_box(command, "--bbox", window.box, "The window by its edges, in degrees, in place of centre and size");
    add_number(
        command, "--cell", [options](double cell) { options->window.cell = cell; }, lengths, "METRES",
        fmt::format("Side of a cell (default: {})", window.cell));
    add_number(
        command, "--tile", [options](double side) { options->tile = side; }, lengths, "METRES",
        "Cut the window into squares of that side, and write a folder with a map of each, ROW_COLUMN.tif");
}

void add_profile(CLI::App& command, std::optional<city::Profile>& profile) {
    using enum city::Profile;
    add_choice<city::Profile>(
        command, "--profile", {{"rover", rover}, {"truck", truck}, {"walker", walker}, {"paper", paper}}, profile,
        "Who drives: for rover, truck and walker water, forbidden ground and barriers bar the way as well, for paper "
        "only buildings do; with a profile, --obstacles takes the place of its buildings and barriers (default: rover; "
        "with --obstacles paper)");
}

// A number of metres, or "none".
void add_section(CLI::App& command, std::optional<double>& section) {
    add_number(
        command, "--section", [&section](double side) { section = side; }, {0, lengths.most}, "METRES|none",
        "One breach clears what can be destroyed in one square of that side, rounded to whole cells; none: a whole "
        "building or barrier (default: 20; for paper none)")
        ->transform([](const std::string& given) { return given == "none" ? "0" : given; });
}

void add_choice_options(CLI::App& command, city::ObstacleChoice& choice) {
    add_filters(
        command, "--obstacles", choice.obstacles,
        "What is an obstacle: tags such as building, natural=water and barrier=wall,fence, with commas between, "
        "or * for everything; can be given several times (default: what bars the way of the profile)");
    add_file(command, "--layer", choice.layer,
             "The layer with the obstacles, of a source that has several, such as a folder of shapefiles")
        ->type_name("NAME");
    add_number(
        command, "--wall-width", [&choice](double width) { choice.wall_width = width; }, lengths, "METRES",
        "Width of obstacles that are lines in the source, such as walls (default, and least: a cell)");
    add_filters(command, "--destructible", choice.destructible,
                "Only obstacles with this tag can be destroyed; can be given several times");
    add_filters(command, "--protected", choice.protect,
                "Obstacles with this tag cannot be destroyed; can be given several times");
    add_quantity(command, "--obstacle-weight", choice.weight,
                 "What each obstacle weighs against a budget: area (square metres), or the number that a tag says, "
                 "building:levels for one; with *FACTOR if it is to be scaled (default: 1 each)");
    add_quantity(command, "--obstacle-breach-time", choice.breach_time,
                 "How long the breach of each obstacle takes, as above (default: 0)");
}

}  // namespace

void setup_import(CLI::App& root, Run& run_chosen) {
    auto options = std::make_shared<ImportOptions>();
    CLI::App* command =
        root.add_subcommand("import",
                            "Make a map from map data of a city\n\n"
                            "Reads buildings and the ground around them from any vector source GDAL knows "
                            "(OpenStreetMap .osm.pbf, .osm, .osm.gz, shapefile, "
                            "GeoJSON), projects them to the local UTM zone and writes a window "
                            "as a GeoTIFF label map. Every building, wall and fence "
                            "is an obstacle and keeps its OpenStreetMap id and its name; water and forbidden ground "
                            "are obstacles that cannot be destroyed, and ways are open. The map keeps the streets, "
                            "railways, water and green, if the source has them.");
    add_file(*command, "SOURCE", options->source, "File with map data")->required();
    add_window_options(*command, options);
    add_profile(*command, options->window.profile);
    add_section(*command, options->window.section);
    add_choice_options(*command, options->window.choice);
    command->add_flag("--unknown-free", options->window.unknown_free,
                      "What lies beyond the data of an OpenStreetMap file is free, not unknown");
    add_overlay_options(*command, options->overlays);
    add_file(*command, "--zones", options->zones,
             "Also write what aircraft keep clear of by the map data, as GeoJSON for `waybreaker plan --zones`: "
             "aerodromes, heliports and helipads, prisons, military ground");
    add_number(
        *command, "--clearance", [options](double metres) { options->clearance = metres; }, {0, lengths.most}, "METRES",
        fmt::format("How far aircraft keep from these (default: {})", city::usual_clearance));
    command->add_flag("--merge-touching", options->window.merge_touching,
                      "Buildings that touch are one obstacle, as in the paper");
    command->add_flag_callback(
        "--no-names", [options] { options->window.names = false; }, "Leave out what people call the obstacles");
    command->add_flag_callback(
        "--no-background", [options] { options->window.background = false; },
        "Leave out streets, railways, water, green and names of places");
    add_file(*command, "-o,--output", options->output, "The map to write; with --tile the folder")->required();
    set_examples(*command,
                 {"waybreaker import turin_buildings.shp --center 7.674,45.069 -o turin.tif",
                  ("waybreaker import berlin-mitte.osm.gz --center 13.383,52.5213 --size 600 --cell 1.2 "
                   "--profile truck -o berlin.tif"),
                  ("waybreaker import berlin-mitte.osm.gz --center 13.383,52.5213 --profile paper --merge-touching "
                   "-o paper.tif"),
                  ("waybreaker import monaco.osm.pbf --bbox 7.41,43.725,7.43,43.74 --obstacles building "
                   "--obstacles barrier=wall --obstacles natural=water --protected natural=water "
                   "--obstacle-weight area -o monaco.tif"),
                  ("waybreaker import krems.osm.pbf --center 15.605,48.4095 --also flood.geojson --as water "
                   "--also debris.geojson --as debris -o krems-today.tif"),
                  ("waybreaker import krems.osm.gz --center 15.608,48.4086 -o krems.tif --zones krems-zones.geojson "
                   "--clearance 120"),
                  "waybreaker import kyoto.osm.gz --center 135.765,34.96 --size 3607.2 --tile 1202.4 -o kyoto"});
    command->callback([options, &run_chosen] { run_chosen = [options] { run(*options); }; });
}

}  // namespace waybreaker::apps
