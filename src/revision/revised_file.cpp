#include "revision/revised_file.hpp"

#include <utility>

#include "core/range.hpp"
#include "io/check_report.hpp"
#include "waybreaker/error.hpp"

namespace waybreaker::revision {

io::PlanContext RevisedFile::context(bool timing_fields) const {
    return {.map = map,
            .asked = asked,
            .connectivity = connectivity,
            .timing_fields = timing_fields,
            .image = image,
            .supersedes = supersedes};
}

io::MapFile map_of(const io::PlanFile& plan, const io::MapFile& map, const std::string& plan_name) {
    io::require_map_of(plan, map, plan_name);
    io::MapFile known = io::known_map(map, plan.plan);
    if (auto weighed = io::reweighed(plan, known, {})) known.map = *std::move(weighed);
    return known;
}

RevisedFile next_file(const io::PlanFile& before, io::MapFile map, Revision next, std::string digest) {
    RevisedFile file{.status = next.status,
                     .plan = std::move(next.plan),
                     .map = std::move(map),
                     .asked = before.asked,
                     .connectivity = before.connectivity,
                     .image = before.image,
                     .supersedes = next.status == RevisionStatus::unchanged ? before.supersedes : std::move(digest)};
    file.map.map = std::move(next.map);
    file.asked.mission = std::move(next.mission);
    return file;
}

RevisedFile revise(Planner& planner, const Task& task, const Limits& limits) {
    // For these no state is to blame.
    require_range(task.reaction, 0, most_breach_time, "the time of reaction");
    if (!(limits.seconds > 0)) throw InputError("the time limit must be above 0 seconds");
    const io::PlanFile& before = task.before;
    io::MapFile map = map_of(before, task.map, task.before_name);
    try {
        Revision next = waybreaker::revise(planner, map.map, before.asked.mission, before.plan, task.state,
                                           task.reaction, before.asked.method, limits);
        return next_file(before, std::move(map), std::move(next), task.digest);
    } catch (const InputError& error) {
        throw InputError(task.state_name, 0, error.what());
    }
}

}  // namespace waybreaker::revision
