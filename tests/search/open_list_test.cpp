// The open list against a sorted one.
#include "search/open_list.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <vector>

namespace waybreaker {
namespace {

template <class Order>
void check_order() {
    OpenMemory memory;
    for (int query = 0; query < 2; ++query) {  // the second finds used memory
        OpenList<Order> open(memory);
        std::vector<OpenEntry> sorted;
        const double spread = *rc::gen::element(0.1, 3.0, 100.0, 1e9);
        const auto steps = *rc::gen::container<std::vector<int>>(rc::gen::resize(1000, rc::gen::inRange(-300, 700)));
        for (const int step : steps) {
            RC_ASSERT(open.empty() == sorted.empty());
            if (step < 0 && !sorted.empty()) {
                const auto first = std::min_element(sorted.begin(), sorted.end(), Order::before);
                const OpenEntry popped = open.pop();
                RC_ASSERT(popped.f == first->f);
                RC_ASSERT(popped.g == first->g);
                RC_ASSERT(popped.key.value == first->key.value);
                sorted.erase(first);
            } else if (step >= 0) {
                // Few different f and g, so that ties come up; f may fall below what was taken already.
                const OpenEntry entry{spread * (step % 40), float(step % 3), CellKey(Cell{step, int(sorted.size())})};
                open.push(entry);
                sorted.push_back(entry);
            }
        }
        std::sort(sorted.begin(), sorted.end(), Order::before);
        for (const OpenEntry& expected : sorted) RC_ASSERT(open.pop().key.value == expected.key.value);
        RC_ASSERT(open.empty());
    }
}

RC_GTEST_PROP(OpenList, TakesLargerGFirst, ()) {
    check_order<LargerGFirst>();
}

RC_GTEST_PROP(OpenList, TakesSmallerGFirst, ()) {
    check_order<SmallerGFirst>();
}

TEST(OpenList, OrdersByFThenGThenCell) {
    const OpenEntry near{1, 5, CellKey(Cell{9, 9})};
    const OpenEntry far{2, 5, CellKey(Cell{0, 0})};
    const OpenEntry deep{2, 7, CellKey(Cell{9, 9})};
    const OpenEntry later{2, 5, CellKey(Cell{1, 0})};
    EXPECT_TRUE(LargerGFirst::before(near, far) && SmallerGFirst::before(near, far));
    EXPECT_TRUE(LargerGFirst::before(deep, far) && SmallerGFirst::before(far, deep));
    EXPECT_TRUE(LargerGFirst::before(far, later) && SmallerGFirst::before(far, later));
    EXPECT_FALSE(LargerGFirst::before(far, far) || SmallerGFirst::before(far, far));
}

}  // namespace
}  // namespace waybreaker
