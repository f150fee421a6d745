#include "city/scenery.hpp"

#include <algorithm>
#include <utility>

#include "labels/obstacle_names.hpp"

namespace waybreaker::city {
namespace {

using FeatureKind = site::Background::Kind;
using Shape = site::Background::Shape;

// Features of a shape with a tag are scenery.
struct Rule {
    FeatureKind kind;
    int rank;
    std::vector<Shape> shapes;
    TagFilter filter;
    bool only_named = false;  // excludes ways across courtyards, and pavements on both sides of streets
};

// The first matching rule applies.
const std::vector<Rule>& rules() {
    static const std::vector<Rule> all{
        {FeatureKind::street,
         0,
         {Shape::line},
         {"highway",
          {"motorway", "motorway_link", "trunk", "trunk_link", "primary", "primary_link", "secondary",
           "secondary_link"}}},
        {FeatureKind::street, 1, {Shape::line}, {"highway", {"tertiary", "tertiary_link"}}},
        {FeatureKind::street,
         2,
         {Shape::line},
         {"highway", {"unclassified", "residential", "living_street", "pedestrian", "road"}}},
        {FeatureKind::street, 2, {Shape::area}, {"highway", {"pedestrian"}}, true},
        {FeatureKind::street,
         3,
         {Shape::line},
         {"highway", {"service", "track", "footway", "path", "cycleway", "steps", "bridleway"}},
         true},
        {FeatureKind::rail,
         0,
         {Shape::line},
         {"railway", {"rail", "light_rail", "narrow_gauge", "monorail", "funicular"}}},
        {FeatureKind::rail, 1, {Shape::line}, {"railway", {"subway", "tram"}}},
        {FeatureKind::water, 0, {Shape::area}, {"natural", {"water"}}},
        {FeatureKind::water, 0, {Shape::area}, {"waterway", {"riverbank", "dock"}}},
        {FeatureKind::water, 0, {Shape::area}, {"landuse", {"reservoir", "basin"}}},
        {FeatureKind::water, 0, {Shape::line}, {"waterway", {"river", "canal"}}},
        {FeatureKind::water, 0, {Shape::line}, {"natural", {"coastline"}}},
        {FeatureKind::water, 2, {Shape::line}, {"waterway", {"stream"}}},
        {FeatureKind::green, 1, {Shape::area}, {"leisure", {"park", "garden", "golf_course", "nature_reserve"}}},
        {FeatureKind::green, 1, {Shape::area}, {"natural", {"wood", "scrub", "heath", "grassland"}}},
        {FeatureKind::green,
         1,
         {Shape::area},
         {"landuse", {"forest", "cemetery", "recreation_ground", "village_green"}}},
        {FeatureKind::green, 3, {Shape::area}, {"landuse", {"grass", "meadow", "allotments", "orchard", "vineyard"}}},
        {FeatureKind::place,
         0,
         {Shape::point},
         {"place", {"city", "town", "borough", "suburb", "village", "island"}},
         true},
        {FeatureKind::place,
         2,
         {Shape::point, Shape::area},
         {"place", {"quarter", "neighbourhood", "square", "hamlet", "islet", "locality"}},
         true}};
    return all;
}

}  // namespace

std::vector<TagFilter> scenery_keys(std::optional<Shape> shape) {
    std::vector<TagFilter> keys;
    for (const Rule& rule : rules()) {
        const bool fits = !shape || std::find(rule.shapes.begin(), rule.shapes.end(), *shape) != rule.shapes.end();
        const bool known = std::any_of(keys.begin(), keys.end(),
                                       [&](const TagFilter& filter) { return filter.key == rule.filter.key; });
        if (fits && !known) keys.push_back({.key = rule.filter.key});
    }
    return keys;
}

std::optional<Sight> sight_of(const TagSet& tags, Shape shape) {
    if (tags.says("tunnel")) return std::nullopt;
    const auto rule = std::find_if(rules().begin(), rules().end(), [&](const Rule& one) {
        return std::find(one.shapes.begin(), one.shapes.end(), shape) != one.shapes.end() && tags.matches(one.filter);
    });
    if (rule == rules().end()) return std::nullopt;
    const std::string* said = tags.find("name");
    std::string name = labels::clean_name(said ? *said : "");
    const bool siding = rule->kind == FeatureKind::rail && tags.says("service");
    if ((rule->only_named && name.empty()) || siding) return std::nullopt;
    return Sight{rule->kind, rule->rank, *tags.find(rule->filter.key), std::move(name), nullptr};
}

}  // namespace waybreaker::city
