#include "request/plan_request.hpp"

#include "laws.hpp"
#include "mapfile/map_reader.hpp"

// What is read can be put on a map, or is refused there in one line.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace waybreaker;
    static const io::MapFile map = mapfile::parse_map("type octile\nheight 2\nwidth 5\nmap\n.@.@@\n.....\n", "map");
    read_or_refuse(data, size, [](std::string_view bytes) {
        const request::PlanRequest request = request::parse_plan_request(bytes, "input");
        law(request.variants.size() <= bytes.size() &&
            request.options.asked.mission.rules.protect.size() <= bytes.size());
        try {
            const io::MissionDocument asked = request::on_map(request.mission, request.options, map).asked;
            validate(map.map, asked.mission, asked.method, asked.limits);
        } catch (const InputError& error) {
            for (const char c : std::string_view(error.what())) law(static_cast<unsigned char>(c) >= ' ');
        }
    });
    return 0;
}
