#include "geotiff/raster_cells.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string_view>

#include "waybreaker/error.hpp"
#include "waybreaker/grid.hpp"

namespace waybreaker::geotiff {
namespace {

// No practical compression gets more cells into a byte of the file; even the table of a file's empty blocks takes more.
// So a few bytes cannot claim a gigabyte.
constexpr std::size_t most_cells_per_byte = 16384;

// Makes a mask of a raster, whatever its cells are. gdal_translate would round small numbers to 0.
std::string mask_of(std::string_view condition) {
    return fmt::format(R"('gdal_calc.py -A IN.tif --outfile=OUT.tif --type=Byte --calc="{}"')", condition);
}

void require_integers(GDALDataType type, const std::string& name) {
    if (type == GDT_Byte || type == GDT_UInt16 || type == GDT_Int16 || type == GDT_UInt32 || type == GDT_Int32) return;
    const std::string what =
        fmt::format("has cells of type {}, obstacle ids are integers of up to 32 bits", GDALGetDataTypeName(type));
    if (GDALDataTypeIsComplex(type)) throw InputError(name, 0, what);
    if (!GDALDataTypeIsFloating(type)) {
        throw InputError(name, 0,
                         what + "; if its numbers are below 4294967296, 'gdal_translate -ot UInt32' converts it");
    }
    throw InputError(name, 0,
                     fmt::format("{}; to block what is above 0, make a mask with {}, or with \"~(A<=0)\" if what is no "
                                 "number (NaN) is blocked, too",
                                 what, mask_of("A>0")));
}

void require_small_blocks(GDALRasterBand& band, std::size_t cells, const std::string& name) {
    int width = 0;
    int height = 0;
    band.GetBlockSize(&width, &height);
    if (std::size_t(width) * std::size_t(height) <= std::max(4 * cells, std::size_t{4096} * 4096)) return;
    throw InputError(name, 0,
                     fmt::format("is cut into tiles of {} x {} cells, far larger than itself; write it anew with "
                                 "'gdal_translate -co TILED=NO'",
                                 width, height));
}

// Whether a mask, or a band of transparency, says which cells count. The nodata value is looked for among the numbers.
bool is_masked(GDALRasterBand& band) {
    return (band.GetMaskFlags() & GMF_PER_DATASET) != 0;
}

// All values of a band, row by row. Block by block, as GDAL would cache what it has read: as much memory again for a
// large map.
template <class Value>
std::vector<Value> read_band(GDALRasterBand& band, GDALDataType as, const MemoryFile& memory, const std::string& name) {
    const int width = band.GetXSize();
    const int height = band.GetYSize();
    std::vector<Value> values(std::size_t(width) * std::size_t(height));
    const GdalScope gdal;
    int block_width = 0;
    int rows = 0;
    band.GetBlockSize(&block_width, &rows);
    for (int y = 0; y < height; y += rows) {
        rows = std::min(rows, height - y);
        const CPLErr outcome = band.RasterIO(GF_Read, 0, y, width, rows, &values[std::size_t(y) * std::size_t(width)],
                                             width, rows, as, 0, 0, nullptr);
        if (outcome != CE_None || gdal.failed()) {
            throw InputError(name, 0, "is damaged or cut short: " + memory.nameless(gdal.failure()));
        }
        band.FlushCache(false);
    }
    return values;
}

void free_no_data(GDALRasterBand& band, std::vector<std::uint32_t>& labels) {
    int has_no_data = 0;
    const double no_data = band.GetNoDataValue(&has_no_data);
    if (has_no_data && no_data >= std::numeric_limits<std::int32_t>::min() &&
        no_data <= std::numeric_limits<std::uint32_t>::max() && no_data == std::floor(no_data)) {
        const auto no_data_label = std::uint32_t(std::int64_t(no_data));
        std::replace(labels.begin(), labels.end(), no_data_label, 0U);
    }
}

}  // namespace

void require_labels(GDALDataset& file, std::size_t bytes, const std::string& name, std::size_t most_cells) {
    const int bands = file.GetRasterCount();
    const bool transparent = bands == 2 && file.GetRasterBand(2)->GetColorInterpretation() == GCI_AlphaBand;
    if (bands != 1 && !transparent) {
        throw InputError(name, 0,
                         fmt::format("has {} bands, a label map has one; pick one with 'gdal_translate -b 1'", bands));
    }
    GDALRasterBand& band = *file.GetRasterBand(1);
    require_integers(band.GetRasterDataType(), name);
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
    require_small_blocks(band, width * height, name);
    if (is_masked(band)) require_small_blocks(*band.GetMaskBand(), width * height, name);
}

std::vector<std::uint32_t> read_labels(GDALDataset& file, const MemoryFile& memory, const std::string& name) {
    GDALRasterBand& band = *file.GetRasterBand(1);
    const GDALDataType type = band.GetRasterDataType();
    const bool is_signed = type == GDT_Int16 || type == GDT_Int32;
    auto labels = read_band<std::uint32_t>(band, is_signed ? GDT_Int32 : GDT_UInt32, memory, name);
    free_no_data(band, labels);
    if (is_masked(band)) {
        const auto counts = read_band<std::uint8_t>(*band.GetMaskBand(), GDT_Byte, memory, name);
        for (std::size_t i = 0; i < labels.size(); ++i) {
            if (counts[i] == 0) labels[i] = 0;
        }
    }
    const auto negative = std::find_if(labels.begin(), labels.end(), [](std::uint32_t l) { return l >> 31 != 0; });
    if (is_signed && negative != labels.end()) {
        const std::ptrdiff_t at = negative - labels.begin();
        throw InputError(
            name, 0,
            fmt::format("has the negative obstacle id {} at cell {},{}; ids start at 1, 0 is free. If all "
                        "but 0 is blocked, make a mask with {}",
                        std::int32_t(*negative), at % band.GetXSize(), at / band.GetXSize(), mask_of("A!=0")));
    }
    return labels;
}

}  // namespace waybreaker::geotiff
