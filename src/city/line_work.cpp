#include "city/line_work.hpp"

#include <algorithm>
#include <array>
#include <limits>
#include <map>
#include <optional>
#include <utility>

namespace waybreaker::city {
namespace {

constexpr std::size_t none = std::numeric_limits<std::size_t>::max();

// Which lines are left that end somewhere.
class LooseEnds {
  public:
    explicit LooseEnds(const std::vector<Line>& lines) {
        for (std::size_t i = 0; i < lines.size(); ++i) {
            ends_.emplace(key(lines[i].front()), i);
            ends_.emplace(key(lines[i].back()), i);
        }
    }

    void take(const Line& line, std::size_t number) {
        for (const Point& end : {line.front(), line.back()}) {
            auto [first, last] = ends_.equal_range(key(end));
            const auto mine = std::find_if(first, last, [&](const auto& entry) { return entry.second == number; });
            if (mine != last) ends_.erase(mine);
        }
    }

    // One that does, or none.
    std::size_t at(const Point& point) const {
        const auto found = ends_.find(key(point));
        return found == ends_.end() ? none : found->second;
    }

  private:
    static std::pair<double, double> key(const Point& point) { return {point.x, point.y}; }

    std::multimap<std::pair<double, double>, std::size_t> ends_;
};

// The part of a segment within bounds, as shares of its length (Liang and Barsky, 1984).
std::optional<std::pair<double, double>> inside(const Point& a, const Point& b, const OGREnvelope& bounds) {
    double from = 0;
    double to = 1;
    // How far it goes past each side, and how far it is from it: all of (from, to) has to satisfy go * t <= room.
    const std::array<std::pair<double, double>, 4> sides{{{a.x - b.x, a.x - bounds.MinX},
                                                          {b.x - a.x, bounds.MaxX - a.x},
                                                          {a.y - b.y, a.y - bounds.MinY},
                                                          {b.y - a.y, bounds.MaxY - a.y}}};
    for (const auto& [go, room] : sides) {
        if (go == 0 && room < 0) return std::nullopt;
        if (go > 0) to = std::min(to, room / go);
        if (go < 0) from = std::max(from, room / go);
    }
    return from < to ? std::optional(std::pair(from, to)) : std::nullopt;
}

}  // namespace

double length_of(const Line& line) {
    double sum = 0;
    for (std::size_t i = 1; i < line.size(); ++i) sum += distance(line[i - 1], line[i]);
    return sum;
}

std::vector<Line> joined(std::vector<Line> lines) {
    LooseEnds loose(lines);
    std::vector<bool> taken(lines.size(), false);
    const auto take = [&](std::size_t number) {
        loose.take(lines[number], number);
        taken[number] = true;
        return std::move(lines[number]);
    };
    std::vector<Line> result;
    for (std::size_t i = 0; i < lines.size(); ++i) {
        if (taken[i]) continue;
        Line whole = take(i);
        // On from one end, then from the other.
        for (int end = 0; end < 2; ++end) {
            std::reverse(whole.begin(), whole.end());
            for (std::size_t next = loose.at(whole.back()); next != none; next = loose.at(whole.back())) {
                Line line = take(next);
                if (line.front() != whole.back()) std::reverse(line.begin(), line.end());
                whole.insert(whole.end(), line.begin() + 1, line.end());
            }
        }
        result.push_back(std::move(whole));
    }
    return result;
}

std::vector<Line> clipped(const Line& line, const OGREnvelope& bounds) {
    std::vector<Line> pieces;
    bool open = false;  // the last piece goes on
    for (std::size_t i = 1; i < line.size(); ++i) {
        const Point& a = line[i - 1];
        const Point& b = line[i];
        const auto share = inside(a, b, bounds);
        if (!share) {
            open = false;
            continue;
        }
        const auto at = [&](double t) { return Point{a.x + t * (b.x - a.x), a.y + t * (b.y - a.y)}; };
        if (!open) pieces.push_back({share->first == 0 ? a : at(share->first)});
        pieces.back().push_back(share->second == 1 ? b : at(share->second));
        open = share->second == 1;
    }
    return pieces;
}

}  // namespace waybreaker::city
