#include "city/merge_touching.hpp"

#include <map>
#include <utility>

#include "map/label.hpp"

namespace waybreaker::city {
namespace {

using site::LabelLayer;

// The labels that do not join, with numbers after those of the components.
template <class TakeTags>
void append_others(const LabelLayer& cells, const std::vector<bool>& joins, LabelLayer& result, TakeTags take_tags) {
    std::vector<std::uint32_t> number(joins.size(), 0);
    for (std::uint32_t label = 1; label < joins.size(); ++label) {
        if (joins[label]) continue;
        number[label] = std::uint32_t(result.attributes.size());
        result.attributes.push_back(cells.attributes[label]);
        result.kinds[number[label]] = cells.kinds.at(label);
        const auto name = cells.names.find(label);
        if (name != cells.names.end()) result.names[number[label]] = name->second;
        take_tags(label, number[label]);
    }
    for (std::size_t i = 0; i < cells.labels.size(); ++i) {
        if (number[cells.labels[i]] != 0) result.labels[i] = number[cells.labels[i]];
    }
}

}  // namespace

LabelLayer merged(const LabelLayer& cells, const std::vector<bool>& joins, bool weighed) {
    const std::vector<std::uint32_t>& labels = cells.labels;
    Grid grid(cells.width, cells.height);
    const auto width = std::size_t(cells.width);
    for (std::size_t i = 0; i < labels.size(); ++i) {
        if (joins[labels[i]]) grid.set_blocked({int(i % width), int(i / width)}, true);
    }
    LabelLayer result{.width = cells.width,
                      .height = cells.height,
                      .labels = label_components(grid, Connectivity::four),
                      .attributes = std::vector<ObstacleAttributes>(1)};
    const auto tags_of = site::by_label(cells.tags);
    const auto take_tags = [&](std::uint32_t from, std::uint32_t to) {
        const auto said = tags_of.find(from);
        if (said == tags_of.end()) return;
        for (const std::string* tag : said->second) result.tags[*tag].push_back(to);
    };
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> shares;  // cells by component and label
    for (std::size_t i = 0; i < labels.size(); ++i) {
        if (joins[labels[i]]) ++shares[{result.labels[i], labels[i]}];
    }
    std::uint32_t most = 0;
    std::uint32_t most_named = 0;
    for (const auto& [key, count] : shares) {
        const auto [component, label] = key;
        const ObstacleAttributes& part = cells.attributes[label];
        take_tags(label, component);
        if (component == result.attributes.size()) {
            result.attributes.push_back(part);
            result.kinds[component] = cells.kinds.at(label);
            most = count;
            most_named = 0;
        } else {
            ObstacleAttributes& whole = result.attributes.back();
            whole.destructible = whole.destructible && part.destructible;
            if (weighed) whole.weight += part.weight;
            whole.breach_time += part.breach_time;
            if (count > most) {
                most = count;
                whole.source_id = part.source_id;
                result.kinds[component] = cells.kinds.at(label);
            }
        }
        const auto name = cells.names.find(label);
        if (name != cells.names.end() && count > most_named) {
            most_named = count;
            result.names[component] = name->second;
        }
    }
    append_others(cells, joins, result, take_tags);
    return result;
}

}  // namespace waybreaker::city
