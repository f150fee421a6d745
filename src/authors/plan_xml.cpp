#include "authors/plan_xml.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <pugixml.hpp>
#include <vector>

#include "authors/authors_xml_writer.hpp"
#include "io/shortest_text.hpp"
#include "waybreaker/error.hpp"

namespace waybreaker::authors {
namespace {

using Cells = std::vector<Cell>;

void set(pugi::xml_node& node, const char* name, double value) {
    node.append_attribute(name).set_value(io::shortest_text(value).c_str());
}

// The turning points of a path, once each.
Cells turns_of(const Itinerary& agent) {
    Cells cells;
    for (const Waypoint& point : agent.path) {
        const bool near = std::abs(point.x) <= max_side && std::abs(point.y) <= max_side;
        if (!near || point.x != std::round(point.x) || point.y != std::round(point.y)) {
            throw InputError("the authors' XML knows paths from cell to cell only, and agent " + agent.id +
                             " turns at corners of cells; use another format, or another planner");
        }
        const Cell cell{int(point.x), int(point.y)};
        if (cells.empty() || cells.back() != cell) cells.push_back(cell);
    }
    return cells;
}

// The cells along a straight line, without its first (Bresenham).
void append_line(Cells& cells, Cell from, Cell to) {
    const int steps = std::max(std::abs(to.x - from.x), std::abs(to.y - from.y));
    for (int i = 1; i <= steps; ++i) {
        const auto part = [&](int a, int b) { return a + int(std::lround(double(b - a) * i / steps)); };
        cells.push_back({part(from.x, to.x), part(from.y, to.y)});
    }
}

Cells passed(const Cells& turns) {
    Cells cells;
    if (!turns.empty()) cells.push_back(turns.front());
    for (std::size_t i = 1; i < turns.size(); ++i) append_line(cells, turns[i - 1], turns[i]);
    return cells;
}

void append_nodes(pugi::xml_node parent, const Cells& cells) {
    for (std::size_t i = 0; i < cells.size(); ++i) {
        pugi::xml_node node = parent.append_child("node");
        set(node, "x", cells[i].x);
        set(node, "y", cells[i].y);
        set(node, "number", double(i));
    }
}

void append_sections(pugi::xml_node parent, const Cells& turns) {
    for (std::size_t i = 1; i < turns.size(); ++i) {
        pugi::xml_node section = parent.append_child("section");
        set(section, "number", double(i - 1));
        set(section, "start.x", turns[i - 1].x);
        set(section, "start.y", turns[i - 1].y);
        set(section, "finish.x", turns[i].x);
        set(section, "finish.y", turns[i].y);
        set(section, "length", distance(turns[i - 1], turns[i]));
    }
}

// The map without the removed obstacles, with a star on each cell of the ground path.
void append_picture(pugi::xml_node parent, const Plan& plan, const Map& map, const Cells& cells) {
    std::vector<ObstacleId> removed;
    for (const Breach& breach : plan.breaches) removed.push_back(breach.obstacle);
    const OpenedMap opened(map, removed);
    std::vector<std::string> rows;
    for (Cell c; c.y < map.height(); ++c.y) {
        std::string& row = rows.emplace_back();
        for (c.x = 0; c.x < map.width(); ++c.x) row += opened.blocked(c) ? "1 " : "0 ";
    }
    for (const Cell c : cells) rows[std::size_t(c.y)][2 * std::size_t(c.x)] = '*';
    for (std::size_t y = 0; y < rows.size(); ++y) {
        pugi::xml_node row = parent.append_child("row");
        set(row, "number", double(y));
        row.text().set(rows[y].c_str());
    }
}

void append_summary(pugi::xml_node log, const Route& ground, double cell_size) {
    pugi::xml_node summary = log.append_child("summary");
    set(summary, "numberofsteps", double(ground.expanded));
    set(summary, "nodescreated", double(ground.generated));
    set(summary, "length", ground.length.value_or(0));
    set(summary, "length_scaled", ground.length.value_or(0) * cell_size);
    if (ground.seconds > 0) set(summary, "time", ground.seconds);
}

void append_destroyed(pugi::xml_node parent, const Plan& plan) {
    for (std::size_t i = 0; i < plan.breaches.size(); ++i) {
        const Breach& breach = plan.breaches[i];
        pugi::xml_node obstacle = parent.append_child("obstacle");
        set(obstacle, "number", double(i));
        set(obstacle, "id", breach.obstacle.value);
        set(obstacle, "x", breach.at.x);
        set(obstacle, "y", breach.at.y);
        set(obstacle, "time", breach.cleared_at);
    }
}

const Itinerary* agent_of(const Plan& plan, AgentKind kind) {
    const auto found = std::find_if(plan.agents.begin(), plan.agents.end(),
                                    [&](const Itinerary& agent) { return agent.kind == kind; });
    return found != plan.agents.end() ? &*found : nullptr;
}

}  // namespace

std::string plan_xml(const Plan& plan, const io::MapFile& map, const SearchOptions& search) {
    if (plan.after.routes.size() != 2) throw InputError("the authors' XML describes one ground and one air agent");
    const Itinerary* const ground = agent_of(plan, AgentKind::ground);
    const Itinerary* const air = agent_of(plan, AgentKind::air);
    io::MapTask task{.search = search};
    if (ground != nullptr) {
        task.start = ground->start;
        task.goal = ground->goal;
    }
    pugi::xml_document document;
    pugi::xml_node root = document.append_child("root");
    append_task(root, map, task);
    pugi::xml_node log = root.append_child("log");
    log.append_child("mapfilename").text().set(map.source.c_str());
    append_summary(log, plan.after.ground(), map.cell_size);
    pugi::xml_node path = log.append_child("path");
    if (ground == nullptr) {
        path.text().set("Path NOT found!");
        return text_of(document);
    }
    const Cells turns = turns_of(*ground);
    const Cells cells = passed(turns);
    append_picture(path, plan, map.map, cells);
    append_nodes(log.append_child("lplevel"), cells);
    append_sections(log.append_child("hplevel"), turns);
    append_destroyed(log.append_child("destroyed"), plan);
    if (air != nullptr) append_nodes(log.append_child("airlevel"), turns_of(*air));
    return text_of(document);
}

}  // namespace waybreaker::authors
