#include "city/cut_ground.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <memory>
#include <optional>
#include <utility>

#include "city/vector_source.hpp"
#include "geotiff/feature_parts.hpp"
#include "geotiff/gdal_scope.hpp"
#include "labels/obstacle_names.hpp"

namespace waybreaker::city {
namespace {

using Shape = site::Background::Shape;

std::string name_of(const CutArea& area) {
    const std::string* const said = area.tags.find("name");
    return labels::clean_name(said ? *said : "");
}

bool is_water(const std::vector<GroundUse>& uses) {
    return std::ranges::any_of(uses, [](const GroundUse& use) { return use.kind == site::ObstacleKind::water; });
}

double area_of(const OGRGeometry& shape) {
    return OGR_G_Area(OGRGeometry::ToHandle(const_cast<OGRGeometry*>(&shape)));
}

// Whether its outline may lead through the bounds.
bool meets(const CutArea& area, const OGREnvelope& bounds) {
    return std::ranges::any_of(area.outer, [&](const Line& line) {
        OGREnvelope box;
        for (const Point& point : line) box.Merge(point.x, point.y);
        return bounds.Intersects(box);
    });
}

std::vector<Point> points_of(const std::vector<CutArea>& areas, const Evidence& evidence) {
    std::vector<Point> points;
    const auto add = [&points](const std::vector<Line>& lines) {
        for (const Line& line : lines) points.insert(points.end(), line.begin(), line.end());
    };
    for (const CutArea& area : areas) {
        add(area.outer);
        add(area.inner);
    }
    add(evidence.within);
    add(evidence.outside);
    return points;
}

// The areas that a note is about, by name.
class Named {
  public:
    void add(const std::string& name) {
        if (name.empty()) {
            ++nameless_;
        } else if (std::ranges::find(names_, name) == names_.end()) {
            names_.push_back(name);
        }
    }

    // "Vltava, Botic and 2 areas without a name"; empty if there are none.
    std::string text() const {
        constexpr std::size_t most = 8;
        const std::vector<std::string> first(names_.begin(),
                                             names_.begin() + std::ptrdiff_t(std::min(most, names_.size())));
        std::string text = fmt::format("{}{}", fmt::join(first, ", "), names_.size() > most ? ", ..." : "");
        if (nameless_ == 0) return text;
        const std::string others =
            nameless_ == 1 ? "1 area without a name" : fmt::format("{} areas without a name", nameless_);
        return text.empty() ? others : text + " and " + others;
    }

    bool one() const { return names_.size() + nameless_ == 1; }

  private:
    std::vector<std::string> names_;
    std::size_t nameless_ = 0;
};

}  // namespace

void add_evidence(const Feature& feature, Evidence& evidence) {
    const TagSet& tags = feature.tags;
    if (feature.shape != Shape::line || tags.says("tunnel")) return;
    const bool river = tags.is("waterway", "river") || tags.is("waterway", "canal");
    const bool street = tags.says("highway") && !tags.says("bridge") && !tags.says("ford") && !tags.says("man_made");
    if (!river && !street) return;
    const auto parts = geotiff::parts_of(*feature.geometry);
    if (!parts) return;
    std::vector<Line>& lines = river ? evidence.within : evidence.outside;
    lines.insert(lines.end(), parts->parts.begin(), parts->parts.end());
}

CutGround cut_ground(const std::vector<CutArea>& areas, const OGREnvelope& data, const Evidence& evidence,
                     const OGREnvelope& window, Profile profile) {
    const geotiff::GdalScope gdal;
    CutGround ground;
    const std::unique_ptr<OGRPolygon> edge = edge_of_data(data, points_of(areas, evidence), areas);
    const OGRPolygon seen = rectangle(window);
    Named closed;
    Named unknown;
    Named left_out;
    for (const CutArea& area : areas) {
        std::vector<GroundUse> uses = ground_uses(area.tags, Shape::area, profile);
        std::erase_if(uses, [](const GroundUse& use) { return !bars(use); });
        std::optional<Sight> sight = sight_of(area.tags, Shape::area);
        if (uses.empty() && !sight) continue;
        const bool water = is_water(uses);
        const ClosedArea found = edge ? closed_along_edge(area, *edge, water ? evidence : Evidence()) : ClosedArea();
        if (!found.shape && !uses.empty() && meets(area, window)) left_out.add(name_of(area));
        if (!found.shape || !found.shape->Intersects(&seen)) continue;
        const bool known = found.how == ClosedArea::How::closed;
        // Most grounds are small beside a city: who takes the wrong side of an outline shuts all of it.
        if (!water && (!known || area_of(*found.shape) > edge->get_Area() / 2)) {
            if (!uses.empty()) left_out.add(name_of(area));
            continue;
        }
        const GroundUse maybe{GroundLayer::forbidden, site::ObstacleKind::unknown};
        for (const GroundUse& use : uses) {
            ground.pieces.push_back({known ? use : maybe, std::unique_ptr<OGRGeometry>(found.shape->clone()),
                                     area.source_id, name_of(area)});
        }
        if (!uses.empty()) (known ? closed : unknown).add(name_of(area));
        if (!known || !sight) continue;
        sight->shape.reset(found.shape->clone());
        ground.scenery.push_back(std::move(*sight));
    }
    if (const std::string text = closed.text(); !text.empty()) {
        ground.notes.push_back(text + ": closed along the edge of the data");
    }
    if (const std::string text = unknown.text(); !text.empty()) {
        ground.notes.push_back(
            fmt::format("{}: {} not whole in the file; where {} may be is unknown ground and bars the way", text,
                        unknown.one() ? "its outline is" : "their outlines are", unknown.one() ? "it" : "they"));
    }
    if (const std::string text = left_out.text(); !text.empty()) {
        ground.notes.push_back(fmt::format("{}: left out, for the source has no more than a part of {}", text,
                                           left_out.one() ? "its outline" : "their outlines"));
    }
    return ground;
}

}  // namespace waybreaker::city
