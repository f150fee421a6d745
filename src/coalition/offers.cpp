#include "coalition/offers.hpp"

#include <algorithm>
#include <queue>

namespace waybreaker::coalition {
namespace {

bool better_paid(const Offer& a, const Offer& b) {
    return a.paid != b.paid ? a.paid > b.paid : a.obstacle < b.obstacle;
}

// The best paid of the offers so far, so many of them.
class BestPaid {
  public:
    explicit BestPaid(std::size_t most) : most_(most) {}

    double sum() const { return sum_; }
    // What the least paid gets; nothing where there is room for more.
    double least() const { return heap_.size() < most_ ? 0 : heap_.front().paid; }
    bool add(const Offer& offer) {
        if (most_ == 0) return false;
        if (heap_.size() == most_) {
            if (!better_paid(offer, heap_.front())) return false;
            sum_ -= heap_.front().paid;
            std::ranges::pop_heap(heap_, better_paid);
            heap_.pop_back();
        }
        sum_ += offer.paid;
        heap_.push_back(offer);
        std::ranges::push_heap(heap_, better_paid);
        return true;
    }
    const std::vector<Offer>& all() const { return heap_; }

  private:
    std::size_t most_;
    std::vector<Offer> heap_;  // the least paid on top
    double sum_ = 0;
};

}  // namespace

Offers::Offers(std::vector<Offer> offers) : offers_(std::move(offers)) {
    std::erase_if(offers_, [](const Offer& offer) { return offer.paid <= 0; });
    std::ranges::sort(offers_, [](const Offer& a, const Offer& b) {
        return a.detour != b.detour ? a.detour < b.detour : a.obstacle < b.obstacle;
    });
}

double Offers::best(std::size_t most, double floor, const Set& beside, std::vector<ObstacleId>* chosen) const {
    double best = -floor;
    std::size_t last = 0;
    BestPaid taken(most);
    for (std::size_t k = 0; k < offers_.size(); ++k) {
        if (contains(beside, offers_[k].obstacle) || !taken.add(offers_[k])) continue;
        const double value = taken.sum() - std::max(offers_[k].detour, floor);
        if (value <= best) continue;
        best = value;
        last = k + 1;
    }
    if (chosen == nullptr) return best;
    BestPaid again(most);
    for (std::size_t k = 0; k < last; ++k) {
        if (!contains(beside, offers_[k].obstacle)) again.add(offers_[k]);
    }
    chosen->clear();
    for (const Offer& offer : again.all()) chosen->push_back(offer.obstacle);
    return best;
}

double Offers::best_by_weight(const Map& map, double budget, std::vector<ObstacleId>& chosen) const {
    std::vector<Offer> order = offers_;
    const auto weight = [&](const Offer& offer) { return map.obstacle(offer.obstacle).weight; };
    std::ranges::sort(order, [&](const Offer& a, const Offer& b) {
        const double left = a.paid * weight(b);
        const double right = b.paid * weight(a);
        return left != right ? left > right : a.obstacle < b.obstacle;
    });
    chosen.clear();
    double paid = 0;
    for (const Offer& offer : order) {
        if (budget <= 0) break;
        const double share = std::min(budget / weight(offer), 1.0);
        paid += share * offer.paid;
        budget -= weight(offer);
        if (share == 1) chosen.push_back(offer.obstacle);
    }
    return paid;
}

FreeOffers::FreeOffers(const Offers& offers, std::size_t most) : most_(most), best_(offers.best(most)) {
    steps_.push_back({.left = best_});
    BestPaid taken(most);
    for (const Offer& offer : offers.all()) {
        taken.add(offer);
        steps_.push_back({offer.detour, taken.sum(), taken.least(), best_ - (taken.sum() - offer.detour)});
    }
    for (std::size_t k = steps_.size() - 1; k-- > 0;) steps_[k].left = std::min(steps_[k].left, steps_[k + 1].left);
}

// Of a set with that detour at most, each member that nobody pays for takes the place of another that is paid as much,
// but for its share of what is left.
double FreeOffers::of(double detour) const {
    const auto next = std::ranges::upper_bound(steps_, detour, {}, &Step::detour);
    const Step& last = *(next - 1);
    const double left = std::min(best_ - (last.paid - detour), next == steps_.end() ? infinity : next->left);
    return last.least + std::max(left, 0.0) / double(std::max<std::size_t>(most_, 1));
}

}  // namespace waybreaker::coalition
