#include "geotiff/label_tiff.hpp"

#include <fmt/format.h>
#include <gdal_frmts.h>
#include <gdal_priv.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "geotiff/background_item.hpp"
#include "geotiff/cells_item.hpp"
#include "geotiff/gdal_scope.hpp"
#include "geotiff/kinds_item.hpp"
#include "geotiff/notes_item.hpp"
#include "geotiff/obstacle_metadata.hpp"
#include "geotiff/raster_cells.hpp"
#include "geotiff/raster_place.hpp"
#include "geotiff/sections_item.hpp"
#include "geotiff/tags_item.hpp"
#include "site/described_map.hpp"
#include "waybreaker/error.hpp"

namespace waybreaker::geotiff {
namespace {

constexpr const char* title_item = "TIFFTAG_IMAGEDESCRIPTION";
constexpr const char* attribution_item = "TIFFTAG_COPYRIGHT";
constexpr const char* profile_item = "WAYBREAKER_PROFILE";

std::string metadata(GDALDataset& file, const char* item) {
    const char* text = file.GetMetadataItem(item);
    return text ? text : "";
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

// A map without a georeference cannot have a background.
site::Background read_background(GDALDataset& file, const RasterPlace& place, int width, int height,
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
    require_labels(*file, bytes.size(), name, limits.cells);
    RasterPlace place = read_place(*file, name);
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
    site::Annotations annotations{.title = metadata(*file, title_item),
                                  .profile = site::profile_called(metadata(*file, profile_item)),
                                  .attribution = metadata(*file, attribution_item),
                                  .notes = read_notes(*file),
                                  .background = read_background(*file, place, width, height, name)};
    if (place.georeference) {
        const auto cells_of = [&](const char* item) {
            return read_cells(*file, item, place.georeference->transform, width, height, name);
        };
        annotations.bridges = cells_of(bridges_item);
        annotations.ways = cells_of(ways_item);
        annotations.unknown = cells_of(unknown_item);
    }
    layer.labels = read_labels(*file, memory, name);
    const std::vector<std::uint32_t>& labels = layer.labels;
    const bool mask = attributes.size() == 1 && has_one_value(labels);
    if (limits.admit) {
        limits.admit(
            map_bytes(width, height,
                      mask ? count_obstacles(grid_of(width, height, labels), connectivity) : count_labels(labels)));
    }
    site::DescribedMap described =
        mask ? site::DescribedMap{Map(grid_of(width, height, labels), connectivity), std::move(annotations)}
             : site::described(std::move(layer), std::move(annotations));
    return {.map = std::move(described.map),
            .cell_size = place.cell_size,
            .georeference = std::move(place.georeference),
            .origin = place.origin,
            .annotations = std::move(described.annotations),
            .mask = mask};
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
    const site::Annotations& known = tiff.annotations;
    set(title_item, known.title);
    set(attribution_item, known.attribution);
    if (known.profile) set(profile_item, std::string(site::profile_word(*known.profile)));
    set(notes_item, notes_text(known.notes));
    for (const auto& [item, text] : obstacle_metadata(tiff.map)) set(item, text);
    set(names_item, names_text(known.names));
    set(kinds_item, kinds_text(known.kinds));
    set(tags_item, tags_text(known.tags));
    set(sections_item, sections_text(known.sections));
    if (tiff.georeference) {
        set(background_item, background_text(known.background, *tiff.georeference));
        const auto set_cells = [&](const char* item, const std::vector<site::CellRun>& runs) {
            set(item, cells_text(runs, tiff.georeference->transform));
        };
        set_cells(bridges_item, known.bridges);
        set_cells(ways_item, known.ways);
        set_cells(unknown_item, known.unknown);
    }

    auto* labels = const_cast<std::uint32_t*>(tiff.map.labels().data());  // GDAL only reads it
    const CPLErr outcome = file->GetRasterBand(1)->RasterIO(GF_Write, 0, 0, width, height, labels, width, height,
                                                            GDT_UInt32, 0, 0, nullptr);
    file.reset();
    if (outcome != CE_None || gdal.failed()) throw InputError("cannot make a GeoTIFF: " + gdal.failure());
    return memory.bytes();
}

}  // namespace waybreaker::geotiff
