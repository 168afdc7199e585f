// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The verifier's voxels are the grid's, though neither knows the other.
#include "verify/solids.hpp"

#include <gtest/gtest.h>

#include <random>
#include <sstream>

#include "host/grid_layout.hpp"
#include "host/map/scenario_grid.hpp"
#include "host/scenario.hpp"

namespace tern_verify {
namespace {

/// Faces anywhere, on the lattice, and beside it by less than its tolerance and by more.
double coordinate(std::mt19937& random, double origin, double cell) {
  const double at = origin + cell * std::uniform_int_distribution<int>(-3, 24)(random);
  constexpr double kParts[] = {0.0, 0.0, 5e-10, -5e-10, 1e-6, -1e-6, 0.37};
  return at + cell * kParts[std::uniform_int_distribution<int>(0, 6)(random)];
}

std::string random_scenario(std::mt19937& random) {
  constexpr double kOrigins[] = {0.0, -0.3, 12345.6, -1e6};
  constexpr double kCells[] = {0.1, 0.25, 0.07};
  const double origin = kOrigins[std::uniform_int_distribution<int>(0, 3)(random)];
  const double cell = kCells[std::uniform_int_distribution<int>(0, 2)(random)];
  const bool inside = random() % 2 == 0;
  const double end = origin + 20 * cell;
  std::ostringstream text;
  text.precision(17);
  const auto triple = [&](double v) { text << ' ' << v << ' ' << v << ' ' << v; };
  text << "boundary";
  triple(origin);
  triple(end);
  text << "\nstart";
  triple(origin);
  text << "\ngoal";
  triple(end);
  text << "\nresolution " << cell << "\nradius 0.2\n";
  for (int b = 0; b < 6; ++b) {
    double lower[3], upper[3];
    for (int a = 0; a < 3; ++a) {
      double p = coordinate(random, origin, cell), q = random() % 4 == 0 ? p : coordinate(random, origin, cell);
      if (inside) p = std::clamp(p, origin, end), q = std::clamp(q, origin, end);
      lower[a] = std::min(p, q);
      upper[a] = std::max(p, q);
    }
    text << "block";
    for (const double v : lower) text << ' ' << v;
    for (const double v : upper) text << ' ' << v;
    text << '\n';
  }
  return text.str();
}

bool is_solid(const std::vector<Cells>& solid, const tern::Voxel& v) {
  const long index[3] = {v.x, v.y, v.z};
  for (const Cells& cells : solid) {
    bool within = true;
    for (std::size_t a = 0; a < 3; ++a) within = within && index[a] >= cells.begin[a] && index[a] < cells.end[a];
    if (within) return true;
  }
  return false;
}

TEST(Solids, AreTheVoxelsThatTheGridMarks) {
  std::mt19937 random(7);
  for (int k = 0; k < 60; ++k) {
    const std::string text = random_scenario(random);
    const tern_host::Scenario scenario = tern_host::parse_scenario(text, "s");
    const tern::GridSpec spec = tern_host::lay_out_grid(scenario);
    std::vector<std::uint64_t> words(tern::grid_words(spec.dims));
    tern::Grid grid;
    ASSERT_EQ(grid.bind(spec, words.data(), words.size()), tern::Status::kOk);
    ASSERT_EQ(tern_host::fill_grid(scenario, grid), tern::Status::kOk);
    const Problem problem = parse_problem(text, "s");
    const Lattice lattice = lattice_of(problem);
    const std::vector<Cells> solid = solid_cells(problem, lattice);
    ASSERT_EQ(lattice.dims, (std::array<long, 3>{spec.dims.x, spec.dims.y, spec.dims.z})) << text;
    for (std::int32_t z = 0; z < spec.dims.z; ++z) {
      for (std::int32_t y = 0; y < spec.dims.y; ++y) {
        for (std::int32_t x = 0; x < spec.dims.x; ++x) {
          ASSERT_EQ(is_solid(solid, {x, y, z}), grid.obstacle({x, y, z})) << text << x << ' ' << y << ' ' << z;
        }
      }
    }
  }
}

}  // namespace
}  // namespace tern_verify
