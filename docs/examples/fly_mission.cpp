// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// docs/missions.md and docs/yaw.md: a mission in flight, with a planned yaw. There is no camera here: the vehicle moves
// within what it was told is free.
#include <cstdint>
#include <memory>
#include <vector>

#include "tern/tern.hpp"

static tern::Status fly_mission(tern::Flight& flight) {
  tern::Via points[3];
  points[0].position = {3.0, 0.0, 1.5};
  points[0].tolerance = 0.3;
  points[1].position = {3.0, 2.0, 1.5};
  points[1].stop = true;
  points[2].position = {0.0, 0.0, 1.5};  // the goal
  return flight.set_mission(points, 3, tern::ViaPolicy::kSkip);
}

static tern::Status look_ahead(tern::Flight& flight) {
  tern::FlightYaw yaw{};
  yaw.mode = tern::FlightYawMode::kTowardsUnseen;
  yaw.acceleration_max = 8.0;  // rad/s^2; the limit on the rate is FlightSpec::yaw_rate
  yaw.field_of_view = 1.57;    // the camera's horizontal field of view, rad
  yaw.start = {1.0, 0.0};
  return flight.set_yaw(yaw);
}

int main() {
  const tern::MapSpec map_spec = tern::map_spec({-25.6, -15.0, -0.4}, 0.2, {256, 150, 20}, 0.35);
  std::vector<std::uint64_t> map_words(tern::map_words(map_spec));
  tern::RollingMap map;
  map.bind(map_spec, map_words.data(), map_words.size());
  const tern::Vec3 start{0.0, 0.0, 1.5};
  map.assume_free(start, 6.0);

  auto memory = std::make_unique<tern::Workspace>();
  tern::Planner planner(memory.get(), sizeof *memory);
  const tern::FlightSpec spec = tern::flight_spec({{3.0, 3.0, 2.0}, {6.0, 6.0, 6.0}});
  std::vector<std::uint64_t> words(tern::flight_words(map_spec.dims));
  tern::Flight flight;
  if (flight.start(spec, map, planner, words.data(), words.size(), start, 0) != tern::Status::kOk) return 1;
  if (fly_mission(flight) != tern::Status::kOk || look_ahead(flight) != tern::Status::kOk) return 1;

  tern::FlightReport report{};
  for (std::int64_t now = 0; report.reason != tern::FlightReason::kArrived && now < 20000000000; now += spec.tick) {
    flight.tick(now, report);
  }
  return report.passed == 3 ? 0 : 1;
}
