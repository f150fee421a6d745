// Estimate: a mean over missions with its 95 % confidence interval.
#pragma once

#include <cstddef>
#include <vector>

namespace waybreaker::experiment {

struct Estimate {
    double mean = 0;
    double low = 0;  // low = high = mean where the interval is unknown: fewer than two places
    double high = 0;
    std::size_t count = 0;  // of missions
};

// Missions in one place (places.hpp) are correlated, places are independent: the variance is that of the places' sums
// (the cluster-robust variance of a mean), the interval Student's with one degree of freedom fewer than there are
// places.
class Estimator {
  public:
    explicit Estimator(std::size_t places) : places_(places) {}
    void add(std::size_t place, double value);
    Estimate estimate() const;

  private:
    struct OfPlace {
        double sum = 0;
        std::size_t count = 0;
    };
    std::vector<OfPlace> places_;
};

// Half the width of a 95 % interval in standard errors. Precondition: degrees > 0.
double student_95(std::size_t degrees);

}  // namespace waybreaker::experiment
