// A sign of life for a person who waits longer than a second.
//
//     Progress progress("planning");
//     progress.tell("best 404.9, none below 398.2");
#pragma once

#include <memory>
#include <string>
#include <thread>

namespace waybreaker::apps {

// As long as it lives, from the second second on: what is going on, for how long and how far it is, on one line of
// standard error that is wiped in the end. Nothing if that is not a terminal.
class Progress {
  public:
    explicit Progress(std::string activity);

    // What is known by now.
    void tell(std::string news);

  private:
    struct News;
    std::shared_ptr<News> news_;
    std::jthread ticker_;
};

}  // namespace waybreaker::apps
