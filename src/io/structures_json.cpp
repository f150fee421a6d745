#include "io/structures_json.hpp"

#include <span>
#include <utility>

namespace waybreaker::io {
namespace {

using Json = nlohmann::ordered_json;

}  // namespace

Json structures_json(ObstacleId id, const site::Sections& sections) {
    Json list = Json::array();
    for (const std::uint32_t position : site::structures_of(sections, std::span(&id, 1))) {
        const site::Structure& one = sections.structures[position];
        Json structure{{"kind", site::obstacle_kind_words[std::size_t(one.kind)]}};
        if (one.source_id != 0) structure["source_id"] = one.source_id;
        if (!one.name.empty()) structure["name"] = one.name;
        list.push_back(std::move(structure));
    }
    return list;
}

}  // namespace waybreaker::io
