#include "search/jump_steps.hpp"

#include <bit>

namespace waybreaker {
namespace {

// 64 bits of a line that start at `bit`; what lies behind the line's end does not matter, the frame stops every jump.
std::uint64_t bits_from(const std::uint64_t* line, int bit) {
    const int word = bit / 64;
    const int shift = bit % 64;
    return shift == 0 ? line[word] : line[word] >> shift | line[word + 1] << (64 - shift);
}

std::uint64_t reversed(std::uint64_t bits) {
    bits = (bits >> 1 & 0x5555555555555555U) | (bits & 0x5555555555555555U) << 1;
    bits = (bits >> 2 & 0x3333333333333333U) | (bits & 0x3333333333333333U) << 2;
    bits = (bits >> 4 & 0x0F0F0F0F0F0F0F0FU) | (bits & 0x0F0F0F0F0F0F0F0FU) << 4;
    return __builtin_bswap64(bits);
}

// 64 bits of a line read towards its beginning, from `bit` on: bit k of the result is bit - k of the line.
// Before the line's first bit there is only frame.
std::uint64_t bits_back_from(const std::uint64_t* line, int bit) {
    if (bit >= 63) return reversed(bits_from(line, bit - 63));
    return reversed(line[0] << (63 - bit)) | ~std::uint64_t{0} << bit << 1;
}

// A line to jump along, and its two neighbours, in the direction of the jump.
struct Lanes {
    const std::uint64_t* left;
    const std::uint64_t* middle;
    const std::uint64_t* right;
    bool backwards;

    std::uint64_t read(const std::uint64_t* line, int bit) const {
        return backwards ? bits_back_from(line, bit) : bits_from(line, bit);
    }

    // Steps from bit `from` to the first place where a neighbour is forced, or to `goal_distance` if that comes first
    // (negative: no goal ahead); 0 if a blocked cell comes before.
    int jump(int from, int goal_distance, Corners corners) const {
        for (int done = 0;; done += 62) {  // of 64 bits the first and the last lack a neighbour
            const int bit = backwards ? from - done : from + done;
            const std::uint64_t wall = read(middle, bit) & ~std::uint64_t{1};
            const std::uint64_t l = read(left, bit);
            const std::uint64_t r = read(right, bit);
            std::uint64_t forced = 0;
            if (corners == Corners::none) {  // the side opens here: blocked one step back, free now
                forced = (l << 1 & ~l) | (r << 1 & ~r);
            } else {  // the side opens ahead: blocked now, free one step on
                forced = (l & ~(l >> 1)) | (r & ~(r >> 1));
                if (corners == Corners::cut) forced &= ~(wall >> 1);
            }
            constexpr std::uint64_t seen = ~std::uint64_t{0} >> 1 & ~std::uint64_t{1};  // bits 1 to 62
            const int stop = std::countr_zero((wall | forced) & seen);
            const int goal_at = goal_distance - done;
            if (goal_distance > 0 && goal_at <= 62 && goal_at <= stop && (wall >> goal_at & 1U) == 0)
                return goal_distance;
            if (stop < 63) return (wall >> stop & 1U) != 0 ? 0 : done + stop;
        }
    }
};

}  // namespace

int JumpSteps::straight_jump(Cell from, const Step& step) const {
    if (step.dy == 0) {
        const Lanes lanes{map_.row(from.y - 1), map_.row(from.y), map_.row(from.y + 1), step.dx < 0};
        return lanes.jump(from.x + 1, goal_.y == from.y ? (goal_.x - from.x) * step.dx : -1, corners_);
    }
    const Lanes lanes{map_.column(from.x - 1), map_.column(from.x), map_.column(from.x + 1), step.dy < 0};
    return lanes.jump(from.y + 1, goal_.x == from.x ? (goal_.y - from.y) * step.dy : -1, corners_);
}

int JumpSteps::diagonal_jump(Cell from, const Step& step) const {
    const int ahead = step_index(step.dx, step.dy);
    const Neighbourhood natural = step_bit(step.dx, 0) | step_bit(0, step.dy) | step_bit(step.dx, step.dy);
    Cell cell = from;
    for (int length = 1;; ++length) {
        cell = {cell.x + step.dx, cell.y + step.dy};
        if (cell == goal_) return length;
        const Neighbourhood blocked = blocked_around(map_, cell);
        const Neighbourhood kept = kept_[blocked][std::size_t(ahead)];
        if ((kept & ~natural) != 0) return length;
        if ((kept & step_bit(step.dx, 0)) != 0 && straight_jump(cell, steps[std::size_t(step_index(step.dx, 0))]) > 0)
            return length;
        if ((kept & step_bit(0, step.dy)) != 0 && straight_jump(cell, steps[std::size_t(step_index(0, step.dy))]) > 0)
            return length;
        if ((legal_[blocked] & step_bit(step.dx, step.dy)) == 0) return 0;
    }
}

}  // namespace waybreaker
