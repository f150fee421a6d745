#include "io/mission_json.hpp"
#include "laws.hpp"

// What is read comes back from what is written of it, and can be put on a map, or is refused there in one line.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace waybreaker;
    static const Map map = Map::from_labels(6, 2, {0, 0, 1, 0, 2, 0, 0, 0, 1, 0, 0, 0});
    read_or_refuse(data, size, [](std::string_view bytes) {
        const io::MissionDocument read = io::parse_mission(bytes, "input");
        const std::string text = io::mission_text(read);
        law(io::mission_text(io::parse_mission(text, "input")) == text);
        try {
            validate(map, read.mission, read.method, read.limits);
        } catch (const InputError& error) {
            for (const char c : std::string_view(error.what())) law(static_cast<unsigned char>(c) >= ' ');
        }
    });
    return 0;
}
