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

void validate_name(const std::string& option, const std::string& path) {
    const std::string extension = ending_of(path);
    const auto* const known = std::ranges::find(suffixes, extension, &Suffix::text);
    if (known == suffixes.end() || std::ranges::find(known->options, option) != known->options.end()) return;
    std::vector<std::string_view> own;
    for (const Suffix& suffix : suffixes) {
        if (std::ranges::find(suffix.options, option) != suffix.options.end()) own.push_back(suffix.text);
    }
    throw InputError(fmt::format(
        "{} does not write {} files, as {} would be: {}end the name in {}", option, extension, io::excerpt(path),
        known->options.empty() ? "" : fmt::format("use {}, or ", known->options.front()), fmt::join(own, " or ")));
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

void write_beside(const std::vector<mapfile::OutputFile>& files, const NamedFiles& inputs) {
    NamedFiles outputs;
    for (const mapfile::OutputFile& file : files) outputs.emplace_back("this", file.path);
    keep_inputs(outputs, inputs);
    for (const mapfile::OutputFile& file : files) io::write_whole(file.path, file.bytes);
}

void write_beside(const std::vector<std::pair<std::string, std::string>>& files, const NamedFiles& inputs) {
    NamedFiles outputs;
    for (const auto& [path, bytes] : files) outputs.emplace_back("this", path);
    keep_inputs(outputs, inputs);
    for (const auto& [path, bytes] : files) io::write_whole(path, bytes);
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
        validate_name(option, path);
    }
}

}  // namespace waybreaker::apps
