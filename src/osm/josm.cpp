#include "osm/josm.hpp"

#include <expat.h>
#include <zlib.h>

#include <cstdlib>
#include <memory>
#include <string_view>
#include <type_traits>
#include <vector>

namespace waybreaker::osm {
namespace {

void see_element(void* deleted, const XML_Char* name, const XML_Char** attributes) {
    const std::string_view element = name;
    const osmium::item_type type = element == "node"       ? osmium::item_type::node
                                   : element == "way"      ? osmium::item_type::way
                                   : element == "relation" ? osmium::item_type::relation
                                                           : osmium::item_type::undefined;
    if (type == osmium::item_type::undefined) return;
    std::int64_t id = 0;
    bool marked = false;
    for (; *attributes != nullptr; attributes += 2) {
        const std::string_view attribute = attributes[0];
        if (attribute == "id") id = std::strtoll(attributes[1], nullptr, 10);
        if (attribute == "action") marked = std::string_view(attributes[1]) == "delete";
    }
    if (marked) static_cast<Deleted*>(deleted)->emplace(type, id);
}

}  // namespace

Deleted marked_as_deleted(const std::string& path) {
    Deleted deleted;
    const std::unique_ptr<std::remove_pointer_t<gzFile>, decltype(&gzclose)> file(gzopen(path.c_str(), "rb"), gzclose);
    const std::unique_ptr<std::remove_pointer_t<XML_Parser>, decltype(&XML_ParserFree)> parser(
        XML_ParserCreate(nullptr), XML_ParserFree);
    if (!file || !parser) return deleted;
    XML_SetUserData(parser.get(), &deleted);
    XML_SetStartElementHandler(parser.get(), see_element);
    std::vector<char> piece(std::size_t{1} << 16);
    for (int count = 1; count > 0;) {
        count = gzread(file.get(), piece.data(), unsigned(piece.size()));
        if (count < 0 || XML_Parse(parser.get(), piece.data(), count, count == 0) != XML_STATUS_OK) break;
    }
    return deleted;
}

}  // namespace waybreaker::osm
