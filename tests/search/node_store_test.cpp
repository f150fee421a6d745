// Stamps instead of clearing: nothing of an earlier query shows through, not even when the stamps wrap around.
#include "search/node_store.hpp"

#include <gtest/gtest.h>

namespace waybreaker {
namespace {

void check_queries(NodeStore& nodes, int queries) {
    for (int query = 0; query < queries; ++query) {
        const int width = 2 + query % 3;
        nodes.begin_query(width, 4);
        for (int y = 0; y < 4; ++y) {
            for (int x = 0; x < width; ++x) {
                Node& node = nodes.at({x, y});
                ASSERT_FALSE(nodes.is_open(node)) << "query " << query;
                ASSERT_FALSE(nodes.is_closed(node)) << "query " << query;
                ASSERT_FALSE(nodes.has_parent(node, node.parent)) << "query " << query;
                ASSERT_EQ(nodes.g(node), std::numeric_limits<double>::infinity());
                node.g = query;
                node.parent = CellKey(Cell{x, 0});
                nodes.open(node);
                ASSERT_TRUE(nodes.is_open(node));
                ASSERT_TRUE(nodes.has_parent(node, CellKey(Cell{x, 0})));
                if ((x + y) % 2 == 0) nodes.close(node);
                ASSERT_EQ(nodes.is_closed(node), (x + y) % 2 == 0);
                ASSERT_EQ(nodes.g(node), query);
            }
        }
    }
}

TEST(NodeStore, ForgetsBetweenQueries) {
    NodeStore nodes;
    check_queries(nodes, 12);
}

TEST(NodeStore, ForgetsWhenStampsWrapAround) {
    constexpr std::uint32_t queries_before_wrap = 5;
    NodeStore nodes(~std::uint32_t{0} / 2 - queries_before_wrap);
    check_queries(nodes, 12);
    // Cells written just after construction and not since must not come back either.
    NodeStore sparse(~std::uint32_t{0} / 2);
    sparse.begin_query(4, 4);
    EXPECT_FALSE(sparse.is_open(sparse.at({3, 3})));
    EXPECT_FALSE(sparse.is_closed(sparse.at({3, 3})));
}

TEST(CellKey, HoldsEveryCellOfTheLargestMap) {
    for (const Cell c : {Cell{0, 0}, Cell{32767, 0}, Cell{0, 32767}, Cell{32767, 32767}, Cell{12345, 321}}) {
        EXPECT_EQ(CellKey(c).cell(), c);
    }
    EXPECT_LT(CellKey(Cell{32767, 4}).value, CellKey(Cell{0, 5}).value);
}

}  // namespace
}  // namespace waybreaker
