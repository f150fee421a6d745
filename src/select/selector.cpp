#include "select/selector.hpp"

#include "select/evaluation.hpp"
#include "select/exact.hpp"
#include "select/greedy.hpp"
#include "select/hits.hpp"
#include "select/opening_times.hpp"

namespace waybreaker {
namespace {

// Removes nothing but what must be.
class NoSelector : public Selector {
  public:
    explicit NoSelector(const Searchers& searchers) : searchers_(searchers) {}
    Candidate baseline(const Task& task) override {
        return around_late_openings(task, searchers_, candidate_of(task, open(task.trip(), searchers_, task.opened())));
    }
    Selected select(const Task& /*task*/, const Candidate& /*start*/) override { return {}; }

  private:
    Searchers searchers_;
};

}  // namespace

std::unique_ptr<Selector> selector_of(const Method& method, const Searchers& searchers) {
    switch (method.select) {
        case Selection::exact:
            return std::make_unique<ExactSelector>(searchers);
        case Selection::hits:
            return std::make_unique<HitsSelector>(searchers);
        case Selection::greedy:
            return std::make_unique<GreedySelector>(searchers);
        case Selection::none:
            break;
    }
    return std::make_unique<NoSelector>(searchers);
}

Candidate start_of(const Task& task, const Searchers& searchers, const Candidate& baseline) {
    if (task.given.empty()) return baseline;
    OpeningTimes opening_times(task);
    Candidate opened = evaluate(task, searchers, opening_times, task.given);
    // An obstacle that falls late may better be driven around.
    Opening around = task.rules.opened.empty() ? baseline.opening : open(task.trip(), searchers, {});
    around.removed = task.given;
    around.limited = around.limited || opened.opening.limited;
    Candidate other = candidate_of(task, std::move(around));
    return cost(task, other) < cost(task, opened) ? other : opened;
}

}  // namespace waybreaker
