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

std::vector<Draft> Chooser::drafts(const Draft& nothing) {
    return drafts(task_.options, nothing);
}

std::vector<Draft> Chooser::drafts(const MissionOptions& options, const Draft& nothing) {
    const Task task{task_.map, task_.driver, task_.flyer, options};
    bound_.reset();
    if (options.select == Selection::exact) {
        const Deadline deadline(options.time_limit);
        const Bound bound = bound_of(task, crossing_, cost(task, nothing), deadline);
        bound_ = bound.objective;
        return drafts_by_proof(task, crossing_, searcher_, nothing, bound, deadline);
    }
    return drafts_by_hits(task, searcher_, nothing, chosen_by_hits(task, hits_));
}

}  // namespace waybreaker
