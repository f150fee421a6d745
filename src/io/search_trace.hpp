// A search, step by step, in the open search-trace format 1.4.0 of the Posthoc visualiser
// (posthoc.pathfinding.ai/docs/search-trace). Name the file *.trace.json; lay it over the map's `.map` file.
//
//     io::SearchTrace trace(map, start, goal);
//     options.listener = &trace;
//     searcher.find(map, start, goal, options);
//     io::write_whole("search.trace.json", trace.text());
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "waybreaker/search_options.hpp"

namespace waybreaker::io {

// Listens to one search, gives the trace back as text. About 120 bytes an event.
class SearchTrace final : public SearchListener {
  public:
    SearchTrace(const OpenedMap& map, Cell start, Cell goal);
    void generated(Cell cell, Cell parent, double g, double f) override;
    void updated(Cell cell, Cell parent, double g, double f) override;
    void expanded(Cell cell, Cell parent, double g, double f) override;
    std::string text() const;  // the whole trace file, JSON with a line for each event

  private:
    struct Step {
        Cell cell;
        Cell parent;
        double g;
        double f;
    };
    std::string place(std::string_view type, Cell cell) const;
    std::string event(std::string_view type, const Step& step) const;
    std::string last_event() const;

    int width_;
    Cell goal_;
    std::string events_;  // all but the closing of the cell that is being expanded
    std::optional<Step> expanding_;
};

}  // namespace waybreaker::io
