#include "render/motion.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

#include "render/palette.hpp"
#include "render/sample.hpp"
#include "render/signs.hpp"

namespace waybreaker::render {
namespace {

constexpr double seconds = 14;        // of one round
constexpr double share_moving = 0.9;  // of a round; then the plan is over, and stays in view
constexpr double fade = 1.5;          // percent of a round in which an obstacle vanishes

double end_of(const Plan& plan) {
    double end = 0;
    for (const Itinerary& agent : plan.agents) {
        if (!agent.path.empty()) end = std::max(end, agent.path.back().t);
    }
    for (const Breach& breach : plan.breaches) end = std::max(end, breach.cleared_at);
    return end;
}

// A rule that plays `keyframes` on the element of that id.
std::string played(std::string_view id, std::string_view keyframes) {
    return fmt::format("@keyframes {0}{{{1}}}\n#{0}{{animation:{0} {2:g}s linear infinite}}\n", id, keyframes, seconds);
}

std::string moving(std::string_view id, std::string_view content) {
    return fmt::format("<g class=\"motion\" id=\"{}\">\n{}</g>\n", id, content);
}

// Both are drawn around the origin and look the same whichever way they go.
std::string vehicle_body(std::string_view colour, double unit) {
    return fmt::format(
        R"(<circle r="{:.4g}" fill="{}" stroke="{}" stroke-width="{:.4g}"/><circle r="{:.4g}" fill="{}"/>)"
        "\n",
        11 * unit, colour, colour::halo, 3 * unit, 4 * unit, colour::halo);
}

std::string aircraft_body(std::string_view colour, double unit) {
    const double arm = 8 * unit;
    std::string out = fmt::format(
        R"(<path d="M-{0:.4g}-{0:.4g}L{0:.4g} {0:.4g}M-{0:.4g} {0:.4g}L{0:.4g}-{0:.4g}" stroke="{1}" stroke-width="{2:.4g}"/>)"
        "\n",
        arm, colour::air_edge, 3.5 * unit);
    for (const Point rotor : {Point{-arm, -arm}, {arm, -arm}, {arm, arm}, {-arm, arm}}) {
        out += fmt::format(R"(<circle cx="{:.4g}" cy="{:.4g}" r="{:.4g}" fill="{}" stroke="{}" stroke-width="{:.4g}"/>)"
                           "\n",
                           rotor.x, rotor.y, 6 * unit, colour, colour::air_edge, 1.6 * unit);
    }
    return out;
}

// Path data of each removed obstacle by itself. A drawn cell that several share belongs to the last.
std::vector<std::string> outlines_of(const Map& map, const std::vector<Breach>& breaches, int step) {
    std::vector<std::uint32_t> index(map.obstacles().size() + 1, 0);
    for (std::size_t i = 0; i < breaches.size(); ++i) index[breaches[i].obstacle.value] = std::uint32_t(i + 1);
    const int width = (map.width() + step - 1) / step;
    const int height = (map.height() + step - 1) / step;
    std::vector<std::uint32_t> labels(std::size_t(width) * std::size_t(height), 0);
    for (const Breach& breach : breaches) {
        const Box box = map.obstacle(breach.obstacle).bounds;
        for (int y = box.min.y; y <= box.max.y; ++y) {
            for (int x = box.min.x; x <= box.max.x; ++x) {
                if (const std::uint32_t label = index[map.obstacle_at({x, y}).value]) {
                    labels[std::size_t(y / step) * std::size_t(width) + std::size_t(x / step)] = label;
                }
            }
        }
    }
    return outlines({width, height, labels}, breaches.size());
}

class Round {
  public:
    Round(const Map& map, const Mission& mission, const Plan& plan, const Layout& layout,
          const site::Annotations& known)
        : map_(map), mission_(mission), plan_(plan), layout_(layout), end_(end_of(plan)) {
        if (end_ <= 0) return;
        drive();
        // Without timing, what a plan removes never stood.
        if (mission.rules.timing == Timing::enforce) stand(known);
        for (std::size_t i = 0; i < plan.breaches.size(); ++i) breach(i, plan.breaches[i]);
        parts_.style = fmt::format(
            "<style>\n.motion{{visibility:hidden}}\n@media (prefers-reduced-motion:no-preference){{\n"
            ".motion{{visibility:visible}}\n{}}}\n</style>\n",
            rules_);
    }

