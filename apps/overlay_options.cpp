#include "overlay_options.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "io/map_file.hpp"
#include "note.hpp"
#include "option.hpp"
#include "site/demolition.hpp"
#include "waybreaker/error.hpp"

namespace waybreaker::apps {
namespace {

std::string_view word_of(site::OverlayUse use) {
    return site::overlay_use_words[std::size_t(use)];
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
