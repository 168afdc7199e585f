// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The reader of OctoMap files against OctoMap's own library: random trees, leaf by leaf.
#include <gtest/gtest.h>
#include <octomap/ColorOcTree.h>
#include <octomap/octomap.h>

#include <map>
#include <sstream>
#include <tuple>

#include "host/map/octomap_file.hpp"
#include "support/random.hpp"

namespace {

using tern_host::Octomap;
using tern_host::OctomapLeaf;
using tern_test::Random;

using Leaves = std::map<std::tuple<std::uint32_t, std::uint32_t, std::uint32_t>, std::pair<std::uint32_t, bool>>;

template <typename Tree>
Leaves leaves_of(const Tree& tree) {
  Leaves leaves;
  for (auto it = tree.begin_leafs(); it != tree.end_leafs(); ++it) {
    const std::uint32_t size = 1u << (tree.getTreeDepth() - it.getDepth());
    const octomap::OcTreeKey key = it.getIndexKey();
    leaves[{key[0], key[1], key[2]}] = {size, tree.isNodeOccupied(*it)};
  }
  return leaves;
}

Leaves leaves_of(const Octomap& map) {
  Leaves leaves;
  for (const OctomapLeaf& leaf : map.leaves) {
    leaves[{leaf.key[0], leaf.key[1], leaf.key[2]}] = {leaf.size, leaf.occupied};
  }
  return leaves;
}

/// Boxes that are free or occupied, some so large that they are pruned.
template <typename Tree>
void fill(Random& random, Tree& tree) {
  for (int k = random.integer(0, 12); k > 0; --k) {
    const int edge = random.integer(1, 9);
    const int at[3] = {random.integer(-40, 40), random.integer(-40, 40), random.integer(-40, 40)};
    const bool occupied = random.chance(0.4);
    for (int i = 0; i < edge * edge * edge; ++i) {
      const octomap::OcTreeKey key(static_cast<octomap::key_type>(32768 + at[0] + i % edge),
                                   static_cast<octomap::key_type>(32768 + at[1] + i / edge % edge),
                                   static_cast<octomap::key_type>(32768 + at[2] + i / edge / edge));
      tree.updateNode(key, occupied, true);
      if (random.chance(0.05)) tree.updateNode(key, !occupied, true);
    }
  }
  if (tree.size() == 0) return;  // the library does not look after trees without a root
  tree.updateInnerOccupancy();
  tree.prune();
}

TEST(MapOctomap, ReadsTheLeavesThatTheLibraryWrote) {
  Random random(71);
  std::size_t most = 0;
  for (int k = 0; k < tern_test::scaled(200); ++k) {
    octomap::OcTree tree(random.real(0.05, 0.5));
    fill(random, tree);
    std::stringstream full;
    tree.write(full);
    const Octomap map = tern_host::parse_octomap(full.str(), {"full", 0});
    ASSERT_NEAR(map.resolution, tree.getResolution(), 1e-5);
    ASSERT_EQ(leaves_of(map), leaves_of(tree)) << k;
    most = std::max(most, map.leaves.size());
    tree.toMaxLikelihood();
    tree.prune();
    if (tree.size() < 2) continue;  // a lone root has no place in a .bt
    std::stringstream binary;
    tree.writeBinaryConst(binary);
    ASSERT_EQ(leaves_of(tern_host::parse_octomap(binary.str(), {"binary", 0})), leaves_of(tree)) << k;
  }
  EXPECT_GT(most, 500u);
}

TEST(MapOctomap, PassesOverColours) {
  Random random(72);
  for (int k = 0; k < tern_test::scaled(40); ++k) {
    octomap::ColorOcTree tree(0.1);
    fill(random, tree);
    std::stringstream full;
    tree.write(full);
    ASSERT_EQ(leaves_of(tern_host::parse_octomap(full.str(), {"colour", 0})), leaves_of(tree)) << k;
  }
}

}  // namespace
