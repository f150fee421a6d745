// The authors' XML task files: a grid, a start, a goal and search options in one.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "waybreaker/grid.hpp"
#include "waybreaker/search.hpp"

namespace waybreaker::io {

// What the file says beside its grid.
struct XmlTask {
    std::string title;
    double cell_size = 1;
    std::optional<Cell> start;
    std::optional<Cell> goal;
    SearchOptions search;  // from <algorithm>; what it leaves out has our defaults
};

struct AuthorsXml {
    Grid grid;
    XmlTask task;
};

// `name` is how the input is called in errors. Throws InputError with name and line.
AuthorsXml parse_authors_xml(std::string_view bytes, const std::string& name);

}  // namespace waybreaker::io
