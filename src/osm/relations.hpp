// The areas of multipolygon relations.
#pragma once

#include <cstddef>
#include <cstdint>
#include <osmium/memory/buffer.hpp>
#include <osmium/osm/relation.hpp>
#include <osmium/osm/way.hpp>
#include <unordered_map>
#include <unordered_set>
#include <vector>

#include "osm/features.hpp"
#include "osm/node_places.hpp"

namespace waybreaker::osm {

class Relations {
  public:
    explicit Relations(const Query& query) : query_(query) {}

    // Keeps it if it is wanted; without tags of its own it may be, as it has those of its outer way.
    void add(const osmium::Relation& relation);
    bool empty() const { return offsets_.empty(); }
    // Keeps it if it is a member of one.
    void add_member(const osmium::Way& way);

    // All areas, in the source's order.
    void visit(const NodePlaces& places, const Visitor& visitor, Defects& defects);

    // Whether the way is nothing but the outer ring of an area that was visited: it says nothing else.
    bool is_part(const osmium::Way& way) const;

  private:
    struct Members;

    void place_ways(const NodePlaces& places);
    Members members_of(const osmium::Relation& relation) const;
    void visit(const osmium::Relation& relation, const Visitor& visitor, Defects& defects);

    const Query& query_;
    osmium::memory::Buffer relations_{std::size_t{1} << 16, osmium::memory::Buffer::auto_grow::yes};
    osmium::memory::Buffer ways_{std::size_t{1} << 16, osmium::memory::Buffer::auto_grow::yes};
    std::vector<std::size_t> offsets_;  // of the relations
    std::unordered_set<std::int64_t> ids_;
    std::unordered_map<std::int64_t, std::size_t> members_;                  // offsets of ways by their ids
    std::vector<Tags> tags_;                                                 // of the areas that were visited
    std::unordered_map<std::int64_t, std::vector<std::size_t>> bounded_by_;  // numbers of those, by their outer ways
};

}  // namespace waybreaker::osm
