// MovingAI maps and scenarios. Both are read whole, then scanned line by line.
#include "waybreaker/movingai.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/number.hpp"
#include "movingai/text_lines.hpp"

namespace waybreaker {
namespace {

// The largest map fits with room to spare; an endless stream is cut off.
constexpr std::size_t max_bytes = std::size_t{1} << 30;

std::string all_bytes(std::istream& in, const std::string& name) {
    constexpr std::size_t chunk = std::size_t{1} << 20;
    std::string bytes;
    std::vector<char> buffer(chunk);
    while (in && bytes.size() <= max_bytes) {
        in.read(buffer.data(), std::streamsize(chunk));
        bytes.append(buffer.data(), std::size_t(in.gcount()));
    }
    if (in) throw InputError(name, 0, "is over 1 GiB, more than any map or scenario file needs");
    if (!in.eof()) throw InputError(name, 0, "cannot be read: check that it is a file and that you may read it");
    return bytes;
}

struct Size {
    int width;
    int height;
};

int header_number(const TextLines& lines, std::string_view key, std::string_view word) {
    const std::optional<int> value = number<int>(word);
    if (!value || *value < 1 || *value > max_side) {
        throw lines.error("the " + std::string(key) + " is " + in_quotes(word) + ", but must be a number from 1 to " +
                          std::to_string(max_side));
    }
    return *value;
}

// The lines down to `map`.
Size read_header(TextLines& lines) {
    const std::string form = "a MovingAI map begins with the lines 'type octile', 'height H', 'width W' and 'map'";
    lines.next();
    if (words(lines.line()) != std::vector<std::string_view>{"type", "octile"}) {
        throw lines.error("not a MovingAI map: " + form);
    }
    std::optional<int> width;
    std::optional<int> height;
    while (lines.next()) {
        const std::vector<std::string_view> parts = words(lines.line());
        if (parts.size() == 1 && parts[0] == "map") {
            if (!width) throw lines.error("no width is given before 'map': " + form);
            if (!height) throw lines.error("no height is given before 'map': " + form);
            return {*width, *height};
        }
        if (parts.size() != 2 || (parts[0] != "width" && parts[0] != "height")) {
            throw lines.error("unexpected header line " + in_quotes(lines.line()) + ": " + form);
        }
        std::optional<int>& side = parts[0] == "width" ? width : height;
        if (side) throw lines.error("the " + std::string(parts[0]) + " is given twice");
        side = header_number(lines, parts[0], parts[1]);
    }
    throw lines.error("the file ends within its header: " + form);
}

// A row without blanks that follow its cells: no map means anything by them.
std::string_view without_blanks_beyond(std::string_view line, std::size_t width) {
    const bool only_blanks = line.size() > width && line.find_first_not_of(" \t", width) == std::string_view::npos;
    return only_blanks ? line.substr(0, width) : line;
}

// The rows as views into the text: so many, all of one length, and nothing after them.
std::vector<std::string_view> read_rows(TextLines& lines, int width, int height) {
    std::vector<std::string_view> rows;
    while (std::ssize(rows) < height) {
        if (!lines.next()) {
            throw lines.error("the map ends after " + std::to_string(rows.size()) + " of " + std::to_string(height) +
                              " rows: is the file cut off, or its height wrong?");
        }
        const std::string_view row = without_blanks_beyond(lines.line(), std::size_t(width));
        if (std::ssize(row) != width) {
            throw lines.error("this row has " + std::to_string(row.size()) + " cells, but the width is " +
                              std::to_string(width) + ": mend the row or the header");
        }
        rows.push_back(row);
    }
    while (lines.next()) {
        if (!words(lines.line()).empty()) {
            throw lines.error("more lines follow the " + std::to_string(height) +
                              " rows of the map: is the height in the header wrong?");
        }
    }
    return rows;
}

constexpr std::array<bool, 256> passable = [] {
    std::array<bool, 256> table{};
    table['.'] = table['G'] = table['S'] = table['E'] = true;
    return table;
}();

Cell cell_of(const TextLines& lines, std::string_view x_word, std::string_view y_word, const Scenario& scenario) {
    const std::optional<int> x = number<int>(x_word);
    const std::optional<int> y = number<int>(y_word);
    if (!x || !y || *x < 0 || *y < 0 || *x >= scenario.width || *y >= scenario.height) {
        throw lines.error("the cell " + in_quotes(x_word) + ", " + in_quotes(y_word) + " does not lie on a map of " +
                          std::to_string(scenario.width) + " x " + std::to_string(scenario.height) + " cells");
    }
    return {*x, *y};
}

constexpr std::size_t scenario_columns = 9;

// What stands between tabs, where that makes a scenario: then the map's name may hold blanks. Else between tabs and
// spaces.
std::vector<std::string_view> columns_of(std::string_view line) {
    std::vector<std::string_view> columns;
    for (std::string_view rest = line; columns.size() <= scenario_columns;) {
        const std::size_t tab = rest.find('\t');
        columns.push_back(trimmed(rest.substr(0, tab)));
        if (tab == std::string_view::npos) break;
        rest.remove_prefix(tab + 1);
    }
    const bool all_said = std::ranges::none_of(columns, &std::string_view::empty);
    return columns.size() == scenario_columns && all_said ? columns : words(line);
}

Scenario read_scenario(const TextLines& lines, const std::vector<std::string_view>& columns) {
    if (columns.size() != scenario_columns) {
        throw lines.error(
            "a scenario has 9 columns (bucket, map, width, height, start x, y, goal x, y, length), this line " +
            std::to_string(columns.size()));
    }
    Scenario scenario;
    const std::optional<int> bucket = number<int>(columns[0]);
    if (!bucket) throw lines.error("the bucket is " + in_quotes(columns[0]) + ", but must be a whole number");
    scenario.bucket = *bucket;
    scenario.map = columns[1];
    scenario.width = header_number(lines, "width", columns[2]);
    scenario.height = header_number(lines, "height", columns[3]);
    scenario.start = cell_of(lines, columns[4], columns[5], scenario);
    scenario.goal = cell_of(lines, columns[6], columns[7], scenario);
    const std::optional<double> length = number<double>(columns[8]);
    if (!length || !std::isfinite(*length) || *length < 0) {
        throw lines.error("the length is " + in_quotes(columns[8]) + ", but must be a number, 0 or more");
    }
    scenario.optimal_length = *length;
    return scenario;
}

}  // namespace

Grid read_movingai_map(std::string_view bytes, const std::string& name) {
    TextLines lines(bytes, name);
    const auto [width, height] = read_header(lines);
    if (std::size_t(width) * std::size_t(height) > max_cells) {
        throw lines.error("a map of " + std::to_string(width) + " x " + std::to_string(height) +
                          " cells is too large: it may have at most " + std::to_string(max_cells));
    }
    const std::vector<std::string_view> rows = read_rows(lines, width, height);
    Grid grid(width, height);
    for (int y = 0; y < height; ++y) {
        const std::string_view row = rows[std::size_t(y)];
        for (int x = 0; x < width; ++x) {
            if (!passable[static_cast<unsigned char>(row[std::size_t(x)])]) grid.set_blocked({x, y}, true);
        }
    }
    return grid;
}

Grid read_movingai_map(std::istream& in, const std::string& name) {
    return read_movingai_map(all_bytes(in, name), name);
}

std::string movingai_map(const Grid& grid) {
    std::string text =
        "type octile\nheight " + std::to_string(grid.height()) + "\nwidth " + std::to_string(grid.width()) + "\nmap\n";
    text.reserve(text.size() + grid.cell_count() + std::size_t(grid.height()));
    for (Cell c; c.y < grid.height(); ++c.y) {
        for (c.x = 0; c.x < grid.width(); ++c.x) text += grid.blocked(c) ? '@' : '.';
        text += '\n';
    }
    return text;
}

std::vector<Scenario> read_movingai_scenarios(std::string_view bytes, const std::string& name) {
    TextLines lines(bytes, name);
    std::vector<Scenario> scenarios;
    bool first = true;
    while (lines.next()) {
        const std::vector<std::string_view> columns = columns_of(lines.line());
        if (columns.empty()) continue;
        const bool is_version = first && columns.size() == 2 && columns[0] == "version";
        first = false;
        if (!is_version) {
            scenarios.push_back(read_scenario(lines, columns));
        } else if (columns[1] != "1" && columns[1] != "1.0") {
            throw lines.error("scenarios of version " + in_quotes(columns[1]) + " cannot be read, only of version 1");
        }
    }
    return scenarios;
}

std::vector<Scenario> read_movingai_scenarios(std::istream& in, const std::string& name) {
    return read_movingai_scenarios(all_bytes(in, name), name);
}

}  // namespace waybreaker
