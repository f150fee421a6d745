#include "safe_interval/traffic.hpp"

#include <algorithm>
#include <string>

#include "core/range.hpp"
#include "safe_interval/tuning.hpp"
#include "waybreaker/error.hpp"

namespace waybreaker {
namespace safe_interval {
namespace {

int side_for(int width, int height) {
    int side = tuning::least_square_side;
    while (std::size_t(width / side + 1) * std::size_t(height / side + 1) > tuning::most_squares) side *= 2;
    return side;
}

void validate(std::span<const Waypoint> path, double radius, int width, int height) {
    require_range(radius, 0, 32, "the radius of a disc in traffic, in cells,");
    if (path.empty()) throw InputError("a disc in traffic has a path without points");
    for (std::size_t i = 0; i < path.size(); ++i) {
        require_range(path[i].x, -0.5, width - 0.5, "x of a disc in traffic");
        require_range(path[i].y, -0.5, height - 0.5, "y of a disc in traffic");
        require_range(path[i].t, i > 0 ? path[i - 1].t : 0, 1e15, "the times of a disc in traffic");
    }
}

// Adds the times at which one coordinate passes a border of squares.
void add_border_times(double start, double velocity, const Leg& leg, int side, std::vector<double>& times) {
    if (velocity == 0) return;
    const double end = start + (leg.to - leg.from) * velocity;
    const auto border_after = [side](double c) { return int(std::floor((c + 0.5) / side)) + 1; };
    const int last = border_after(std::max(start, end));
    for (int border = border_after(std::min(start, end)); border < last; ++border) {
        times.push_back(leg.from + (border * double(side) - 0.5 - start) / velocity);
    }
}

}  // namespace

TrafficIndex::TrafficIndex(int width, int height, double separation)
    : width_(width),
      height_(height),
      side_(side_for(width, height)),
      per_cell_(1.0 / side_),
      columns_((width - 1) / side_ + 1),
      rows_((height - 1) / side_ + 1),
      separation_(separation),
      squares_(std::size_t(columns_) * std::size_t(rows_)) {}

std::vector<Leg> TrafficIndex::legs(std::span<const Waypoint> path, bool stays) {
    std::vector<Leg> legs;
    for (std::size_t i = 1; i < path.size(); ++i) {
        const Waypoint& a = path[i - 1];
        const Waypoint& b = path[i];
        const double lasts = b.t - a.t;
        if (lasts <= 0) continue;
        legs.push_back({{a.x, a.y}, {(b.x - a.x) / lasts, (b.y - a.y) / lasts}, a.t, b.t});
    }
    const Waypoint& end = path.back();
    if (stays) legs.push_back({{end.x, end.y}, {}, end.t, for_ever});
    return legs;
}

void TrafficIndex::add(std::uint32_t who, std::span<const Waypoint> path, double radius, bool stays) {
    validate(path, radius, width_, height_);
    if (squares_of_.contains(who)) throw InputError("disc " + std::to_string(who) + " is in traffic already");
    widest_ = std::max(widest_, radius);
    std::vector<std::uint32_t>& squares = squares_of_[who];
    for (const Leg& leg : legs(path, stays)) add_leg(who, leg, radius, squares);
    std::ranges::sort(squares);
    squares.erase(std::unique(squares.begin(), squares.end()), squares.end());
}

void TrafficIndex::add_leg(std::uint32_t who, const Leg& leg, double radius, std::vector<std::uint32_t>& squares) {
    std::vector<double> times{leg.from};
    add_border_times(leg.start.x, leg.velocity.x, leg, side_, times);
    add_border_times(leg.start.y, leg.velocity.y, leg, side_, times);
    times.push_back(leg.to);
    std::ranges::sort(times);
    for (std::size_t i = 1; i < times.size(); ++i) {
        if (times[i] <= times[i - 1]) continue;
        add_piece({{leg.at(times[i - 1]), leg.velocity, times[i - 1], times[i]}, radius, who}, squares);
    }
}

void TrafficIndex::add_piece(const Piece& piece, std::vector<std::uint32_t>& squares) {
    const Vector middle = piece.leg.at(std::isinf(piece.leg.to) ? piece.leg.from : (piece.leg.from + piece.leg.to) / 2);
    const auto number =
        std::uint32_t(square(middle.y, rows_)) * std::uint32_t(columns_) + std::uint32_t(square(middle.x, columns_));
    std::vector<Piece>& here = squares_[number];
    here.insert(std::ranges::upper_bound(here, piece.leg.from, {}, [](const Piece& p) { return p.leg.from; }), piece);
    squares.push_back(number);
}

void TrafficIndex::remove(std::uint32_t who) {
    const auto known = squares_of_.find(who);
    if (known == squares_of_.end()) return;
    for (const std::uint32_t square : known->second) {
        std::erase_if(squares_[square], [who](const Piece& piece) { return piece.who == who; });
    }
    squares_of_.erase(known);
}

std::vector<std::uint32_t> TrafficIndex::met(std::span<const Waypoint> path, double radius, bool stays,
                                             double slack) const {
    std::vector<std::uint32_t> met;
    for (const Leg& leg : legs(path, stays)) {
        near(leg, radius, [&](const Piece& piece) {
            if (!overlap(leg, piece.leg, reach(piece, radius, slack)).empty()) met.push_back(piece.who);
            return true;
        });
    }
    std::sort(met.begin(), met.end());
    met.erase(std::unique(met.begin(), met.end()), met.end());
    return met;
}

const TrafficIndex& index_of(const Traffic& traffic) {
    return *traffic.index_;
}

}  // namespace safe_interval

Traffic::Traffic(int width, int height, double separation) {
    require_range(width, 1, max_side, "the width of the map of a traffic");
    require_range(height, 1, max_side, "the height of the map of a traffic");
    require_range(separation, 0, 32, "the separation of discs in traffic, in cells,");
    index_ = std::make_unique<safe_interval::TrafficIndex>(width, height, separation);
}
Traffic::~Traffic() = default;
Traffic::Traffic(Traffic&&) noexcept = default;
Traffic& Traffic::operator=(Traffic&&) noexcept = default;

void Traffic::add(std::uint32_t who, std::span<const Waypoint> path, double radius, bool stays) {
    index_->add(who, path, radius, stays);
}
void Traffic::remove(std::uint32_t who) {
    index_->remove(who);
}

std::vector<std::uint32_t> Traffic::met(std::span<const Waypoint> path, double radius, bool stays) const {
    return index_->met(path, radius, stays, clearance_slack);
}

}  // namespace waybreaker
