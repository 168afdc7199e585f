// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "cli/flight_progress.hpp"

#include <unistd.h>

#include <cmath>
#include <cstdio>

#include "host/nanoseconds.hpp"
#include "tern/flight.hpp"

namespace tern_cli {
namespace {

constexpr std::chrono::milliseconds kPatience{500};
constexpr std::chrono::milliseconds kInterval{200};

}  // namespace

FlightProgress::FlightProgress(const tern_host::FlightWorld& world)
    : world_(world), is_terminal_(isatty(STDERR_FILENO) == 1), due_(Clock::now() + kPatience) {}

void FlightProgress::note(const tern_host::FlightMoment& moment) {
  if (!is_terminal_ || Clock::now() < due_) return;
  due_ = Clock::now() + kInterval;
  has_line_ = true;
  const tern::Vec3 p = moment.vehicle.position();
  const tern::Vec3& goal = world_.goal;
  std::fprintf(stderr, "\r%.1f s of at most %.0f s flown, %.0f m from the goal: %s  ", tern_host::seconds_of(moment.t),
               world_.settings.time_limit, std::hypot(p.x - goal.x, std::hypot(p.y - goal.y, p.z - goal.z)),
               tern::flight_mode_name(moment.report.mode));
  std::fflush(stderr);
}

void FlightProgress::finish() {
  if (has_line_) std::fprintf(stderr, "\r\033[K");
}

}  // namespace tern_cli
