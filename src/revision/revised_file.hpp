// A plan file revised: whoever has a plan file, its map and a state gets the next plan file, whatever the front end.
//
//     const io::PlanFile before = io::parse_plan(bytes, "plan.json");
//     const State state = io::parse_state(report, "state.json");
//     RevisedFile next = revise(planner, {before, "plan.json", io::sha256_digest(bytes), map, state, "state.json"},
//     limits); write(next.json(true));
#pragma once

#include <string>

#include "io/map_file.hpp"
#include "io/mission_document.hpp"
#include "io/plan_file.hpp"
#include "io/plan_json.hpp"
#include "waybreaker/limits.hpp"
#include "waybreaker/planner.hpp"
#include "waybreaker/revise.hpp"
#include "waybreaker/state.hpp"

namespace waybreaker::revision {

// What is revised, and from what.
struct Task {
    const io::PlanFile& before;
    std::string before_name;  // as errors call it
    std::string digest;       // of its bytes
    const io::MapFile& map;   // that the mission began on
    const State& state;
    std::string state_name;  // as errors call it
    double reaction = 0;     // as revise() has it
};

// What the next plan file says.
struct RevisedFile {
    RevisionStatus status;
    Plan plan;
    io::MapFile map;            // as it is known now
    io::MissionDocument asked;  // what is left of it
    Connectivity connectivity;
    io::ImageReading image;
    std::string supersedes;

    // Looks at this: as long as it is there, where it is.
    io::PlanContext context(bool timing_fields) const;
    std::string json(bool timing_fields) const { return io::plan_json(plan, context(timing_fields)); }
};

// The map that a plan was made on, from the one that its mission began on. Throws InputError, under the name of the
// plan, if that was made for another.
io::MapFile map_of(const io::PlanFile& plan, const io::MapFile& map, const std::string& plan_name);

// The file of what comes after a plan. `map`: that it was made on; `digest`: of its bytes, if they are known.
RevisedFile next_file(const io::PlanFile& before, io::MapFile map, Revision next, std::string digest = {});

// Throws InputError, under the name of the plan if that was made for another map, or of the state if it cannot be one
// of the plan.
RevisedFile revise(Planner& planner, const Task& task, const Limits& limits);

}  // namespace waybreaker::revision
