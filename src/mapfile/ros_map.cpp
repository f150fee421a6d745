#include "mapfile/ros_map.hpp"

#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include "core/byte_order_mark.hpp"
#include "core/in_quotes.hpp"
#include "core/number.hpp"
#include "io/shortest_text.hpp"
#include "map/label.hpp"
#include "mapfile/occupancy.hpp"
#include "waybreaker/error.hpp"

namespace waybreaker::mapfile {
namespace {

constexpr std::size_t most_bytes = 1 << 16;

// yaml-cpp's message, without control characters that it quotes from the file.
std::string reason(const YAML::Exception& problem) {
    std::string text = "not well-formed YAML: " + problem.msg;
    std::replace_if(
        text.begin(), text.end(), [](char c) { return c < ' ' || c > '~'; }, '?');
    return text;
}

// The document and its name in errors.
class Document {
  public:
    Document(std::string_view bytes, const std::string& name) : name_(name) {
        if (bytes.size() > most_bytes) throw InputError(name, 0, "is too long for the YAML of a ROS map");
        try {
            root_ = YAML::Load(std::string(bytes));
        } catch (const YAML::Exception& problem) {
            throw error(problem.mark, reason(problem));
        }
        if (!root_.IsMap()) throw InputError(name, 0, "is no YAML of a ROS map: 'key: value' lines are expected");
    }

    std::optional<YAML::Node> find(const char* key) const {
        const YAML::Node& root = root_;
        const YAML::Node node = root[key];
        return node.IsDefined() && !node.IsNull() ? std::optional(node) : std::nullopt;
    }

    YAML::Node get(const char* key) const {
        const std::optional<YAML::Node> node = find(key);
        if (!node) throw InputError(name_, 0, std::string(key) + " is missing: the YAML of a ROS map must say it");
        return *node;
    }

    InputError error(const YAML::Mark& mark, const std::string& message) const {
        return {name_, mark.is_null() ? 0 : std::size_t(mark.line) + 1, message};
    }

    double number(const YAML::Node& node, const char* what, double least, double most) const {
        const std::optional<double> value =
            node.IsScalar() ? waybreaker::number<double>(node.Scalar()) : std::optional<double>();
        if (!value || !(*value >= least && *value <= most)) {
            throw error(node.Mark(), std::string(what) + " must be a number from " + io::shortest_text(least) + " to " +
                                         io::shortest_text(most));
        }
        return *value;
    }

