// Public interface of the crossing search: checks the query, and hides the search.
#include "crossing/search.hpp"
#include "crossing/validate.hpp"
#include "waybreaker/error.hpp"

namespace waybreaker {

CrossingMemory::CrossingMemory() : lengths_(std::make_unique<crossing::PathLengths>()) {}
CrossingMemory::~CrossingMemory() = default;
CrossingMemory::CrossingMemory(CrossingMemory&&) noexcept = default;
CrossingMemory& CrossingMemory::operator=(CrossingMemory&&) noexcept = default;

CrossingSearcher::CrossingSearcher() : search_(std::make_unique<Search>()) {}
CrossingSearcher::CrossingSearcher(std::unique_ptr<Search> search) : search_(std::move(search)) {}
CrossingSearcher::~CrossingSearcher() = default;
CrossingSearcher::CrossingSearcher(CrossingSearcher&&) noexcept = default;
CrossingSearcher& CrossingSearcher::operator=(CrossingSearcher&&) noexcept = default;

CrossingSearcher CrossingSearcher::another() const {
    return CrossingSearcher(search_->another());
}

void CrossingSearcher::exchange(CrossingMemory& memory) {
    search_->exchange(*memory.lengths_);
}

CrossingResult CrossingSearcher::find(const Map& map, Cell start, Cell goal, const CrossingOptions& options) {
    validate(map, options);
    return search_->run(map, start, goal, options, nullptr);
}

CrossingResult CrossingSearcher::enumerate(const Map& map, Cell start, Cell goal, const CrossingOptions& options,
                                           const std::function<bool(const CrossingPath&)>& accept) {
    validate(map, options);
    if (options.weight > 1) throw InputError("paths in order of their cost have no weight");
    return search_->run(map, start, goal, options, &accept);
}

}  // namespace waybreaker
