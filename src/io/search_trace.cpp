#include "io/search_trace.hpp"

#include "io/shortest_text.hpp"

namespace waybreaker::io {
namespace {

// How the visualiser draws an event: its cell, in the colour it has for the event's type.
constexpr std::string_view head = R"({"version": "1.4.0",
 "views": {"main": [{"$": "rect", "x": "${{ $.x }}", "y": "${{ $.y }}", "width": 1, "height": 1,
                     "fill": "${{ color[$.type] }}"}]},
 "pivot": {"x": "${{ $.x + 0.5 }}", "y": "${{ $.y + 0.5 }}", "scale": 1},
 "events": [
)";

// Nodes are numbered from 1: the visualiser takes 0 for "no parent".
std::string node_id(Cell cell, int width) {
    return std::to_string(std::int64_t{cell.y} * width + cell.x + 1);
}

}  // namespace

SearchTrace::SearchTrace(const OpenedMap& map, Cell start, Cell goal) : width_(map.width()), goal_(goal) {
    events_ = place("source", start) + "},\n" + place("destination", goal) + "}";
}

void SearchTrace::generated(Cell cell, Cell parent, double g, double f) {
    events_ += ",\n" + event("generating", {cell, parent, g, f});
}

void SearchTrace::updated(Cell cell, Cell parent, double g, double f) {
    events_ += ",\n" + event("updating", {cell, parent, g, f});
}

void SearchTrace::expanded(Cell cell, Cell parent, double g, double f) {
    events_ += last_event();
    expanding_ = Step{cell, parent, g, f};
    events_ += ",\n" + event("expanding", *expanding_);
}

std::string SearchTrace::text() const {
    return std::string(head) + events_ + last_event() + "\n]}\n";
}

// An event without its closing brace.
std::string SearchTrace::place(std::string_view type, Cell cell) const {
    return R"({"type": ")" + std::string(type) + R"(", "id": )" + node_id(cell, width_) + R"(, "x": )" +
           std::to_string(cell.x) + R"(, "y": )" + std::to_string(cell.y);
}

std::string SearchTrace::event(std::string_view type, const Step& step) const {
    const std::string parent = step.parent == step.cell ? "null" : node_id(step.parent, width_);
    return place(type, step.cell) + R"(, "pId": )" + parent + R"(, "g": )" + shortest_text(step.g) + R"(, "f": )" +
           shortest_text(step.f) + "}";
}

// A cell is closed when all its neighbours have been visited; the goal ends the search.
std::string SearchTrace::last_event() const {
    if (!expanding_) return "";
    return ",\n" + event(expanding_->cell == goal_ ? "end" : "closing", *expanding_);
}

}  // namespace waybreaker::io
