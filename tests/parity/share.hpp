// How often something holds, for claims of the kind "on at least 99 % of the rows".
#pragma once

#include <ostream>

namespace waybreaker {

class Share {
  public:
    void count(bool holds) {
        held_ += holds ? 1 : 0;
        ++all_;
    }
    double percent() const { return all_ == 0 ? 0 : 100.0 * held_ / all_; }
    friend std::ostream& operator<<(std::ostream& out, const Share& share) {
        return out << share.held_ << " of " << share.all_ << " (" << share.percent() << " %)";
    }

  private:
    int held_ = 0;
    int all_ = 0;
};

}  // namespace waybreaker
