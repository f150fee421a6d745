#include "laws.hpp"
#include "waybreaker/movingai.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    waybreaker::read_or_refuse(data, size, [](std::string_view bytes) {
        const waybreaker::Grid grid = waybreaker::read_movingai_map(bytes, "input");
        waybreaker::law(grid.cell_count() < bytes.size());  // no memory is allocated for cells that are not in the file
    });
    return 0;
}
