#include "orders/passing.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <tuple>

#include "orders/encounter.hpp"
#include "orders/orders.hpp"

namespace waybreaker::orders {
namespace {

// The second waits where it would touch the first, until that has gone on: one order if the plan keeps it. If not, the
// second goes on by steps, each half as long as the plan allows, so that the rest is slack.
void add_steps(const Encounter& encounter, const Stretch& first, const Stretch& second, double reach,
               const Precision& precision, std::vector<Order>& orders) {
    const double longest = std::max(reach, 1.0);
    const double end = encounter.worst();
    for (double place = encounter.places().from;;) {
        const Moment after = second.departure(place);
        const double leaves = second.time(place);
        const double reached = first.reached(leaves);
        double next = std::min(end, place + longest);
        if (encounter.furthest(next) > reached) {
            const double kept = std::max(encounter.met_at(std::max(reached, 0.0)) - place, 0.0);
            next = std::min(next, place + std::max(kept / 2, precision.step));
        }
        double needed = encounter.furthest(next);
        if (precision.kept) needed = std::clamp(needed, 0.0, std::max(reached, 0.0));
        const Moment before = first.arrival(needed);
        orders.push_back({before, after, OrderReason::passing, {}, slack_of(first.time(needed), leaves)});
        if (next >= end) return;
        place = next;
    }
}

struct Box {
    double left, right, top, bottom;
    std::uint32_t track;
    std::uint32_t stretch;
};

Box box_of(const Stretch& stretch, double margin) {
    const safe_interval::Vector end = stretch.start + stretch.length * stretch.direction;
    return {std::min(stretch.start.x, end.x) - margin,
            std::max(stretch.start.x, end.x) + margin,
            std::min(stretch.start.y, end.y) - margin,
            std::max(stretch.start.y, end.y) + margin,
            0,
            0};
}

}  // namespace

std::vector<Pair> near_pairs(const std::vector<Track>& tracks, double separation) {
    std::vector<Box> boxes;
    for (std::uint32_t i = 0; i < tracks.size(); ++i) {
        for (std::uint32_t k = 0; k < tracks[i].stretches.size(); ++k) {
            Box& box = boxes.emplace_back(box_of(tracks[i].stretches[k], tracks[i].radius + separation / 2));
            box.track = i;
            box.stretch = k;
        }
    }
    std::ranges::sort(boxes, {}, [](const Box& box) { return std::tuple(box.left, box.track, box.stretch); });
    std::vector<Pair> pairs;
    std::vector<const Box*> open;  // not left behind by the sweep from left to right
    for (const Box& box : boxes) {
        std::erase_if(open, [&](const Box* other) { return other->right <= box.left; });
        for (const Box* other : open) {
            if (other->track == box.track || other->top >= box.bottom || other->bottom <= box.top) continue;
            const Track& a = tracks[other->track];
            const Track& b = tracks[box.track];
            pairs.push_back({&a.stretches[other->stretch], &b.stretches[box.stretch],
                             a.radius + b.radius + separation - order_clearance / 2});
        }
        open.push_back(&box);
    }
    return pairs;
}

void add_passing_orders(const Pair& pair, const Precision& precision, std::vector<Order>& orders) {
    if (pair.reach <= 0) return;
    const Encounter encounter(*pair.one, *pair.other, pair.reach);
    if (encounter.empty()) return;
    const bool in_order = pair.one->time(encounter.middle_of_first()) < pair.other->time(encounter.middle_of_second());
    if (in_order) {
        add_steps(encounter, *pair.one, *pair.other, pair.reach, precision, orders);
    } else {
        const Encounter mirrored(*pair.other, *pair.one, pair.reach);
        if (mirrored.empty()) return;
        add_steps(mirrored, *pair.other, *pair.one, pair.reach, precision, orders);
    }
}

void leave_out_implied(std::vector<Order>& orders) {
    const auto key = [](const Order& order) {
        return std::tuple(order.before.agent, order.after.agent, order.after.point, order.after.fraction);
    };
    std::ranges::sort(orders, [&](const Order& a, const Order& b) {
        return key(a) != key(b) ? key(a) < key(b) : b.before < a.before;
    });
    std::size_t kept = 0;
    for (const Order& order : orders) {
        const bool same = kept > 0 && orders[kept - 1].before.agent == order.before.agent &&
                          orders[kept - 1].after.agent == order.after.agent;
        if (same && order.before <= orders[kept - 1].before) continue;
        orders[kept++] = order;
    }
    orders.resize(kept);
}

std::vector<bool> stuck_agents(const std::vector<Order>& orders, std::size_t agents) {
    // Of each agent in its order: it has got to the moment of an order's `before`, or leaves that of its `after`.
    struct Event {
        Moment moment;
        bool leaves;
        std::size_t order;
    };
    std::vector<std::vector<Event>> events(agents);
    for (std::size_t i = 0; i < orders.size(); ++i) {
        events[orders[i].before.agent].push_back({orders[i].before, false, i});
        events[orders[i].after.agent].push_back({orders[i].after, true, i});
    }
    for (std::vector<Event>& own : events) {
        std::ranges::sort(own, {}, [](const Event& e) { return std::tuple(e.moment, e.leaves, e.order); });
    }
    std::vector<bool> happened(orders.size());  // the order's `before`
    std::vector<std::size_t> next(agents);
    std::vector<std::size_t> ready;
    for (std::size_t i = 0; i < agents; ++i) ready.push_back(i);
    while (!ready.empty()) {
        const std::size_t agent = ready.back();
        ready.pop_back();
        for (; next[agent] < events[agent].size(); ++next[agent]) {
            const Event& event = events[agent][next[agent]];
            if (event.leaves && !happened[event.order]) break;
            if (event.leaves) continue;
            happened[event.order] = true;
            const std::size_t waiting = orders[event.order].after.agent;
            const bool waits =
                next[waiting] < events[waiting].size() && events[waiting][next[waiting]].order == event.order;
            if (waits) ready.push_back(waiting);
        }
    }
    std::vector<bool> stuck(agents);
    for (std::size_t i = 0; i < agents; ++i) stuck[i] = next[i] < events[i].size();
    return stuck;
}

}  // namespace waybreaker::orders
