// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TERN_HOST_FLIGHT_STACK_MARGIN_HPP
#define TERN_HOST_FLIGHT_STACK_MARGIN_HPP

#include "host/flight/flown_plan.hpp"

namespace tern_host {

/// What a plan's tracking margin must hold, measured over flights of the plan that differ in their seeds.
struct StackMargin {
  int flights = 0;
  std::uint64_t worst_seed = 0;
  double controller = 0.0;  ///< largest distance of the estimate from the command, metres
  double estimate = 0.0;    ///< largest error of the estimate, metres
  double rms = 0.0;         ///< of the controller, in the worst flight
  std::string samples;      ///< of the worst flight, as a table

  /// The margin to set: both errors may point the same way. Whole centimetres.
  double needed() const;
};

/// A length rounded up to centimetres.
double up_to_centimetres(double metres);

/// Flies the plan with the seeds from the settings' one on.
StackMargin measure_margin(const tern::Trajectory& plan, const FlightSettings& settings, int flights);

}  // namespace tern_host

#endif
