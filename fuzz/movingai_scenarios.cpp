#include <cmath>

#include "laws.hpp"
#include "waybreaker/movingai.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    waybreaker::read_or_refuse(data, size, [](std::string_view bytes) {
        for (const waybreaker::Scenario& s : waybreaker::read_movingai_scenarios(bytes, "input")) {
            for (const waybreaker::Cell c : {s.start, s.goal}) {
                waybreaker::law(c.x >= 0 && c.y >= 0 && c.x < s.width && c.y < s.height);
            }
            waybreaker::law(s.optimal_length >= 0 && std::isfinite(s.optimal_length));
        }
    });
    return 0;
}
