// usage: plan MAP: what the library for C++ plans for mission.json. It writes no plan files, so this prints parts of
// one, as the others write them: the times, the removals and the timed paths.
#include <charconv>
#include <cmath>
#include <fstream>
#include <iostream>
#include <string>
#include <waybreaker/waybreaker.hpp>

namespace {

// The shortest text that is read as this very number.
std::string number(double value) {
    char digits[32];
    const std::string text(digits, std::to_chars(digits, digits + sizeof digits, value).ptr);
    return text.find_first_of(".e") == std::string::npos ? text + ".0" : text;
}

// Whole where it is.
std::string coordinate(double value) {
    return std::trunc(value) == value ? std::to_string(static_cast<int>(value)) : number(value);
}

}  // namespace

int main(int count, char** words) {
    if (count != 2) return 2;
    std::ifstream file(words[1]);
    const waybreaker::Map map(waybreaker::read_movingai_map(file, words[1]));
    waybreaker::Mission mission = waybreaker::ground_and_air({130, 104}, {466, 105});
    mission.agents.at(1).speed = 2;
    mission.rules.removals = 2;
    const waybreaker::Plan plan = waybreaker::Planner().plan(map, mission);

    std::cout << "\"makespan\": " << number(*plan.before.makespan) << '\n'
              << "\"makespan\": " << number(*plan.after.makespan) << '\n'
              << "\"bound\": {\"makespan\": " << number(*plan.bound) << ", \"gap\": " << number(*plan.gap) << "}\n";
    for (const auto& breach : plan.breaches) {
        std::cout << "\"at\": [" << breach.at.x << ", " << breach.at.y << "], "
                  << "\"cleared_at\": " << number(breach.cleared_at) << '\n';
    }
    for (const auto& agent : plan.agents) {
        std::cout << "\"path\": [";
        for (const auto& point : agent.path) {
            if (&point != &agent.path.front()) std::cout << ", ";
            std::cout << '[' << coordinate(point.x) << ", " << coordinate(point.y) << ", " << number(point.t) << ']';
        }
        std::cout << "]\n";
    }
}
