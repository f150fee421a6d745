// Ellipse: where a path from one vertex to another can go if it is to be short enough.
#pragma once

#include <algorithm>

#include "crossing/geometry/lattice.hpp"

namespace waybreaker::crossing {

class Ellipse {
  public:
    // Paths from `from` to `to` of at most that length (half cells; infinity: anywhere).
    Ellipse(Vertex from, Vertex to, double longest) : to_goal_(to - from), longest_(longest) {
        const double distance = length(to_goal_);
        middle_x_ = from.x + to_goal_.x / 2.0;
        middle_y_ = from.y + to_goal_.y / 2.0;
        axis_x_ = distance > 0 ? to_goal_.x / distance : 1;
        axis_y_ = distance > 0 ? to_goal_.y / distance : 0;
        if (longest == infinity) return;
        reserve_ = (longest * longest - distance * distance) / 2;
        const double half = longest / 2 * (1 + rounding);
        along_scale_ = 1 / std::max(half * half, rounding);
        across_scale_ = 1 / std::max(half * half - distance * distance / 4, rounding);
    }

    bool holds(Vertex v) const {
        const double x = v.x - middle_x_;
        const double y = v.y - middle_y_;
        const double along = x * axis_x_ + y * axis_y_;
        const double across = x * axis_y_ - y * axis_x_;
        return along * along * along_scale_ + across * across * across_scale_ <= 1;
    }

    // How many times the step leads from `from` to where one leaves the ellipse; infinity if one never does.
    double times(Step step) const {
        if (along_scale_ == 0) return infinity;
        const double towards = double(step.x) * to_goal_.x + double(step.y) * to_goal_.y;
        const double left = longest_ * length(step) - towards;
        return left > 0 ? reserve_ / left : 1;
    }

  private:
    static constexpr double rounding = 1e-9;

    Step to_goal_;
    double longest_;
    double reserve_ = 0;
    double middle_x_, middle_y_;
    double axis_x_, axis_y_;
    double along_scale_ = 0;
    double across_scale_ = 0;
};

}  // namespace waybreaker::crossing
