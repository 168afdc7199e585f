// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// docs/flight.md: a flight's loop. The camera sees nothing here: the vehicle moves within what it was told is free.
#include <cmath>
#include <cstdint>
#include <memory>
#include <vector>

#include "tern/tern.hpp"

namespace {

struct Camera {
  bool has_frame() const { return false; }
  tern::DepthView view() const { return {}; }
  tern::Pose pose() const { return {}; }
};

struct Vehicle {
  void follow(const tern::Command& command) { position = command.sample.position; }
  tern::Vec3 position{};
};

}  // namespace

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
  flight.set_goal({3.0, 1.0, 1.5});

  Camera camera;
  Vehicle vehicle;
  tern::FlightReport report{};
  const std::int64_t timeout = 20000000000;
  std::int64_t now = 0;
  while (report.reason != tern::FlightReason::kArrived && now < timeout) {
    if (camera.has_frame() && !map.busy()) map.begin_frame(camera.view(), camera.pose(), now);
    flight.tick(now, report);
    vehicle.follow(flight.command(now));
    now += spec.tick;
  }
  return std::abs(vehicle.position.x - 3.0) < 1e-9 && std::abs(vehicle.position.y - 1.0) < 1e-9 ? 0 : 1;
}
