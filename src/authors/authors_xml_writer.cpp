#include "authors/authors_xml_writer.hpp"

#include <algorithm>
#include <sstream>

#include "authors/authors_xml_words.hpp"
#include "io/shortest_text.hpp"

namespace waybreaker::authors {
namespace {

template <class Value>
void put(pugi::xml_node& parent, const char* tag, const Value& value) {
    parent.append_child(tag).text().set(value);
}

// The word for a value, and no element where there is none.
template <class Value, std::size_t n>
void put_word(pugi::xml_node& parent, const char* tag, const XmlWords<Value, n>& words, const Value& value) {
    const auto found = std::find_if(words.begin(), words.end(), [&](const auto& word) { return word.second == value; });
    if (found != words.end()) put(parent, tag, found->first.data());
}

void put_cell(pugi::xml_node& map, const char* x_tag, const char* y_tag, const std::optional<Cell>& cell) {
    if (!cell) return;
    put(map, x_tag, cell->x);
    put(map, y_tag, cell->y);
}

void put_grid(pugi::xml_node& map, const Grid& grid) {
    pugi::xml_node rows = map.append_child("grid");
    std::string row(2 * std::size_t(grid.width()) - 1, ' ');
    for (Cell c; c.y < grid.height(); ++c.y) {
        for (c.x = 0; c.x < grid.width(); ++c.x) row[2 * std::size_t(c.x)] = grid.blocked(c) ? '1' : '0';
        put(rows, "row", row.c_str());
    }
}

}  // namespace

void append_task(pugi::xml_node root, const io::MapFile& file, const io::MapTask& task) {
    const Grid& grid = file.map.grid();
    pugi::xml_node map = root.append_child("map");
    if (!file.annotations.title.empty()) put(map, "title", file.annotations.title.c_str());
    put(map, "width", grid.width());
    put(map, "height", grid.height());
    put(map, "cellsize", io::shortest_text(file.cell_size).c_str());
    put_cell(map, "startx", "starty", task.start);
    put_cell(map, "finishx", "finishy", task.goal);
    put_grid(map, grid);

    const SearchOptions& search = task.search;
    pugi::xml_node algorithm = root.append_child("algorithm");
    put_word(algorithm, "searchtype", xml_planners, search.planner);
    put_word(algorithm, "metrictype", xml_heuristics, std::optional(heuristic_of(search)));
    put_word(algorithm, "breakingties", xml_ties, search.tie_break);
    put(algorithm, "hweight", io::shortest_text(search.weight).c_str());
    put(algorithm, "allowdiagonal", int(search.diagonal));
    put(algorithm, "cutcorners", int(search.body.corners != Corners::none));
    put(algorithm, "allowsqueeze", int(search.body.corners == Corners::squeeze));
}

std::string text_of(const pugi::xml_document& document) {
    std::ostringstream text;
    document.save(text, "  ");
    return text.str();
}

std::string authors_xml_text(const io::MapFile& file) {
    pugi::xml_document document;
    append_task(document.append_child("root"), file, file.task.value_or(io::MapTask{}));
    return text_of(document);
}

}  // namespace waybreaker::authors