  private:
    const std::string& name_;
    YAML::Node root_;
};

io::RosMode mode_of(const Document& document, const YAML::Node& node) {
    const std::string word = node.IsScalar() ? node.Scalar() : "";
    if (word == "trinary") return io::RosMode::trinary;
    if (word == "scale") return io::RosMode::scale;
    if (word == "raw") return io::RosMode::raw;
    throw document.error(node.Mark(), "mode is " + in_quotes(word) + ", but must be trinary, scale or raw");
}

bool negate_of(const Document& document, const YAML::Node& node) {
    const std::string word = node.IsScalar() ? node.Scalar() : "";
    if (word == "0" || word == "false") return false;
    if (word == "1" || word == "true") return true;
    throw document.error(node.Mark(), "negate is " + in_quotes(word) + ", but must be 0 or 1");
}

std::array<double, 2> origin_of(const Document& document, const YAML::Node& node) {
    constexpr double far = 1e9;
    constexpr double full_turn = 2 * std::numbers::pi;
    constexpr double least_turn = 1e-6;  // less moves no cell of the largest map by a tenth of its side
    if (!node.IsSequence() || node.size() < 2 || node.size() > 3) {
        throw document.error(node.Mark(), "origin must be [x, y, yaw]");
    }
    const double yaw = node.size() == 3 ? document.number(node[2], "the yaw of origin", -far, far) : 0;
    if (std::abs(std::remainder(yaw, full_turn)) > least_turn) {
        throw document.error(node.Mark(), "origin has a yaw, which turns the map; turn the image until it is 0");
    }
    return {document.number(node[0], "the x of origin", -far, far),
            document.number(node[1], "the y of origin", -far, far)};
}

// Whether the text is the YAML of a ROS map with that image.
bool names_image(const std::string& text, const std::string& image) {
    try {
        return parse_ros_yaml(text, "").image == image;
    } catch (const InputError&) {
        return false;
    }
}

std::string as_yaml(const std::string& text) {
    YAML::Emitter emitter;
    emitter << text;
    return emitter.c_str();
}

std::string image_of(const Document& document) {
    const YAML::Node node = document.get("image");
    std::string image = node.IsScalar() ? node.Scalar() : "";
    const bool one_line = image.find_first_of(std::string_view("\0\n\r", 3)) == std::string::npos;
    // Bytes that are not UTF-8 would not be written as they were read.
    const bool text = YAML::Load(as_yaml(image)).Scalar() == image;
    if (image.empty() || !one_line || !text) throw document.error(node.Mark(), "image must be the name of a file");
    return image;
}

// Where the first line begins that says "image:", perhaps indented.
std::optional<std::size_t> image_line(std::string_view bytes) {
    for (std::size_t begin = 0; begin < bytes.size();) {
        const std::size_t end = std::min(bytes.find('\n', begin), bytes.size() - 1);
        const std::size_t word = bytes.find_first_not_of(" \t", begin);
        if (word < end && bytes.substr(word).starts_with("image:")) return begin;
        begin = end + 1;
    }
    return std::nullopt;
}

}  // namespace

bool is_ros_yaml(std::string_view bytes) {
    if (bytes.size() > most_bytes) return false;
    bytes = without_byte_order_mark(bytes);
    const auto has = [bytes](std::string_view key) { return bytes.find(key) != std::string_view::npos; };
    const std::size_t first = bytes.find_first_not_of(" \t\r\n");
    // One pair of braces around all of it, as YAML also allows.
    const bool flow = first != std::string_view::npos && bytes[first] == '{';
    return image_line(bytes) || (flow && (has("image:") || has("image\":")));
}

std::optional<RosPieces> ros_pieces(std::string_view bytes) {
    constexpr std::string_view end = "\n...\n";
    const std::size_t at = bytes.substr(0, most_bytes).find(end);
    if (at == std::string_view::npos || !is_ros_yaml(bytes.substr(0, at))) return std::nullopt;
    const std::string_view image = bytes.substr(at + end.size());
    if (!is_png(image) && !is_netpbm(image)) return std::nullopt;
    return RosPieces{std::string(bytes.substr(0, at)), std::string(image)};
}

io::RosYaml parse_ros_yaml(std::string_view bytes, const std::string& name) try {
    const Document document(bytes, name);
    io::RosYaml yaml;
    yaml.image = image_of(document);
    yaml.resolution = document.number(document.get("resolution"), "resolution", 1e-6, 1e6);
    yaml.origin = origin_of(document, document.get("origin"));
    if (const auto node = document.find("mode")) yaml.mode = mode_of(document, *node);
    if (const auto node = document.find("negate")) yaml.negate = negate_of(document, *node);
    if (const auto node = document.find("occupied_thresh")) {
        yaml.occupied_thresh = document.number(*node, "occupied_thresh", 0, 1);
    }
    if (const auto node = document.find("free_thresh")) yaml.free_thresh = document.number(*node, "free_thresh", 0, 1);
    if (yaml.free_thresh > yaml.occupied_thresh) {
        throw InputError(name, 0, "free_thresh is above occupied_thresh: are they exchanged?");
    }
    return yaml;
} catch (const YAML::Exception& problem) {
    throw InputError(name, 0, reason(problem));
}

RosCells ros_cells(const GreyImage& image, const io::RosYaml& yaml, double threshold, io::Nav2 nav2) {
    constexpr int savers_unknown = 3 * 205;
    RosCells cells{.occupied = Grid(image.width, image.height),
                   .unknown = Grid(image.width, image.height),
                   .transparency = image.transparency};
    const GreyImage::Pixel* pixel = image.pixels.data();
    for (int y = 0; y < image.height; ++y) {
        for (int x = 0; x < image.width; ++x, ++pixel) {
            const std::optional<int> percent = occupancy(*pixel, image.transparency, yaml, nav2);
            if (!percent) {
                cells.unknown.set_blocked({x, y}, true);
                ++cells.unknown_count;
            } else if (*percent >= 100 * threshold) {
                cells.occupied.set_blocked({x, y}, true);
            }
            if (percent == 0 && pixel->sum == savers_unknown && yaml.mode != io::RosMode::raw)
                cells.frees_unknown = true;
        }
    }
    return cells;
}

Map ros_map(const RosCells& cells, Connectivity connectivity, bool unknown_free) {
    if (unknown_free || cells.unknown_count == 0) return Map(Grid(cells.occupied), connectivity);
    std::vector<std::uint32_t> labels = label_components(cells.occupied, connectivity);
    const std::uint32_t walls = *std::max_element(labels.begin(), labels.end());
    std::uint32_t last = walls;
    const std::vector<std::uint32_t> unknown = label_components(cells.unknown, connectivity);
    for (std::size_t i = 0; i < labels.size(); ++i) {
        if (unknown[i] == 0) continue;
        labels[i] = walls + unknown[i];
        last = std::max(last, labels[i]);
    }
    std::vector<ObstacleAttributes> attributes(last + 1);
    std::for_each(attributes.begin() + walls + 1, attributes.end(), [](auto& a) { a.destructible = false; });
    return Map::from_labels(cells.occupied.width(), cells.occupied.height(), std::move(labels), attributes);
}

std::string ros_yaml_text(const io::RosYaml& yaml) {
    const char* const mode = yaml.mode == io::RosMode::trinary ? "trinary"
                             : yaml.mode == io::RosMode::scale ? "scale"
                                                               : "raw";
    return "image: " + as_yaml(yaml.image) + "\nmode: " + mode + "\nresolution: " + io::shortest_text(yaml.resolution) +
           "\norigin: [" + io::shortest_text(yaml.origin[0]) + ", " + io::shortest_text(yaml.origin[1]) +
           ", 0]\nnegate: " + (yaml.negate ? "1" : "0") +
           "\noccupied_thresh: " + io::shortest_text(yaml.occupied_thresh) +
           "\nfree_thresh: " + io::shortest_text(yaml.free_thresh) + "\n";
}

std::string with_image(std::string_view bytes, const std::string& image, const std::string& name) {
    io::RosYaml yaml = parse_ros_yaml(bytes, name);
    if (yaml.image == image) return std::string(bytes);
    const std::size_t key = image_line(bytes).value_or(0);
    const std::size_t at = bytes.find(yaml.image, key);
    std::string changed(bytes);
    if (at < bytes.find('\n', key)) changed.replace(at, yaml.image.size(), image);
    // The YAML's style hides the name, or does not suit the new one: then the file is written from scratch.
    yaml.image = image;
    return names_image(changed, image) ? changed : ros_yaml_text(yaml);
}

}  // namespace waybreaker::mapfile
