#include "authors/authors_xml.hpp"

#include "authors/agents_xml.hpp"
#include "laws.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    waybreaker::read_or_refuse(data, size, [](std::string_view bytes) {
        waybreaker::law(!waybreaker::authors::parse_agents_xml(bytes, "input").agents.empty());
    });
    waybreaker::read_or_refuse(data, size, [](std::string_view bytes) {
        const auto [grid, title, cell_size, task] = waybreaker::authors::parse_authors_xml(bytes, "input");
        waybreaker::law(grid.cell_count() < bytes.size());  // no memory is allocated for cells that are not in the file
        waybreaker::law(!task.start || grid.contains(*task.start));
        waybreaker::law(!task.goal || grid.contains(*task.goal));
        waybreaker::law(task.agents.size() <= waybreaker::most_agents && (task.agents.empty() || !task.start));
        waybreaker::law(cell_size > 0 && task.search.weight >= 1);
    });
    return 0;
}
