// Where nodes lie, by their ids: about eight bytes for each where they come in the order of their ids, as in most
// files.
#pragma once

#include <cstddef>
#include <cstdint>
#include <osmium/osm/location.hpp>
#include <string>
#include <utility>
#include <vector>

namespace waybreaker::osm {

class NodePlaces {
  public:
    void add(std::int64_t id, osmium::Location location);
    // Before the first is found. Of several with one id the first counts.
    void finish();
    // Undefined if there is no such node.
    osmium::Location find(std::int64_t id) const;

  private:
    struct Entry {
        std::int64_t id;
        std::int32_t x;
        std::int32_t y;
    };
    // Some nodes: the first, and differences from one to the next.
    struct Block {
        Entry first;
        std::uint32_t chunk;
        std::uint32_t begin;  // in the chunk
    };

    void begin_block(const Entry& entry);

    std::vector<Block> blocks_;
    std::vector<std::string> chunks_;
    Entry last_{};
    int in_block_ = 0;
    std::vector<std::pair<std::int64_t, osmium::Location>> out_of_order_;
};

}  // namespace waybreaker::osm
