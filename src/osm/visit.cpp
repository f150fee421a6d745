#include <algorithm>
#include <exception>
#include <memory>
#include <new>
#include <osmium/io/gzip_compression.hpp>
#include <osmium/io/o5m_input.hpp>
#include <osmium/io/pbf_input.hpp>
#include <osmium/io/reader.hpp>
#include <osmium/io/xml_input.hpp>
#include <osmium/osm/node.hpp>
#include <osmium/osm/relation.hpp>
#include <osmium/osm/way.hpp>
#include <osmium/thread/pool.hpp>
#include <unordered_set>
#include <utility>

#include "core/one_line.hpp"
#include "osm/features.hpp"
#include "osm/josm.hpp"
#include "osm/node_places.hpp"
#include "osm/objects.hpp"
#include "osm/relations.hpp"
#include "osm/uses.hpp"

namespace waybreaker::osm {
namespace {

namespace bits = osmium::osm_entity_bits;

// What libosmium and what it stands on throw, of many kinds.
template <typename Read>
auto guarded(Read read) {
    try {
        return read();
    } catch (const std::bad_alloc&) {
        throw;
    } catch (const std::exception& error) {
        throw ReadError(one_line(error.what()));
    }
}

// One reading of a file. Its threads are its own: a pool of the whole program would not live on in a forked process.
class Reading {
  public:
    Reading(const File& file, bits::type kinds)
        : reader_(guarded([&] {
              return std::make_unique<osmium::io::Reader>(osmium::io::File(file.path, file.format), kinds,
                                                          meta_of(file), pool_);
          })),
          header_(guarded([this] { return reader_->header(); })) {
        // Changes are of many versions by nature.
        if (file.format == "pbf" && header_.has_multiple_object_versions()) {
            throw ReadError("it holds every version of its objects; take those of one day by 'osmium time-filter'");
        }
    }

    std::optional<Box> stated() const {
        Around all;
        for (const osmium::Box& box : header_.boxes()) {
            if (!box.valid()) continue;
            all.add(place_of(box.bottom_left()));
            all.add(place_of(box.top_right()));
        }
        return all.box();
    }

    bool is_by_josm() const { return header_.get("generator").starts_with("JOSM"); }

    // Calls see(object) for nodes, ways and relations, whichever are read.
    template <typename See>
    void each(See see) {
        while (const osmium::memory::Buffer buffer = guarded([this] { return reader_->read(); })) {
            for (const osmium::OSMObject& object : buffer.select<osmium::OSMObject>()) see(object);
        }
    }

  private:
    // Only its metadata says whether a change deletes an object.
    static osmium::io::read_meta meta_of(const File& file) {
        return file.format == "pbf" ? osmium::io::read_meta::no : osmium::io::read_meta::yes;
    }

    osmium::thread::Pool pool_{2};
    std::unique_ptr<osmium::io::Reader> reader_;
    osmium::io::Header header_;
};

class Visit {
  public:
    Visit(const File& file, const Query& query, const Visitor& visitor)
        : file_(file), query_(query), visitor_(visitor), relations_(query) {}

    Report run() {
        if (file_.format != "pbf") {
            read_at_once();
        } else {
            if (query_.areas) {
                Reading(file_, bits::relation).each([this](const osmium::OSMObject& object) {
                    relations_.add(static_cast<const osmium::Relation&>(object));
                });
            }
            read_nodes();
        }
        if (!wants_ways()) return report_;
        places_.finish();
        report_.nodes = all_.box();
        relations_.visit(places_, visitor_, report_.defects);
        const auto see_way = [this](const osmium::Way& way) { see(way); };
        if (file_.format != "pbf") {
            std::ranges::for_each(ways_.select<osmium::Way>(), see_way);
        } else {
            Reading(file_, bits::way).each([&](const osmium::OSMObject& object) {
                see_way(static_cast<const osmium::Way&>(object));
            });
        }
        return report_;
    }

  private:
    bool wants_ways() const { return query_.lines || query_.areas; }

