#include "render/histogram.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

#include "render/chart_axis.hpp"
#include "render/palette.hpp"
#include "render/xml_text.hpp"

namespace waybreaker::render {
namespace {

constexpr double width = 860;
constexpr double height = 430;
constexpr double left = 78;
constexpr double right = 836;
constexpr double top = 76;
constexpr double bottom = 372;
constexpr std::size_t longest_text = 120;
constexpr int bins = 40;

constexpr std::array<std::string_view, histogram_series> colours{"#0072b2", "#d55e00"};
constexpr std::array<std::string_view, histogram_series> fills{"#0072b2", "url(#second)"};

std::string text(double x, double y, std::string_view anchor, std::string_view colour, double size,
                 const std::string& words, std::string_view more = "") {
    return fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"{}\" fill=\"{}\" font-size=\"{}\"{}>{}</text>\n",
                       x, y, anchor, colour, size, more, xml_text(words, longest_text));
}

std::string line(double x1, double y1, double x2, double y2, std::string_view colour, double thickness,
                 std::string_view more = "") {
    return fmt::format(
        "<line x1=\"{:.1f}\" y1=\"{:.1f}\" x2=\"{:.1f}\" y2=\"{:.1f}\" stroke=\"{}\" stroke-width=\"{}\"{}/>\n", x1, y1,
        x2, y2, colour, thickness, more);
}

// An axis over values, from `first` to `last` in the picture.
ChartAxis axis_over(const std::vector<double>& values, bool from_zero, double first, double last) {
    Chart chart;
    chart.from_zero = from_zero;
    ChartSeries& series = chart.series.emplace_back();
    for (const double value : values) series.points.push_back(ChartPoint{value, value, value});
    return {chart, first, last};
}

class Bins {
  public:
    explicit Bins(const Histogram& histogram) {
        std::vector<double> all;
        for (const HistogramSeries& series : histogram.series) {
            all.insert(all.end(), series.values.begin(), series.values.end());
            if (series.mark) all.push_back(*series.mark);
        }
        if (all.empty()) return;
        const auto [least, most] = std::ranges::minmax(all);
        least_ = least;
        step_ = most > least ? (most - least) / bins : 1;
        for (const HistogramSeries& series : histogram.series) {
            std::vector<double>& shares = shares_.emplace_back(std::size_t(bins), 0);
            for (const double value : series.values) {
                shares[std::size_t(std::clamp(int((value - least_) / step_), 0, bins - 1))] +=
                    100.0 / double(series.values.size());
            }
        }
    }

    const std::vector<std::vector<double>>& shares() const { return shares_; }
    double begin(int bin) const { return least_ + bin * step_; }
    std::vector<double> ends() const { return {least_, least_ + bins * step_}; }
    std::vector<double> heights() const {
        std::vector<double> heights{0, 1};
        for (const auto& shares : shares_) heights.push_back(std::ranges::max(shares));
        return heights;
    }

  private:
    double least_ = 0;
    double step_ = 1;
    std::vector<std::vector<double>> shares_;  // of each series, percent
};

class Drawing {
  public:
    explicit Drawing(const Histogram& histogram)
        : histogram_(histogram),
          bins_(histogram),
          x_(axis_over(bins_.ends(), false, left, right)),
          y_(axis_over(bins_.heights(), true, bottom, top)) {}

    std::string svg() {
        out_ = fmt::format(
            "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0}\" height=\"{1}\" viewBox=\"0 0 {0} {1}\" "
            "font-family=\"DejaVu Sans, Helvetica, Arial, sans-serif\" role=\"img\">\n<title>{2}</title>\n"
            "<defs><pattern id=\"second\" width=\"4\" height=\"4\" patternUnits=\"userSpaceOnUse\" "
            "patternTransform=\"rotate(45)\"><rect width=\"4\" height=\"4\" fill=\"{3}\"/>"
            "<rect width=\"2.2\" height=\"4\" fill=\"{4}\"/></pattern></defs>\n"
            "<rect width=\"{0}\" height=\"{1}\" fill=\"{3}\"/>\n",
            width, height, xml_text(histogram_.title, longest_text), colour::halo, colours[1]);
        out_ += text(left, 26, "start", colour::ink, 16, histogram_.title, " font-weight=\"bold\"");
        grid();
        for (std::size_t i = 0; i < bins_.shares().size(); ++i) bars(i);
        axes();
        marks_and_names();
        return out_ + "</svg>\n";
    }

  private:
    void grid() {
        for (const ChartAxis::Tick& tick : y_.ticks()) {
            out_ += line(left, y_.at(tick.value), right, y_.at(tick.value), "#e3ded6", 1);
            out_ += text(left - 8, y_.at(tick.value) + 4.5, "end", colour::faded_ink, 13, tick.label);
        }
    }

    void bars(std::size_t index) {
        const std::size_t count = bins_.shares().size();
        for (int bin = 0; bin < bins; ++bin) {
            const double share = bins_.shares()[index][std::size_t(bin)];
            if (share == 0) continue;
            const double first = x_.at(bins_.begin(bin));
            const double part = (x_.at(bins_.begin(bin + 1)) - first) / double(count);
            out_ += fmt::format(
                "<rect x=\"{:.2f}\" y=\"{:.2f}\" width=\"{:.2f}\" height=\"{:.2f}\" fill=\"{}\" stroke=\"{}\" "
                "stroke-width=\"0.6\"/>\n",
                first + part * double(index), y_.at(share), part, bottom - y_.at(share), fills[index], colours[index]);
        }
    }

    void axes() {
        out_ += line(left, bottom, right, bottom, colour::ink, 1.2);
        out_ += line(left, bottom, left, top, colour::ink, 1.2);
        for (const ChartAxis::Tick& tick : x_.ticks()) {
            const double x = x_.at(tick.value);
            out_ += line(x, bottom, x, bottom + 5, colour::ink, 1.2);
            out_ += text(x, bottom + 20, "middle", colour::ink, 13, tick.label);
        }
        out_ += text((left + right) / 2, bottom + 44, "middle", colour::ink, 14, histogram_.x_label);
        out_ += text(18, (top + bottom) / 2, "middle", colour::ink, 14, histogram_.y_label,
                     fmt::format(" transform=\"rotate(-90 18 {:.1f})\"", (top + bottom) / 2));
    }

    // A row for the legend: what the bars are, and the dashed lines.
    void marks_and_names() {
        for (std::size_t i = 0; i < histogram_.series.size(); ++i) {
            const HistogramSeries& series = histogram_.series[i];
            const double x = left + double(i) * (right - left) / double(histogram_series);
            out_ += fmt::format("<rect x=\"{:.1f}\" y=\"42\" width=\"14\" height=\"14\" fill=\"{}\" stroke=\"{}\"/>\n",
                                x, fills[i], colours[i]);
            std::string name = series.name;
            if (series.mark) {
                const std::string_view dash = i == 0 ? " stroke-dasharray=\"7 4\"" : " stroke-dasharray=\"2 3\"";
                out_ += line(x_.at(*series.mark), bottom, x_.at(*series.mark), top - 8, colours[i], 2.4, dash);
                name += fmt::format("; {} line: {}", i == 0 ? "dashed" : "dotted", series.mark_name);
            }
            out_ += text(x + 22, 54, "start", colour::ink, 13, name);
        }
    }

    const Histogram& histogram_;
    Bins bins_;
    ChartAxis x_;
    ChartAxis y_;
    std::string out_;
};

}  // namespace

std::string histogram_svg(const Histogram& histogram) {
    return Drawing(histogram).svg();
}

}  // namespace waybreaker::render
