#include "geotiff/xml_root.hpp"

#include "laws.hpp"

// What is found is a root; comments and declarations before it do not hide it, and only move it.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace waybreaker;
    read_or_refuse(data, size, [](std::string_view bytes) {
        const auto root = geotiff::xml_root(bytes);
        if (root) law(bytes[root->at] == '<' && bytes.substr(root->at + 1).starts_with(root->name));
        constexpr std::string_view before = "<?xml?><!-- <osm> --><!DOCTYPE osm>";
        if (bytes.starts_with("\xEF\xBB\xBF")) return;
        const std::string later = std::string(before) + std::string(bytes);
        const auto moved = geotiff::xml_root(later);
        law(moved.has_value() == root.has_value());
        law(!root || (moved->at == root->at + before.size() && moved->name == root->name));
    });
    return 0;
}
