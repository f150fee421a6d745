#include "io/map_file.hpp"

#include <chrono>
#include <filesystem>
#include <string_view>
#include <utility>

#include "io/digest.hpp"
#include "io/output_file.hpp"
#include "waybreaker/error.hpp"
#include "waybreaker/movingai.hpp"

namespace waybreaker::io {
namespace {

using namespace std::string_view_literals;

// TIFF and BigTIFF, in either byte order.
bool is_tiff(std::string_view bytes) {
    return bytes.starts_with("II*\0"sv) || bytes.starts_with("MM\0*"sv) || bytes.starts_with("II+\0"sv) ||
           bytes.starts_with("MM\0+"sv);
}

bool is_xml(std::string_view bytes) {
    constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";
    if (bytes.starts_with(byte_order_mark)) bytes.remove_prefix(byte_order_mark.size());
    const std::size_t first = bytes.find_first_not_of(" \t\r\n");
    return first != std::string_view::npos && bytes[first] == '<';
}

// The map and how long it took to make it.
template <class MakeMap>
std::pair<Map, double> timed(MakeMap make_map) {
    const auto start = std::chrono::steady_clock::now();
    Map map = make_map();
    const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
    return {std::move(map), seconds.count()};
}

}  // namespace

MapFile read_map_file(const std::string& path, Connectivity connectivity) {
    std::string bytes = read_whole(path);
    std::string source = std::filesystem::path(path).filename().string();
    std::string digest = sha256_digest(bytes);
    // Labels and pictures need their memory; the file's bytes go before.
    const auto label = [&](Grid grid) {
        std::string().swap(bytes);
        return timed([&] { return Map(std::move(grid), connectivity); });
    };
    if (is_tiff(bytes)) {
        auto tiff = geo::read_label_tiff(bytes, path);
        return {.map = std::move(tiff.map),
                .source = std::move(source),
                .format = "GeoTIFF label map",
                .digest = std::move(digest),
                .cell_size = tiff.cell_size,
                .label_seconds = 0,  // the labels came with the file
                .georeference = std::move(tiff.georeference),
                .attribution = std::move(tiff.attribution),
                .title = std::move(tiff.title),
                .task = std::nullopt};
    }
    if (is_xml(bytes)) {
        AuthorsXml xml = parse_authors_xml(bytes, path);
        auto [map, seconds] = label(std::move(xml.grid));
        return {.map = std::move(map),
                .source = std::move(source),
                .format = "authors' XML",
                .digest = std::move(digest),
                .cell_size = xml.task.cell_size,
                .label_seconds = seconds,
                .georeference = std::nullopt,
                .attribution = {},
                .title = xml.task.title,
                .task = std::move(xml.task)};
    }
    if (!bytes.starts_with("type")) {
        throw InputError(path, 0,
                         "not a map that can be read: give a MovingAI map (its first line is 'type octile'), a task in "
                         "the authors' XML or a GeoTIFF label map");
    }
    auto [map, seconds] = label(read_movingai_map(std::string_view(bytes), path));
    return {.map = std::move(map),
            .source = std::move(source),
            .format = "MovingAI map",
            .digest = std::move(digest),
            .cell_size = 1,
            .label_seconds = seconds,
            .georeference = std::nullopt,
            .attribution = {},
            .title = {},
            .task = std::nullopt};
}

}  // namespace waybreaker::io
