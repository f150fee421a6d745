#include "mission/chooser.hpp"

#include <utility>

#include "mission/exact.hpp"
#include "mission/hits.hpp"
#include "mission/stopwatch.hpp"

namespace waybreaker {

Draft Chooser::nothing() {
    if (task_.options.select == Selection::exact)
        return draft_of(task_, ground_candidate(task_, crossing_, searcher_, {}));
    SearchOptions counting = task_.options.search;
    counting.count_hits = true;
    const Stopwatch watch;
    SearchResult search = searcher_.find(OpenedMap(task_.map), task_.driver.start, task_.driver.goal, counting);
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
        bound_ = bound_of(task, crossing_, cost(task, nothing));
        return drafts_by_proof(task, crossing_, searcher_, nothing, *bound_);
    }
    return drafts_by_hits(task, searcher_, nothing, chosen_by_hits(task, hits_));
}

}  // namespace waybreaker
