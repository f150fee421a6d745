#include "io/surface_judge.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace waybreaker::io {
namespace {

// A part of a straight piece of a path, from one share of it to another.
using Part = std::pair<double, double>;

// The shares for which a coordinate that runs from `from` to `to` is at most half a cell from `centre`, within `part`;
// none if the first is above the second.
Part clipped(Part part, double from, double to, int centre) {
    if (from == to) return std::abs(from - centre) <= 0.5 ? part : Part{1, 0};
    const double a = (centre - 0.5 - from) / (to - from);
    const double b = (centre + 0.5 - from) / (to - from);
    return {std::max(part.first, std::min(a, b)), std::min(part.second, std::max(a, b))};
}

// How much they cover together.
double united(std::vector<Part>& parts) {
    std::ranges::sort(parts);
    double sum = 0;
    double end = 0;
    for (const auto& [first, last] : parts) {
        sum += std::max(last - std::max(first, end), 0.0);
        end = std::max(end, last);
    }
    return sum;
}

// What is known of each cell, row by row.
struct Ground {
    std::vector<bool> ways;
    std::vector<bool> unknown;
    std::vector<bool> near_water;
};

class SurfaceJudge {
  public:
    SurfaceJudge(const PlanFile& file, const MapFile& map, double tolerance)
        : file_(file), map_(map.map), tolerance_(tolerance) {
        const std::size_t cells = map_.labels().size();
        ground_ = {std::vector<bool>(cells), std::vector<bool>(cells), std::vector<bool>(cells)};
        mark(map.annotations.ways, ground_.ways);
        mark(map.annotations.unknown, ground_.unknown);
        mark_unknown(map.annotations.tags);
        mark_near_water(map.annotations.kinds);
    }

    std::vector<Violation> judge() {
        for (std::size_t i = 0; i < file_.surfaces.size(); ++i) judge_agent(file_.plan.agents[i], file_.surfaces[i]);
        return std::move(found_);
    }

  private:
    std::size_t at(int x, int y) const { return std::size_t(y) * std::size_t(map_.width()) + std::size_t(x); }

    void mark(const std::vector<site::CellRun>& runs, std::vector<bool>& cells) const {
        for (const auto& [first, length] : runs) {
            for (int x = first.x; x < first.x + length; ++x) cells[at(x, first.y)] = true;
        }
    }

    void mark_unknown(const site::ObstacleTags& tags) {
        const auto tagged = tags.find("occupancy=unknown");
        if (tagged == tags.end()) return;
        std::vector<bool> unknown(map_.obstacles().size() + 1);
        for (const ObstacleId id : tagged->second) unknown.at(id.value) = true;
        for (std::size_t i = 0; i < ground_.unknown.size(); ++i) {
            if (unknown[map_.labels()[i]]) ground_.unknown[i] = true;
        }
    }

    // Water, and around it as far as the centres of other cells are at most 5 m away. Of finer cells plans do not say.
    void mark_near_water(const site::ObstacleKinds& kinds) {
        constexpr double finest = 0.05;
        if (file_.cell_size < finest) return;
        constexpr double metres = 5 + 1e-6;
        const int reach = int(std::ceil(metres / file_.cell_size));
        for (int y = 0; y < map_.height(); ++y) {
            for (int x = 0; x < map_.width(); ++x) {
                if (!is_water(x, y, kinds)) continue;
                ground_.near_water[at(x, y)] = true;
                if (is_shore(x, y, kinds)) mark_around(x, y, reach, metres);
            }
        }
    }

    bool is_water(int x, int y, const site::ObstacleKinds& kinds) const {
        const std::uint32_t id = map_.labels()[at(x, y)];
        return id != 0 && id < kinds.size() && kinds[id] == site::ObstacleKind::water;
    }

    // Whether anything else lies beside it: to other water nothing is nearer.
    bool is_shore(int x, int y, const site::ObstacleKinds& kinds) const {
        constexpr std::array<Cell, 4> sides{Cell{1, 0}, Cell{-1, 0}, Cell{0, 1}, Cell{0, -1}};
        return std::ranges::any_of(sides, [&](Cell side) {
            const Cell beside{x + side.x, y + side.y};
            const bool inside = beside.x >= 0 && beside.y >= 0 && beside.x < map_.width() && beside.y < map_.height();
            return !inside || !is_water(beside.x, beside.y, kinds);
        });
    }

