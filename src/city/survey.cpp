#include "city/survey.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>
#include <map>
#include <optional>
#include <set>
#include <tuple>
#include <utility>

#include "city/feature_tags.hpp"
#include "geotiff/gdal_scope.hpp"
#include "geotiff/obstacle_names.hpp"

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

// What is read so far.
struct Findings {
    Survey survey;
    std::vector<GroundPiece> coasts;
};

// One layer of the source.
class SurveyedLayer {
  public:
    SurveyedLayer(OGRLayer& layer, const Window& window, const SurveyOptions& options,
                  const std::vector<TagFilter>& premises, const std::string& source)
        : tags_(layer),
          window_(window),
          options_(options),
          premises_(premises),
          to_window_(transformation(system_of(layer, source), window.system)) {
        // If GDAL's OSM driver skips points, ways lose them too.
        if (wkbFlatten(layer.GetGeomType()) != wkbPoint) {
            Window wide = window;
            wide.bounds.MinX -= margin;
            wide.bounds.MinY -= margin;
            wide.bounds.MaxX += margin;
            wide.bounds.MaxY += margin;
            const OGREnvelope bounds = bounds_in(system_of(layer, source), wide, source);
            layer.SetSpatialFilterRect(bounds.MinX, bounds.MinY, bounds.MaxX, bounds.MaxY);
        }
        const std::optional<Shape> shape = shape_of(layer.GetGeomType());
        layer.SetAttributeFilter(tags_.condition(keys_of(options, premises, shape)).c_str());
    }

    void see(const OGRFeature& feature, Findings& findings) const {
        const OGRGeometry* geometry = feature.GetGeometryRef();
        const std::optional<Shape> shape = geometry ? shape_of(geometry->getGeometryType()) : std::nullopt;
        if (!shape) return;
        const TagSet tags = tags_.all(feature);
        std::optional<Sight> sight = options_.scenery ? sight_of(tags, *shape) : std::nullopt;
        const std::vector<GroundUse> uses = ground_uses(tags, *shape, options_.profile);
        const bool coast = options_.profile != Profile::paper && tags.is("natural", "coastline");
        std::optional<Premises> premises = premises_of(tags, *shape, premises_);
        if (!sight && uses.empty() && !coast && !premises) return;
        const std::unique_ptr<OGRGeometry> placed = place(*geometry);
        if (!placed) return;
        const std::string* name = tags.find("name");
        for (const GroundUse& use : uses) {
            if (!short_enough(use, *placed)) continue;
            GroundPiece piece{use, std::unique_ptr<OGRGeometry>(placed->clone()), tags_.source_id(feature),
                              geotiff::clean_name(name ? *name : "")};
            if (use.layer == GroundLayer::barrier) describe_barrier(feature, tags, piece);
            findings.survey.ground.pieces.push_back(std::move(piece));
        }
        if (coast) {  // GDAL makes areas of islands
            OGRGeometry* line = *shape == Shape::area ? placed->Boundary() : placed->clone();
            findings.coasts.push_back({{}, std::unique_ptr<OGRGeometry>(line), 0, ""});
        }
        if (premises) {
            premises->shape.reset(placed->clone());
            findings.survey.premises.push_back(std::move(*premises));
        }
        OGREnvelope box;
        placed->getEnvelope(&box);
        if (!sight || !window_.bounds.Intersects(box)) return;
        sight->shape.reset(placed->clone());
        findings.survey.scenery.push_back(std::move(*sight));
    }

  private:
    void describe_barrier(const OGRFeature& feature, const TagSet& tags, GroundPiece& barrier) const {
        const auto among = [&tags](const std::vector<TagFilter>& filters) {
            return std::any_of(filters.begin(), filters.end(), [&](const auto& one) { return tags.matches(one); });
        };
        const ObstacleChoice& choice = options_.choice;
        barrier.sheltered = among(choice.shelter);
        barrier.destructible =
            (choice.destructible.empty() || among(choice.destructible)) && !among(choice.protect) && !barrier.sheltered;
        barrier.tags = tags_.kept(feature);
    }

    static bool short_enough(const GroundUse& use, const OGRGeometry& shape) {
        return use.layer != GroundLayer::underpass ||
               OGR_G_Length(OGRGeometry::ToHandle(const_cast<OGRGeometry*>(&shape))) <= longest_underpass;
    }

    // Null if it cannot be projected or lies elsewhere.
    std::unique_ptr<OGRGeometry> place(const OGRGeometry& geometry) const {
        const geotiff::GdalScope gdal;
        std::unique_ptr<OGRGeometry> shape(geometry.clone());
        if (shape->transform(to_window_.get()) != OGRERR_NONE) return nullptr;
        shape.reset(shape->getLinearGeometry());
        OGREnvelope box;
        shape->getEnvelope(&box);
        OGREnvelope wide = window_.bounds;
        wide.Merge(wide.MinX - margin, wide.MinY - margin);
        wide.Merge(wide.MaxX + margin, wide.MaxY + margin);
        return wide.Intersects(box) ? std::move(shape) : nullptr;
    }

