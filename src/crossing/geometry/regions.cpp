#include "crossing/geometry/regions.hpp"

#include <cmath>
#include <map>
#include <memory>
#include <utility>

#include "crossing/geometry/lattice.hpp"
#include "crossing/tuning.hpp"
#include "map/bit_run.hpp"
#include "map/line_of_sight.hpp"

namespace waybreaker::crossing {
namespace {

constexpr std::int64_t unit = 1000;  // a radius is exact to thousandths of a cell

// The cells around a blocked one where the body cannot be, as half widths of rows. Of the square: where the disc around
// a cell's centre meets the blocked cell. Relaxed: cells that lie in the disc's way as a whole.
std::vector<int> growth_of(const CrossingOptions& options) {
    const std::int64_t radius = options.body.thousandths();
    const auto relaxed_row = [radius](std::int64_t y) {
        int x = -1;
        while ((std::int64_t(x + 1) * (x + 1) + y * y) * unit * unit <= radius * radius) ++x;
        return x;
    };
    std::vector<int> half_widths;
    for (int y = 0;; ++y) {
        const int half_width = reach_of(options) == 1 ? relaxed_row(y) : disc_row(radius, y);
        if (half_width < 0) break;
        half_widths.push_back(half_width);
    }
    if (half_widths.size() == 1 && half_widths.front() == 0) half_widths.clear();  // the cell itself
    return half_widths;
}

// Blocked cells side by side that belong to one obstacle.
struct Run {
    int first;
    int last;
    ObstacleId obstacle;
};

std::vector<std::vector<Run>> runs_of(const Map& map) {
    std::vector<std::vector<Run>> rows(std::size_t(map.height()));
    for (int y = 0; y < map.height(); ++y) {
        std::vector<Run>& row = rows[std::size_t(y)];
        for (int x = 0; x < map.width(); ++x) {
            const ObstacleId obstacle = map.obstacle_at({x, y});
            if (!obstacle) continue;
            if (!row.empty() && row.back().last == x - 1 && row.back().obstacle == obstacle) {
                row.back().last = x;
            } else {
                row.push_back({x, x, obstacle});
            }
        }
    }
    return rows;
}

// Where an obstacle's growth begins or ends in a row.
struct Event {
    int x;
    bool begins;
    ObstacleId obstacle;
};

// Grows a map row by row: the growths that reach into a row begin and end one after the other.
class Growing {
  public:
    Growing(const Map& map, const std::vector<int>& half_widths)
        : map_(map),
          half_widths_(half_widths),
          rows_(runs_of(map)),
          edge_{std::uint32_t(map.obstacles().size() + 1)},
          labels_(map.grid().cell_count(), 0) {}

    // False if it is interrupted, or the regions have too many members.
    bool grow(Interrupt& interrupt) {
        for (int y = 0; y < map_.height(); ++y) {
            find_events(y);
            around_.clear();
            for (std::size_t i = 0; i < events_.size(); ++i) {
                if (interrupt.due() || member_count_ > tuning::most_region_members) return false;
                count(events_[i]);
                if (i + 1 < events_.size() && events_[i + 1].x > events_[i].x && !around_.empty()) {
                    const auto row = labels_.begin() + std::ptrdiff_t(y) * map_.width();
                    std::fill(row + events_[i].x, row + events_[i + 1].x, region_here());
                }
            }
        }
        return true;
    }

    // Members of each region, in the order of their numbers.
    const std::vector<std::vector<ObstacleId>>& members() const { return members_; }
    std::vector<std::uint32_t> take_labels() { return std::move(labels_); }

