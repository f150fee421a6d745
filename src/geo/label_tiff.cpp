#include "geo/label_tiff.hpp"

#include <fmt/format.h>
#include <gdal_frmts.h>
#include <gdal_priv.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "geo/background_item.hpp"
#include "geo/gdal_scope.hpp"
#include "geo/kinds_item.hpp"
#include "geo/obstacle_metadata.hpp"
#include "geo/sections_item.hpp"
#include "geo/tags_item.hpp"
#include "site/described_map.hpp"
#include "waybreaker/error.hpp"

namespace waybreaker::geo {
namespace {

constexpr const char* title_item = "TIFFTAG_IMAGEDESCRIPTION";
constexpr const char* attribution_item = "TIFFTAG_COPYRIGHT";

// No practical compression gets more cells into a byte of the file; even the table of a file's empty blocks takes more.
// So a few bytes cannot claim a gigabyte.
constexpr std::size_t most_cells_per_byte = 16384;

// Cells may deviate from squares by this share of their side.
constexpr double square_tolerance = 1e-3;

std::string metadata(GDALDataset& file, const char* item) {
    const char* text = file.GetMetadataItem(item);
    return text ? text : "";
}

// Reads only the header, so that nothing large is allocated for a map that is refused.
void check_layout(GDALDataset& file, std::size_t bytes, const std::string& name, std::size_t most_cells) {
    if (file.GetRasterCount() != 1) {
        throw InputError(name, 0,
                         fmt::format("has {} bands, a label map has one; pick one with 'gdal_translate -b 1'",
                                     file.GetRasterCount()));
    }
    GDALRasterBand& band = *file.GetRasterBand(1);
    const GDALDataType type = band.GetRasterDataType();
    const bool fits =
        type == GDT_Byte || type == GDT_UInt16 || type == GDT_Int16 || type == GDT_UInt32 || type == GDT_Int32;
    if (!fits) {
        throw InputError(name, 0,
                         fmt::format("has cells of type {}, obstacle ids are integers of up to 32 bits; convert it "
                                     "with 'gdal_translate -ot UInt32'",
                                     GDALGetDataTypeName(type)));
    }
    const auto width = std::size_t(band.GetXSize());
    const auto height = std::size_t(band.GetYSize());
    if (width > max_side || height > max_side || width * height > most_cells) {
        throw SizeError(
            fmt::format("{}: has {} x {} cells; a map has sides of at most {} and at most {} cells in all: "
                        "cut a piece out with 'gdal_translate -srcwin'",
                        name, width, height, max_side, most_cells));
    }
    if (width * height > most_cells_per_byte * bytes) {
        throw InputError(
            name, 0, fmt::format("is damaged or cut short: {} bytes cannot hold {} x {} cells", bytes, width, height));
    }
    int block_width = 0;
    int block_height = 0;
    band.GetBlockSize(&block_width, &block_height);
    const std::size_t block = std::size_t(block_width) * std::size_t(block_height);
    if (block > std::max(4 * width * height, std::size_t{4096} * 4096)) {
        throw InputError(name, 0,
                         fmt::format("is cut into tiles of {} x {} cells, far larger than itself; write it anew with "
                                     "'gdal_translate -co TILED=NO'",
                                     block_width, block_height));
    }
}

// The ids of all cells, row by row; cells without data are free.
std::vector<std::uint32_t> read_labels(GDALDataset& file, const MemoryFile& memory, const std::string& name) {
    GDALRasterBand& band = *file.GetRasterBand(1);
    const int width = band.GetXSize();
    const int height = band.GetYSize();
    const GDALDataType type = band.GetRasterDataType();
    const bool is_signed = type == GDT_Int16 || type == GDT_Int32;
    std::vector<std::uint32_t> labels(std::size_t(width) * std::size_t(height));
    const GdalScope gdal;
    int block_width = 0;
    int rows = 0;
    band.GetBlockSize(&block_width, &rows);
    // Block by block, as GDAL would cache what it has read: as much memory again for a large map.
    for (int y = 0; y < height; y += rows) {
        rows = std::min(rows, height - y);
        const CPLErr outcome = band.RasterIO(GF_Read, 0, y, width, rows, &labels[std::size_t(y) * std::size_t(width)],
                                             width, rows, is_signed ? GDT_Int32 : GDT_UInt32, 0, 0, nullptr);
        if (outcome != CE_None || gdal.failed()) {
            throw InputError(name, 0, "is damaged or cut short: " + memory.nameless(gdal.failure()));
        }
        band.FlushCache(false);
    }

    int has_no_data = 0;
    const double no_data = band.GetNoDataValue(&has_no_data);
    if (has_no_data && no_data >= std::numeric_limits<std::int32_t>::min() &&
        no_data <= std::numeric_limits<std::uint32_t>::max() && no_data == std::floor(no_data)) {
        const auto no_data_label = std::uint32_t(std::int64_t(no_data));
        std::replace(labels.begin(), labels.end(), no_data_label, 0U);
    }
    const auto negative = std::find_if(labels.begin(), labels.end(), [](std::uint32_t l) { return l >> 31 != 0; });
    if (is_signed && negative != labels.end()) {
        const std::ptrdiff_t at = negative - labels.begin();
        throw InputError(name, 0,
                         fmt::format("has the negative obstacle id {} at cell {},{}; ids start at 1, 0 is free",
                                     std::int32_t(*negative), at % width, at / width));
    }
    return labels;
}

// Whether all labels other than 0 are equal.
bool has_one_value(const std::vector<std::uint32_t>& labels) {
    const auto first = std::find_if(labels.begin(), labels.end(), [](std::uint32_t l) { return l != 0; });
    return std::all_of(first, labels.end(), [&](std::uint32_t l) { return l == 0 || l == *first; });
}

Grid grid_of(int width, int height, const std::vector<std::uint32_t>& labels) {
    Grid grid(width, height);
    const std::uint32_t* label = labels.data();
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x, ++label) {
            if (*label != 0) grid.set_blocked({x, y}, true);
        }
    }
    return grid;
}

