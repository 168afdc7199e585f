// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TERN_BENCH_MARGINS_FLOWN_HPP
#define TERN_BENCH_MARGINS_FLOWN_HPP

#include <string>
#include <vector>

#include "host/flight/flown_plan.hpp"
#include "host/session.hpp"

namespace tern_bench {

/// Limits of v m/s and v m/s^2, horizontally on the norm, upright no more than PX4 flies; `jerk` of 0 is none.
tern::Limits equal_limits(double v, double jerk);

/// The limits that tern::limits_from_px4 or tern::limits_from_ardupilot give with the firmware's defaults, at v m/s.
tern::Limits preset_limits(const std::string& stack, double v);

/// Setpoints at 50 Hz.
tern_host::FlightSettings stack_settings(const std::string& stack, double speed, double drag, double wind);

/// Plans of the paper's maps 1 to 5, there and back.
class Plans {
 public:
  std::vector<tern::Trajectory> of(const tern::Limits& limits);

 private:
  tern_host::Session session_;
};

/// The largest tracking error of all plans and seeds, metres.
double largest_error(const std::vector<tern::Trajectory>& plans, const tern_host::FlightSettings& settings, int seeds);

}  // namespace tern_bench

#endif
