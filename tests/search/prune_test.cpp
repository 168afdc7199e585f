// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The pruning rules against their definition: every way through the 27 cells around a voxel is tried.
#include "search/prune.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <vector>

#include "search/neighbourhood.hpp"
#include "support/path_world.hpp"
#include "support/random.hpp"

namespace {

using tern::CellMask;
using tern::Voxel;
using tern_test::Random;
using tern_test::scaled;

constexpr int kCentre = 13;
constexpr double kEqual = 1e-9;

struct Move {
  int x, y, z;
  int axes() const { return (x != 0) + (y != 0) + (z != 0); }
  double cost() const { return std::sqrt(static_cast<double>(axes())); }
};

Move move_of(int d) {
  return {d % 3 - 1, d / 3 % 3 - 1, d / 9 - 1};
}
bool in_cube(const Move& c) {
  return std::abs(c.x) <= 1 && std::abs(c.y) <= 1 && std::abs(c.z) <= 1;
}
int cell_of(const Move& c) {
  return (c.x + 1) + 3 * (c.y + 1) + 9 * (c.z + 1);
}

/// The cells that a move from a cell needs free, by the definition; the move must stay within the 27 cells.
CellMask needed(int from, int move) {
  const Move at = move_of(from);
  const Move m = move_of(move);
  CellMask cells = 0;
  for (int x = 0; x <= 1; ++x) {
    for (int y = 0; y <= 1; ++y) {
      for (int z = 0; z <= 1; ++z) cells |= 1u << cell_of({at.x + x * m.x, at.y + y * m.y, at.z + z * m.z});
    }
  }
  return cells;
}

/// Least costs of the ways inside the 27 cells from one of them to each, avoiding the centre; `first_axes` other than 0
/// allows only first moves along so many axes.
std::vector<double> detour_costs(CellMask free, int from, int first_axes) {
  std::vector<double> cost(27, 1e9);
  const auto step = [&](int at, double base, int only_axes) {
    for (int d = 0; d < 27; ++d) {
      const Move m = move_of(d);
      const Move c = move_of(at);
      const Move next{c.x + m.x, c.y + m.y, c.z + m.z};
      if (d == kCentre || !in_cube(next) || cell_of(next) == kCentre) continue;
      if (only_axes != 0 && m.axes() != only_axes) continue;
      if ((free & needed(at, d)) != needed(at, d)) continue;
      double& known = cost[static_cast<std::size_t>(cell_of(next))];
      known = std::min(known, base + m.cost());
    }
  };
  step(from, 0.0, first_axes);
  // Bellman-Ford: a cheapest way costs 2 sqrt(3) at most where it matters, so that four rounds settle it.
  for (int round = 0; round < 4; ++round) {
    for (int at = 0; at < 27; ++at) {
      if (at != kCentre && cost[static_cast<std::size_t>(at)] < 1e8) step(at, cost[static_cast<std::size_t>(at)], 0);
    }
  }
  return cost;
}

/// Whether the definition prunes each move after the arrival.
std::vector<bool> pruned_by_definition(CellMask free, int arrival) {
  const int from = 26 - arrival;
  const std::vector<double> any = detour_costs(free, from, 0);
  const std::vector<double> plane = detour_costs(free, from, 2);
  const std::vector<double> space = detour_costs(free, from, 3);
  const int axes = move_of(arrival).axes();
  std::vector<bool> pruned(27);
  for (std::size_t d = 0; d < 27; ++d) {
    const double through = move_of(arrival).cost() + move_of(static_cast<int>(d)).cost();
    pruned[d] = static_cast<int>(d) == from || any[d] < through - kEqual ||
                (axes < 2 && plane[d] <= through + kEqual) || (axes < 3 && space[d] <= through + kEqual);
  }
  return pruned;
}

void expect_rules_match(CellMask free, int arrival) {
  const CellMask moves = tern::successor_moves(arrival, free, tern::legal_moves(free));
  const std::vector<bool> pruned = pruned_by_definition(free, arrival);
  for (int d = 0; d < 27; ++d) {
    if (d == kCentre) continue;
    const bool legal = (free & needed(kCentre, d)) == needed(kCentre, d);
    const bool wanted = legal && !pruned[static_cast<std::size_t>(d)];
    ASSERT_EQ((moves >> d & 1u) != 0, wanted) << "arrival " << arrival << " move " << d << " free " << free;
  }
}

/// The cells that an arrival guarantees to be free.
CellMask arrival_cells(int arrival) {
  return needed(26 - arrival, arrival);
}

TEST(PathPrune, MatchesDefinitionOnRandomNeighbourhoods) {
  Random random(11);
  for (int k = 0; k < scaled(1500); ++k) {
    CellMask free = 0;
    const double density = random.real(0.05, 0.95);
    for (int c = 0; c < 27; ++c) free |= random.chance(density) ? 1u << c : 0u;
    for (int arrival = 0; arrival < 27; ++arrival) {
      if (arrival != kCentre) expect_rules_match(free | arrival_cells(arrival), arrival);
    }
  }
}

// Up to three blocked cells anywhere: every rule has its own minimal obstacle among them.
TEST(PathPrune, MatchesDefinitionOnEveryFewBlockedCells) {
  for (const int arrival : {tern::direction(1, 0, 0), tern::direction(0, -1, 1), tern::direction(-1, 1, 1)}) {
    for (int a = 0; a < 27; ++a) {
      for (int b = a; b < 27; ++b) {
        for (int c = b; c < 27; c += scaled(20) < 20 ? 9 : 1) {
          const CellMask blocked = 1u << a | 1u << b | 1u << c;
          expect_rules_match((tern::kAllCells & ~blocked) | arrival_cells(arrival), arrival);
        }
      }
    }
  }
}

TEST(PathPrune, OpenSpaceForcesNothing) {
  for (int arrival = 0; arrival < 27; ++arrival) {
    if (arrival == kCentre) continue;
    EXPECT_EQ(tern::forced_moves(arrival, tern::kAllCells, tern::legal_moves(tern::kAllCells)), 0u);
    const int axes = tern::axes_of(arrival);
    EXPECT_EQ(__builtin_popcount(tern::successor_moves(arrival, tern::kAllCells, tern::legal_moves(tern::kAllCells))),
              axes == 1 ? 1 : (axes == 2 ? 3 : 7));
  }
  EXPECT_EQ(__builtin_popcount(tern::successor_moves(tern::kHere, tern::kAllCells, tern::legal_moves(tern::kAllCells))),
            26);
}

TEST(PathPrune, BlockedCellBesideForcesTheTurnPastIt) {
  // Arriving along +x past a blocked cell at (-1, 1, 0): straight and diagonal turns to +y open up.
  const CellMask free = tern::kAllCells & ~tern::cell_bit(tern::direction(-1, 1, 0));
  const CellMask forced = tern::forced_moves(tern::direction(1, 0, 0), free, tern::legal_moves(free));
  EXPECT_NE(forced & tern::cell_bit(tern::direction(0, 1, 0)), 0u);
  EXPECT_NE(forced & tern::cell_bit(tern::direction(1, 1, 0)), 0u);
  EXPECT_EQ(forced & tern::cell_bit(tern::direction(0, -1, 0)), 0u);
}

TEST(PathNeighbourhood, MatchesTheGridAtWordsAndFaces) {
  Random random(12);
  tern_test::VoxelWorld world({130, 3, 4});
  for (int k = 0; k < 700; ++k) {
    world.grid.mark_voxel({random.integer(0, 129), random.integer(0, 2), random.integer(0, 3)});
  }
  world.grid.inflate();
  for (int x = 0; x < 130; ++x) {
    for (int y = 0; y < 3; ++y) {
      for (int z = 0; z < 4; ++z) {
        const CellMask free = tern::free_cells(world.grid, {x, y, z});
        for (int c = 0; c < 27; ++c) {
          const Move m = move_of(c);
          ASSERT_EQ((free >> c & 1u) != 0, world.grid.free({x + m.x, y + m.y, z + m.z}));
        }
      }
    }
  }
}

}  // namespace
