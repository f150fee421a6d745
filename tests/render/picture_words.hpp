// What is written in the picture of a small world.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <pugixml.hpp>
#include <string>
#include <vector>

#include "render/picture.hpp"
#include "worlds.hpp"

namespace waybreaker::render {

inline std::string svg_of(const World& world, const PictureOptions& options = {}) {
    return svg(world.map, world.mission, world.plan, options);
}

inline pugi::xml_document parsed(const std::string& svg) {
    pugi::xml_document document;
    const pugi::xml_parse_result result = document.load_buffer(svg.data(), svg.size());
    EXPECT_TRUE(result) << result.description();
    return document;
}

inline std::vector<std::string> words(const pugi::xml_document& picture) {
    std::vector<std::string> words;
    for (const auto& found : picture.select_nodes("//text")) words.emplace_back(found.node().text().get());
    return words;
}

inline bool says(const pugi::xml_document& picture, const std::string& word) {
    const auto all = words(picture);
    return std::find(all.begin(), all.end(), word) != all.end();
}

}  // namespace waybreaker::render
