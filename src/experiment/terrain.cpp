#include "experiment/terrain.hpp"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <string>
#include <utility>
#include <vector>

#include "core/random.hpp"
#include "waybreaker/error.hpp"

namespace waybreaker::experiment {
namespace {

constexpr int wall = 2;        // thickness, in cells
constexpr int maze_room = 24;  // from wall to wall
constexpr int large_room = 50;
constexpr int door = 4;
constexpr int spiral_tile = 100;  // a spiral and the street around it
constexpr int spiral_pitch = 10;  // from turn to turn
constexpr int street = 8;
constexpr std::array<int, 2> block_sides{14, 60};

// Labels as they are drawn; every rectangle is cut off at the map's edge.
class Canvas {
  public:
    explicit Canvas(int side) : side_(side), labels_(std::size_t(side) * std::size_t(side), 0) {}

    int side() const { return side_; }
    std::uint32_t new_label() { return ++last_; }
    void fill(int x, int y, int width, int height, std::uint32_t label) {
        for (int row = std::max(y, 0); row < std::min(y + height, side_); ++row) {
            for (int column = std::max(x, 0); column < std::min(x + width, side_); ++column) {
                labels_[std::size_t(row) * std::size_t(side_) + std::size_t(column)] = label;
            }
        }
    }
    Map map() && { return Map::from_labels(side_, side_, std::move(labels_)); }

  private:
    int side_;
    std::vector<std::uint32_t> labels_;
    std::uint32_t last_ = 0;
};

// A grid of rooms, and which neighbours are joined. Joined rooms are a tree that a random walk makes, and some more.
class Rooms {
  public:
    Rooms(int count, double share, Random& random) : count_(count), right_(cells(), false), down_(cells(), false) {
        grow_tree(random);
        for (std::size_t i = 0; i < cells(); ++i) {
            if (random.chance(share)) right_[i] = true;
            if (random.chance(share)) down_[i] = true;
        }
    }

    int count() const { return count_; }
    bool joined_right(int x, int y) const { return right_[index(x, y)]; }
    bool joined_down(int x, int y) const { return down_[index(x, y)]; }

  private:
    std::size_t cells() const { return std::size_t(count_) * std::size_t(count_); }
    std::size_t index(int x, int y) const { return std::size_t(y) * std::size_t(count_) + std::size_t(x); }

    // Goes on from the last room into one never entered, and back where there is none.
    void grow_tree(Random& random) {
        std::vector<bool> entered(cells(), false);
        std::vector<Cell> way{{random.below(count_), random.below(count_)}};
        entered[index(way[0].x, way[0].y)] = true;
        while (!way.empty()) {
            const Cell at = way.back();
            std::vector<Cell> next;
            for (const Cell step : {Cell{1, 0}, Cell{0, 1}, Cell{-1, 0}, Cell{0, -1}}) {
                const Cell to{at.x + step.x, at.y + step.y};
                if (std::min(to.x, to.y) < 0 || std::max(to.x, to.y) >= count_ || entered[index(to.x, to.y)]) continue;
                next.push_back(to);
            }
            if (next.empty()) {
                way.pop_back();
                continue;
            }
            const Cell to = next[std::size_t(random.below(int(next.size())))];
            (to.y == at.y ? right_ : down_)[index(std::min(at.x, to.x), std::min(at.y, to.y))] = true;
            entered[index(to.x, to.y)] = true;
            way.push_back(to);
        }
    }

