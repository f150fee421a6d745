#include "city/cut_areas.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <utility>

#include "city/edge_faces.hpp"
#include "city/vector_source.hpp"
#include "geotiff/feature_parts.hpp"
#include "geotiff/gdal_scope.hpp"

namespace waybreaker::city {
namespace {

bool is_ring(const Line& line) {
    return line.size() > 3 && line.front() == line.back();
}

// The ways of an outline, as far as they go.
std::vector<Line> joined_outline(const CutArea& area) {
    std::vector<Line> ways = area.outer;
    ways.insert(ways.end(), area.inner.begin(), area.inner.end());
    std::erase_if(ways, [](const Line& way) { return !(length_of(way) > 0); });
    return joined(std::move(ways));
}

// Where an outline ends, and the point before it.
struct End {
    Point at;
    Point before;
    Point edge;  // where the edge is nearest
    bool near = false;
};

std::vector<End> ends_within(const std::vector<Line>& outline, const OGRPolygon& edge) {
    const double reach = reach_of(edge);
    const std::vector<Point> loose = loose_ends(outline);
    std::vector<End> ends;
    const auto add = [&](const Point& at, const Point& before) {
        if (std::find(loose.begin(), loose.end(), at) == loose.end() || !lies_within(edge, at)) return;
        const Point foot = just_beyond(edge, at);
        ends.push_back({at, before, foot, distance(at, foot) <= reach});
    };
    for (const Line& line : outline) {
        add(line.front(), line[1]);
        add(line.back(), line[line.size() - 2]);
    }
    return ends;
}

// Whether the outline goes on from one end to the other, rather than beyond the edge.
bool head_for_each_other(const End& a, const End& b) {
    const double gap = distance(a.at, b.at);
    if (gap >= std::min(distance(a.at, a.edge), distance(b.at, b.edge))) return false;
    const auto heads = [gap](const End& from, const Point& to) {
        constexpr double least = 0.7;  // cosine: within 45 degrees
        const double along =
            (from.at.x - from.before.x) * (to.x - from.at.x) + (from.at.y - from.before.y) * (to.y - from.at.y);
        return along >= least * gap * distance(from.at, from.before);
    };
    return heads(a, b.at) && heads(b, a.at);
}

// An outline, its gaps closed by straight lines, to the edge or from end to end.
struct Outline {
    std::vector<Line> lines;
    bool doubtful = false;  // some gap is too long to be straight
};

Outline without_gaps(std::vector<Line> lines, const OGRPolygon& edge) {
    // A straight line instead of a piece of bank is right to about its own length squared; of a gap no longer than
    // that share of the bank next to it one still sees the shape.
    constexpr double short_share = 0.1;
    Outline result;
    const std::vector<End> ends = ends_within(lines, edge);
    double length = 0;
    for (const Line& line : lines) length += length_of(line);
    struct Gap {
        double length;
        std::size_t from;
        std::size_t to;
    };
    std::vector<Gap> gaps;
    for (std::size_t i = 0; i < ends.size(); ++i) {
        for (std::size_t j = i + 1; j < ends.size(); ++j) {
            const bool both_inside = !ends[i].near && !ends[j].near;
            if (both_inside || head_for_each_other(ends[i], ends[j])) {
                gaps.push_back({distance(ends[i].at, ends[j].at), i, j});
            }
        }
    }
    std::stable_sort(gaps.begin(), gaps.end(), [](const Gap& a, const Gap& b) { return a.length < b.length; });
    std::vector<bool> closed(ends.size(), false);
    for (const Gap& gap : gaps) {
        if (closed[gap.from] || closed[gap.to]) continue;
        closed[gap.from] = closed[gap.to] = true;
        lines.push_back({ends[gap.from].at, ends[gap.to].at});
        if (gap.length > short_share * length) result.doubtful = true;
    }
    for (std::size_t i = 0; i < ends.size(); ++i) {
        if (closed[i]) continue;
        lines.push_back({ends[i].at, ends[i].edge});
        if (!ends[i].near) result.doubtful = true;
    }
    result.lines = std::move(lines);
    return result;
}

// Of each face 0 or 1, so that they differ wherever the outline lies between: one of the two is the area.
struct Colours {
    std::vector<int> of;
    bool consistent = true;
};

Colours colours_of(const Faces& faces, const std::vector<Border>& borders) {
    constexpr double tolerance = 1;  // metres of outline that may have one face, or one colour, on both sides
    std::map<std::pair<std::size_t, std::size_t>, double> between;
    for (const Border& border : borders) {
        if (border.left == Faces::none || border.right == Faces::none) continue;
        between[std::minmax(border.left, border.right)] += border.length;
    }
    std::vector<std::vector<std::size_t>> neighbours(faces.size());
    for (const auto& [pair, length] : between) {
        neighbours[pair.first].push_back(pair.second);
        neighbours[pair.second].push_back(pair.first);
    }
    Colours colours{std::vector<int>(faces.size(), -1)};
    for (std::size_t first = 0; first < faces.size(); ++first) {
        if (colours.of[first] >= 0) continue;
        colours.of[first] = 0;
        std::vector<std::size_t> open{first};
        while (!open.empty()) {
            const std::size_t face = open.back();
            open.pop_back();
            for (const std::size_t next : neighbours[face]) {
                if (colours.of[next] >= 0) continue;
                colours.of[next] = 1 - colours.of[face];
                open.push_back(next);
            }
        }
    }
    for (const auto& [pair, length] : between) {
        if (length > tolerance && colours.of[pair.first] == colours.of[pair.second]) colours.consistent = false;
    }
    return colours;
}

// What speaks for each of the two colours.
using Votes = std::array<double, 2>;

// The one with that many times the votes of the other.
std::optional<int> decided(const Votes& votes, double times) {
    if (votes[0] > times * votes[1]) return 0;
    if (votes[1] > times * votes[0]) return 1;
    return std::nullopt;
}

class Choice {
  public:
    Choice(const Faces& faces, const std::vector<int>& colours) : faces_(faces), colours_(colours) {
        for (std::size_t i = 0; i < faces.size(); ++i) {
            areas_[std::size_t(colours[i])] += faces[i].toPolygon()->get_Area();
        }
    }

