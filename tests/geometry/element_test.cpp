// Paths in trees under elements, and leaves that are a whole.
#include "geometry/element.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <set>

#include "kernel/support/failure.h"

namespace hottel::element_test {
namespace {

TreePath path(std::initializer_list<int> digits) { return TreePath(std::vector<int>(digits)); }

// Leaves of a random tree, in order.
void append_random(std::vector<TreeNode>& leaves, const TreeNode& node, int children, int depth, std::mt19937& random) {
  if (depth == 0 || random() % 3 == 0) {
    leaves.push_back(node);
    return;
  }
  for (int digit = 0; digit < children; ++digit)
    append_random(leaves, {node.part, node.path.child(digit)}, children, depth - 1, random);
}

TEST(TreePath, IsSpelledAsTheContractHasIt) {
  EXPECT_EQ(TreePath().text(), "");
  EXPECT_EQ(path({0, 1}).text(), "/01");
  EXPECT_EQ(path({3, 0, 2, 1}).text(), "/3021");
  EXPECT_EQ(element_name("wall", 1, {}), "wall");
  EXPECT_EQ(element_name("wall", 4, {2, {}}), "wall#2");
  EXPECT_EQ(element_name("wall:back", 1, {0, path({0, 1})}), "wall:back#0/01");
  EXPECT_EQ(element_name("wall", 4, {3, path({1})}), "wall#3/1");
}

TEST(TreePath, IsOrderedAsNodesAreMetANodeBeforeThoseUnderIt) {
  const std::vector<TreePath> order{path({}),     path({0}), path({0, 0}),    path({0, 0, 3}),
                                    path({0, 1}), path({1}), path({1, 0, 0}), path({1, 3}),
                                    path({2}),    path({3}), path({3, 3}),    path({3, 3, 3})};
  for (std::size_t a = 0; a < order.size(); ++a)
    for (std::size_t b = 0; b < order.size(); ++b) EXPECT_EQ(order[a] < order[b], a < b) << a << " " << b;
}

TEST(TreePath, HoldsWhatLiesUnderIt) {
  EXPECT_TRUE(path({}).holds(path({})));
  EXPECT_TRUE(path({}).holds(path({3, 2})));
  EXPECT_TRUE(path({1, 2}).holds(path({1, 2})));
  EXPECT_TRUE(path({1, 2}).holds(path({1, 2, 0})));
  EXPECT_FALSE(path({1, 2}).holds(path({1})));
  EXPECT_FALSE(path({1, 2}).holds(path({1, 3, 0})));
  EXPECT_FALSE(path({0}).holds(path({1})));
}

TEST(TreePath, GoesDownAndUp) {
  std::mt19937 random(1);
  TreePath here;
  std::vector<int> digits;
  for (int level = 0; level < TreePath::kMostLevels; ++level) {
    digits.push_back(static_cast<int>(random() % 4));
    const TreePath next = here.child(digits.back());
    EXPECT_EQ(next.parent(), here);
    EXPECT_EQ(next.depth(), level + 1);
    here = next;
    for (std::size_t k = 0; k < digits.size(); ++k) EXPECT_EQ(here.digit(static_cast<int>(k)), digits[k]);
  }
  EXPECT_THROW(here.child(0), ContractViolation);
  EXPECT_THROW(TreePath().child(4), ContractViolation);
  EXPECT_EQ(here, TreePath(digits));
}

TEST(TreeLeaves, OfARandomTreeAreWholeUntilOneIsTakenAwayOrTold) {
  std::mt19937 random(2);
  for (int round = 0; round < 200; ++round) {
    const int children = round % 2 == 0 ? 2 : 4;
    std::vector<TreeNode> leaves;
    for (std::uint32_t part = 0; part < 3; ++part) append_random(leaves, {part, {}}, children, 4, random);
    EXPECT_TRUE(std::ranges::is_sorted(leaves));
    EXPECT_TRUE(are_whole(leaves, 3, children));
    EXPECT_FALSE(are_whole(leaves, 4, children));
    const std::size_t at = random() % leaves.size();
    std::vector<TreeNode> less = leaves, twice = leaves, turned = leaves;
    less.erase(less.begin() + static_cast<std::ptrdiff_t>(at));
    EXPECT_FALSE(are_whole(less, 3, children));
    twice.insert(twice.begin() + static_cast<std::ptrdiff_t>(at), leaves[at]);
    EXPECT_FALSE(are_whole(twice, 3, children));
    std::swap(turned.front(), turned.back());
    EXPECT_FALSE(are_whole(turned, 3, children));
  }
}

TEST(TreeLeaves, OfOneDepthAreWholeAndAsMany) {
  EXPECT_EQ(uniform_leaves(3, 4, 0).size(), 3u);
  EXPECT_EQ(uniform_leaves(3, 2, 5).size(), 96u);
  EXPECT_TRUE(are_whole(uniform_leaves(3, 4, 3), 3, 4));
  EXPECT_FALSE(are_whole(uniform_leaves(3, 2, 3), 3, 4));
}

}  // namespace
}  // namespace hottel::element_test
