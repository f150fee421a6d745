#include "coalition/evaluation.hpp"

#include <algorithm>
#include <utility>

namespace waybreaker::coalition {

bool Evaluation::is_new(const Set& all) {
    if (std::ranges::find(evaluated_, all) != evaluated_.end()) return false;
    evaluated_.push_back(all);
    return true;
}

void Evaluation::add(Draft draft) {
    if (draft.cost.missing > 0) return;
    const auto worse = [&](const Draft& other) { return team::better(draft.cost, other.cost); };
    drafts_.insert(std::ranges::find_if(drafts_, worse), std::move(draft));
}

void Evaluation::evaluate(const Set& set) {
    const Set all = with_forced(set);
    if (is_new(all)) add(sorties_.plan(all, problem_.forced(), reached()));
}

void Evaluation::evaluate_growing(const Set& set) {
    const Set all = with_forced(set);
    if (!is_new(all)) return;
    Draft draft = sorties_.plan(all, problem_.forced(), reached());
    if (draft.cost.first < reached() * (1 - rounding)) add(std::move(draft));
}

void Evaluation::evaluate_whole(const Set& set) {
    const Set all = with_forced(set);
    if (is_new(all)) add(sorties_.plan(all, all, reached()));
}

void Evaluation::evaluate_as_own(std::size_t vehicle, const Candidate& own) {
    Draft draft = sorties_.plan_as_own(with_forced(own.opening.removed), vehicle, own);
    if (draft.cost.first < reached() * (1 - rounding)) add(std::move(draft));
}

void Evaluation::evaluate_carefully(const Set& set, std::uint64_t enough) {
    add(sorties_.plan(with_forced(set), problem_.forced(), reached(), enough));
}

}  // namespace waybreaker::coalition
