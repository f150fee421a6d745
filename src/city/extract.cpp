#include "city/extract.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string_view>

#include "city/city_import.hpp"
#include "city/features.hpp"
#include "city/footprints.hpp"
#include "city/vector_source.hpp"
#include "labels/obstacle_names.hpp"

namespace waybreaker::city {
namespace {

constexpr double metres_per_degree = 111'320;  // of latitude; good enough to choose by
constexpr int drawn_parts = 64;                // of the longer side, to draw
constexpr int most_bins = 1024;                // of a side, to find the densest square
constexpr double least_bin = 60;               // metres

struct Spot {
    double longitude;
    double latitude;
    double area;  // square degrees
};

struct Finds {
    OGREnvelope stated;
    std::vector<Spot> spots;
    std::vector<NamedPlace> places;
};

// The most important first.
constexpr std::array<std::string_view, 6> place_kinds{"city", "town", "borough", "suburb", "village", "quarter"};

std::vector<NamedPlace> find_places(const std::string& source) {
    constexpr std::size_t most = 40;
    std::array<std::vector<NamedPlace>, place_kinds.size()> found;
    FeatureQuery query;
    query.system.SetWellKnownGeogCS("WGS84");
    query.points = {{.key = "place"}};
    visit_features(source, query, [&found](const Feature& feature) {
        const std::string* const kind = feature.tags.find("place");
        const std::string* const name = feature.tags.find("name");
        if (!kind || !name || !feature.geometry || feature.shape != site::Background::Shape::point) return;
        const auto* const rank = std::ranges::find(place_kinds, *kind);
        const std::string clean = labels::clean_name(*name);
        if (rank == place_kinds.end() || clean.empty()) return;
        const OGRPoint* const point = feature.geometry->toPoint();
        found[std::size_t(rank - place_kinds.begin())].push_back({clean, {point->getX(), point->getY()}});
    });
    std::vector<NamedPlace> places;
    for (const auto& of_kind : found) places.insert(places.end(), of_kind.begin(), of_kind.end());
    places.resize(std::min(places.size(), most));
    return places;
}

Finds find_all(const std::string& source) {
    Finds finds{.stated = {}, .spots = {}, .places = find_places(source)};
    finds.stated = visit_buildings(source, [&finds, &source](const OGRGeometry& outline) {
        OGREnvelope box;
        outline.getEnvelope(&box);
        require_degrees(box, source);
        const double area = OGR_G_Area(OGRGeometry::ToHandle(const_cast<OGRGeometry*>(&outline)));
        finds.spots.push_back({(box.MinX + box.MaxX) / 2, (box.MinY + box.MaxY) / 2, area});
    });
    return finds;
}

OGREnvelope bounds_of(const Finds& finds) {
    if (finds.stated.IsInit()) return finds.stated;
    OGREnvelope box;
    for (const Spot& spot : finds.spots) box.Merge(spot.longitude, spot.latitude);
    return box;
}

// Metres of the box, along its middle.
struct SizeInMetres {
    double width;
    double height;
};

double metres_per_longitude(const OGREnvelope& box) {
    return metres_per_degree * std::cos((box.MinY + box.MaxY) / 2 * std::numbers::pi / 180);
}

SizeInMetres extent_of(const OGREnvelope& box) {
    return {(box.MaxX - box.MinX) * metres_per_longitude(box), (box.MaxY - box.MinY) * metres_per_degree};
}

int parts_of(double side, double longer, int most) {
    return std::clamp(int(std::ceil(most * side / longer)), 1, most);
}

// The share of each part of the box that is built up, row by row from the north-western one.
std::vector<double> shares(const std::vector<Spot>& spots, const OGREnvelope& box, int columns, int rows) {
    std::vector<double> areas(std::size_t(columns) * std::size_t(rows), 0);
    const double width = (box.MaxX - box.MinX) / columns;
    const double height = (box.MaxY - box.MinY) / rows;
    for (const Spot& spot : spots) {
        const double column = width > 0 ? std::floor((spot.longitude - box.MinX) / width) : 0;
        const double row = height > 0 ? std::floor((box.MaxY - spot.latitude) / height) : 0;
        if (!(column >= 0 && column <= columns && row >= 0 && row <= rows)) continue;
        const int x = std::min(int(column), columns - 1);
        const int y = std::min(int(row), rows - 1);
        areas[std::size_t(y) * std::size_t(columns) + std::size_t(x)] += spot.area;
    }
    for (double& area : areas) area = std::min(width > 0 && height > 0 ? area / (width * height) : 1, 1.0);
    return areas;
}

// The upper-left part of the square of that many parts with the largest sum; of several the first.
std::array<int, 2> best_square(const std::vector<double>& values, int columns, int rows, int across, int down) {
    const std::size_t line = std::size_t(columns) + 1;
    std::vector<double> sums(line * (std::size_t(rows) + 1), 0);  // of all above and to the left
    for (int y = 0; y < rows; ++y) {
        for (int x = 0; x < columns; ++x) {
            const std::size_t at = (std::size_t(y) + 1) * line + std::size_t(x) + 1;
            const double value = values[std::size_t(y) * std::size_t(columns) + std::size_t(x)];
            sums[at] = value + sums[at - 1] + sums[at - line] - sums[at - line - 1];
        }
    }
    std::array<int, 2> best{0, 0};
    double most = -1;
    for (int y = 0; y + down <= rows; ++y) {
        for (int x = 0; x + across <= columns; ++x) {
            const std::size_t top = std::size_t(y) * line + std::size_t(x);
            const std::size_t bottom = top + std::size_t(down) * line;
            const double sum =
                sums[bottom + std::size_t(across)] - sums[bottom] - sums[top + std::size_t(across)] + sums[top];
            if (sum > most + 1e-9) {  // sums differ in their last digits
                most = sum;
                best = {x, y};
            }
        }
    }
    return best;
}

void find_densest(const std::vector<Spot>& spots, const OGREnvelope& box, Extract& extract) {
    const auto [width, height] = extent_of(box);
    const double least_side = 10;  // metres; a single building is an extract, too
    extract.side = std::max(std::floor(10 * std::min({ImportOptions().size, width, height})) / 10, least_side);
    const double longer = std::max({width, height, least_side});
    const int most = std::clamp(int(longer / least_bin), 1, most_bins);
    const int columns = parts_of(width, longer, most);
    const int rows = parts_of(height, longer, most);
    // How many of so many parts of a length the square takes; a single point has no length.
    const auto taken = [side = extract.side](double length, int count) {
        return int(std::clamp(std::round(side / std::max(length / count, 1e-9)), 1.0, double(count)));
    };
    const int across = taken(width, columns);
    const int down = taken(height, rows);
    const auto [x, y] = best_square(shares(spots, box, columns, rows), columns, rows, across, down);
    // The middle of those parts, to a metre, from which the square does not reach beyond the data.
    const auto middle = [&](double low, double high, double at, double length) {
        const double half = 0.5 * extract.side / std::max(length, extract.side);
        return std::round((low + (high - low) * std::clamp(at, half, 1 - half)) * 1e5) / 1e5;
    };
    extract.densest = {middle(box.MinX, box.MaxX, (x + across / 2.0) / columns, width),
                       middle(box.MinY, box.MaxY, 1 - (y + down / 2.0) / rows, height)};
}

}  // namespace

Extract read_extract(const std::string& source) {
    const Finds finds = find_all(source);
    if (finds.spots.empty()) throw refusal(source, "has no buildings");
    const OGREnvelope box = bounds_of(finds);
    require_degrees(box, source);
    const auto rounded = [](double degrees) { return std::round(degrees * 1e7) / 1e7; };  // as OpenStreetMap has them
    Extract extract{.bounds = {rounded(box.MinX), rounded(box.MinY), rounded(box.MaxX), rounded(box.MaxY)},
                    .buildings = finds.spots.size()};
    const auto [width, height] = extent_of(box);
    const double longer = std::max({width, height, 1e-9});
    extract.columns = parts_of(width, longer, drawn_parts);
    extract.rows = parts_of(height, longer, drawn_parts);
    extract.built = shares(finds.spots, box, extract.columns, extract.rows);
    for (double& share : extract.built) share = std::round(share * 100) / 100;
    find_densest(finds.spots, box, extract);
    extract.places = finds.places;
    return extract;
}

}  // namespace waybreaker::city
