#include "geo/osm_root.hpp"

#include "laws.hpp"

// What is found is a root; comments and declarations before it do not hide it, and only move it.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace waybreaker;
    read_or_refuse(data, size, [](std::string_view bytes) {
        const auto root = geo::osm_root(bytes);
        if (root) law(bytes.substr(*root).starts_with("<osm"));
        constexpr std::string_view before = "<?xml?><!-- <osm> --><!DOCTYPE osm>";
        if (bytes.starts_with("\xEF\xBB\xBF")) return;
        const auto moved = geo::osm_root(std::string(before) + std::string(bytes));
        law(moved.has_value() == root.has_value() && (!root || *moved == *root + before.size()));
    });
    return 0;
}