    int count_;
    std::vector<bool> right_;
    std::vector<bool> down_;
};

// Walls between rooms that are not joined; between joined ones none, or one with a door.
void draw_rooms(Canvas& canvas, const Rooms& rooms, bool doors, Random& random) {
    // Where room number i begins, less the wall before it; the rooms fill the map.
    const auto begin = [&](int i) { return i * canvas.side() / rooms.count() - wall; };
    const auto piece = [&](int x, int y, bool upright, bool joined) {
        if (joined && !doors) return;
        const int from = begin(upright ? y : x);
        const int length = begin((upright ? y : x) + 1) + wall - from;  // from post to post, so that walls meet
        const int across = begin((upright ? x : y) + 1);
        const auto fill = [&](int at, int size, std::uint32_t label) {
            if (upright) {
                canvas.fill(across, at, wall, size, label);
            } else {
                canvas.fill(at, across, size, wall, label);
            }
        };
        fill(from, length, canvas.new_label());
        if (joined) fill(from + wall + random.below(length - 2 * wall - door + 1), door, 0);
    };
    for (int y = 0; y < rooms.count(); ++y) {
        for (int x = 0; x < rooms.count(); ++x) {
            if (x + 1 < rooms.count()) piece(x, y, true, rooms.joined_right(x, y));
            if (y + 1 < rooms.count()) piece(x, y, false, rooms.joined_down(x, y));
        }
    }
}

// A square spiral from the outside in, turned and mirrored at random.
void draw_spiral(Canvas& canvas, int left, int top, int size, Random& random) {
    const int longest = size - wall;
    const std::uint32_t label = canvas.new_label();
    const bool flip_x = random.chance(0.5);
    const bool flip_y = random.chance(0.5);
    const bool transpose = random.chance(0.5);
    const auto place = [&](Cell c) {
        if (flip_x) c.x = longest - c.x;
        if (flip_y) c.y = longest - c.y;
        return transpose ? Cell{c.y, c.x} : c;
    };
    Cell at{0, 0};
    Cell ahead{1, 0};
    for (int i = 0;; ++i) {
        const int length = longest - spiral_pitch * (std::max(i - 1, 0) / 2);
        if (length < spiral_pitch) return;
        const Cell to{at.x + length * ahead.x, at.y + length * ahead.y};
        const Cell a = place(at);
        const Cell b = place(to);
        canvas.fill(left + std::min(a.x, b.x), top + std::min(a.y, b.y), std::abs(a.x - b.x) + wall,
                    std::abs(a.y - b.y) + wall, label);
        at = to;
        ahead = {-ahead.y, ahead.x};
    }
}

void draw_spirals(Canvas& canvas, Random& random) {
    const int tile = std::min(spiral_tile, canvas.side());
    for (int y = 0; y + tile <= canvas.side(); y += tile) {
        for (int x = 0; x + tile <= canvas.side(); x += tile) {
            draw_spiral(canvas, x + street / 2, y + street / 2, tile - street, random);
        }
    }
}

// Where blocks begin and how long they are, along one side of the map.
std::vector<std::pair<int, int>> rows_of_blocks(int side, Random& random) {
    std::vector<std::pair<int, int>> rows;
    for (int at = street / 2; at < side;) {
        const int length = block_sides[0] + random.below(block_sides[1] - block_sides[0]);
        rows.emplace_back(at, std::min(length, side - at));
        at += length + street;
    }
    return rows;
}

void draw_blocks(Canvas& canvas, Random& random) {
    for (const auto& [y, height] : rows_of_blocks(canvas.side(), random)) {
        for (const auto& [x, width] : rows_of_blocks(canvas.side(), random)) {
            canvas.fill(x, y, width, height, canvas.new_label());
        }
    }
}

Map random_cells(int side, double share, Random& random) {
    Grid grid(side, side);
    for (int y = 0; y < side; ++y) {
        for (int x = 0; x < side; ++x) {
            if (random.chance(share)) grid.set_blocked({x, y}, true);
        }
    }
    return Map(std::move(grid));
}

}  // namespace

Map make_terrain(Terrain terrain, const TerrainOptions& options) {
    if (options.side < least_terrain_side || options.side > max_side / 2) {
        throw InputError("the side of a made-up map is from " + std::to_string(least_terrain_side) + " to " +
                         std::to_string(max_side / 2) + " cells");
    }
    if (options.share > 1) throw InputError("a share is from 0 to 1");
    const auto share = [&](double usual) { return options.share < 0 ? usual : options.share; };
    Random random(options.seed);
    Canvas canvas(options.side);
    switch (terrain) {
        case Terrain::maze:
            draw_rooms(canvas, Rooms(std::max(options.side / maze_room, 2), share(0), random), false, random);
            break;
        case Terrain::rooms:
            draw_rooms(canvas, Rooms(std::max(options.side / large_room, 2), share(0.1), random), true, random);
            break;
        case Terrain::spiral:
            draw_spirals(canvas, random);
            break;
        case Terrain::blocks:
            draw_blocks(canvas, random);
            break;
        case Terrain::random:
            return random_cells(options.side, share(0.25), random);
    }
    return std::move(canvas).map();
}

}  // namespace waybreaker::experiment
