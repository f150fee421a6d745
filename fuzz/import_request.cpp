#include "service/import_request.hpp"

#include <cmath>

#include "laws.hpp"

// What is read names a source and a window in degrees and metres, or is refused in one line.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace waybreaker;
    read_or_refuse(data, size, [](std::string_view bytes) {
        const service::ImportRequest request = service::parse_import_request(bytes, "input");
        const city::ImportOptions& options = request.options;
        law(std::abs(options.longitude) <= 180 && std::abs(options.latitude) <= 180);
        law(options.size > 0 && options.cell > 0 && std::isfinite(options.size) && std::isfinite(options.cell));
        law(options.section.value_or(0) >= 0);
        law(request.placed || !options.box);
        try {
            const auto [columns, rows] = city::import_cells(options);
            law(columns >= 1 && rows >= 1);
        } catch (const InputError& error) {
            for (const char c : std::string_view(error.what())) law(static_cast<unsigned char>(c) >= ' ');
        }
    });
    return 0;
}
