// Puts a search together from its parts, as the options say.
#include "search/best_first.hpp"
#include "search/jump_steps.hpp"
#include "search/observers.hpp"
#include "search/parents.hpp"
#include "search/steps.hpp"
#include "waybreaker/advanced/search.hpp"
#include "waybreaker/error.hpp"

namespace waybreaker {

class Searcher::Memory {
  public:
    NodeStore nodes;
    OpenMemory open;
};

Searcher::Searcher() : memory_(std::make_unique<Memory>()) {}
Searcher::~Searcher() = default;
Searcher::Searcher(Searcher&&) noexcept = default;
Searcher& Searcher::operator=(Searcher&&) noexcept = default;

namespace {

bool is_wide(const Body& body) {
    return body.reach() > 0.5;
}

// The parts are chosen one after the other, each choice a function: steps, parents, order, observer.
struct Assembly {
    const Query& query;
    const LineOfSight& sight;
    NodeStore& nodes;
    OpenMemory& open;

    HitCounter hit_counter() const { return {query.map, sight, is_wide(query.options.body)}; }

    template <class Order, class Steps, class Parents, class Observer>
    SearchResult run(const Steps& moves, const Parents& parents, Observer& observer) const {
        return BestFirst<Steps, Parents, Order, Observer>(query, nodes, open, moves, parents, observer).run();
    }

    template <class Steps, class Parents, class Observer>
    SearchResult order(const Steps& moves, const Parents& parents, Observer& observer) const {
        return query.options.tie_break == TieBreak::g_max ? run<LargerGFirst>(moves, parents, observer)
                                                          : run<SmallerGFirst>(moves, parents, observer);
    }

    template <class Steps, class Parents>
    SearchResult observe(const Steps& moves, const Parents& parents) const {
        if (query.options.listener != nullptr) {
            ListeningHitCounter observer(hit_counter(), *query.options.listener);
            SearchResult result = order(moves, parents, observer);
            if (query.options.count_hits) result.hits = observer.take();
            return result;
        }
        if (query.options.count_hits) {
            HitCounter observer = hit_counter();
            SearchResult result = order(moves, parents, observer);
            result.hits = observer.take();
            return result;
        }
        NoObserver observer;
        return order(moves, parents, observer);
    }

    template <class Steps>
    SearchResult parents(const Steps& moves) const {
        if (query.options.planner == Algorithm::theta) return observe(moves, ThetaParents(query.map, sight));
        if (query.options.planner == Algorithm::lazy_theta)
            return observe(moves, LazyThetaParents<Steps>{sight, moves});
        return observe(moves, StepParents{});
    }

    SearchResult assemble() const {
        const Corners corners = query.options.body.passes();
        const bool diagonal = query.options.diagonal;
        if (query.options.planner == Algorithm::jps) {
            return observe(JumpSteps(query.map, corners, query.goal), StepParents{});
        }
        const bool unit_cost = query.options.planner == Algorithm::bfs;
        if (is_wide(query.options.body)) return parents(WideSteps(sight, diagonal, unit_cost));
        return parents(GridSteps(query.map, corners, diagonal, unit_cost));
    }
};

}  // namespace

void Searcher::explore(const OpenedMap& map, Cell start, SearchOptions options) {
    options.heuristic = Heuristic::zero;
    validate(options);
    if (options.planner == Algorithm::optimal || options.planner == Algorithm::jps)
        throw InputError("only a search from cell to cell explores: neither jps nor optimal");
    const LineOfSight sight(map, options.body);
    if (!map.map().grid().contains(start) || !sight.fits(start)) return;
    constexpr Cell nowhere{-1, -1};
    const Query query{map, start, nowhere, Heuristic::zero, 1, options};
    (void)Assembly{query, sight, memory_->nodes, memory_->open}.assemble();
}

SearchResult Searcher::find(const OpenedMap& map, Cell start, Cell goal, const SearchOptions& options) {
    validate(options);
    if (options.planner == Algorithm::optimal)
        throw InputError("a Searcher has no optimal planner: use CrossingSearcher");
    const LineOfSight sight(map, options.body);
    const auto stands = [&](Cell c) { return map.map().grid().contains(c) && sight.fits(c); };
    if (!stands(start) || !stands(goal)) {
        SearchResult nowhere;
        if (options.count_hits) nowhere.hits.assign(map.map().obstacles().size() + 1, 0);
        return nowhere;
    }
    const Query query{map, start, goal, heuristic_of(options), options.weight, options};
    return Assembly{query, sight, memory_->nodes, memory_->open}.assemble();
}

}  // namespace waybreaker
