#include "geotiff/label_tiff.hpp"

#include <fmt/format.h>
#include <gdal_frmts.h>
#include <gdal_priv.h>

#include <algorithm>
#include <limits>
#include <optional>
#include <utility>

#include "geotiff/background_item.hpp"
#include "geotiff/gdal_scope.hpp"
#include "geotiff/hex_zlib.hpp"
#include "geotiff/raster_cells.hpp"
#include "geotiff/raster_place.hpp"
#include "labels/kinds_item.hpp"
#include "labels/label_map.hpp"
#include "labels/notes_item.hpp"
#include "labels/obstacle_metadata.hpp"
#include "labels/obstacle_names.hpp"
#include "labels/sections_item.hpp"
#include "labels/tags_item.hpp"
#include "waybreaker/error.hpp"

namespace waybreaker::geotiff {
namespace {

std::string metadata(GDALDataset& file, const char* item) {
    const char* text = file.GetMetadataItem(item);
    return text ? text : "";
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
    const int width = file->GetRasterXSize();
    const int height = file->GetRasterYSize();
    const auto transform = place.georeference ? std::optional(place.georeference->transform) : std::nullopt;
    labels::LabelRaster raster = labels::read_items([&](const char* item) { return metadata(*file, item); }, width,
                                                    height, transform, inflated, name);
    raster.annotations.background = read_background(*file, place, width, height, name);
    raster.layer.labels = read_labels(*file, memory, name);
    labels::LabelMap read = labels::label_map(std::move(raster), connectivity, limits);
    return {.map = std::move(read.described.map),
            .cell_size = place.cell_size,
            .georeference = std::move(place.georeference),
            .origin = place.origin,
            .annotations = std::move(read.described.annotations),
            .mask = read.mask};
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

    write_place(*file, {tiff.cell_size, tiff.georeference, tiff.origin});
    file->SetMetadataItem("TIFFTAG_SOFTWARE", "waybreaker");
    const auto set = [&](const char* item, const std::string& text) {
        if (!text.empty()) file->SetMetadataItem(item, text.c_str());
    };
    const site::Annotations& known = tiff.annotations;
    set(labels::title_item, known.title);
    set(labels::attribution_item, known.attribution);
    if (known.profile) set(labels::profile_item, std::string(site::profile_word(*known.profile)));
    set(labels::notes_item, labels::notes_text(known.notes));
    for (const auto& [item, text] : labels::obstacle_metadata(tiff.map)) set(item, text);
    set(labels::names_item, labels::names_text(known.names));
    set(labels::kinds_item, labels::kinds_text(known.kinds));
    set(labels::tags_item, labels::tags_text(known.tags));
    set(labels::sections_item, labels::sections_text(known.sections));
    if (tiff.georeference) {
        set(background_item, background_text(known.background, *tiff.georeference));
        const auto set_cells = [&](const char* item, const std::vector<site::CellRun>& runs) {
            set(item, labels::cells_text(runs, tiff.georeference->transform, deflated));
        };
        set_cells(labels::bridges_item, known.bridges);
        set_cells(labels::ways_item, known.ways);
        set_cells(labels::unknown_item, known.unknown);
    }

    auto* ids = const_cast<std::uint32_t*>(tiff.map.labels().data());  // GDAL only reads it
    const CPLErr outcome =
        file->GetRasterBand(1)->RasterIO(GF_Write, 0, 0, width, height, ids, width, height, GDT_UInt32, 0, 0, nullptr);
    file.reset();
    if (outcome != CE_None || gdal.failed()) throw InputError("cannot make a GeoTIFF: " + gdal.failure());
    return memory.bytes();
}

}  // namespace waybreaker::geotiff
