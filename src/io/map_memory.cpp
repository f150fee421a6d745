#include "io/map_memory.hpp"

#include "map/map_size.hpp"

namespace waybreaker::io {
namespace {

constexpr std::size_t allocation = 16;  // heap overhead per allocation

std::size_t memory_of(const std::string& text) {
    const bool inside = text.capacity() <= std::string().capacity();
    return sizeof(std::string) + (inside ? 0 : text.capacity() + allocation);
}

std::size_t memory_of(const site::Background& background) {
    std::size_t bytes = background.features.capacity() * sizeof(site::Background::Feature);
    for (const auto& feature : background.features) {
        bytes += memory_of(feature.type) + memory_of(feature.name) - 2 * sizeof(std::string);
        bytes += feature.parts.capacity() * sizeof(std::vector<Point>) + allocation;
        for (const auto& part : feature.parts) bytes += part.capacity() * sizeof(Point) + allocation;
    }
    return bytes;
}

std::size_t memory_of(const site::Sections& sections) {
    std::size_t bytes = sections.structures.capacity() * sizeof(site::Structure);
    for (const site::Structure& one : sections.structures) bytes += memory_of(one.name) - sizeof(std::string);
    for (const auto& parts : sections.parts) {
        bytes += sizeof(std::vector<std::uint32_t>) + parts.capacity() * sizeof(std::uint32_t) + allocation;
    }
    return bytes;
}

std::size_t memory_of(const site::ObstacleTags& tags) {
    constexpr std::size_t node = 64;  // of the tree
    std::size_t bytes = 0;
    for (const auto& [tag, obstacles] : tags) {
        bytes += node + memory_of(tag) + obstacles.capacity() * sizeof(ObstacleId) + 2 * allocation;
    }
    return bytes;
}

}  // namespace

std::size_t memory_of(const MapFile& file) {
    const Map& map = file.map;
    std::size_t bytes = map_bytes(map.width(), map.height(), map.obstacles().size());
    const site::Annotations& known = file.annotations;
    for (const std::string& note : known.notes) bytes += memory_of(note);
    for (const std::string& name : known.names) bytes += memory_of(name);
    bytes += memory_of(known.background) + known.kinds.capacity() + memory_of(known.sections) + memory_of(known.tags);
    for (const auto* cells : {&known.bridges, &known.ways, &known.unknown}) {
        bytes += cells->capacity() * sizeof(site::CellRun);
    }
    if (file.ros) bytes += memory_of(file.ros->text) + memory_of(file.ros->image);
    return bytes;
}

}  // namespace waybreaker::io
