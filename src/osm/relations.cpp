#include "osm/relations.hpp"

#include <algorithm>
#include <array>
#include <cstring>
#include <deque>
#include <map>
#include <osmium/area/assembler_config.hpp>
#include <osmium/area/geom_assembler.hpp>
#include <osmium/osm/area.hpp>
#include <string_view>
#include <utility>

#include "osm/objects.hpp"
#include "osm/uses.hpp"

namespace waybreaker::osm {

// The ways of a relation that the file has, each once.
struct Relations::Members {
    std::vector<const osmium::Way*> outer;  // or of no role
    std::vector<const osmium::Way*> inner;
    bool complete = true;  // all ways, with all their nodes
};

namespace {

constexpr std::size_t absent = std::size_t(-1);

// What says nothing of the thing itself.
bool says_nothing(const char* key) {
    static constexpr std::array<std::string_view, 7> keys{"type",  "source",      "created_by", "note",
                                                          "fixme", "attribution", "source:date"};
    return std::ranges::find(keys, std::string_view(key)) != keys.end();
}

bool is_silent(const osmium::TagList& tags) {
    return std::ranges::all_of(tags, [](const osmium::Tag& tag) { return says_nothing(tag.key()); });
}

bool bounds_area(const osmium::Relation& relation) {
    const char* const type = relation.tags().get_value_by_key("type", "");
    return std::strcmp(type, "multipolygon") == 0 || std::strcmp(type, "boundary") == 0;
}

// [wiki: Relation:multipolygon, and Relation:boundary for the old words] Others are what lies within, such as the parts
// of a building.
bool bounds_area(const osmium::RelationMember& member) {
    static constexpr std::array<std::string_view, 5> roles{"", "outer", "inner", "exclave", "enclave"};
    return member.type() == osmium::item_type::way &&
           std::ranges::find(roles, std::string_view(member.role())) != roles.end();
}

// The tags of the relation, or else those of its first outer way that has any: so they were drawn until 2017.
const osmium::TagList& speaking_tags(const osmium::Relation& relation, const std::vector<const osmium::Way*>& outer) {
    if (!is_silent(relation.tags())) return relation.tags();
    const auto speaks = std::ranges::find_if(outer, [](const osmium::Way* way) { return !is_silent(way->tags()); });
    return speaks == outer.end() ? relation.tags() : (*speaks)->tags();
}

template <typename Nodes>
Line line_of(const Nodes& nodes) {
    Line line;
    for (const osmium::NodeRef& node : nodes) {
        if (node.location().valid()) line.push_back(place_of(node.location()));
    }
    return line;
}

std::vector<Line> lines_of(const std::vector<const osmium::Way*>& ways) {
    std::vector<Line> lines;
    for (const osmium::Way* way : ways) {
        Line line = line_of(way->nodes());
        if (line.size() >= 2) lines.push_back(std::move(line));
    }
    return lines;
}

std::vector<Polygon> polygons_of(const osmium::Area& area) {
    std::vector<Polygon> polygons;
    for (const osmium::OuterRing& outer : area.outer_rings()) {
        Polygon& polygon = polygons.emplace_back();
        polygon.push_back(line_of(outer));
        for (const osmium::InnerRing& inner : area.inner_rings(outer)) polygon.push_back(line_of(inner));
    }
    return polygons;
}

using Corner = std::pair<double, double>;

Corner corner(const Place& place) {
    return {place.longitude, place.latitude};
}

// Lines joined end to end to closed ones; empty unless all of them close.
std::vector<Line> rings_of(std::vector<Line> lines) {
    std::multimap<Corner, std::size_t> ends;
    for (std::size_t i = 0; i < lines.size(); ++i) {
        ends.emplace(corner(lines[i].front()), i);
        ends.emplace(corner(lines[i].back()), i);
    }
    std::vector<bool> used(lines.size(), false);
    std::vector<Line> rings;
    for (std::size_t i = 0; i < lines.size(); ++i) {
        if (used[i]) continue;
        used[i] = true;
        Line& ring = rings.emplace_back(lines[i]);
        while (corner(ring.front()) != corner(ring.back())) {
            const auto [begin, end] = ends.equal_range(corner(ring.back()));
            const auto next = std::find_if(begin, end, [&](const auto& one) { return !used[one.second]; });
            if (next == end) return {};
            used[next->second] = true;
            Line more = lines[next->second];
            if (corner(more.front()) != corner(ring.back())) std::ranges::reverse(more);
            ring.insert(ring.end(), more.begin() + 1, more.end());
        }
    }
    return rings;
}

}  // namespace

void Relations::add(const osmium::Relation& relation) {
    if (!relation.visible() || !bounds_area(relation)) return;
    if (!is_silent(relation.tags()) && !wants(query_.areas, relation.tags())) return;
    if (!ids_.insert(relation.id()).second) return;
    relations_.add_item(relation);
    offsets_.push_back(relations_.commit());
    for (const osmium::RelationMember& member : relation.members()) {
        if (bounds_area(member)) members_.emplace(member.ref(), absent);
    }
}

void Relations::add_member(const osmium::Way& way) {
    const auto member = members_.find(way.id());
    if (member == members_.end() || member->second != absent || !way.visible()) return;
    ways_.add_item(way);
    member->second = ways_.commit();
}

void Relations::place_ways(const NodePlaces& places) {
    for (osmium::Way& way : ways_.select<osmium::Way>()) {
        for (osmium::NodeRef& node : way.nodes()) node.set_location(location_of(node, places));
    }
}

Relations::Members Relations::members_of(const osmium::Relation& relation) const {
    Members members;
    std::unordered_set<std::int64_t> known;
    for (const osmium::RelationMember& member : relation.members()) {
        if (!bounds_area(member) || !known.insert(member.ref()).second) continue;
        const std::size_t offset = members_.at(member.ref());
        if (offset == absent) {
            members.complete = false;
            continue;
        }
        const auto& way = ways_.get<osmium::Way>(offset);
        const bool whole =
            std::ranges::all_of(way.nodes(), [](const osmium::NodeRef& node) { return node.location().valid(); });
        if (!whole) members.complete = false;
        const std::string_view role = member.role();
        (role == "inner" || role == "enclave" ? members.inner : members.outer).push_back(&way);
    }
    return members;
}

void Relations::visit(const NodePlaces& places, const Visitor& visitor, Defects& defects) {
    place_ways(places);
    for (const std::size_t offset : offsets_) visit(relations_.get<osmium::Relation>(offset), visitor, defects);
}

void Relations::visit(const osmium::Relation& relation, const Visitor& visitor, Defects& defects) {
    const Members members = members_of(relation);
    const osmium::TagList& tags = speaking_tags(relation, members.outer);
    if (!wants(query_.areas, tags)) return;
    std::vector<Line> outer = lines_of(members.outer);
    std::vector<Line> inner = lines_of(members.inner);
    Around around;
    for (const std::vector<Line>* const lines : {&outer, &inner}) {
        for (const Line& line : *lines) around.add(line);
    }
    if ((outer.empty() && inner.empty()) || !around.meets(query_.box)) return;
    Feature feature{.shape = Shape::area, .source_id = -relation.id(), .tags = tags_of(tags)};
    if (members.complete) {
        osmium::memory::Buffer ways{std::size_t{1} << 12, osmium::memory::Buffer::auto_grow::yes};
        for (const std::vector<const osmium::Way*>* const some : {&members.outer, &members.inner}) {
            for (const osmium::Way* way : *some) {
                ways.add_item(*way);
                ways.commit();
            }
        }
        osmium::memory::Buffer assembled{std::size_t{1} << 12, osmium::memory::Buffer::auto_grow::yes};
        const osmium::area::AssemblerConfig config;
        if (osmium::area::GeomAssembler{config}(relation, ways, assembled)) {
            feature.polygons = polygons_of(*assembled.select<osmium::Area>().begin());
        } else {
            // Rings that cross: filled by turns, as one would draw them.
            std::vector<Line> all = outer;
            all.insert(all.end(), inner.begin(), inner.end());
            Polygon rings = rings_of(std::move(all));
            if (!rings.empty()) {
                feature.polygons.push_back(std::move(rings));
                defects.crossing.push_back(feature.source_id);
            }
        }
    }
    if (feature.polygons.empty()) {
        visitor.cut({feature.source_id, std::move(feature.tags), std::move(outer), std::move(inner)});
        return;
    }
    for (const osmium::Way* way : members.outer) bounded_by_[way->id()].push_back(tags_.size());
    tags_.push_back(feature.tags);
    visitor.feature(std::move(feature));
}

bool Relations::is_part(const osmium::Way& way) const {
    const auto areas = bounded_by_.find(way.id());
    if (areas == bounded_by_.end()) return false;
    return std::ranges::any_of(areas->second, [&](std::size_t area) {
        bool says_any = false;
        for (const osmium::Tag& tag : way.tags()) {
            if (!is_area_key(tag.key())) continue;
            says_any = true;
            const bool said = std::ranges::any_of(tags_[area], [&](const auto& one) {
                return one.first == tag.key() && (one.second == tag.value() || one.first == "building");
            });
            if (!said) return false;
        }
        return says_any;
    });
}

}  // namespace waybreaker::osm
