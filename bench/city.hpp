// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// A city of 5 x 5 x 0.15 km for far ways: blocks of 60 m, streets of 20 m or as wide as they come, and four in ten of
// them built over for the length of a block.
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
  double narrowest = kStreet, widest = kStreet;
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

/// Marks what a grid holds of the city, and inflates it.
inline void build_city(const City& city, tern::Grid& grid) {
  tern_test::Random random(1);
  tern_test::Random columns(2);
  double x = columns.real(city.narrowest, city.widest);
  while (x + kBlock < city.edge) {
    const double east_end = x + kBlock + columns.real(city.narrowest, city.widest);
    tern_test::Random rows(3);
    double y = rows.real(city.narrowest, city.widest);
    while (y + kBlock < city.edge) {
      const double north_end = y + kBlock + rows.real(city.narrowest, city.widest);
      const double roof = random.real(city.low, city.high);
      const bool east = random.chance(0.2);
      const bool north = random.chance(0.2);
      grid.mark_box({{x, y, 0.0}, {x + kBlock, y + kBlock, roof}});
      if (east) grid.mark_box({{x + kBlock, y, 0.0}, {east_end, y + kBlock, roof}});
      if (north) grid.mark_box({{x, y + kBlock, 0.0}, {x + kBlock, north_end, roof}});
      y = north_end;
    }
    x = east_end;
  }
  grid.inflate();
}

}  // namespace tern_bench

#endif
