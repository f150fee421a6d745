#include "city/layer_features.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "city/feature_tags.hpp"
#include "city/vector_source.hpp"
#include "core/in_quotes.hpp"
#include "geotiff/gdal_scope.hpp"
#include "waybreaker/error.hpp"

namespace waybreaker::city {
namespace {

using Shape = site::Background::Shape;

std::string names_of(const std::vector<OGRLayer*>& layers) {
    constexpr std::size_t most = 12;
    std::string names;
    for (std::size_t i = 0; i < std::min(layers.size(), most); ++i) {
        names += fmt::format("{}{}", i == 0 ? "" : ", ", layers[i]->GetName());
    }
    return names + (layers.size() > most ? ", ..." : "");
}

// In a source of several layers, such as a folder of shapefiles, those that know what a building is hold the buildings;
// else the user has to say which.
void choose_buildings(std::vector<OGRLayer*>& layers, const std::string& source) {
    if (layers.size() < 2) return;
    const auto knows = [](OGRLayer* layer) { return FeatureTags(*layer).can_have("building"); };
    if (std::any_of(layers.begin(), layers.end(), knows)) {
        std::erase_if(layers, [&](OGRLayer* layer) { return !knows(layer); });
        return;
    }
    throw OptionError("layer",
                      fmt::format("is missing: {} has {} layers of areas ({}) and none says what is a building", source,
                                  layers.size(), names_of(layers)));
}

// The layer of that name alone.
void choose_layer(std::vector<OGRLayer*>& layers, const std::string& name, const std::string& source) {
    const std::vector<OGRLayer*> all = layers;
    std::erase_if(layers, [&](OGRLayer* layer) { return layer->GetName() != name; });
    if (!layers.empty()) return;
    throw refusal(source, fmt::format("has no layer {}; it has {}", in_quotes(name), names_of(all)));
}

// What features of a shape are wanted by; null if they are not.
const std::vector<TagFilter>* keys_of(const FeatureQuery& query, Shape shape) {
    const auto& keys = shape == Shape::point ? query.points : shape == Shape::line ? query.lines : query.areas;
    return keys ? &*keys : nullptr;
}

// Of the wanted shapes that the layer can hold.
std::vector<TagFilter> keys_of(const FeatureQuery& query, OGRLayer& layer) {
    const std::optional<Shape> only = shape_of(layer.GetGeomType());
    std::vector<TagFilter> keys;
    for (const Shape shape : {Shape::point, Shape::line, Shape::area}) {
        const std::vector<TagFilter>* const some = only.value_or(shape) == shape ? keys_of(query, shape) : nullptr;
        if (some != nullptr) keys.insert(keys.end(), some->begin(), some->end());
    }
    return keys;
}

bool can_hold(OGRLayer& layer, const FeatureQuery& query) {
    const OGRwkbGeometryType type = wkbFlatten(layer.GetGeomType());
    if (type == wkbUnknown || type == wkbGeometryCollection) return true;
    const std::optional<Shape> shape = shape_of(type);
    return shape && keys_of(query, *shape) != nullptr;
}

std::vector<OGRLayer*> layers_of(GDALDataset& file, const FeatureQuery& query, const std::string& source) {
    std::vector<OGRLayer*> layers(file.GetLayers().begin(), file.GetLayers().end());
    if (!query.layer.empty()) choose_layer(layers, query.layer, source);
    std::erase_if(layers, [&](OGRLayer* layer) { return !can_hold(*layer, query); });
    if (query.buildings) choose_buildings(layers, source);
    if (query.obstacles) return layers;
    std::erase_if(layers, [&](OGRLayer* layer) {
        const FeatureTags tags(*layer);
        return layer->GetSpatialRef() == nullptr ||
               std::ranges::none_of(keys_of(query, *layer),
                                    [&](const TagFilter& key) { return tags.can_have(key.key); });
    });
    return layers;
}

// Whether all coordinates of a shape are numbers.
class AllNumbers : public OGRDefaultConstGeometryVisitor {
  public:
    static bool in(const OGRGeometry& shape) {
        AllNumbers numbers;
        shape.accept(&numbers);
        return numbers.all_;
    }
    using OGRDefaultConstGeometryVisitor::visit;
    void visit(const OGRPoint* point) override {
        all_ = all_ && std::isfinite(point->getX()) && std::isfinite(point->getY());
    }