  private:
    void find_events(int y) {
        events_.clear();
        const int last_column = map_.width() - 1;
        const auto add = [&](int first, int last, ObstacleId obstacle) {
            events_.push_back({std::max(first, 0), true, obstacle});
            events_.push_back({std::min(last, last_column) + 1, false, obstacle});
        };
        const int reach = int(half_widths_.size()) - 1;
        for (int row = std::max(y - reach, 0); row <= std::min(y + reach, map_.height() - 1); ++row) {
            const int beside = half_widths_[std::size_t(std::abs(row - y))];
            for (const Run& run : rows_[std::size_t(row)]) add(run.first - beside, run.last + beside, run.obstacle);
        }
        if (std::min(y, map_.height() - 1 - y) < reach) add(0, last_column, edge_);
        add(0, half_widths_.front() - 1, edge_);
        add(map_.width() - half_widths_.front(), last_column, edge_);
        std::ranges::sort(events_, {}, &Event::x);  // in which order those at one place are counted does not matter
    }

    void count(const Event& event) {
        const auto at = std::ranges::lower_bound(around_, event.obstacle, {}, &Around::obstacle);
        const int step = event.begins ? 1 : -1;
        if (at == around_.end() || at->obstacle != event.obstacle) {
            around_.insert(at, {event.obstacle, step});
        } else if (at->times + step == 0) {
            around_.erase(at);
        } else {
            at->times += step;
        }
    }

    std::uint32_t region_here() {
        std::vector<ObstacleId> obstacles;
        for (const Around& one : around_) obstacles.push_back(one.obstacle);
        const auto [known, added] = numbers_.try_emplace(obstacles, std::uint32_t(numbers_.size() + 1));
        if (added) {
            member_count_ += obstacles.size();
            members_.push_back(std::move(obstacles));
        }
        return known->second;
    }

    // An obstacle whose growth has begun, and how often.
    struct Around {
        ObstacleId obstacle;
        int times;
    };

    const Map& map_;
    const std::vector<int>& half_widths_;
    std::vector<std::vector<Run>> rows_;
    ObstacleId edge_;  // of the map
    std::vector<std::uint32_t> labels_;
    std::vector<Event> events_;
    std::vector<Around> around_;  // sorted
    std::map<std::vector<ObstacleId>, std::uint32_t> numbers_;
    std::vector<std::vector<ObstacleId>> members_;
    std::size_t member_count_ = 0;
};

}  // namespace

Regions::Regions(const Map& map, const CrossingOptions& options, Interrupt& interrupt) : map_(&map) {
    const auto shape = std::make_shared<Shape>();
    shape_ = shape;
    shape->identity = map.identity();
    shape->body = options.body;
    shape->relaxed = options.relaxed;
    shape->half_widths = growth_of(options);
    if (shape->half_widths.empty()) return;
    Growing growing(map, shape->half_widths);
    shape->complete = growing.grow(interrupt);
    if (!shape->complete) return;
    std::vector<std::vector<RegionId>> regions_of(obstacle_limit());
    RegionId region;
    for (const std::vector<ObstacleId>& members : growing.members()) {
        shape->members.add(members);
        ++region.value;
        for (const ObstacleId obstacle : members) regions_of[obstacle.value].push_back(region);
    }
    for (std::size_t obstacle = 1; obstacle < regions_of.size(); ++obstacle) shape->regions.add(regions_of[obstacle]);
    // It numbers what it finds row by row, as growing does.
    shape->grown = std::make_unique<const Map>(Map::from_labels(map.width(), map.height(), growing.take_labels()));
}

const Permanent& Regions::permanent() const {
    shape_->permanent_made.call([this] { shape_->permanent = std::make_unique<const Permanent>(find_permanent()); });
    return *shape_->permanent;
}

Permanent Regions::find_permanent() const {
    std::vector<bool> stays(count() + 1);
    for (std::uint32_t region = 1; region <= count(); ++region) {
        for_each_member(RegionId{region}, [&](ObstacleId o) { stays[region] = stays[region] || !destructible(o); });
    }
    Grid rows(map().width(), map().height());
    for (int y = 0; y < rows.height(); ++y) {
        for_each_run(map().grid().row(y), rows.width(), [&](int first, int last) {
            for (int x = first; x <= last; ++x) {
                if (stays[region_at(map(), {x, y}).value]) rows.set_blocked({x, y}, true);
            }
        });
    }
    Grid columns = rows.transposed();
    return {std::move(rows), std::move(columns)};
}

}  // namespace waybreaker::crossing
