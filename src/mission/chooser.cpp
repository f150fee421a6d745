#include "mission/chooser.hpp"

#include <utility>

#include "mission/exact.hpp"
#include "mission/hits.hpp"
#include "mission/stopwatch.hpp"

namespace waybreaker {

Draft Chooser::nothing() {
    if (task_.options.select == Selection::exact)
        return draft_of(task_, ground_candidate(task_, crossing_, searcher_, {}));
    const Stopwatch watch;
    SearchResult search = search_counting_hits(task_, searcher_);
    hits_ = std::move(search.hits);
    return draft_of(task_, candidate_of({}, search, watch.seconds()));
}

Draft Chooser::least(const MissionOptions& options, const Draft& nothing) {
    if (options.force.empty()) return nothing;
    const Task task = task_of(task_, options);
    Draft opened = draft_of(task, ground_candidate(task, crossing_, searcher_, options.force));
    // An obstacle that falls late may better be driven around.
    Candidate around = nothing.candidate;
    around.removed = options.force;
    Draft other = draft_of(task, std::move(around));
    return cost(task, other) < cost(task, opened) ? other : opened;
}

std::vector<Draft> Chooser::drafts(const MissionOptions& options, const Draft& least) {
    const Task task = task_of(task_, options);
    bound_.reset();
    if (options.select == Selection::exact) {
        const Deadline deadline(options.time_limit);
        task.tell(cost(task, least), 0);
        const Bound bound = bound_of(task, crossing_, cost(task, least), deadline);
        bound_ = bound.objective;
        task.tell(cost(task, least), bound.objective);
        return drafts_by_proof(task, crossing_, searcher_, least, bound, deadline);
    }
    return drafts_by_hits(task, searcher_, least, chosen_by_hits(task, hits_));
}

}  // namespace waybreaker
