#include "overlay_options.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "mapfile/map_reader.hpp"
#include "mapfile/map_writer.hpp"
#include "mapfile/relabelled_map.hpp"
#include "note.hpp"
#include "option.hpp"
#include "site/demolition.hpp"
#include "waybreaker/error.hpp"

namespace waybreaker::apps {
namespace {

std::string_view word_of(site::OverlayUse use) {
    return site::overlay_use_words[std::size_t(use)];
}

const site::Georeference& place_of(const io::MapFile& file) {
    if (file.georeference) return *file.georeference;
    throw InputError(
        fmt::format("{}: does not say where on Earth it lies, so that nothing can be laid over it; if its "
                    "metres are those of a coordinate system, 'waybreaker map convert' it to placed.tif, "
                    "and name the system with 'gdal_edit.py -a_srs EPSG:25833 placed.tif'",
                    file.source));
}

}  // namespace

void add_overlay_options(CLI::App& command, OverlayOptions& options) {
    const std::vector<std::string> words(site::overlay_use_words.begin(), site::overlay_use_words.end());
    command
        .add_option_function<std::string>(
            "--also",
            [&options](const std::string& file) {
                if (file.empty()) throw CLI::ValidationError("--also", "the name of a file is missing");
                options.files.push_back(file);
            },
            "Lay the areas and lines of that file over the map: any vector format GDAL reads, in any coordinate "
            "system; "
            "can be given several times, each with an --as, and a later one lies on top")
        ->type_name("FILE")
        ->trigger_on_parse();
    add_word(
        command, "--as", words, [&options](std::size_t i) { options.uses.push_back(site::OverlayUse(i)); },
        "What they are: water bars the way for ever but leaves bridges open, closed bars bridges as well, debris and "
        "walls lie on open ground and can be removed, each thing at once; free opens what stands there")
        ->trigger_on_parse();
    add_number(
        command, "--width", [&options](double width) { options.width = width; }, {0.001, 10000}, "METRES",
        "Width of lines, and of points as discs, that do not state a width of their own (default of lines, and least: "
        "a cell)");
}

std::vector<city::OverlaySource> overlays_of(const OverlayOptions& options) {
    if (options.files.size() != options.uses.size()) {
        const bool file_lacks = options.files.size() > options.uses.size();
        throw InputError(file_lacks
                             ? fmt::format("{}: say what it is by --as {}; each file needs one",
                                           options.files[options.uses.size()], fmt::join(site::overlay_use_words, "|"))
                             : fmt::format("--as {}: there is no file that it is about; give it by --also FILE",
                                           word_of(options.uses[options.files.size()])));
    }
    std::vector<city::OverlaySource> sources;
    for (std::size_t i = 0; i < options.files.size(); ++i) {
        sources.push_back({.file = options.files[i], .use = options.uses[i], .width = options.width});
    }
    return sources;
}

CLI::Option* add_quantity(CLI::App& command, const std::string& name, city::Quantity& quantity,
                          const std::string& text) {
    const auto read = [name, &quantity](const std::string& given) {
        try {
            quantity = city::parse_quantity(given);
        } catch (const InputError& error) {
            throw CLI::ValidationError(name, error.what());
        }
    };
    return command.add_option_function<std::string>(name, read, text)->type_name("WHAT");
}

OverlaidMap lay_over(const std::vector<city::OverlaySource>& overlays, io::MapFile file,
                     const city::OverlayCosts& costs) {
    OverlaidMap result{std::move(file), {}};
    for (const city::OverlaySource& source : overlays) {
        const Map& map = result.file.map;
        city::ReadOverlay read = city::read_overlay(source, place_of(result.file), map.width(), map.height(), costs);
        if (std::string doubt = site::doubt(result.file.annotations, read.overlay); !doubt.empty()) {
            read.report.notes.push_back(std::move(doubt));
        }
        result.reports.push_back(std::move(read.report));
        result.file = mapfile::with_overlay(std::move(result.file), read.overlay);
    }
    return result;
}

io::MapFile to_plan_on(const std::vector<city::OverlaySource>& overlays, io::MapFile file) {
    if (overlays.empty()) return file;
    OverlaidMap overlaid = lay_over(overlays, std::move(file));
    note_overlays(overlaid.reports);
    io::MapFile& laid = overlaid.file;
    io::MapFile read = mapfile::parse_map(mapfile::write_map(laid, "overlaid.tif").files.front().bytes, laid.source);
    read.source = std::move(laid.source);
    read.cell_size = laid.cell_size;
    read.cell_size_given = laid.cell_size_given;
    read.notes = std::move(laid.notes);
    read.overlays = overlays;
    return read;
}

std::string overlay_summary(const std::vector<city::OverlayReport>& reports, double cell_size) {
    std::string text;
    for (const city::OverlayReport& report : reports) {
        text += fmt::format("{} as {}: {} {} on {} cells, {}\n", report.file, word_of(report.use), report.things,
                            report.things == 1 ? "thing" : "things", report.cells,
                            site::area_text(io::square_metres(report.cells, cell_size)));
    }
    return text;
}

void note_overlays(const std::vector<city::OverlayReport>& reports) {
    for (const city::OverlayReport& report : reports) {
        for (const std::string& noticed : report.notes) note(report.file, noticed);
    }
}

}  // namespace waybreaker::apps