    FeatureTags tags_;
    const Window& window_;
    const SurveyOptions& options_;
    const std::vector<TagFilter>& premises_;
    Transformation to_window_;
};

// By layer, of those that say where they lie. In OpenStreetMap's files without the layers of relations that are not
// areas.
std::map<const OGRLayer*, SurveyedLayer> layers_of(GDALDataset& file, const Window& window,
                                                   const SurveyOptions& options, const std::vector<TagFilter>& premises,
                                                   const std::string& source) {
    const bool osm = EQUAL(file.GetDriverName(), "OSM");
    if (osm) {
        file.ReleaseResultSet(file.ExecuteSQL("SET interest_layers = points,lines,multipolygons", nullptr, nullptr));
    }
    const std::vector<TagFilter> keys = keys_of(options, premises, {});
    std::map<const OGRLayer*, SurveyedLayer> layers;
    for (OGRLayer* layer : file.GetLayers()) {
        const std::string name = layer->GetName();
        const bool wanted = !osm || name == "points" || name == "lines" || name == "multipolygons";
        if (!wanted || layer->GetSpatialRef() == nullptr) continue;
        const FeatureTags tags(*layer);
        if (std::any_of(keys.begin(), keys.end(), [&](const TagFilter& key) { return tags.can_have(key.key); })) {
            layers.emplace(std::piecewise_construct, std::forward_as_tuple(layer),
                           std::forward_as_tuple(*layer, window, options, premises, source));
        }
    }
    return layers;
}

// Relations that GDAL leaves out because ways of theirs are not in the file, from what it says about them.
class IncompleteRelations {
  public:
    void hear(std::string_view line) {
        constexpr std::string_view before = "Relation ";
        const std::size_t at = line.find(before);
        if (at == std::string_view::npos || line.find("missing ways") == std::string_view::npos) return;
        std::int64_t id = 0;
        const std::string_view rest = line.substr(at + before.size());
        if (std::from_chars(rest.data(), rest.data() + rest.size(), id).ec == std::errc()) ids_.insert(id);
    }

    void note(std::vector<std::string>& notes) const {
        constexpr std::size_t most = 8;
        if (ids_.empty()) return;
        std::vector<std::int64_t> first(ids_.begin(), ids_.end());
        first.resize(std::min(first.size(), most));
        notes.push_back(
            fmt::format("{} lack{} ways in the file and {} left out: {}{}; of a river or canal its line "
                        "remains, as a strip",
                        ids_.size() == 1 ? "1 area" : fmt::format("{} areas", ids_.size()), ids_.size() == 1 ? "s" : "",
                        ids_.size() == 1 ? "is" : "are",
                        fmt::format("relation{} {}", ids_.size() == 1 ? "" : "s", fmt::join(first, ", ")),
                        ids_.size() > most ? ", ..." : ""));
    }

  private:
    std::set<std::int64_t> ids_;
};

}  // namespace

Survey read_survey(const std::string& source, const Window& window, const SurveyOptions& options) {
    const GDALDatasetUniquePtr file = open_source(source);
    IncompleteRelations incomplete;
    const geotiff::GdalScope gdal([&incomplete](std::string_view line) { incomplete.hear(line); });
    const std::vector<TagFilter> premises = premises_filters(options.choice);
    const std::map<const OGRLayer*, SurveyedLayer> layers = layers_of(*file, window, options, premises, source);
    Findings findings;
    if (layers.empty() && options.profile != Profile::paper) findings.survey.ground.notes.emplace_back(nothing_found);
    if (layers.empty()) return std::move(findings.survey);
    for (const GDALDataset::FeatureLayerPair& read : file->GetFeatures()) {
        const auto layer = layers.find(read.layer);
        if (layer != layers.end()) layer->second.see(*read.feature, findings);
    }
    require_read(gdal, source);
    Survey survey = std::move(findings.survey);
    if (options.profile == Profile::paper) return survey;
    OGREnvelope bounds = window.bounds;
    if (options.data.IsInit() && options.data.Intersects(bounds)) bounds.Intersect(options.data);
    survey.ground = finished(std::move(survey.ground), std::move(findings.coasts), bounds, options.cell);
    if (survey.ground.pieces.empty()) survey.ground.notes.emplace_back(nothing_found);
    incomplete.note(survey.ground.notes);
    return survey;
}

}  // namespace waybreaker::city