// Cell size in metres, and where the map lies if the file knows its coordinate system.
struct Place {
    double cell_size = 1;
    std::optional<site::Georeference> georeference;
    std::optional<std::array<double, 2>> origin;
};

// To a nanometre: the file holds the upper-left corner, and the way from there and back rounds.
double as_written(double metres) {
    constexpr double nanometres = 1e9;
    constexpr double most = 1e6;  // beyond, a number has no nanometres
    return std::abs(metres) < most ? std::round(metres * nanometres) / nanometres + 0.0 : metres;
}

Place read_place(GDALDataset& file, const std::string& name) {
    Place place;
    std::array<double, 6> transform{};
    if (file.GetGeoTransform(transform.data()) != CE_None) return place;
    const auto [west, cell_x, skew_x, north, skew_y, cell_y] = transform;
    if (!std::all_of(transform.begin(), transform.end(), [](double t) { return std::isfinite(t); })) {
        throw InputError(name, 0, "has a georeference that is not a number; give it one with 'gdal_edit.py -a_ullr'");
    }
    if (skew_x != 0 || skew_y != 0 || !(cell_x > 0) || !(cell_y < 0)) {
        throw InputError(name, 0, "is rotated or not north-up; straighten it with 'gdalwarp -r near'");
    }
    if (!(std::abs(cell_x + cell_y) <= square_tolerance * cell_x)) {
        throw InputError(
            name, 0,
            fmt::format("has cells of {:.6g} x {:.6g}, cells must be square; resample it with 'gdalwarp -r near -tr'",
                        cell_x, -cell_y));
    }
    place.cell_size = cell_x;
    const OGRSpatialReference* system = file.GetSpatialRef();
    if (system == nullptr) {
        const double south = north + file.GetRasterYSize() * cell_y;
        if (std::isfinite(south)) place.origin = {as_written(west), as_written(south)};
        return place;
    }
    if (system->IsGeographic()) {
        throw InputError(name, 0,
                         "has cells in degrees, which are not square on the ground; project it with "
                         "'gdalwarp -r near -t_srs EPSG:326ZZ', ZZ being its UTM zone");
    }
    place.cell_size = cell_x * system->GetLinearUnits();
    char* text = nullptr;
    system->exportToWkt(&text);
    place.georeference = site::Georeference{text ? text : "", transform};
    CPLFree(text);
    return place;
}

// A map without a georeference cannot have a background.
site::Background read_background(GDALDataset& file, const Place& place, int width, int height,
                                 const std::string& name) {
    const std::string text = metadata(file, background_item);
    return text.empty() || !place.georeference ? site::Background{}
                                               : parse_background(text, *place.georeference, width, height, name);
}

GDALDriver& tiff_driver() {
    GDALRegister_GTiff();
    return *GetGDALDriverManager()->GetDriverByName("GTiff");
}

}  // namespace

