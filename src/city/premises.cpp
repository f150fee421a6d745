#include "city/premises.hpp"

#include <ogr_api.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <utility>

#include "city/ground_rules.hpp"
#include "city/label_raster.hpp"
#include "city/vector_source.hpp"
#include "geotiff/gdal_scope.hpp"
#include "labels/obstacle_names.hpp"

namespace waybreaker::city {
namespace {

using Shape = site::Background::Shape;

double area_of(const OGRGeometry& shape) {
    return OGR_G_Area(OGRGeometry::ToHandle(const_cast<OGRGeometry*>(&shape)));
}

// Premises on the cells of a window, and who inherits from them.
class Heirs {
  public:
    Heirs(const std::vector<const OGRGeometry*>& buildings, const std::vector<std::uint32_t>& labels,
          const CellWindow& window, const std::vector<Premises>& premises, const std::vector<TagFilter>& filters)
        : buildings_(buildings),
          labels_(labels),
          window_(window),
          premises_(premises),
          filters_(filters),
          cells_(buildings.size() + 1, 0),
          found_(buildings.size()) {
        for (const std::uint32_t label : labels) ++cells_[label];
    }

    // Of points first: the name of a chapel before that of the hospital around it.
    std::vector<Inheritance> find() && {
        inherit_from_points();
        for (std::size_t filter = 0; filter < filters_.size(); ++filter) inherit_from_areas(filter);
        return std::move(found_);
    }

  private:
    bool inherits(std::uint32_t label) const { return label != 0 && buildings_[label - 1] != nullptr; }

    void inherit(std::uint32_t label, const Premises& from, const PremisesTag& tag) {
        Inheritance& heir = found_[label - 1];
        heir.tags.push_back(tag);
        if (heir.name.empty()) heir.name = from.name;
    }

    void inherit_from_points() {
        std::map<std::uint32_t, std::vector<const Premises*>> near;  // by label
        for (const Premises& one : premises_) {
            if (is_area(one.shape->getGeometryType())) continue;
            for (const std::uint32_t label : labels_around(*one.shape->toPoint())) near[label].push_back(&one);
        }
        for (const auto& [label, points] : near) {
            // Each shape is prepared once: strangers may send large ones, and many points.
            const OGRPreparedGeometryUniquePtr building(
                OGRCreatePreparedGeometry(OGRGeometry::ToHandle(const_cast<OGRGeometry*>(buildings_[label - 1]))));
            for (const Premises* one : points) {
                if (!building ||
                    !OGRPreparedGeometryIntersects(building.get(), OGRGeometry::ToHandle(one->shape.get())))
                    continue;
                for (const PremisesTag& tag : one->tags) inherit(label, *one, tag);
            }
        }
    }

    // The buildings with cells where a point is: its own cell may have its centre outside the walls.
    std::set<std::uint32_t> labels_around(const OGRPoint& point) const {
        const auto& transform = window_.georeference.transform;
        const double column = std::floor((point.getX() - transform[0]) / transform[1]);
        const double row = std::floor((point.getY() - transform[3]) / transform[5]);
        std::set<std::uint32_t> labels;
        for (const int down : {-1, 0, 1}) {
            for (const int right : {-1, 0, 1}) {
                const double x = column + right;
                const double y = row + down;
                if (!(x >= 0 && y >= 0 && x < window_.width && y < window_.height)) continue;
                const std::uint32_t label = labels_[std::size_t(y) * std::size_t(window_.width) + std::size_t(x)];
                if (inherits(label)) labels.insert(label);
            }
        }
        return labels;
    }

