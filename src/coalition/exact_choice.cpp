#include "coalition/exact_choice.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "coalition/all_sets.hpp"
#include "coalition/joint.hpp"
#include "coalition/own_mission.hpp"
#include "coalition/restricted_master.hpp"
#include "coalition/tuning.hpp"
#include "model/objective.hpp"

namespace waybreaker::coalition {
void ExactChoice::run() {
    improve_prices();
    const bool none = evaluation_.drafts().empty();
    if (none) try_for_own_bodies();
    try_jointly();
    if (!none && !is_within(tuning::gap_for_own_bodies)) try_for_own_bodies();
    try_own_missions();
    if (!is_within(tuning::gap_of_choice)) try_all();
}

// Prices learn from the best set, and find new columns; these find better sets.
void ExactChoice::improve_prices() {
    evaluation_.evaluate(RestrictedMaster(problem_, columns_).best_from({}));
    for (int round = 0; round < tuning::most_price_rounds && !due() && !is_within(tuning::gap_for_prices); ++round) {
        const double aim = std::min(reached(), tuning::farthest_aim * bound_);
        const bool found = relaxation_.tighten(aim);
        const double gain = relaxation_.bound() - bound_;
        const double missing = reached() - bound_;
        bound_ = relaxation_.bound();
        if (found) evaluation_.evaluate(RestrictedMaster(problem_, columns_).best_from({}));
        const bool goes_on = found && (round <= 1 || gain > tuning::least_gain_of_round * missing);
        if (!goes_on && !columns_.search_longer() && !columns_.heed_times()) return;
    }
}

// Sets in the order of their limits, until none can be better, or several do not improve the incumbent.
void ExactChoice::try_jointly() {
    if (evaluation_.drafts().empty() || is_within(tuning::gap_of_choice) || due()) return;
    // All that could be part of a better plan, or what is likely to be. Where vehicles are many, lists as long as that
    // say too little.
    const double gap = problem_.interrupts().gap;
    const double useless = reached() / (1 + gap);
    const double longest = tuning::most_margin * reached() / double(columns_.size());
    if (problem_.sums() && longest < tuning::least_gain_of_round * (useless - bound_)) return;
    relaxation_.list(std::min(useless - bound_, tuning::margin_of_enumeration * reached()));
    bound_ = std::max(bound_, relaxation_.bound());
    if (!relaxation_.proof().complete) return;
    Joint joint(problem_, columns_, relaxation_.proof(), workers_.own().openings, useless);
    const double enough = 1 + std::max(tuning::gap_of_choice, gap);
    for (int without_gain = 0; without_gain < tuning::most_sets_without_gain && reached() > joint.rest() * enough;) {
        const std::optional<Set> set = joint.next();
        if (!set) break;
        const double before = reached();
        evaluation_.evaluate(*set);
        without_gain = reached() < before ? 0 : without_gain + 1;
    }
    bound_ = std::max(bound_, std::min(joint.bound(), reached()));
}

// A vehicle may need more open than a point, which slips through.
void ExactChoice::try_for_own_bodies() {
    if (due()) return;
    const Columns own(problem_, workers_, Shape::own);
    RestrictedMaster master(problem_, own);
    evaluation_.evaluate(master.best_from({}));
    evaluation_.evaluate(master.best_from(most_wanted()));
}

// The vehicle that decides the objective, and another one where that changes who does.
void ExactChoice::try_own_missions() {
    std::vector<char> asked(columns_.size(), false);
    while (!is_within(tuning::gap_for_own_mission) && !due()) {
        const std::optional<std::size_t> vehicle = decisive();
        if (!vehicle || asked[*vehicle]) return;
        asked[*vehicle] = true;
        const OwnMission own = plan_own_mission(problem_, *vehicle, workers_.own());
        const double others = least_of_others(*vehicle);
        const double unreached = problem_.sums() ? infinity : problem_.unreached(*vehicle);
        if (const double proven = std::min({own.bound + others, unreached, reached()}); std::isfinite(proven))
            bound_ = std::max(bound_, proven);
        for (const OwnMission::Proposal& proposal : own.proposals) {
            const auto promises = [&] { return proposal.objective + others < reached() * (1 - rounding); };
            if (!promises() || due()) break;
            evaluation_.evaluate(proposal.candidate.opening.removed);
            if (promises()) evaluation_.evaluate_as_own(*vehicle, proposal.candidate);
        }
    }
}

// The vehicle that is last in the incumbent; of a sum, the one that may gain most, if its own mission counts what the
// sum does.
std::optional<std::size_t> ExactChoice::decisive() const {
    std::optional<std::size_t> decisive;
    double most = 0;
    double all = 0;
    for (std::size_t i = 0; i < columns_.size(); ++i) {
        const Pool& pool = columns_.of(i);
        const double closed = pool.columns.front().arrival;
        double time = closed;
        if (!evaluation_.drafts().empty()) {
            const Draft& draft = evaluation_.drafts().front();
            time = arrival(*problem_.vehicles()[i], draft.taken[i], draft.openings);
        }
        const double counts =
            problem_.sums() ? weighted(problem_.weight(i), std::max(time, closed) - pool.least) : time;
        if (counts > most) decisive = i;
        most = std::max(most, counts);
        all += counts;
    }
    if (!problem_.sums() || !decisive) return decisive;
    if (std::isfinite(most) && most < tuning::least_share_of_own_mission * all) return std::nullopt;
    const auto counts_once = [](const Agent* agent) { return agent->weight == 1; };
    const bool is_part = counts_once(problem_.vehicles()[*decisive]) && std::isinf(problem_.unreached(*decisive)) &&
                         std::ranges::all_of(problem_.aircraft(), counts_once);
    return is_part ? decisive : std::nullopt;
}

// What a sum counts beside a vehicle's own mission, at least.
double ExactChoice::least_of_others(std::size_t vehicle) const {
    double least = 0;
    for (std::size_t i = 0; problem_.sums() && i < columns_.size(); ++i) {
        if (i != vehicle) least += weighted(problem_.weight(i), columns_.of(i).least);
    }
    return least;
}

// With more care than before, as long as that takes little. Of more sets, the first that has a plan, if none had.
void ExactChoice::try_all() {
    const std::uint64_t enough = evaluation_.effort() + tuning::most_effort_for_all_sets;
    const bool none = evaluation_.drafts().empty();
    const std::vector<Set> sets =
        all_sets(problem_, columns_, none ? tuning::most_sets_without_plan : tuning::most_sets_evaluated);
    for (const Set& set : sets) {
        if (due() || evaluation_.effort() >= enough) return;
        if (sets.size() > tuning::most_sets_evaluated && !evaluation_.drafts().empty()) return;
        evaluation_.evaluate_carefully(set, enough);
    }
}

// As many as may be removed together.
Set ExactChoice::most_wanted() const {
    Set set;
    double weight = 0;
    for (const ObstacleId id : relaxation_.wanted()) {
        if (set.size() == std::size_t(problem_.spare_removals())) break;
        const double more = weight + problem_.map().obstacle(id).weight;
        if (more > problem_.spare_budget()) continue;
        weight = more;
        set.push_back(id);
    }
    std::ranges::sort(set);
    return set;
}

}  // namespace waybreaker::coalition
