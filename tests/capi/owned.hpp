// Handles of the C interface that free themselves.
#pragma once

#include <memory>
#include <string>
#include <string_view>

#include "waybreaker.h"

namespace waybreaker::capi {

template <auto free>
struct Free {
    template <class Handle>
    void operator()(Handle* handle) const {
        free(handle);
    }
};
using OwnedMap = std::unique_ptr<waybreaker_map, Free<waybreaker_map_free>>;
using OwnedPlanner = std::unique_ptr<waybreaker_planner, Free<waybreaker_planner_free>>;
using OwnedText = std::unique_ptr<waybreaker_text, Free<waybreaker_text_free>>;

inline OwnedPlanner new_planner() {
    return OwnedPlanner(waybreaker_planner_new());
}

// The bytes of a text, which goes.
inline std::string taken(waybreaker_text* text) {
    const OwnedText owned(text);
    return {waybreaker_text_data(text), waybreaker_text_size(text)};
}

// What a call gave: a text, or why there is none.
struct Answer {
    waybreaker_status status = WAYBREAKER_OK;
    std::string text = {};
    std::string error = {};
};

// call(&text, &error)
template <class Call>
Answer answer(Call call) {
    waybreaker_text* text = nullptr;
    waybreaker_text* error = nullptr;
    const waybreaker_status status = call(&text, &error);
    return {status, taken(text), taken(error)};
}

inline Answer plan(const OwnedPlanner& planner, const OwnedMap& map, std::string_view mission) {
    return answer([&](auto** text, auto** error) {
        return waybreaker_plan(planner.get(), map.get(), mission.data(), mission.size(), false, text, error);
    });
}

inline Answer front(const OwnedPlanner& planner, const OwnedMap& map, std::string_view mission) {
    return answer([&](auto** text, auto** error) {
        return waybreaker_front(planner.get(), map.get(), mission.data(), mission.size(), false, text, error);
    });
}

inline Answer check(const OwnedMap& map, std::string_view plan, bool* valid = nullptr) {
    return answer([&](auto** text, auto** error) {
        return waybreaker_check(map.get(), plan.data(), plan.size(), valid, text, error);
    });
}

inline Answer revise(const OwnedPlanner& planner, const OwnedMap& map, std::string_view plan, std::string_view state,
                     double reaction = 0, double seconds = 1e6) {
    return answer([&](auto** text, auto** error) {
        return waybreaker_revise(planner.get(), map.get(), plan.data(), plan.size(), state.data(), state.size(),
                                 reaction, seconds, false, text, error);
    });
}

inline Answer check_after(const OwnedMap& map, std::string_view plan, std::string_view before, std::string_view state,
                          bool* valid = nullptr) {
    return answer([&](auto** text, auto** error) {
        return waybreaker_check_after(map.get(), plan.data(), plan.size(), before.data(), before.size(), state.data(),
                                      state.size(), valid, text, error);
    });
}

inline Answer svg(const OwnedMap& map, std::string_view plan) {
    return answer([&](auto** text, auto** error) {
        return waybreaker_plan_svg(map.get(), plan.data(), plan.size(), text, error);
    });
}

// call(&map, &error): the map; `*why`, where there is none, is why.
template <class Call>
OwnedMap map_by(Call call, Answer* why = nullptr) {
    waybreaker_map* map = nullptr;
    waybreaker_text* error = nullptr;
    const waybreaker_status status = call(&map, &error);
    const std::string message = taken(error);
    if (why != nullptr) *why = {status, "", message};
    return OwnedMap(map);
}

inline OwnedMap from_movingai(std::string_view bytes, const char* name = "yard.map", int connectivity = 4,
                              double cell_size = 0, Answer* why = nullptr) {
    return map_by(
        [&](auto** map, auto** error) {
            return waybreaker_map_from_movingai(name, bytes.data(), bytes.size(), connectivity, cell_size, map, error);
        },
        why);
}

}  // namespace waybreaker::capi
