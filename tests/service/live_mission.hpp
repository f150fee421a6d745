// Live missions on the maps of LiveServer, for tests.
#pragma once

#include <string>

#include "live_server.hpp"
#include "test_store.hpp"

namespace waybreaker::service {

inline const std::string missions = "/api/v1/missions";

// One rover around the house, without aircraft: down to the gap below it, through, and up again.
inline const Json rover_mission{
    {"format", "waybreaker-mission/1"},
    {"map", "house.map"},
    {"agents", {{{"id", "rover"}, {"kind", "ground"}, {"start", {1, 3}}, {"goal", {9, 3}}}}}};

inline Json state(int sequence, double now, const Json& more = Json::object()) {
    Json state{{"format", "waybreaker-state/1"}, {"sequence", sequence}, {"now", now}};
    state.update(more);
    return state;
}

// The gap below the house is blocked: there is no way left.
inline const Json gap_blocked{{"found", {{{"cells", {{5, 6}}}}}}};

class LiveMissionServer : public LiveServer {
  protected:
    LiveMissionServer() {
        if (on_postgres()) options_.store = new_store();
    }

    // For options_.store: one that goes on after end() and begin().
    std::string new_store() const { return new_test_store(path("missions.db")); }
    // The path of a mission that has begun.
    std::string begun(const Json& request = rover_mission) const {
        return missions + "/" + post_json(missions, request, 201)["id"].get<std::string>();
    }
    std::string kind(const Json& problem) const { return problem["type"].get<std::string>(); }
};

}  // namespace waybreaker::service
