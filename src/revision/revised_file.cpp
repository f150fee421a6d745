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

RevisedFile revise(Planner& planner, const Task& task, const Limits& limits) {
    // For these no state is to blame.
    require_range(task.reaction, 0, most_breach_time, "the time of reaction");
    if (!(limits.seconds > 0)) throw InputError("the time limit must be above 0 seconds");
    const io::PlanFile& before = task.before;
    io::require_map_of(before, task.map, task.before_name);
    io::MapFile map = io::known_map(task.map, before.plan);
    if (const auto weighed = io::reweighed(before, map, {})) map.map = *weighed;
    Revision next = [&] {
        try {
            return waybreaker::revise(planner, map.map, before.asked.mission, before.plan, task.state, task.reaction,
                                      before.asked.method, limits);
        } catch (const InputError& error) {
            throw InputError(task.state_name, 0, error.what());
        }
    }();
    RevisedFile file{.status = next.status,
                     .plan = std::move(next.plan),
                     .map = std::move(map),
                     .asked = before.asked,
                     .connectivity = before.connectivity,
                     .image = before.image,
                     .supersedes = next.status == RevisionStatus::unchanged ? before.supersedes : task.digest};
    file.map.map = std::move(next.map);
    file.asked.mission = std::move(next.mission);
    return file;
}

}  // namespace waybreaker::revision
