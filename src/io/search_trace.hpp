// A search's expansions in the search-trace format that the Posthoc visualiser reads.
#pragma once

#include <string>

#include "waybreaker/search.hpp"

namespace waybreaker::io {

// Listens to one search, gives the trace back as text.
class SearchTrace final : public SearchListener {
  public:
    SearchTrace(const OpenedMap& map, Cell start, Cell goal);
    void generated(Cell cell, Cell parent, double g, double f) override;
    void updated(Cell cell, Cell parent, double g, double f) override;
    void expanded(Cell cell, Cell parent, double g, double f) override;
    std::string text() const;  // the whole trace file

  private:
    std::string events_;
};

}  // namespace waybreaker::io
