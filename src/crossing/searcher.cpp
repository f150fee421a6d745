// Interface of the crossing search: checks the query, and hides the search.
#include "crossing/access.hpp"
#include "crossing/search.hpp"
#include "crossing/validate.hpp"
#include "waybreaker/error.hpp"

namespace waybreaker {

CrossingSearcher::CrossingSearcher() : search_(std::make_unique<Search>()) {}
CrossingSearcher::CrossingSearcher(std::unique_ptr<Search> search) : search_(std::move(search)) {}
CrossingSearcher::~CrossingSearcher() = default;
CrossingSearcher::CrossingSearcher(CrossingSearcher&&) noexcept = default;
CrossingSearcher& CrossingSearcher::operator=(CrossingSearcher&&) noexcept = default;

CrossingResult CrossingSearcher::find(const Map& map, Cell start, Cell goal, const CrossingOptions& options) {
    return crossing::Access::find(*this, map, start, goal, options, {});
}

CrossingResult CrossingSearcher::enumerate(const Map& map, Cell start, Cell goal, const CrossingOptions& options,
                                           const std::function<bool(const CrossingPath&)>& accept) {
    return crossing::Access::enumerate(*this, map, start, goal, options, {}, accept);
}

namespace crossing {

Memory::Memory() : lengths_(std::make_unique<PathLengths>()) {}
Memory::~Memory() = default;
Memory::Memory(Memory&&) noexcept = default;
Memory& Memory::operator=(Memory&&) noexcept = default;

CrossingResult Access::find(CrossingSearcher& searcher, const Map& map, Cell start, Cell goal,
                            const CrossingOptions& options, const Opener& opener) {
    validate(map, options, opener);
    return searcher.search_->run(map, start, goal, options, opener, nullptr);
}

CrossingResult Access::enumerate(CrossingSearcher& searcher, const Map& map, Cell start, Cell goal,
                                 const CrossingOptions& options, const Opener& opener,
                                 const std::function<bool(const CrossingPath&)>& accept) {
    validate(map, options, opener);
    if (options.weight > 1) throw InputError("paths in order of their cost have no weight");
    return searcher.search_->run(map, start, goal, options, opener, &accept);
}

CrossingSearcher Access::another(const CrossingSearcher& searcher) {
    return CrossingSearcher(searcher.search_->another());
}

void Access::exchange(CrossingSearcher& searcher, Memory& memory) {
    searcher.search_->exchange(*memory.lengths_);
}

}  // namespace crossing
}  // namespace waybreaker
