#include "render/chart.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string_view>

#include "render/chart_axis.hpp"
#include "render/palette.hpp"
#include "render/xml_text.hpp"

namespace waybreaker::render {
namespace {

constexpr double width = 860;
constexpr double height = 430;
constexpr double left = 78;
constexpr double right = 640;  // names of the series stand behind it
constexpr double top = 52;
constexpr double bottom = 372;
constexpr double title_height = 36;
constexpr double name_height = 19;
constexpr std::size_t longest_text = 120;

constexpr std::array<std::string_view, chart_colours> colours{"#0072b2", "#d55e00", "#009e73",
                                                              "#cc79a7", "#8c6d00", "#56b4e9"};

std::string text(double x, double y, std::string_view anchor, std::string_view colour, double size,
                 const std::string& words, std::string_view more = "") {
    return fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"{}\" fill=\"{}\" font-size=\"{}\"{}>{}</text>\n",
                       x, y, anchor, colour, size, more, xml_text(words, longest_text));
}

std::string line(double x1, double y1, double x2, double y2, std::string_view colour, double thickness) {
    return fmt::format(
        "<line x1=\"{:.1f}\" y1=\"{:.1f}\" x2=\"{:.1f}\" y2=\"{:.1f}\" stroke=\"{}\" stroke-width=\"{}\"/>\n", x1, y1,
        x2, y2, colour, thickness);
}

// A shape for each colour, so that prints without colours can be read.
std::string marker(double x, double y, const ChartSeries& series) {
    const std::string_view colour = colours[std::size_t(series.colour)];
    const std::string_view fill = series.dashed ? colour::halo : colour;
    constexpr std::array<std::string_view, chart_colours> shapes{"M-5 0a5 5 0 1 0 10 0a5 5 0 1 0 -10 0z",
                                                                 "M-4.5 -4.5h9v9h-9z",
                                                                 "M0 -6l5.5 10h-11z",
                                                                 "M0 -6l6 6l-6 6l-6 -6z",
                                                                 "M0 6l5.5 -10h-11z",
                                                                 "M-6 -2h12v4h-12z"};
    return fmt::format(
        "<path d=\"{}\" transform=\"translate({:.1f} {:.1f})\" fill=\"{}\" stroke=\"{}\" stroke-width=\"1.6\"/>\n",
        shapes[std::size_t(series.colour)], x, y, fill, colour);
}

class Drawing {
  public:
    explicit Drawing(const Chart& chart) : chart_(chart), axis_(chart, bottom, top) {}

    std::string svg() {
        const double first = chart_.headed ? 0 : title_height;
        out_ = fmt::format(
            "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0}\" height=\"{1}\" viewBox=\"0 {4} {0} {1}\" "
            "font-family=\"DejaVu Sans, Helvetica, Arial, sans-serif\" role=\"img\">\n<title>{2}</title>\n"
            "<rect y=\"{4}\" width=\"{0}\" height=\"{1}\" fill=\"{3}\"/>\n",
            width, height - first, xml_text(chart_.title, longest_text), colour::halo, first);
        if (chart_.headed) out_ += text(left, 26, "start", colour::ink, 16, chart_.title, " font-weight=\"bold\"");
        axes();
        for (std::size_t i = 0; i < chart_.series.size(); ++i) draw(i);
        names();
        return out_ + "</svg>\n";
    }

  private:
    double step() const { return (right - left) / double(std::max<std::size_t>(chart_.categories.size(), 1)); }
    // Series stand side by side, so that their intervals do not overlap.
    double x_of(std::size_t category, std::size_t series) const {
        const double spread = std::min(0.5 * step(), 9.0 * double(chart_.series.size() - 1));
        const double offset =
            chart_.series.size() < 2 ? 0 : spread * (double(series) / double(chart_.series.size() - 1) - 0.5);
        return left + (double(category) + 0.5) * step() + offset;
    }
    bool drawn(const std::optional<ChartPoint>& point) const { return point && axis_.shows(point->y); }

