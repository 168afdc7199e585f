// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "host/flight/stack_margin.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace tern_host {

double up_to_centimetres(double metres) {
  return 0.01 * std::ceil(100.0 * metres - 1e-9);
}

double StackMargin::needed() const {
  return up_to_centimetres(controller + estimate);
}

StackMargin measure_margin(const tern::Trajectory& plan, const FlightSettings& settings, int flights) {
  StackMargin margin;
  for (FlightSettings s = settings; margin.flights < flights; ++margin.flights, ++s.seed) {
    FlightResult flown = fly_plan(plan, s);
    margin.estimate = std::max(margin.estimate, flown.pose_max);
    if (margin.flights > 0 && flown.tracking_max <= margin.controller) continue;
    margin.worst_seed = s.seed;
    margin.controller = flown.tracking_max;
    margin.rms = flown.tracking_rms;
    margin.samples = std::move(flown.samples);
  }
  return margin;
}

}  // namespace tern_host
