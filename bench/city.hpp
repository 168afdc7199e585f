// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// A city of 5 x 5 x 0.15 km for far ways: blocks of 60 m, streets of 20 m, and four in ten of them built over for the
// length of a block.
#ifndef TERN_BENCH_CITY_HPP
#define TERN_BENCH_CITY_HPP

#include <cstdint>

#include "support/random.hpp"
#include "tern/grid.hpp"

namespace tern_bench {

constexpr double kCityEdge = 5000.0;
constexpr double kCityHeight = 150.0;
constexpr double kBlock = 60.0;
constexpr double kStreet = 20.0;

struct City {
  double low, high;  ///< roofs, metres
  double ceiling;    ///< of the flight
  double edge = kCityEdge;
};

/// Cells from face to face, the last one in part beyond it.
inline std::int32_t city_cells(double size, double cell) {
  const auto whole = static_cast<std::int32_t>(size / cell);
  return whole * cell < size ? whole + 1 : whole;
}

inline tern::GridSpec city_spec(const City& city, double cell) {
  const tern::Voxel dims{city_cells(city.edge, cell), city_cells(city.edge, cell), city_cells(kCityHeight, cell)};
  return {{0.0, 0.0, 0.0}, cell, dims, {{0.0, 0.0, 0.0}, {city.edge, city.edge, city.ceiling}}, 0.0, 0.0};
}

/// Marks the city in a grid of city_spec(), and inflates it.
inline void build_city(const City& city, tern::Grid& grid) {
  tern_test::Random random(1);
  for (double x = kStreet; x + kBlock < city.edge; x += kBlock + kStreet) {
    for (double y = kStreet; y + kBlock < city.edge; y += kBlock + kStreet) {
      const double roof = random.real(city.low, city.high);
      const bool east = random.chance(0.2);
      const bool north = random.chance(0.2);
      grid.mark_box({{x, y, 0.0}, {x + kBlock, y + kBlock, roof}});
      if (east) grid.mark_box({{x + kBlock, y, 0.0}, {x + kBlock + kStreet, y + kBlock, roof}});
      if (north) grid.mark_box({{x, y + kBlock, 0.0}, {x + kBlock, y + kBlock + kStreet, roof}});
    }
  }
  grid.inflate();
}

}  // namespace tern_bench

#endif