    void axes() {
        for (const ChartAxis::Tick& tick : axis_.ticks()) {
            const double y = axis_.at(tick.value);
            out_ += line(left, y, right, y, "#e3ded6", 1);
            out_ += text(left - 8, y + 4.5, "end", colour::faded_ink, 13, tick.label);
        }
        out_ += line(left, bottom, right, bottom, colour::ink, 1.2);
        out_ += line(left, bottom, left, top, colour::ink, 1.2);
        for (std::size_t i = 0; i < chart_.categories.size(); ++i) {
            const double x = left + (double(i) + 0.5) * step();
            out_ += line(x, bottom, x, bottom + 5, colour::ink, 1.2);
            out_ += text(x, bottom + 20, "middle", colour::ink, 13, chart_.categories[i]);
        }
        out_ += text((left + right) / 2, bottom + 44, "middle", colour::ink, 14, chart_.x_label);
        out_ += text(18, (top + bottom) / 2, "middle", colour::ink, 14, chart_.y_label,
                     fmt::format(" transform=\"rotate(-90 18 {:.1f})\"", (top + bottom) / 2));
    }

    void draw(std::size_t index) {
        const ChartSeries& series = chart_.series[index];
        const std::string_view colour = colours[std::size_t(series.colour)];
        std::string path;
        std::string marks;
        for (std::size_t i = 0; i < series.points.size(); ++i) {
            const auto& point = series.points[i];
            if (!drawn(point)) continue;
            const double x = x_of(i, index);
            const double y = axis_.at(point->y);
            path += fmt::format("{}{:.1f} {:.1f}", path.empty() ? "M" : "L", x, y);
            if (point->low < point->high) {
                marks += line(x, axis_.at(axis_.clipped(point->low)), x, axis_.at(point->high), colour, 1.4);
                for (const double end : {point->low, point->high}) {
                    if (axis_.shows(end)) marks += line(x - 4, axis_.at(end), x + 4, axis_.at(end), colour, 1.4);
                }
            }
            marks += marker(x, y, series);
        }
        if (chart_.lines && !path.empty()) {
            out_ += fmt::format("<path d=\"{}\" fill=\"none\" stroke=\"{}\" stroke-width=\"2\"{}/>\n", path, colour,
                                series.dashed ? " stroke-dasharray=\"6 4\"" : "");
        }
        out_ += marks;
    }

    // Behind its last point, as near as the others allow, every series' name with its marker.
    void names() {
        struct Name {
            double y;
            std::size_t series;
        };
        std::vector<Name> names;
        for (std::size_t i = 0; i < chart_.series.size(); ++i) {
            const auto& points = chart_.series[i].points;
            const auto last =
                std::find_if(points.rbegin(), points.rend(), [&](const auto& point) { return drawn(point); });
            if (last == points.rend()) continue;
            if (const auto& point = *last) names.push_back({axis_.at(point->y), i});
        }
        std::ranges::stable_sort(names, {}, &Name::y);
        double free = top;
        for (Name& name : names) {
            name.y = std::max(name.y, free);
            free = name.y + name_height;
        }
        double limit = bottom;
        for (std::size_t i = names.size(); i-- > 0;) {
            names[i].y = std::min(names[i].y, limit);
            limit = names[i].y - name_height;
        }
        for (const Name& name : names) {
            const ChartSeries& series = chart_.series[name.series];
            out_ += marker(right + 16, name.y, series);
            out_ += text(right + 28, name.y + 4.5, "start", colours[std::size_t(series.colour)], 13, series.name);
        }
    }

    const Chart& chart_;
    ChartAxis axis_;
    std::string out_;
};

}  // namespace

std::string chart_svg(const Chart& chart) {
    return Drawing(chart).svg();
}

}  // namespace waybreaker::render
