// Scene: everything the parts of one picture are drawn from.
#pragma once

#include <algorithm>
#include <array>
#include <optional>
#include <string>
#include <vector>

#include "render/layout.hpp"
#include "render/outline.hpp"

namespace waybreaker::render {

struct Scene {
    const Map& map;
    const Mission& mission;
    const Plan& plan;
    const PictureOptions& options;
    Layout layout;
    std::array<std::string, style_count> outlines;

    const std::string& outline(Style style) const { return outlines[std::size_t(style)]; }
    double unit() const { return layout.unit; }
    double raster_scale() const { return layout.cell * layout.sample_step; }
    template <class Place>
    std::vector<Point> on_map(const std::vector<Place>& path) const {
        std::vector<Point> points;
        for (const Place at : path) points.push_back(layout.at(at.x, at.y));
        return points;
    }
    // Whether that place of an agent is drawn as one of those that are reached from a hub, or that reach one.
    bool is_dot(const Agent& agent, Cell Agent::*which) const {
        if (!options.reach || agent.kind == AgentKind::air) return false;
        return which == (options.reach->inbound ? &Agent::start : &Agent::goal);
    }
    // Each start, or goal, once, in the order of the agents.
    std::vector<Point> places(Cell Agent::*which) const {
        std::vector<Cell> cells;
        for (const Agent& agent : mission.agents) {
            if (is_dot(agent, which)) continue;
            if (std::find(cells.begin(), cells.end(), agent.*which) == cells.end()) cells.push_back(agent.*which);
        }
        return on_map(cells);
    }
    // Where aircraft recharge, each once: at places of their own, or else at starts and goals, which have their signs.
    std::vector<Point> bases() const {
        std::vector<Cell> cells;
        for (const Agent& agent : mission.agents) {
            if (!agent.recharge) continue;
            for (const Cell base : agent.bases) {
                if (std::ranges::find(cells, base) == cells.end()) cells.push_back(base);
            }
        }
        return on_map(cells);
    }
    // Of several aircraft the one that breaches, in the mission's order; empty if there is no doubt.
    std::optional<std::size_t> opener(const Breach& breach) const {
        std::size_t count = 0;
        std::optional<std::size_t> found;
        for (const Agent& agent : mission.agents) {
            if (agent.kind != AgentKind::air) continue;
            if (agent.id == breach.by) found = count;
            ++count;
        }
        return count > 1 ? found : std::nullopt;
    }
};

}  // namespace waybreaker::render
