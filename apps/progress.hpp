// Progress display for a person who waits longer than a second.
//
//     Progress progress("planning");
//     progress.update("best 404.9, none below 398.2");
#pragma once

#include <memory>
#include <string>
#include <thread>

namespace waybreaker::apps {

// While it exists and more than a second has passed: activity, elapsed time and status on one line of standard error,
// which is cleared at the end. Shows nothing if that is not a terminal.
class Progress {
  public:
    explicit Progress(std::string activity);

    void update(std::string status);

  private:
    struct Status;
    std::shared_ptr<Status> status_;
    std::jthread ticker_;
};

}  // namespace waybreaker::apps
