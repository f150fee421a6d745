// Where labels with something to say first occur, so that it can be told when the map has numbered its obstacles.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <unordered_map>
#include <utility>
#include <vector>

namespace waybreaker::site {

// A {cell, value} for each label that has a value, of the first cell of that label, row by row.
template <class AtCell, class Value>
std::vector<AtCell> first_cells(std::unordered_map<std::uint32_t, Value> values,
                                std::span<const std::uint32_t> labels) {
    std::vector<AtCell> cells;
    std::uint32_t last = 0;
    for (std::size_t i = 0; i < labels.size() && !values.empty(); ++i) {
        if (labels[i] == last) continue;
        last = labels[i];
        const auto found = values.find(last);
        if (found == values.end()) continue;
        cells.push_back({i, std::move(found->second)});
        values.erase(found);
    }
    return cells;
}

}  // namespace waybreaker::site
