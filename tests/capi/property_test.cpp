// Any map, any mission, and missions with a few bytes changed: a call plans or says in one line why not, and what it
// plans is valid.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "capi/owned.hpp"
#include "random_map.hpp"

namespace waybreaker::capi {
namespace {

std::string text(Cell c) {
    return "[" + std::to_string(c.x) + ", " + std::to_string(c.y) + "]";
}

std::string any_mission(const PlainMap& map) {
    const auto agent = [&](const std::string& id, const char* kind) {
        return R"({"id": ")" + id + R"(", "kind": ")" + kind + R"(", "start": )" + text(any_cell(map)) +
               R"(, "goal": )" + text(any_cell(map)) + R"(, "speed": )" + std::to_string(*number(1, 3)) + "}";
    };
    std::string agents = agent("rover", "ground");
    if (mostly()) agents += ", " + agent("drone", "air");
    if (!mostly()) agents += ", " + agent("second", "ground");
    return R"({"format": "waybreaker-mission/1", "agents": [)" + agents + R"(], "rules": {"removals": )" +
           std::to_string(*number(0, 3)) + R"(, "breach_time": )" + std::to_string(*number(0, 2)) + "}}";
}

std::string with_other_bytes(std::string text) {
    const int changes = *rc::gen::element(0, 0, 1, 2, 5);
    for (int i = 0; i < changes; ++i) {
        text[std::size_t(*number(0, int(text.size()) - 1))] = char(*number(-128, 127));
    }
    return text;
}

void require_one_line(const Answer& answer) {
    RC_ASSERT(answer.status == WAYBREAKER_INPUT_ERROR);
    RC_ASSERT(answer.text.empty());
    RC_ASSERT(!answer.error.empty());
    RC_ASSERT(std::none_of(answer.error.begin(), answer.error.end(), [](char c) { return c == '\n' || c == '\0'; }));
}

RC_GTEST_PROP(CInterface, PlansOrSaysWhyNot, ()) {
    const PlainMap plain = *random_map(12, 12);
    const std::vector<std::uint8_t> blocked(plain.obstacles.begin(), plain.obstacles.end());
    const OwnedMap map = map_by([&](auto** result, auto** error) {
        return waybreaker_map_from_grid(nullptr, blocked.data(), plain.width, plain.height, 4, 0, result, error);
    });
    if (!map) RC_FAIL("the grid is refused");
    const OwnedPlanner planner = new_planner();
    const std::string document = with_other_bytes(any_mission(plain));
    for (const auto& call : {capi::plan, capi::front}) {
        const Answer answer = call(planner, map, document);
        if (answer.status != WAYBREAKER_OK) {
            require_one_line(answer);
            continue;
        }
        bool valid = false;
        const Answer report = check(map, answer.text, &valid);
        if (!valid) RC_FAIL(report.text + report.error);
        const Answer changed = check(map, with_other_bytes(answer.text));
        if (changed.status != WAYBREAKER_OK) require_one_line(changed);
    }
}

RC_GTEST_PROP(CInterface, ReadsMapFilesOrSaysWhyNot, ()) {
    const PlainMap plain = *random_map(6, 6);
    std::string file =
        "type octile\nheight " + std::to_string(plain.height) + "\nwidth " + std::to_string(plain.width) + "\nmap\n";
    for (const Cell c : plain.cells()) {
        file += plain.blocked(c) ? '@' : '.';
        if (c.x == plain.width - 1) file += '\n';
    }
    Answer why;
    const OwnedMap map = from_movingai(with_other_bytes(file), nullptr, 4, 0, &why);
    if (!map) require_one_line(why);
}

}  // namespace
}  // namespace waybreaker::capi
