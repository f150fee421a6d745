#include "render/signs.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <numbers>

#include "render/palette.hpp"

namespace waybreaker::render {
namespace {

struct LineStyle {
    std::string_view colour;
    double width;
    std::string_view edge_colour;  // of a wider line below it
    double edge_width;
    std::array<double, 2> dash_and_gap;  // {0, 0}: solid
};

LineStyle style_of(PathSign sign) {
    switch (sign) {
        case PathSign::ground:
            return {colour::ground, size::ground_path, colour::halo, 2, {0, 0}};
        case PathSign::air:
            return {colour::air, size::air_path, colour::air_edge, 0.6, {12, 9}};
        case PathSign::ground_before:
            return {colour::ground, size::path_before, colour::halo, 1.2, {7, 6}};
        case PathSign::air_before:
            return {colour::air_edge, size::path_before, colour::halo, 1.2, {0.1, 6}};
    }
    return {};
}

std::string path_data(const std::vector<Point>& points) {
    std::string data;
    for (const Point& p : points) data += fmt::format("{}{:.6g} {:.6g}", data.empty() ? "M" : "L", p.x, p.y);
    return data;
}

std::string line(std::string_view data, std::string_view colour, double width, std::string_view more) {
    return fmt::format(
        R"(<path d="{}" fill="none" stroke="{}" stroke-width="{:.4g}" stroke-linejoin="round" stroke-linecap="round"{}/>)"
        "\n",
        data, colour, width, more);
}

std::string star(Point centre, double radius) {
    std::string data;
    for (int tip = 0; tip < 10; ++tip) {
        const double angle = std::numbers::pi / 5 * tip;
        const double r = tip % 2 == 0 ? radius : 0.46 * radius;
        data += fmt::format("{}{:.6g} {:.6g}", tip == 0 ? "M" : "L", centre.x + r * std::sin(angle),
                            centre.y - r * std::cos(angle));
    }
    return data + "z";
}

std::string disc(Point centre, double radius, std::string_view fill, std::string_view edge, double edge_width) {
    return fmt::format(R"(<circle cx="{:.6g}" cy="{:.6g}" r="{:.4g}" fill="{}" stroke="{}" stroke-width="{:.4g}"/>)"
                       "\n",
                       centre.x, centre.y, radius, fill, edge, edge_width);
}

std::string path_sign(const LineStyle& style, const std::vector<Point>& points, double unit) {
    if (points.empty()) return "";
    const std::string data = path_data(points);
    const auto [dash, gap] = style.dash_and_gap;
    const std::string dashes =
        gap == 0 ? "" : fmt::format(R"( stroke-dasharray="{:.4g} {:.4g}")", dash * unit, gap * unit);
    return line(data, style.edge_colour, (style.width + 2 * style.edge_width) * unit, dashes) +
           line(data, style.colour, style.width * unit, dashes);
}

}  // namespace

std::string path_sign(PathSign sign, const std::vector<Point>& points, double unit) {
    return path_sign(style_of(sign), points, unit);
}

std::string vehicle_sign(std::size_t number, const std::vector<Point>& points, double unit) {
    static constexpr std::array<std::array<double, 2>, 3> patterns{{{0, 0}, {12, 9}, {0.1, 9}}};
    const std::size_t colours = colour::vehicles.size();
    const LineStyle style{colour::vehicles[number % colours], size::team_path, colour::halo, 1.5,
                          patterns[number / colours % patterns.size()]};
    return path_sign(style, points, unit);
}

std::string aircraft_sign(std::size_t number, const std::vector<Point>& points, double unit) {
    LineStyle style = style_of(PathSign::air);
    style.colour = colour::fleet[number % colour::fleet.size()];
    return path_sign(style, points, unit);
}

std::string start_sign(Point at, double unit, bool is_goal) {
    const double radius = (is_goal ? size::start_at_goal : size::start) * unit;
    return disc(at, radius + 2 * unit, colour::halo, colour::halo, unit) +
           disc(at, radius - 2 * unit, colour::halo, colour::ink, 4 * unit);
}

std::string goal_sign(Point at, double unit) {
    return fmt::format(
        R"(<path d="{}" fill="{}" stroke="{}" stroke-width="{:.4g}" stroke-linejoin="round" paint-order="stroke"/>)"
        "\n",
        star(at, size::goal * unit), colour::ink, colour::halo, 5 * unit);
}

std::string base_sign(Point at, double unit) {
    const double half = size::base * unit;
    const auto plate = [&](double edge, std::string_view colour) {
        return fmt::format(R"(rx="{:.4g}" fill="{}" stroke="{}" stroke-width="{:.4g}")", 0.35 * half, colour::halo,
                           colour, edge * unit);
    };
    const Rectangle square{at.x - half, at.y - half, 2 * half, 2 * half};
    // Its case with what is in it, and its pole.
    const Rectangle around{at.x - 0.62 * half, at.y - 0.45 * half, 1.1 * half, 0.9 * half};
    const Rectangle charge{at.x - 0.42 * half, at.y - 0.25 * half, 0.4 * half, 0.5 * half};
    const Rectangle pole{at.x + 0.48 * half, at.y - 0.2 * half, 0.18 * half, 0.4 * half};
    const std::string filled = fmt::format(R"(fill="{}")", colour::air_edge);
    return rectangle(square, plate(6, colour::halo)) + rectangle(square, plate(2.2, colour::air_edge)) +
           rectangle(around,
                     fmt::format(R"(fill="none" stroke="{}" stroke-width="{:.4g}")", colour::air_edge, 1.6 * unit)) +
           rectangle(charge, filled) + rectangle(pole, filled);
}

std::string breach_leader(Point at, Point label, double unit) {
    if (std::hypot(at.x - label.x, at.y - label.y) < unit) return "";
    const std::string data = path_data({at, label});
    return line(data, colour::halo, 4 * unit, "") + line(data, colour::breach, 2 * unit, "") +
           disc(at, 4 * unit, colour::breach, colour::halo, 1.5 * unit);
}

std::string breach_label(Point at, std::string_view number, double unit) {
    const double radius = (number.empty() ? 0.5 : 1) * size::breach_label * unit;
    const double pixels = (number.size() < 2 ? 16 : 13) * unit;
    std::string sign = disc(at, radius, colour::breach, colour::halo, 2 * unit);
    if (number.empty()) return sign;
    return sign + text({at.x, at.y + 0.36 * pixels}, number, pixels, colour::halo, Anchor::middle, true);
}

std::string opener_sign(Point at, std::size_t aircraft, double unit) {
    const double radius = (size::breach_label + 3.5) * unit;
    return disc(at, radius, colour::fleet[aircraft % colour::fleet.size()], colour::air_edge, 1.2 * unit);
}

std::string wait_sign(Point at, double unit) {
    const auto bar = [&](double x) {
        return fmt::format(R"(<rect x="{:.6g}" y="{:.6g}" width="{:.4g}" height="{:.4g}" fill="{}"/>)"
                           "\n",
                           at.x + x * unit, at.y - 5 * unit, 3 * unit, 10 * unit, colour::halo);
    };
    return disc(at, size::breach_label * unit, colour::ground, colour::halo, 2 * unit) + bar(-4.5) + bar(1.5);
}

std::string words(Point begin, std::string_view content, double unit) {
    return fmt::format(
        R"(<text x="{:.6g}" y="{:.6g}" font-size="{:.4g}" fill="{}" stroke="{}" stroke-width="{:.4g}" paint-order="stroke">{}</text>)"
        "\n",
        begin.x, begin.y, size::small_text * unit, colour::ink, colour::halo, 4 * unit, content);
}

std::string obstacle_sign(Style style, std::string_view data, Point origin, double scale, double unit) {
    if (data.empty()) return "";
    struct Paint {
        std::string_view fill, edge;
        double edge_width;
    };
    constexpr Paint paints[style_count] = {{colour::obstacle, colour::obstacle_edge, size::edge},
                                           {colour::barrier, colour::barrier_edge, size::edge},
                                           {colour::fixed_obstacle, colour::fixed_obstacle_edge, size::edge},
                                           {"url(#waves)", colour::shore, size::edge},
                                           {colour::cliff, colour::cliff_edge, size::edge},
                                           {"url(#stripes)", colour::forbidden_edge, size::edge},
                                           {"url(#dots)", colour::off_road_edge, size::edge},
                                           {"url(#lattice)", colour::unknown_edge, size::edge},
                                           {"url(#hatching)", colour::removed, size::removed_edge}};
    const Paint& paint = paints[std::size_t(style)];
    // Obstacles hardly a pixel wide would show only their edges, which take most of the drawing time.
    const bool edged = style == Style::removed || scale >= 1;
    return fmt::format(
        R"svg(<path transform="translate({:.6g} {:.6g}) scale({:.6g})" fill="{}" fill-rule="evenodd" stroke="{}" stroke-width="{:.4g}" d="{}"/>)svg"
        "\n",
        origin.x, origin.y, scale, paint.fill, edged ? paint.edge : "none", paint.edge_width * unit / scale, data);
}

std::string patterns(double unit, double scale) {
    const auto pattern = [&](std::string_view id, double size, int turn, std::string_view content) {
        return fmt::format(
            R"svg(<pattern id="{0}" width="{1:.4g}" height="{1:.4g}" patternUnits="userSpaceOnUse" patternTransform="rotate({2})">{3}</pattern>)svg"
            "\n",
            id, size, turn, content);
    };
    const auto striped = [](double step, double share, std::string_view fill, std::string_view stripe) {
        return fmt::format(
            R"(<rect width="{0:.4g}" height="{0:.4g}" fill="{1}"/><rect width="{2:.4g}" height="{0:.4g}" fill="{3}"/>)",
            step, fill, share * step, stripe);
    };
    const double hatch = 7 * unit / scale;
    const double stripe = 6 * unit / scale;
    const double wave = 16 * unit / scale;
    // Dashes, every second row shifted.
    const std::string waves = fmt::format(
        R"(<rect width="{0:.4g}" height="{0:.4g}" fill="{1}"/><path d="M0 {2:.4g}h{3:.4g}M{3:.4g} {4:.4g}h{3:.4g}" stroke="{5}" stroke-width="{6:.4g}"/>)",
        wave, colour::deep_water, 0.25 * wave, 0.5 * wave, 0.75 * wave, colour::shore, unit / scale);
    const double grid = 14 * unit / scale;
    const std::string dots = fmt::format(
        R"(<rect width="{0:.4g}" height="{0:.4g}" fill="{1}"/><path d="M{2:.4g} {2:.4g}h0M{3:.4g} {3:.4g}h0" stroke="{4}" stroke-width="{5:.4g}" stroke-linecap="round"/>)",
        grid, colour::off_road, 0.25 * grid, 0.75 * grid, colour::off_road_edge, 2 * unit / scale);
    const double mesh = 12 * unit / scale;
    const std::string lattice = fmt::format(
        R"(<rect width="{0:.4g}" height="{0:.4g}" fill="{1}"/><path d="M0 0h{0:.4g}M0 0v{0:.4g}" stroke="{2}" stroke-width="{3:.4g}"/>)",
        mesh, colour::unknown, colour::unknown_edge, 1.2 * unit / scale);
    return pattern("hatching", hatch, 45, striped(hatch, 0.3, colour::removed_tint, colour::removed)) +
           pattern("waves", wave, 0, waves) + pattern("dots", grid, 0, dots) + pattern("lattice", mesh, 45, lattice) +
           pattern("stripes", stripe, -45, striped(stripe, 0.22, colour::forbidden, colour::forbidden_edge));
}

std::string text(Point at, std::string_view content, double pixels, std::string_view colour, Anchor anchor, bool bold) {
    constexpr std::string_view anchors[] = {"", R"( text-anchor="middle")", R"( text-anchor="end")"};
    return fmt::format(R"(<text x="{:.6g}" y="{:.6g}" font-size="{:.4g}" fill="{}"{}{}>{}</text>)"
                       "\n",
                       at.x, at.y, pixels, colour, anchors[std::size_t(anchor)], bold ? R"( font-weight="bold")" : "",
                       content);
}

std::string rectangle(Rectangle r, std::string_view more) {
    return fmt::format(R"(<rect x="{:.6g}" y="{:.6g}" width="{:.6g}" height="{:.6g}" {}/>)"
                       "\n",
                       r.x, r.y, r.width, r.height, more);
}

}  // namespace waybreaker::render
