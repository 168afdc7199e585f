// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Far ways through a city, whose coarse grid has ever smaller cells.
#include <algorithm>
#include <cstdio>
#include <fstream>
#include <memory>
#include <vector>

#include "city.hpp"
#include "host/fine_parts.hpp"
#include "host/session.hpp"
#include "quantile.hpp"
#include "scale_rows.hpp"
#include "support/random.hpp"
#include "tern/far_way.hpp"

namespace tern_bench {
namespace {

using tern::Vec3;
using tern_test::Random;

constexpr int kWays = 300;
constexpr int kRuns = 3;  ///< of each; the least time counts
const City kCities[] = {{15.0, kCityHeight, kCityHeight}, {15.0, kCityHeight, 60.0}, {45.0, kCityHeight, 40.0}};
constexpr double kDrawn = 60.0;  ///< metres: the ceiling of the city whose rows the plot has
/// The last one is nearly as large as a grid may be: in cells of 2 m, that is 13 % of the city.
struct CityGrid {
  double edge, cell;
};
const City kNarrow = {45.0, kCityHeight, 40.0, kCityEdge, 4.0, 8.0};
const CityGrid kGrids[] = {{kCityEdge, 16.0}, {kCityEdge, 8.0}, {kCityEdge, 4.0}, {1800.0, 2.0}};

double milliseconds_since(std::uint64_t begin) {
  const tern_host::Clock clock = tern_host::platform_clock();
  return 1e3 * static_cast<double>(clock.read(clock.context) - begin) / clock.ticks_per_second;
}

/// A point in the city above no roof: half of them in the streets.
Vec3 free_point(const tern::Grid& grid, const City& city, Random& random) {
  for (;;) {
    const double top = random.chance(0.5) ? 20.0 : city.ceiling;
    const Vec3 at{random.real(0.0, city.edge), random.real(0.0, city.edge), random.real(2.0, top)};
    if (grid.free(grid.voxel_of(grid.to_local(at)))) return at;
  }
}

/// Units to the way; `least` becomes the milliseconds that it took, if they are less.
double find_way(const Vec3& start, const Vec3& goal, tern::Grid& grid, tern::Planner& planner, tern::FarWay& far,
                double& least) {
  far.start({100.0}, grid, planner);
  far.set_goal(goal);
  const tern_host::Clock clock = tern_host::platform_clock();
  const std::uint64_t begin = clock.read(clock.context);
  double spent = 0.0;
  for (; far.state() == tern::FarState::kSearching; spent += 100.0) far.tick(start, {}, {}, 0, 100);
  least = std::min(least, milliseconds_since(begin));
  return spent;
}

struct CityRow {
  std::vector<double> units, times;
  int found = 0;
  double longest = 0.0;  ///< metres
};

/// Far ways through the coarse grid, the first one from corner to corner.
CityRow find_ways(const City& city, tern::Grid& grid) {
  const auto memory = std::make_unique<tern::Workspace>();
  tern::Planner planner(memory.get(), sizeof *memory);
  CityRow row;
  Random random(2);
  for (int k = 0; k < kWays; ++k) {
    const Vec3 start = k == 0 ? Vec3{5.0, 5.0, 10.0} : free_point(grid, city, random);
    const Vec3 goal = k == 0 ? Vec3{city.edge - 5.0, city.edge - 5.0, 10.0} : free_point(grid, city, random);
    tern::FarWay far;
    double least = 1e9;
    double spent = 0.0;
    for (int run = 0; run < kRuns; ++run) {
      spent = find_way(start, goal, grid, planner, far, least);
    }
    row.times.push_back(least);
    row.units.push_back(spent);
    row.found += far.state() == tern::FarState::kLeads ? 1 : 0;
    row.longest = std::max(row.longest, far.left());
  }
  return row;
}

/// Of all the cells below the ceiling.
double free_share(const tern::Grid& grid) {
  std::int64_t free = 0;
  const tern::Voxel dims = grid.spec().dims;
  for (std::int32_t z = 0; z < dims.z; ++z) {
    for (std::int32_t y = 0; y < dims.y; ++y) {
      for (std::int32_t x = 0; x < dims.x; ++x) free += grid.free({x, y, z}) ? 1 : 0;
    }
  }
  return static_cast<double>(free) * grid.spec().cell / grid.spec().boundary.upper.z / dims.x / dims.y;
}

void over_city(const City& city, double cell, bool is_fine, std::ofstream& csv) {
  const tern::GridSpec spec = city_spec(city, cell);
  std::vector<std::uint64_t> words(tern::grid_words(spec.dims));
  tern::Grid grid;
  if (grid.bind(spec, words.data(), words.size()) != tern::Status::kOk) return;
  const tern_host::Clock clock = tern_host::platform_clock();
  const std::uint64_t begin = clock.read(clock.context);
  if (is_fine) tern_host::mark_from_fine(grid, [&](tern::Grid& fine) { build_city(city, fine); });
  if (!is_fine) build_city(city, grid);
  std::printf("%s in %.0f ms, %.1f %% free; ", is_fine ? "from voxels of a quarter of the cell" : "from boxes",
              milliseconds_since(begin), 100.0 * free_share(grid));
  const CityRow row = find_ways(city, grid);
  const double cells = static_cast<double>(spec.dims.x) * spec.dims.y * spec.dims.z;
  std::printf(
      "city of %.1f km, roofs %.0f to %.0f m, ceiling %.0f m, cells of %.0f m: %.3g of them, %.1f MB; %d of %d ways, "
      "%.1f km at most; units %.0f, %.0f at most; ms %.2f, %.2f at most\n",
      1e-3 * city.edge, city.low, city.high, city.ceiling, cell, cells, 8e-6 * static_cast<double>(words.size()),
      row.found, kWays, 1e-3 * row.longest, quantile(row.units, 0.5), quantile(row.units, 1.0),
      quantile(row.times, 0.5), quantile(row.times, 1.0));
  if (is_fine || city.ceiling != kDrawn || city.edge < kCityEdge) return;
  csv << "coarse cells," << cells << ',' << row.found << ',' << kWays << ",0,0,0,0,0,0,0," << quantile(row.units, 0.5)
      << ",0,0\n";
}

}  // namespace

void over_cities(std::ofstream& csv) {
  for (City city : kCities) {
    for (const CityGrid& grid : kGrids) {
      city.edge = grid.edge;
      over_city(city, grid.cell, false, csv);
    }
    city.edge = kCityEdge;
    over_city(city, 4.0, true, csv);
  }
  over_city(kNarrow, 4.0, false, csv);
  over_city(kNarrow, 4.0, true, csv);
}

}  // namespace tern_bench
