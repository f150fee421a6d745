#include "named_files.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <string_view>

#include "io/excerpt.hpp"
#include "io/output_file.hpp"
#include "waybreaker/error.hpp"

namespace waybreaker::apps {
namespace {

struct Suffix {
    std::string_view text;
    std::vector<std::string_view> options;  // that write such files; none: only maps have such names
};

// Extensions that identify a format. Other extensions may be used for any format.
const std::array<Suffix, 32> suffixes{{{".json", {"--json", "--save-mission", "--trace", "--geojson", "--vda5050"}},
                                       {".svg", {"--svg"}},
                                       {".png", {"--png", "--opened-map"}},
                                       {".html", {"--html"}},
                                       {".htm", {"--html"}},
                                       {".geojson", {"--geojson", "--opened-map"}},
                                       {".csv", {"--csv"}},
                                       {".yaml", {"--ros-path", "--ros-parts", "--opened-map"}},
                                       {".yml", {"--ros-path", "--ros-parts", "--opened-map"}},
                                       {".xml", {"--xml", "--opened-map"}},
                                       {".gpx", {"--gpx"}},
                                       {".plan", {"--qgc"}},
                                       {".scen", {}},
                                       {".db", {}},
                                       {".osm", {}},
                                       {".pbf", {}},
                                       {".gpkg", {}},
                                       {".shp", {}},
                                       {".kml", {"--kml"}},
                                       {".gml", {}},
                                       {".fgb", {}},
                                       {".toml", {}},
                                       {".svgz", {}},
                                       {".gz", {}},
                                       {".zip", {}},
                                       {".jpg", {}},
                                       {".jpeg", {}},
                                       {".pdf", {}},
                                       {".map", {"--opened-map"}},
                                       {".pgm", {"--opened-map"}},
                                       {".tif", {"--opened-map", "--reach"}},
                                       {".tiff", {"--opened-map", "--reach"}}}};

std::string lower(std::string text) {
    std::ranges::transform(text, text.begin(), [](char c) { return c >= 'A' && c <= 'Z' ? char(c + ('a' - 'A')) : c; });
    return text;
}

std::string ending_of(const std::string& path) {
    return lower(std::filesystem::path(path).extension().string());
}

// `outputs`: all of the command.
void validate_name(const std::string& option, const std::string& path, const NamedFiles& outputs) {
    const std::string extension = ending_of(path);
    const auto* const known = std::ranges::find(suffixes, extension, &Suffix::text);
    if (known == suffixes.end() || std::ranges::find(known->options, option) != known->options.end()) return;
    const auto is_here = [&](std::string_view other) {
        return std::ranges::find(outputs, other, &NamedFiles::value_type::first) != outputs.end();
    };
    const auto other = std::ranges::find_if(known->options, is_here);
    std::vector<std::string_view> own;
    for (const Suffix& suffix : suffixes) {
        if (std::ranges::find(suffix.options, option) != suffix.options.end()) own.push_back(suffix.text);
    }
    throw InputError(fmt::format(
        "{} does not write {} files, as {} would be: {}end the name in {}", option, extension, io::excerpt(path),
        other == known->options.end() ? "" : fmt::format("use {}, or ", *other), fmt::join(own, " or ")));
}

std::string name_of(const std::string& path) {
    return path == "-" ? "standard output" : io::excerpt(path);
}

bool is_one_file(const std::string& a, const std::string& b) {
    std::error_code failed;
    return a == b || (std::filesystem::is_regular_file(a, failed) && std::filesystem::equivalent(a, b, failed));
}

}  // namespace

void validate_inputs(const NamedFiles& inputs) {
    const auto reads_it = [](const auto& input) { return io::is_standard_input(input.second); };
    const auto first = std::ranges::find_if(inputs, reads_it);
    if (first == inputs.end()) return;
    const auto second = std::find_if(first + 1, inputs.end(), reads_it);
    if (second == inputs.end()) return;
    throw InputError(fmt::format("{} and {} cannot both be standard input", first->first, second->first));
}

void require_ending(const std::string& option, const std::string& path, const std::vector<std::string_view>& endings,
                    const std::string& remedy) {
    const std::string extension = ending_of(path);
    const bool known = std::ranges::find(suffixes, extension, &Suffix::text) != suffixes.end();
    if (!known || std::ranges::find(endings, extension) != endings.end()) return;
    throw InputError(fmt::format("{} does not write {} files, as {} would be: end the name in {}{}", option, extension,
                                 io::excerpt(path), fmt::join(endings, " or "), remedy));
}

void keep_inputs(const NamedFiles& outputs, const NamedFiles& inputs) {
    for (const auto& [output, path] : outputs) {
        if (path.empty() || path == "-") continue;
        for (const auto& [input, read] : inputs) {
            if (!is_one_file(path, read)) continue;
            throw InputError(fmt::format("{} would overwrite {}, {}", output, input, name_of(path)));
        }
    }
}

NamedFiles files_of_map(const std::string& path, const io::MapFile& map) {
    NamedFiles files{{"MAP", path}};
    if (map.ros)
        files.emplace_back("the image of MAP",
                           (std::filesystem::path(path).parent_path() / map.ros->yaml.image).string());
    return files;
}

void write_beside(const std::vector<io::OutputFile>& files, const NamedFiles& inputs) {
    NamedFiles outputs;
    for (const io::OutputFile& file : files) outputs.emplace_back("this", file.path);
    keep_inputs(outputs, inputs);
    for (const io::OutputFile& file : files) io::write_whole(file.path, file.bytes);
}

void validate_outputs(const NamedFiles& outputs, const NamedFiles& inputs) {
    keep_inputs(outputs, inputs);
    for (std::size_t i = 0; i < outputs.size(); ++i) {
        const auto& [option, path] = outputs[i];
        if (path.empty()) continue;
        for (std::size_t j = 0; j < i; ++j) {
            if (path != outputs[j].second) continue;
            throw InputError(fmt::format("{} and {} cannot both write to {}", outputs[j].first, option, name_of(path)));
        }
        validate_name(option, path, outputs);
    }
}

}  // namespace waybreaker::apps
