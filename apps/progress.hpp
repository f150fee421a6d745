// A sign of life for a person who waits longer than a second.
//
//     const Progress progress("reading berlin.osm.pbf");
#pragma once

#include <string>
#include <thread>

namespace waybreaker::apps {

// As long as it lives, from the second second on: what is going on and for how long, on one line of standard error that
// is wiped in the end. Nothing if that is not a terminal.
class Progress {
  public:
    explicit Progress(std::string activity);

  private:
    std::jthread ticker_;
};

}  // namespace waybreaker::apps