    void mark_around(int x, int y, int reach, double metres) {
        const double limit = metres / file_.cell_size;
        for (int v = std::max(y - reach, 0); v <= std::min(y + reach, map_.height() - 1); ++v) {
            for (int u = std::max(x - reach, 0); u <= std::min(x + reach, map_.width() - 1); ++u) {
                const double across = u == x ? 0 : std::abs(u - x) - 0.5;
                const double down = v == y ? 0 : std::abs(v - y) - 0.5;
                if (across * across + down * down <= limit * limit) ground_.near_water[at(u, v)] = true;
            }
        }
    }

    // The lengths on unknown ground, on that or on ways, and near water.
    std::array<double, 3> lengths(const Itinerary& agent) const {
        std::array<double, 3> sums{};
        for (std::size_t i = 1; i < agent.path.size(); ++i) add_piece(agent.path[i - 1], agent.path[i], sums);
        return sums;
    }

    void add_piece(const Waypoint& a, const Waypoint& b, std::array<double, 3>& sums) const {
        const double length = std::hypot(b.x - a.x, b.y - a.y);
        if (!(length > 0)) return;
        std::array<std::vector<Part>, 3> parts;
        const auto [left, right] = cells_between(a.x, b.x, map_.width());
        for (int x = left; x <= right; ++x) {
            // Where the piece is within the column, from one height to another.
            const Part within = clipped({0, 1}, a.x, b.x, x);
            if (within.first > within.second) continue;
            const double from = a.y + within.first * (b.y - a.y);
            const double to = a.y + within.second * (b.y - a.y);
            const auto [top, bottom] = cells_between(from, to, map_.height());
            for (int y = top; y <= bottom; ++y) {
                const Part part = clipped(within, a.y, b.y, y);
                if (part.first > part.second) continue;
                const std::size_t cell = at(x, y);
                if (ground_.unknown[cell]) parts[0].push_back(part);
                if (ground_.unknown[cell] || ground_.ways[cell]) parts[1].push_back(part);
                if (ground_.near_water[cell]) parts[2].push_back(part);
            }
        }
        for (std::size_t i = 0; i < parts.size(); ++i) sums[i] += united(parts[i]) * length;
    }

    // The first and the last of so many in a row that a piece from one coordinate to another may touch.
    static std::pair<int, int> cells_between(double from, double to, int count) {
        return {int(std::clamp(std::floor(std::min(from, to)), 0.0, double(count))),
                int(std::clamp(std::ceil(std::max(from, to)), -1.0, count - 1.0))};
    }

    void judge_agent(const Itinerary& agent, const PlanFile::Surface& stated) {
        double length = 0;
        for (std::size_t i = 1; i < agent.path.size(); ++i) {
            length += std::hypot(agent.path[i].x - agent.path[i - 1].x, agent.path[i].y - agent.path[i - 1].y);
        }
        const auto [unknown, known_or_not, near_water] = lengths(agent);
        expect(agent, "on ways", stated.ways, known_or_not - unknown, length);
        expect(agent, "off ways", stated.off_ways, length - known_or_not, length);
        expect(agent, "on unknown ground", stated.unknown, unknown, length);
        expect(agent, "near water", stated.near_water, near_water, length);
    }

    void expect(const Itinerary& agent, const char* where, const std::optional<double>& stated, double truth,
                double length) {
        if (!stated || std::abs(*stated - truth) <= tolerance_ * std::max(1.0, length)) return;
        found_.push_back({Rule::surface,
                          fmt::format("the {} agent drives {:.9g} cells {}, not {:.9g} as the plan says", agent.id,
                                      truth, where, *stated),
                          agent.id});
    }

    const PlanFile& file_;
    const Map& map_;
    double tolerance_;
    Ground ground_;
    std::vector<Violation> found_;
};

}  // namespace

std::vector<Violation> judge_surfaces(const PlanFile& plan, const MapFile& map, const JudgeOptions& options) {
    const auto says = [](const PlanFile::Surface& one) {
        return one.ways || one.off_ways || one.unknown || one.near_water;
    };
    if (std::ranges::none_of(plan.surfaces, says)) return {};
    if (map.annotations.ways.empty()) {
        if (options.ignore_digest) return {};
        return {{Rule::surface, "the plan says what is driven on ways, but the map knows none"}};
    }
    return SurfaceJudge(plan, map, options.tolerance).judge();
}

}  // namespace waybreaker::io
