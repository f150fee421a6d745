#include "city/survey.hpp"

#include <algorithm>
#include <iterator>
#include <memory>
#include <optional>
#include <utility>

#include "city/cut_ground.hpp"
#include "labels/obstacle_names.hpp"

namespace waybreaker::city {
namespace {

using Shape = site::Background::Shape;

// Strips reach into the window from so far beside it, in metres.
constexpr double margin = 50;

constexpr const char* nothing_found = "no water, ways or barriers in the window: only buildings bar the way";

// Keys by which a feature of that shape is worth reading; of any shape, if it is empty.
std::vector<TagFilter> keys_of(const SurveyOptions& options, const std::vector<TagFilter>& premises,
                               std::optional<Shape> shape) {
    std::vector<TagFilter> keys;
    const auto add = [&keys](const std::vector<TagFilter>& more) {
        for (const TagFilter& one : more) {
            const bool known =
                std::any_of(keys.begin(), keys.end(), [&](const TagFilter& key) { return key.key == one.key; });
            if (!known) keys.push_back(one);
        }
    };
    if (options.scenery) add(scenery_keys(shape));
    if (options.profile != Profile::paper) add(ground_keys(shape));
    if (shape == Shape::line) return keys;
    for (const TagFilter& one : premises) add({{one.key}});
    return keys;
}

FeatureQuery query_of(const Window& window, const SurveyOptions& options, const std::vector<TagFilter>& premises) {
    FeatureQuery query{.system = window.system};
    query.bounds = window.bounds;
    query.bounds->Merge(window.bounds.MinX - margin, window.bounds.MinY - margin);
    query.bounds->Merge(window.bounds.MaxX + margin, window.bounds.MaxY + margin);
    query.points = keys_of(options, premises, Shape::point);
    query.lines = keys_of(options, premises, Shape::line);
    query.areas = keys_of(options, premises, Shape::area);
    return query;
}

class Surveyor {
  public:
    Surveyor(const Window& window, const SurveyOptions& options)
        : window_(window),
          options_(options),
          premises_(premises_filters(options.choice)),
          query_(query_of(window, options, premises_)) {}

    Survey read(const std::string& source) {
        FeatureReport report = visit_features(source, query_, [this](const Feature& feature) { see(feature); });
        survey_.defects = std::move(report.defects);
        if (options_.profile == Profile::paper) return std::move(survey_);
        close(report.cut);
        // Of a line and an area that both bar a cell, the area is the later one, and has it.
        std::ranges::stable_partition(survey_.ground.pieces,
                                      [](const GroundPiece& piece) { return is_line(piece.shape->getGeometryType()); });
        OGREnvelope bounds = window_.bounds;
        if (options_.data.IsInit() && options_.data.Intersects(bounds)) bounds.Intersect(options_.data);
        survey_.ground = finished(std::move(survey_.ground), std::move(coasts_), bounds, options_.cell);
        if (survey_.ground.pieces.empty()) survey_.ground.notes.emplace_back(nothing_found);
        return std::move(survey_);
    }

  private:
    void close(const std::vector<CutArea>& areas) {
        CutGround cut = cut_ground(areas, options_.data, evidence_, window_.bounds, options_.profile);
        Ground& ground = survey_.ground;
        std::ranges::move(cut.pieces, std::back_inserter(ground.pieces));
        std::ranges::move(cut.notes, std::back_inserter(ground.notes));
        if (options_.scenery) std::ranges::move(cut.scenery, std::back_inserter(survey_.scenery));
    }

    void see(const Feature& feature) {
        if (!feature.geometry || !lies_near(*feature.geometry)) return;
        add_evidence(feature, evidence_);
        if (feature.shape == Shape::line && feature.tags.says("highway") && lies_inside(*feature.geometry)) {
            ++survey_.streets;
        }
        see_ground(feature);
        if (std::optional<Premises> premises = premises_of(feature.tags, feature.shape, premises_)) {
            premises->shape.reset(feature.geometry->clone());
            survey_.premises.push_back(std::move(*premises));
        }
        std::optional<Sight> sight = options_.scenery ? sight_of(feature.tags, feature.shape) : std::nullopt;
        if (!sight || !lies_inside(*feature.geometry)) return;
        sight->shape.reset(feature.geometry->clone());
        survey_.scenery.push_back(std::move(*sight));
    }

    void see_ground(const Feature& feature) {
        if (options_.profile == Profile::paper) return;
        const std::string* const name = feature.tags.find("name");
        for (const GroundUse& use : ground_uses(feature.tags, feature.shape, options_.profile)) {
            if (!short_enough(use, *feature.geometry)) continue;
            GroundPiece piece{use, std::unique_ptr<OGRGeometry>(feature.geometry->clone()), feature.source_id,
                              labels::clean_name(name ? *name : "")};
            if (use.layer == GroundLayer::barrier) describe_barrier(feature.tags, piece);
            survey_.ground.pieces.push_back(std::move(piece));
        }
        if (!feature.tags.is("natural", "coastline")) return;
        // Who converts OpenStreetMap's data makes areas of islands.
        OGRGeometry* const line =
            feature.shape == Shape::area ? feature.geometry->Boundary() : feature.geometry->clone();
        coasts_.push_back({{}, std::unique_ptr<OGRGeometry>(line), 0, ""});
    }

    void describe_barrier(const TagSet& tags, GroundPiece& barrier) const {
        const ObstacleChoice& choice = options_.choice;
        barrier.sheltered = tags.matches_any(choice.shelter);
        barrier.destructible = (choice.destructible.empty() || tags.matches_any(choice.destructible)) &&
                               !tags.matches_any(choice.protect) && !barrier.sheltered;
        barrier.tags = kept_tags(tags);
    }

    static bool short_enough(const GroundUse& use, const OGRGeometry& shape) {
        return use.layer != GroundLayer::underpass ||
               OGR_G_Length(OGRGeometry::ToHandle(const_cast<OGRGeometry*>(&shape))) <= longest_underpass;
    }

    // In the window or the margin around it.
    bool lies_near(const OGRGeometry& shape) const {
        OGREnvelope box;
        shape.getEnvelope(&box);
        return query_.bounds && query_.bounds->Intersects(box);
    }

    bool lies_inside(const OGRGeometry& shape) const {
        OGREnvelope box;
        shape.getEnvelope(&box);
        return window_.bounds.Intersects(box);
    }

    const Window& window_;
    const SurveyOptions& options_;
    std::vector<TagFilter> premises_;
    FeatureQuery query_;
    Survey survey_;
    std::vector<GroundPiece> coasts_;
    Evidence evidence_;
};

}  // namespace

Survey read_survey(const std::string& source, const Window& window, const SurveyOptions& options) {
    return Surveyor(window, options).read(source);
}

}  // namespace waybreaker::city
