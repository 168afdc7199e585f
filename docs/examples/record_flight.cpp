// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// docs/record.md: a flight is recorded through a small buffer, and flown again from what was saved.
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "host/flight/flight_replay.hpp"
#include "tern/tern.hpp"

static std::uint8_t bytes[8192];
static std::string saved;

/// Stands for a memory card or a link.
static void save(const std::uint8_t* from, std::size_t count) {
  saved.append(reinterpret_cast<const char*>(from), count);
}

int main() {
  const tern::MapSpec map_spec = tern::map_spec({-12.8, -6.4, -0.4}, 0.2, {128, 64, 20}, 0.35);
  const tern::FlightSpec spec = tern::flight_spec({{3.0, 3.0, 2.0}, {6.0, 6.0, 6.0}});
  const tern::Vec3 start{0.0, 0.0, 1.5}, goal{2.0, 1.0, 1.5};
  std::vector<std::uint64_t> map_words(tern::map_words(map_spec)), words(tern::flight_words(map_spec.dims));
  const auto memory = std::make_unique<tern::Workspace>();
  tern::Planner planner(memory.get(), sizeof *memory);
  tern::RollingMap map;
  tern::Flight flight;
  tern::FlightReport report{};
  tern::FlightRecorder recorder;

  recorder.begin(bytes, sizeof bytes);
  recorder.bind(map_spec, map.bind(map_spec, map_words.data(), map_words.size()));
  recorder.assume_free(start, 4.0, map.assume_free(start, 4.0));
  recorder.start(spec, start, 0, flight.start(spec, map, planner, words.data(), words.size(), start, 0));
  recorder.set_goal(goal, flight.set_goal(goal));
  for (std::int64_t now = 0; report.reason != tern::FlightReason::kArrived && now < 20000000000; now += spec.tick) {
    recorder.tick(flight, now, report, flight.tick(now, report));
    if (recorder.pending() < sizeof bytes / 2) continue;
    save(bytes, recorder.pending());
    recorder.clear();
  }
  std::size_t used = 0;
  if (recorder.close(&used) == tern::Status::kOk) save(bytes, used);

  const tern_host::FlightReplay replay = tern_host::replay_flight(saved);
  return report.reason == tern::FlightReason::kArrived && replay.ticks > 100 && replay.difference.empty() ? 0 : 1;
}