LabelTiff read_label_tiff(std::string_view bytes, const std::string& name, Connectivity connectivity,
                          const MapLimits& limits) {
    tiff_driver();
    const GdalScope gdal;
    const MemoryFile memory(bytes);
    const char* const only_tiff[] = {"GTiff", nullptr};
    const GDALDatasetUniquePtr file(GDALDataset::Open(memory.path().c_str(), GDAL_OF_RASTER, only_tiff));
    if (!file) throw InputError(name, 0, "is no GeoTIFF map: " + memory.nameless(gdal.failure()));
    check_layout(*file, bytes.size(), name, limits.cells);
    Place place = read_place(*file, name);
    const std::vector<ObstacleAttributes> attributes = read_obstacle_metadata(*file, name);
    site::LabelLayer layer{.width = file->GetRasterXSize(),
                           .height = file->GetRasterYSize(),
                           .attributes = attributes,
                           .names = read_names(*file, name),
                           .kinds = read_kinds(*file, name),
                           .tags = read_tags(*file, name)};
    read_sections(*file, name, layer);
    const int width = layer.width;
    const int height = layer.height;
    site::Background background = read_background(*file, place, width, height, name);
    layer.labels = read_labels(*file, memory, name);
    const std::vector<std::uint32_t>& labels = layer.labels;
    const bool mask = attributes.size() == 1 && has_one_value(labels);
    if (limits.admit) {
        limits.admit(
            map_bytes(width, height,
                      mask ? count_obstacles(grid_of(width, height, labels), connectivity) : count_labels(labels)));
    }
    site::DescribedMap described = mask ? site::DescribedMap{Map(grid_of(width, height, labels), connectivity)}
                                        : site::described(std::move(layer));
    LabelTiff tiff{.map = std::move(described.map),
                   .cell_size = place.cell_size,
                   .georeference = std::move(place.georeference),
                   .origin = place.origin,
                   .attribution = metadata(*file, attribution_item),
                   .title = metadata(*file, title_item),
                   .names = std::move(described.names),
                   .background = std::move(background),
                   .kinds = std::move(described.kinds),
                   .tags = std::move(described.tags),
                   .sections = std::move(described.sections),
                   .mask = mask};
    return tiff;
}

std::string label_tiff_bytes(const LabelTiff& tiff) {
    GDALDriver& driver = tiff_driver();
    const GdalScope gdal;
    const MemoryFile memory;
    const int width = tiff.map.width();
    const int height = tiff.map.height();
    const bool short_ids = tiff.map.obstacles().size() <= std::numeric_limits<std::uint16_t>::max();
    // Level 9 makes a city map a seventh smaller, but takes minutes on the largest maps.
    const bool small = tiff.map.grid().cell_count() <= std::size_t{4096} * 4096;
    // Long strips compress better; a million cells a strip keeps a reader's buffers small.
    CPLStringList options;
    options.SetNameValue("COMPRESS", "DEFLATE");
    options.SetNameValue("ZLEVEL", small ? "9" : "6");
    options.SetNameValue("PREDICTOR", "2");
    options.SetNameValue("BLOCKYSIZE", std::to_string(std::clamp((1 << 20) / width, 1, height)).c_str());
    GDALDatasetUniquePtr file(
        driver.Create(memory.path().c_str(), width, height, 1, short_ids ? GDT_UInt16 : GDT_UInt32, options.List()));
    if (!file) throw InputError("cannot make a GeoTIFF: " + gdal.failure());

    const auto [west, south] = tiff.origin.value_or(std::array<double, 2>{});
    std::array<double, 6> transform{west, tiff.cell_size, 0, south + height * tiff.cell_size, 0, -tiff.cell_size};
    if (tiff.georeference) {
        transform = tiff.georeference->transform;
        const OGRSpatialReference system(tiff.georeference->crs.c_str());
        file->SetSpatialRef(&system);
    }
    file->SetGeoTransform(transform.data());
    file->SetMetadataItem("TIFFTAG_SOFTWARE", "waybreaker");
    const auto set = [&](const char* item, const std::string& text) {
        if (!text.empty()) file->SetMetadataItem(item, text.c_str());
    };
    set(title_item, tiff.title);
    set(attribution_item, tiff.attribution);
    for (const auto& [item, text] : obstacle_metadata(tiff.map)) set(item, text);
    set(names_item, names_text(tiff.names));
    set(kinds_item, kinds_text(tiff.kinds));
    set(tags_item, tags_text(tiff.tags));
    set(sections_item, sections_text(tiff.sections));
    if (tiff.georeference) set(background_item, background_text(tiff.background, *tiff.georeference));

    auto* labels = const_cast<std::uint32_t*>(tiff.map.labels().data());  // GDAL only reads it
    const CPLErr outcome = file->GetRasterBand(1)->RasterIO(GF_Write, 0, 0, width, height, labels, width, height,
                                                            GDT_UInt32, 0, 0, nullptr);
    file.reset();
    if (outcome != CE_None || gdal.failed()) throw InputError("cannot make a GeoTIFF: " + gdal.failure());
    return memory.bytes();
}

}  // namespace waybreaker::geo
