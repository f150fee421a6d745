#include "mission/chooser.hpp"

#include <utility>

#include "core/stopwatch.hpp"
#include "mission/exact.hpp"
#include "mission/hits.hpp"

namespace waybreaker {
namespace {

// Of the time that is left when choosing begins; the rest is for sets that are likely to be good, if the proof is not
// done by then.
constexpr double share_of_proof = 0.8;

}  // namespace

Draft Chooser::nothing() {
    if (task_.method.select == Selection::exact)
        return draft_of(task_, ground_candidate(task_, crossing_, searcher_, {}));
    const Stopwatch watch;
    SearchResult search = search_counting_hits(task_, searcher_);
    hits_ = std::move(search.hits);
    return draft_of(task_, candidate_of({}, search, watch.seconds()));
}

Draft Chooser::least(const Task& task, const Draft& nothing) {
    const std::vector<ObstacleId>& force = task.rules.force;
    if (force.empty()) return nothing;
    Draft opened = draft_of(task, ground_candidate(task, crossing_, searcher_, force));
    limited_ = limited_ || opened.candidate.limited;
    // An obstacle that falls late may better be driven around.
    Candidate around = nothing.candidate;
    around.removed = force;
    Draft other = draft_of(task, std::move(around));
    return cost(task, other) < cost(task, opened) ? other : opened;
}

std::vector<Draft> Chooser::drafts(const Task& task, const Draft& least) {
    bound_.reset();
    if (task.method.select == Selection::exact) {
        const Deadline deadline = task.deadline.share(share_of_proof);
        task.report(cost(task, least), 0);
        const Bound bound = bound_of(task, crossing_, cost(task, least), deadline);
        bound_ = bound.objective;
        task.report(cost(task, least), bound.objective);
        Choice choice = choice_by_proof(task, crossing_, searcher_, least, bound, deadline);
        limited_ = limited_ || bound.limited || choice.limited;
        return std::move(choice.drafts);
    }
    std::vector<Draft> drafts = drafts_by_hits(task, searcher_, least, chosen_by_hits(task, hits_));
    limited_ = limited_ || task.deadline.passed();
    return drafts;
}

}  // namespace waybreaker
