#include "io/plan_file.hpp"

#include "laws.hpp"
#include "waybreaker/check.hpp"

// What is read can be judged, on any map.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    static const waybreaker::Map map =
        waybreaker::Map::from_labels(6, 4, {0, 0, 1, 0, 0, 0, 0, 0, 1, 1, 0, 0, 0, 0, 0, 0, 2, 0, 3, 0, 0, 0, 2, 0});
    waybreaker::read_or_refuse(data, size, [](std::string_view bytes) {
        const waybreaker::io::PlanFile file = waybreaker::io::parse_plan(bytes, "input");
        waybreaker::law(file.plan.breaches.size() < bytes.size() && file.plan.agents.size() < bytes.size());
        for (const waybreaker::Violation& violation : waybreaker::check(map, file.asked.mission, file.plan)) {
            waybreaker::law(!violation.message.empty());
            for (const char c : violation.message) waybreaker::law(static_cast<unsigned char>(c) >= ' ');
        }
    });
    return 0;
}
