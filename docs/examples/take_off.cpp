// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// From the ground into the air, and back to it. What is flown here is what the operator stated: there is no camera.
#include <cstdint>
#include <cstdio>
#include <memory>
#include <vector>

#include "tern/flight.hpp"

int main() {
  const double ground = 0.05;    // the highest of it, and what the sensor may be wrong by
  const double standing = 0.15;  // the height of the vehicle's centre where it stands
  const double x = 3.0;
  const double y = 2.0;
  const tern::MapSpec map_spec = tern::map_spec({-10.0, -10.0, -0.6}, 0.2, {128, 100, 20}, 0.35);
  std::vector<std::uint64_t> map_words(tern::map_words(map_spec));
  tern::RollingMap map;
  if (map.bind(map_spec, map_words.data(), map_words.size()) != tern::Status::kOk) return 1;

  const tern::FlightSpec spec = tern::flight_spec({{3.0, 3.0, 2.0}, {6.0, 6.0, 6.0}});
  auto memory = std::make_unique<tern::Workspace>();
  tern::Planner planner(memory.get(), sizeof *memory);
  std::vector<std::uint64_t> words(tern::flight_words(map_spec.dims));
  tern::Flight flight;
  tern::FlightRefusal refusal;
  map.assume_column({{x, y, ground}, 1.3, 3.0});  // base, radius, height
  const tern::Status started =
      flight.start(spec, map, planner, words.data(), words.size(), {x, y, standing}, 0, &refusal);
  if (started != tern::Status::kOk) {
    std::printf("%s: %s\n", tern::status_name(started), tern::blocked_by_text(refusal.blocked_by));
    return 1;
  }

  tern::FlightReport report{};
  std::int64_t now = 0;
  const auto fly_to = [&](tern::FlightReason end) {
    for (; report.reason != end && now < 20000000000; now += spec.tick) flight.tick(now, report);
    std::printf("%5.2f s: %s, %.2f m high\n", 1e-9 * static_cast<double>(now), tern::flight_reason_text(report.reason),
                flight.command(now).sample.position.z);
    return report.reason == end;
  };
  flight.set_goal({x, y, 1.6});
  if (!fly_to(tern::FlightReason::kArrived)) return 1;
  flight.land({x, y, standing}, ground, 0.5);
  return fly_to(tern::FlightReason::kLanded) ? 0 : 1;
}