    // The areas with the filter's tag that the window sees, the smallest last; labelled by their places in premises_,
    // from 1.
    std::vector<Paint> areas_with(std::size_t filter) const {
        std::vector<std::pair<double, Paint>> areas;
        for (std::size_t i = 0; i < premises_.size(); ++i) {
            const Premises& one = premises_[i];
            OGREnvelope box;
            one.shape->getEnvelope(&box);
            if (!is_area(one.shape->getGeometryType()) || !window_.window.bounds.Intersects(box) ||
                tag_of(one, filter) == nullptr) {
                continue;
            }
            areas.push_back({area_of(*one.shape), {one.shape.get(), std::uint32_t(i + 1)}});
        }
        std::stable_sort(areas.begin(), areas.end(), [](const auto& a, const auto& b) { return a.first > b.first; });
        std::vector<Paint> paints;
        for (const auto& [area, one] : areas) paints.push_back(one);
        return paints;
    }

    void inherit_from_areas(std::size_t filter) {
        const std::vector<Paint> areas = areas_with(filter);
        if (areas.empty()) return;
        std::vector<std::uint32_t> owners(labels_.size(), 0);
        paint(areas, Cover::centre, window_, owners);
        std::map<std::uint32_t, std::map<std::uint32_t, std::uint32_t>> shares;  // cells by label and owner
        for (std::size_t i = 0; i < owners.size(); ++i) {
            if (owners[i] != 0 && inherits(labels_[i])) ++shares[labels_[i]][owners[i]];
        }
        for (const auto& [label, by_owner] : shares) {
            std::uint64_t all = 0;
            for (const auto& [owner, cells] : by_owner) all += cells;
            if (2 * all <= cells_[label]) continue;
            const auto most = std::max_element(by_owner.begin(), by_owner.end(),
                                               [](const auto& a, const auto& b) { return a.second < b.second; });
            const Premises& from = premises_[most->first - 1];
            inherit(label, from, *tag_of(from, filter));
        }
    }

    static const PremisesTag* tag_of(const Premises& premises, std::size_t filter) {
        const auto tag = std::find_if(premises.tags.begin(), premises.tags.end(),
                                      [&](const auto& one) { return one.filter == filter; });
        return tag == premises.tags.end() ? nullptr : &*tag;
    }

    const std::vector<const OGRGeometry*>& buildings_;
    const std::vector<std::uint32_t>& labels_;
    const CellWindow& window_;
    const std::vector<Premises>& premises_;
    const std::vector<TagFilter>& filters_;
    std::vector<std::uint32_t> cells_;  // of each label
    std::vector<Inheritance> found_;
};

}  // namespace

std::vector<TagFilter> premises_filters(const ObstacleChoice& choice) {
    std::vector<TagFilter> filters;
    for (const TagFilter& tag : choice.premises) {
        if (tag.key == "building") continue;
        if (tag.values.empty()) filters.push_back(tag);
        for (const std::string& value : tag.values) filters.push_back({tag.key, {value}});
    }
    return filters;
}

std::optional<Premises> premises_of(const TagSet& tags, Shape shape, const std::vector<TagFilter>& filters) {
    if (shape == Shape::line) return std::nullopt;
    Premises premises;
    for (std::size_t i = 0; i < filters.size(); ++i) {
        const std::string& key = filters[i].key;
        if (!tags.matches(filters[i]) || (shape == Shape::point && !holds_around_point(key, tags))) continue;
        premises.tags.push_back({i, key, labels::clean_name(*tags.find(key))});
    }
    if (premises.tags.empty()) return std::nullopt;
    const std::string* name = tags.find("name");
    premises.name = labels::clean_name(name ? *name : "");
    return premises;
}

bool any_fits(const std::vector<PremisesTag>& tags, const std::vector<TagFilter>& filters) {
    return std::ranges::any_of(filters, [&](const TagFilter& filter) {
        return std::ranges::any_of(
            tags, [&](const PremisesTag& tag) { return tag.key == filter.key && filter.accepts(tag.value); });
    });
}

std::vector<Inheritance> inherited(const std::vector<const OGRGeometry*>& buildings,
                                   const std::vector<std::uint32_t>& labels, const CellWindow& window,
                                   const std::vector<Premises>& premises, const std::vector<TagFilter>& filters) {
    const geotiff::GdalScope gdal;
    return Heirs(buildings, labels, window, premises, filters).find();
}

}  // namespace waybreaker::city
