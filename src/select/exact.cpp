#include "select/exact.hpp"

#include <utility>

#include "select/exact_selection.hpp"
#include "select/tuning.hpp"

namespace waybreaker {

Selected ExactSelector::select(const Task& task, const Candidate& start) {
    const Deadline deadline = task.deadline.share(tuning::share_of_proof);
    task.report(cost(task, start), 0);
    OpeningTimes opening_times(task);
    Evaluation evaluation(task, searchers_, opening_times, start);
    Selected selected;
    const auto choose = [&] {
        if (opening_times.matter() && task.spare_removals() > 0) {
            // Often nobody has to wait; and what is proven as if nobody did makes the search in time short.
            OpeningTimes at_once = OpeningTimes::at_once(task);
            const Deadline soon = deadline.share(tuning::share_at_once);
            ExactSelection of_all_open(task, searchers_, start, at_once, soon, evaluation, selected);
            if (of_all_open.prove_at_once()) return;
            // Which obstacles are worth their rubble, a search in time does not know; and where only flights count, it
            // need not look for waits.
            if (task.rules.rubble > 0 || !opening_times.may_be_late()) of_all_open.select();
        }
        ExactSelection(task, searchers_, start, opening_times, deadline, evaluation, selected).run();
    };
    choose();
    selected.candidates = std::move(evaluation).candidates();
    return selected;
}

}  // namespace waybreaker