    int smaller() const { return areas_[1] < areas_[0] ? 1 : 0; }

    std::optional<int> inside(const CutArea& area, const Evidence& evidence) const {
        if (const auto dry = decided(metres_of(evidence.outside, false), 10)) return 1 - *dry;
        if (const auto inside = inside_of_rings(area)) return inside;
        Votes dense = metres_of(evidence.within, true);
        for (std::size_t i = 0; i < 2; ++i) dense[i] = areas_[i] > 0 ? dense[i] / areas_[i] : 0;
        return decided(dense, 3);
    }

  private:
    // Metres in each colour, of lines within one only if asked.
    Votes metres_of(const std::vector<Line>& lines, bool uncrossed) const {
        constexpr double step = 10;  // metres
        Votes votes{};
        for (const Line& line : lines) {
            Votes own{};
            for (std::size_t i = 1; i < line.size(); ++i) {
                const double length = distance(line[i - 1], line[i]);
                const auto pieces = std::size_t(std::ceil(length / step));
                for (std::size_t piece = 0; piece < pieces; ++piece) {
                    const double share = (double(piece) + 0.5) / double(pieces);
                    const std::size_t face = faces_.at({line[i - 1].x + share * (line[i].x - line[i - 1].x),
                                                        line[i - 1].y + share * (line[i].y - line[i - 1].y)});
                    if (face != Faces::none) own[std::size_t(colours_[face])] += length / double(pieces);
                }
            }
            if (uncrossed && own[0] > 0 && own[1] > 0) continue;
            for (std::size_t i = 0; i < 2; ++i) votes[i] += own[i];
        }
        return votes;
    }

    // Whole rings know their inside; islands' rings their outside.
    std::optional<int> inside_of_rings(const CutArea& area) const {
        Votes votes{};
        const auto count = [&](const std::vector<Line>& ways, bool outer) {
            for (Line& ring : joined(ways)) {
                if (!is_ring(ring)) continue;
                if (geotiff::signed_area(ring) < 0) std::reverse(ring.begin(), ring.end());
                for (const Border& border : borders(faces_, {ring})) {
                    const std::size_t face = outer ? border.left : border.right;
                    if (face != Faces::none) votes[std::size_t(colours_[face])] += border.length;
                }
            }
        };
        count(area.outer, true);
        count(area.inner, false);
        return decided(votes, 3);
    }

    const Faces& faces_;
    const std::vector<int>& colours_;
    std::array<double, 2> areas_{};
};

std::unique_ptr<OGRGeometry> union_of(const Faces& faces, const std::vector<int>& colours, int colour) {
    OGRMultiPolygon all;
    for (std::size_t i = 0; i < faces.size(); ++i) {
        if (colours[i] == colour) all.addGeometry(&faces[i]);
    }
    return std::unique_ptr<OGRGeometry>(all.IsEmpty() ? nullptr : all.UnionCascaded());
}

}  // namespace

ClosedArea closed_along_edge(const CutArea& area, const OGRPolygon& edge, const Evidence& evidence) {
    const geotiff::GdalScope gdal;
    ClosedArea result;
    const Outline outline = without_gaps(joined_outline(area), edge);
    const Faces faces(outline.lines, edge);
    if (faces.size() < 2) return result;
    const Colours colours = colours_of(faces, borders(faces, outline.lines));
    const Choice choice(faces, colours.of);
    const std::optional<int> inside = choice.inside(area, evidence);
    result.shape = union_of(faces, colours.of, inside.value_or(choice.smaller()));
    if (inside && colours.consistent && !outline.doubtful) result.how = ClosedArea::How::closed;
    return result;
}

std::unique_ptr<OGRPolygon> edge_of_data(const OGREnvelope& bounds, const std::vector<Point>& points,
                                         const std::vector<CutArea>& areas) {
    const geotiff::GdalScope gdal;
    std::unique_ptr<OGRPolygon> box;
    if (bounds.IsInit()) box = std::make_unique<OGRPolygon>(rectangle(bounds));
    OGRMultiPoint all;
    for (const Point& point : points) {
        const OGRPoint one(point.x, point.y);
        all.addGeometry(&one);
    }
    std::unique_ptr<OGRGeometry> around(all.ConvexHull());
    if (!around || wkbFlatten(around->getGeometryType()) != wkbPolygon) return box;
    std::unique_ptr<OGRPolygon> hull(around.release()->toPolygon());
    if (!box) return hull;
    constexpr double clearly = 0.9;  // of the area
    if (hull->get_Area() > clearly * box->get_Area()) return box;
    std::size_t near_hull = 0;
    std::size_t near_box = 0;
    for (const CutArea& area : areas) {
        for (const End& end : ends_within(joined_outline(area), *box)) {
            if (end.near) ++near_box;
            if (distance(end.at, just_beyond(*hull, end.at)) <= reach_of(*hull)) ++near_hull;
        }
    }
    return near_hull > 2 * near_box ? std::move(hull) : std::move(box);
}

}  // namespace waybreaker::city