  private:
    bool all_ = true;
};

// The areas of a collection of anything, or else its lines; null if it has neither.
std::unique_ptr<OGRGeometry> gathered(const OGRGeometryCollection& all) {
    auto areas = std::make_unique<OGRMultiPolygon>();
    auto lines = std::make_unique<OGRMultiLineString>();
    for (const OGRGeometry* part : all) {
        const std::unique_ptr<OGRGeometry> straight(part->getLinearGeometry());
        const OGRwkbGeometryType type = wkbFlatten(straight->getGeometryType());
        if (type == wkbPolygon) areas->addGeometry(straight.get());
        if (type == wkbLineString) lines->addGeometry(straight.get());
        if (type == wkbMultiPolygon) {
            for (const OGRPolygon* polygon : *straight->toMultiPolygon()) areas->addGeometry(polygon);
        }
        if (type == wkbMultiLineString) {
            for (const OGRLineString* line : *straight->toMultiLineString()) lines->addGeometry(line);
        }
    }
    if (!areas->IsEmpty()) return areas;
    return lines->IsEmpty() ? nullptr : std::move(lines);
}

class LayerReader {
  public:
    LayerReader(OGRLayer& layer, const FeatureQuery& query, const std::string& source)
        : layer_(layer), query_(query), source_(source), tags_(layer) {
        const OGRSpatialReference& system = system_of(layer, source);
        to_query_ = transformation(system, query.system);
        const std::string condition = tags_.condition(keys_of(query, layer));
        layer.SetAttributeFilter(condition.empty() ? nullptr : condition.c_str());
        if (!query.bounds) return;
        bounds_ = bounds_in(system, {query.system, *query.bounds}, source);
        // It passes over what has no coordinates, which is of interest where it costs nothing to see it.
        if (layer.TestCapability(OLCFastSpatialFilter)) {
            layer.SetSpatialFilterRect(bounds_->MinX, bounds_->MinY, bounds_->MaxX, bounds_->MaxY);
        }
    }

    void read(const std::function<void(Feature)>& visit) {
        const geotiff::GdalScope gdal;
        for (const OGRFeatureUniquePtr& feature : layer_) {
            if (std::optional<Feature> seen = seen_as(*feature)) visit(std::move(*seen));
        }
        require_read(gdal, source_);
    }

  private:
    std::optional<Feature> seen_as(OGRFeature& feature) const {
        std::unique_ptr<OGRGeometry> shape(feature.StealGeometry());
        if (shape && wkbFlatten(shape->getGeometryType()) == wkbGeometryCollection) {
            shape = gathered(*shape->toGeometryCollection());
        }
        if (!shape || shape->IsEmpty()) return described(feature, shape_of(layer_.GetGeomType()), nullptr);
        const std::optional<Shape> kind = shape_of(shape->getGeometryType());
        if (!AllNumbers::in(*shape)) return described(feature, kind, nullptr);
        OGREnvelope box;
        shape->getEnvelope(&box);
        if (bounds_ && !bounds_->Intersects(box)) return std::nullopt;
        const geotiff::GdalScope gdal;  // what reaches too far around the globe cannot be transformed, and is left out
        if (shape->transform(to_query_.get()) != OGRERR_NONE) return std::nullopt;
        return described(feature, kind, std::unique_ptr<OGRGeometry>(shape->getLinearGeometry()));
    }

    // What has no shape may be anything.
    std::optional<Feature> described(const OGRFeature& feature, std::optional<Shape> kind,
                                     std::unique_ptr<OGRGeometry> shape) const {
        if (!kind && shape) return std::nullopt;
        const Shape known = kind.value_or(Shape::area);
        if (keys_of(query_, known) == nullptr) return std::nullopt;
        return Feature{known, tags_.all(feature), tags_.source_id(feature), std::move(shape), !tags_.tells_buildings()};
    }

    OGRLayer& layer_;
    const FeatureQuery& query_;
    const std::string& source_;
    FeatureTags tags_;
    Transformation to_query_;
    std::optional<OGREnvelope> bounds_;
};

// The part of the world that the source has data of, as far as it says so without being read.
OGREnvelope extent_of(GDALDataset& file, const OGRSpatialReference& target) {
    const geotiff::GdalScope gdal;
    OGREnvelope all;
    for (OGRLayer* layer : file.GetLayers()) {
        OGREnvelope extent;
        const OGRSpatialReference* system = layer->GetSpatialRef();
        if (!system || layer->GetExtent(&extent, TRUE) != OGRERR_NONE) continue;
        if (const auto box = transformed(extent, *system, target)) all.Merge(*box);
    }
    return all;
}

}  // namespace

FeatureReport visit_layers(const std::string& source, const FeatureQuery& query,
                           const std::function<void(Feature)>& visit) {
    const GDALDatasetUniquePtr file = open_source(source);
    const std::vector<OGRLayer*> layers = layers_of(*file, query, source);
    FeatureReport report{.any_layer = !layers.empty()};
    // Filters of layers hold for it, too: those of tags should, that of a window must not.
    if (query.obstacles && query.bounds) report.extent = extent_of(*file, query.system);
    for (OGRLayer* layer : layers) {
        report.from_osm = report.from_osm || FeatureTags(*layer).from_osm();
        LayerReader(*layer, query, source).read(visit);
    }
    if (query.obstacles && !query.bounds) report.extent = extent_of(*file, query.system);
    return report;
}

}  // namespace waybreaker::city
