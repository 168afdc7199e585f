// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// docs/far_way.md: a flight that a coarse map leads. The vehicle knows all of its surroundings here, which are empty:
// the way leads around a court that the coarse map alone knows.
#include <cmath>
#include <cstdint>
#include <memory>
#include <vector>

#include "tern/tern.hpp"

namespace {

/// 320 x 320 x 16 m in cells of this edge.
std::vector<std::uint64_t> bind(double cell, tern::Grid& grid) {
  const tern::Box all{{-160.0, -160.0, 0.0}, {160.0, 160.0, 16.0}};
  const int level = static_cast<int>(320.0 / cell);
  const tern::GridSpec spec{all.lower, cell, {level, level, static_cast<int>(16.0 / cell)}, all, 0.0, 0.0};
  std::vector<std::uint64_t> words(tern::grid_words(spec.dims));
  grid.bind(spec, words.data(), words.size());
  return words;
}

/// A coarse grid with a court of three walls that is open towards -x.
std::vector<std::uint64_t> make_coarse(tern::Grid& coarse) {
  tern::Grid fine;
  const std::vector<std::uint64_t> fine_words = bind(1.0, fine);
  std::vector<std::uint64_t> words = bind(4.0, coarse);
  fine.mark_box({{20.0, -40.0, 0.0}, {24.0, 40.0, 16.0}});
  fine.mark_box({{-20.0, -40.0, 0.0}, {24.0, -36.0, 16.0}});
  fine.mark_box({{-20.0, 36.0, 0.0}, {24.0, 40.0, 16.0}});
  fine.inflate();
  coarse.mark_grid(fine);
  coarse.inflate();
  return words;
}

}  // namespace

int main() {
  tern::Grid coarse;
  const std::vector<std::uint64_t> coarse_words = make_coarse(coarse);
  const tern::MapSpec map_spec = tern::map_spec({-64.0, -64.0, -8.0}, 0.5, {256, 256, 48}, 0.5);
  std::vector<std::uint64_t> map_words(tern::map_words(map_spec));
  tern::RollingMap map;
  map.bind(map_spec, map_words.data(), map_words.size());
  const tern::Vec3 start{-40.0, 0.0, 6.0};
  map.assume_free(start, 120.0);

  auto memory = std::make_unique<tern::Workspace>();
  tern::Planner planner(memory.get(), sizeof *memory);
  auto far_memory = std::make_unique<tern::Workspace>();
  tern::Planner far_planner(far_memory.get(), sizeof *far_memory);
  const tern::FlightSpec spec = tern::flight_spec({{5.0, 5.0, 2.0}, {6.0, 6.0, 6.0}});
  std::vector<std::uint64_t> words(tern::flight_words(map_spec.dims));
  tern::Flight flight;
  if (flight.start(spec, map, planner, words.data(), words.size(), start, 0) != tern::Status::kOk) return 1;
  tern::FarWay far;
  if (far.start({60.0}, coarse, far_planner) != tern::Status::kOk) return 1;
  far.set_goal({40.0, 0.0, 6.0});

  tern::FlightReport report{};
  double most = 0.0;
  for (std::int64_t now = 0; now < 60000000000; now += spec.tick) {
    const tern::Vec3 place = flight.command(now).sample.position;
    most = std::fmax(most, std::fabs(place.y));
    const bool rests = report.mode == tern::FlightMode::kRest && report.reason > tern::FlightReason::kNoGoal;
    if (rests && far.is_last()) break;
    if (far.tick(place, report, map, now, 1000)) flight.set_goal(far.near_goal());
    flight.tick(now, report);
  }
  return report.reason == tern::FlightReason::kArrived && most > 40.0 ? 0 : 1;
}
