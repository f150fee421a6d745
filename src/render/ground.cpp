#include "render/ground.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <string_view>

#include "render/palette.hpp"

namespace waybreaker::render {
namespace {

using Kind = site::Background::Kind;
using Shape = site::Background::Shape;
using Feature = site::Background::Feature;

// Features of one drawing style.
struct Stratum {
    Kind kind;
    Shape shape;
    std::array<std::string_view, 8> types;  // none: all
    std::string_view colour;
    double width;  // of lines, in thousandths of the picture's width

    bool holds(const Feature& feature) const {
        if (feature.kind != kind || feature.shape != shape) return false;
        bool all = true;
        for (const std::string_view type : types) {
            if (type == feature.type) return true;
            all = all && type.empty();
        }
        return all;
    }
};

// From below.
constexpr std::array<Stratum, 8> strata{
    {{Kind::green, Shape::area, {}, colour::green, 0},
     {Kind::water, Shape::area, {}, colour::water, 0},
     {Kind::water, Shape::line, {"stream", "coastline"}, colour::water, 2},
     {Kind::water, Shape::line, {"river", "canal"}, colour::water, 8},
     {Kind::street, Shape::area, {}, colour::road, 0},
     {Kind::street, Shape::line, {}, colour::road, 2.5},
     {Kind::street,
      Shape::line,
      {"motorway", "trunk", "primary", "secondary", "tertiary", "motorway_link", "trunk_link", "primary_link"},
      colour::road,
      6},
     {Kind::rail, Shape::line, {}, colour::rail, 1.2}}};

// Points less than a pixel from the one before are left out, lines and rings of a single point too.
std::string path(const std::vector<waybreaker::Point>& part, const Layout& layout, bool closed) {
    std::string text;
    std::size_t points = 0;
    Point last{};
    for (const waybreaker::Point& point : part) {
        const Point at = layout.at(point.x, point.y);
        if (points > 0 && std::hypot(at.x - last.x, at.y - last.y) < 1) continue;
        text += fmt::format("{}{:.1f} {:.1f}", points == 0 ? "M" : "L", at.x, at.y);
        last = at;
        ++points;
    }
    if (points < (closed ? 3U : 2U)) return "";
    return closed ? text + "z" : text;
}

std::string draw(const Stratum& stratum, const site::Background& background, const Layout& layout) {
    const bool area = stratum.shape == Shape::area;
    std::string paths;
    for (const Feature& feature : background.features) {
        if (!stratum.holds(feature)) continue;
        for (const auto& part : feature.parts) paths += path(part, layout, area);
    }
    if (paths.empty()) return "";
    const std::string style =
        area ? fmt::format(R"(fill="{}" fill-rule="evenodd")", stratum.colour)
             : fmt::format(R"(fill="none" stroke="{}" stroke-width="{:.4g}" stroke-linejoin="round")", stratum.colour,
                           stratum.width * layout.unit);
    return fmt::format("<path d=\"{}\" {}/>\n", paths, style);
}

}  // namespace

std::string ground(const site::Background& background, const Layout& layout) {
    std::string drawn;
    for (const Stratum& stratum : strata) drawn += draw(stratum, background, layout);
    if (drawn.empty()) return "";
    const Rectangle& map = layout.map;
    return fmt::format(
        "<clipPath id=\"map\"><rect x=\"{:.6g}\" y=\"{:.6g}\" width=\"{:.6g}\" height=\"{:.6g}\"/></clipPath>\n"
        "<g clip-path=\"url(#map)\">\n{}</g>\n",
        map.x, map.y, map.width, map.height, drawn);
}

}  // namespace waybreaker::render
