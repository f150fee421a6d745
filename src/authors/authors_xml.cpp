#include "authors/authors_xml.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include "authors/agents_xml.hpp"
#include "authors/authors_xml_words.hpp"
#include "authors/xml_values.hpp"

namespace waybreaker::authors {
namespace {

using Element = XmlFile::Element;

double positive_number_of(const Element& element) {
    const std::optional<double> value = number<double>(element.trimmed_text());
    if (!value || !std::isfinite(*value) || *value <= 0)
        throw element.error(described(element) + ", but must be a number over 0");
    return *value;
}

double weight_of(const Element& element) {
    const double value = positive_number_of(element);
    if (value < 1) throw element.error(described(element) + ", but must be at least 1");
    return value;
}

bool is_space(char c) {
    return c == ' ' || c == '\t' || c == '\r' || c == '\n';
}

// The rows of the grid: so many, each with so many cells of 0 or 1.
std::vector<Element> checked_rows(const Element& grid, int width, int height) {
    std::vector<Element> rows;
    grid.for_each_child([&](const Element& row) { rows.push_back(row); });
    if (std::ssize(rows) != height) {
        throw grid.error("<grid> has " + std::to_string(rows.size()) + " rows, but <height> is " +
                         std::to_string(height));
    }
    for (const Element& row : rows) {
        std::ptrdiff_t cells = 0;
        for (const char c : row.text()) {
            if (is_space(c)) continue;
            if (c != '0' && c != '1') throw row.error("a cell of this row is neither 0 (free) nor 1 (blocked)");
            ++cells;
        }
        if (cells != width) {
            throw row.error("this row has " + std::to_string(cells) + " cells, but <width> is " +
                            std::to_string(width));
        }
    }
    return rows;
}

// A side of the map: an element of <map>, or as AA-SIPP(m) has it an attribute of <grid>.
int side_of(const Element& map, const char* name) {
    const auto grid = map.find(name) ? std::nullopt : map.find("grid");
    const auto attribute = grid ? grid->attribute(name) : std::nullopt;
    return attribute ? whole_number_of(*attribute, 1, max_side) : whole_number_of(map.get(name), 1, max_side);
}

Grid read_grid(const Element& map, int width, int height) {
    if (std::size_t(width) * std::size_t(height) > max_cells) {
        throw map.error("a map of " + std::to_string(width) + " x " + std::to_string(height) +
                        " cells is too large: it may have at most " + std::to_string(max_cells));
    }
    const std::vector<Element> rows = checked_rows(map.get("grid"), width, height);
    Grid grid(width, height);
    for (Cell c; c.y < height; ++c.y) {
        c.x = 0;
        for (const char symbol : rows[std::size_t(c.y)].text()) {
            if (is_space(symbol)) continue;
            if (symbol == '1') grid.set_blocked(c, true);
            ++c.x;
        }
    }
    return grid;
}

std::optional<Cell> read_cell(const Element& map, std::string_view x_tag, std::string_view y_tag, const Grid& grid) {
    if (!map.find(x_tag) && !map.find(y_tag)) return std::nullopt;
    return Cell{whole_number_of(map.get(x_tag), 0, grid.width() - 1),
                whole_number_of(map.get(y_tag), 0, grid.height() - 1)};
}

bool flag(const Element& algorithm, std::string_view tag, bool otherwise) {
    const std::optional<Element> element = algorithm.find(tag);
    if (!element) return otherwise;
    const std::string_view text = element->trimmed_text();
    if (text == "1" || text == "true") return true;
    if (text == "0" || text == "false") return false;
    throw element->error(described(*element) + ", but must be 0 or 1");
}

// What a word of the file stands for, of a list of them; the fallback where the word, or the element, is not there.
template <class Value, std::size_t n>
Value choice(const Element& algorithm, std::string_view tag, const XmlWords<Value, n>& words, Value fallback) {
    const std::optional<Element> element = algorithm.find(tag);
    if (!element) return fallback;
    std::string text(element->trimmed_text());
    std::transform(text.begin(), text.end(), text.begin(),
                   [](char c) { return c >= 'A' && c <= 'Z' ? char(c - 'A' + 'a') : c; });
    const auto found = std::find_if(words.begin(), words.end(), [&](const auto& word) { return word.first == text; });
    return found != words.end() ? found->second : fallback;
}

SearchOptions read_algorithm(const Element& algorithm) {
    SearchOptions search;
    search.planner = choice(algorithm, "searchtype", xml_planners, Algorithm::theta);
    search.heuristic = choice(algorithm, "metrictype", xml_heuristics, std::optional<Heuristic>());
    search.tie_break = choice(algorithm, "breakingties", xml_ties, TieBreak::g_max);
    if (const auto weight = algorithm.find("hweight")) search.weight = weight_of(*weight);
    search.diagonal = flag(algorithm, "allowdiagonal", true);
    // As in the authors' program, the wider permission counts only together with the narrower one.
    const bool cut = flag(algorithm, "cutcorners", false) && search.diagonal;
    const bool squeeze = flag(algorithm, "allowsqueeze", false) && cut;
    search.body.corners = squeeze ? Corners::squeeze : cut ? Corners::cut : Corners::none;
    return search;
}

}  // namespace

AuthorsXml parse_authors_xml(std::string_view bytes, const std::string& name) {
    const XmlFile file(bytes, name);
    const std::optional<Element> found = file.root().find("map");
    if (!found) throw no_map(file.root());
    const Element& map = *found;
    const int width = side_of(map, "width");
    const int height = side_of(map, "height");
    AuthorsXml result{.grid = read_grid(map, width, height)};
    if (const auto title = map.find("title")) result.title = title->trimmed_text();
    if (const auto cell_size = map.find("cellsize")) result.cell_size = positive_number_of(*cell_size);
    io::MapTask& task = result.task;
    XmlAgents agents = agents_of(file.root());
    if (agents.agents.empty()) {
        task.start = read_cell(map, "startx", "starty", result.grid);
        task.goal = read_cell(map, "finishx", "finishy", result.grid);
    }
    task.agents = std::move(agents.agents);
    task.agents_turn = agents.turn;
    if (const auto algorithm = file.root().find("algorithm")) {
        task.search = read_algorithm(*algorithm);
        // The authors' program smooths no path of Theta*.
        task.smoothing = flag(*algorithm, "postsmoothing", false) && task.search.planner != Algorithm::theta;
    }
    return result;
}

}  // namespace waybreaker::authors