    // Text takes so long to read that it is worth the memory to do it once.
    void read_at_once() {
        osmium::memory::Buffer relations(std::size_t{1} << 16, osmium::memory::Buffer::auto_grow::yes);
        Reading reading(file_, wants_ways() ? bits::node | bits::way | bits::relation : bits::node);
        report_.stated = reading.stated();
        const Deleted deleted = reading.is_by_josm() ? marked_as_deleted(file_.path) : Deleted();
        reading.each([&](const osmium::OSMObject& object) {
            if (deleted.contains({object.type(), object.id()})) return;
            if (object.type() == osmium::item_type::node) return see(static_cast<const osmium::Node&>(object));
            if (object.type() == osmium::item_type::relation && !query_.areas) return;
            osmium::memory::Buffer& buffer = object.type() == osmium::item_type::way ? ways_ : relations;
            buffer.add_item(object);
            buffer.commit();
        });
        for (const auto& relation : relations.select<osmium::Relation>()) relations_.add(relation);
        for (const auto& way : ways_.select<osmium::Way>()) relations_.add_member(way);
    }

    // And members of relations, which may come before them.
    void read_nodes() {
        Reading reading(file_, relations_.empty() ? bits::node : bits::node | bits::way);
        report_.stated = reading.stated();
        reading.each([this](const osmium::OSMObject& object) {
            if (object.type() == osmium::item_type::node) {
                see(static_cast<const osmium::Node&>(object));
            } else {
                relations_.add_member(static_cast<const osmium::Way&>(object));
            }
        });
    }

    void see(const osmium::Node& node) {
        if (!node.visible() || !node.location().valid()) return;
        if (wants_ways()) {
            places_.add(node.id(), node.location());
            all_.add(place_of(node.location()));
        }
        if (node.tags().empty() || !wants(query_.points, node.tags())) return;
        Around around;
        around.add(place_of(node.location()));
        if (!around.meets(query_.box)) return;
        visitor_.feature({.shape = Shape::point,
                          .source_id = node.id(),
                          .tags = tags_of(node.tags()),
                          .line = {place_of(node.location())}});
    }

    void see(const osmium::Way& way) {
        if (!way.visible()) return;
        Uses uses{wants(query_.lines, way.tags()), wants(query_.areas, way.tags())};
        if (!uses.line && !uses.area) return;
        constexpr std::size_t triangle = 4;  // its first node is its last one, too
        const Uses can_be = uses_of(way.tags(), way.nodes().size() >= triangle && closes(way));
        uses.line = uses.line && can_be.line;
        uses.area = uses.area && can_be.area && !relations_.is_part(way);
        if (!uses.line && !uses.area) return;
        Line line;
        Around around;
        for (const osmium::NodeRef& node : way.nodes()) {
            const osmium::Location location = location_of(node, places_);
            if (!location.valid()) continue;
            line.push_back(place_of(location));
            around.add(line.back());
        }
        if (line.empty() || !around.meets(query_.box) || !seen_.insert(way.id()).second) return;
        if (line.size() < way.nodes().size()) report_.defects.lacking_nodes.push_back(way.id());
        visit(way, uses, std::move(line));
    }

    // Its ends are one node, or two in one place.
    bool closes(const osmium::Way& way) const {
        if (way.is_closed()) return true;
        const osmium::Location begin = location_of(way.nodes().front(), places_);
        return begin.valid() && begin == location_of(way.nodes().back(), places_);
    }

    void visit(const osmium::Way& way, Uses uses, Line line) {
        if (uses.area) {
            Line ring = line;
            const bool closed =
                ring.front().longitude == ring.back().longitude && ring.front().latitude == ring.back().latitude;
            if (!closed) ring.push_back(ring.front());  // where the way lacks its first node
            visitor_.feature({.shape = Shape::area,
                              .source_id = way.id(),
                              .tags = tags_of(way.tags()),
                              .polygons = {{std::move(ring)}}});
        }
        if (uses.line && line.size() >= 2) {
            visitor_.feature(
                {.shape = Shape::line, .source_id = way.id(), .tags = tags_of(way.tags()), .line = std::move(line)});
        }
    }

    const File& file_;
    const Query& query_;
    const Visitor& visitor_;
    Relations relations_;
    NodePlaces places_;
    Around all_;
    osmium::memory::Buffer ways_{std::size_t{1} << 16, osmium::memory::Buffer::auto_grow::yes};  // of text
    std::unordered_set<std::int64_t> seen_;  // ways; a file can have one twice
    Report report_;
};

}  // namespace

Report visit(const File& file, const Query& query, const Visitor& visitor) {
    return Visit(file, query, visitor).run();
}

}  // namespace waybreaker::osm