    Motion parts() && { return std::move(parts_); }

  private:
    double percent(double time) const { return 100 * share_moving * std::clamp(time / end_, 0.0, 1.0); }

    // Vehicles above aircraft: both show where they are at one place.
    void drive() {
        std::string driving;
        std::size_t vehicles = 0;
        std::size_t aircraft = 0;
        for (std::size_t i = 0; i < plan_.agents.size(); ++i) {
            const Itinerary& agent = plan_.agents[i];
            const bool flies = agent.kind == AgentKind::air;
            const std::size_t number = flies ? aircraft++ : vehicles++;
            if (agent.path.empty()) continue;
            std::string keyframes;
            const auto at = [&](double share, const Waypoint& point) {
                const Point place = layout_.at(point.x, point.y);
                keyframes += fmt::format("{:.6g}%{{transform:translate({:.6g}px,{:.6g}px)}}", share, place.x, place.y);
            };
            for (const Waypoint& point : agent.path) at(percent(point.t), point);
            at(100, agent.path.back());
            const std::string id = fmt::format("agent{}", i + 1);
            const auto pick = [number](const auto& colours) { return colours[number % colours.size()]; };
            rules_ += played(id, keyframes);
            (flies ? parts_.agents : driving) += moving(id, flies ? aircraft_body(pick(colour::fleet), layout_.unit)
                                                                  : vehicle_body(pick(colour::vehicles), layout_.unit));
        }
        parts_.agents += driving;
    }

    void stand(const site::Annotations& known) {
        const std::vector<Style> styles = standing_styles(map_, known);
        const std::vector<std::string> outlines = outlines_of(map_, plan_.breaches, layout_.sample_step);
        for (std::size_t i = 0; i < outlines.size(); ++i) {
            const Breach& breach = plan_.breaches[i];
            const std::string id = fmt::format("standing{}", i + 1);
            const double gone = percent(breach.cleared_at);
            rules_ += played(id, fmt::format("0%,{:.6g}%{{opacity:1}}{:.6g}%,100%{{opacity:0}}", gone, gone + fade));
            parts_.standing +=
                moving(id, obstacle_sign(styles[breach.obstacle.value], outlines[i], {layout_.map.x, layout_.map.y},
                                         layout_.cell * layout_.sample_step, layout_.unit));
        }
    }

    const Agent& breacher_of(const Breach& breach) const {
        const auto named = std::ranges::find(mission_.agents, breach.by, &Agent::id);
        return named == mission_.agents.end() ? mission_.first(AgentKind::air) : *named;
    }

    // A ring around the aircraft while it breaches.
    void breach(std::size_t i, const Breach& breach) {
        const std::string id = fmt::format("breach{}", i + 1);
        const double stay = time_to_breach(breacher_of(breach), map_.obstacle(breach.obstacle), mission_.rules);
        const double begin = percent(breach.begun_at.value_or(breach.cleared_at - stay));
        const double end = percent(breach.cleared_at);
        rules_ += played(id, fmt::format("0%,{:.6g}%{{opacity:0}}{:.6g}%,{:.6g}%{{opacity:1}}{:.6g}%,100%{{opacity:0}}",
                                         std::max(begin - 0.1, 0.0), begin, end, end + 2 * fade));
        const Point at = layout_.at(breach.at);
        parts_.agents += moving(
            id,
            fmt::format(R"(<circle cx="{:.6g}" cy="{:.6g}" r="{:.4g}" fill="none" stroke="{}" stroke-width="{:.4g}"/>)"
                        "\n",
                        at.x, at.y, 26 * layout_.unit, colour::breach, 5 * layout_.unit));
    }

    const Map& map_;
    const Mission& mission_;
    const Plan& plan_;
    const Layout& layout_;
    double end_;  // of the plan, in units of time
    std::string rules_;
    Motion parts_;
};

}  // namespace

Motion motion(const Map& map, const Mission& mission, const Plan& plan, const Layout& layout,
              const site::Annotations& known) {
    return Round(map, mission, plan, layout, known).parts();
}

}  // namespace waybreaker::render
