// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "host/nearest_thing.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "host/number.hpp"
#include "host/track_sample.hpp"

namespace tern_host {
namespace {

constexpr int kLooks = 1000;
constexpr int kThirds = 40;  ///< each leaves two thirds of an interval

}  // namespace

NearestThing nearest_thing(const tern::Trajectory& plan, const Scenario& scenario) {
  const std::vector<tern::Track> tracks = tracks_of(scenario.tracks);
  const double end = tern::duration(plan) + scenario.rest_clear;
  const double step = end / kLooks;
  NearestThing nearest;
  const auto look = [&](std::size_t k, double t) {
    const tern::Vec3 at = tern::evaluate(plan, std::min(t, tern::duration(plan))).position;
    const double gap = tube_gap(tracks[k], scenario.start_time + t, at);
    const bool is_there = gap < HUGE_VAL;
    if (is_there && (nearest.index < 0 || gap < nearest.gap)) nearest = {static_cast<std::int32_t>(k), gap, t};
    return gap;
  };
  for (std::size_t k = 0; k < tracks.size(); ++k) {
    for (int i = 0; i <= kLooks; ++i) look(k, i * step);
  }
  if (nearest.index < 0) return nearest;
  const auto k = static_cast<std::size_t>(nearest.index);
  double from = std::max(0.0, nearest.when - step), until = std::min(end, nearest.when + step);
  for (int i = 0; i < kThirds; ++i) {
    const double third = (until - from) / 3.0;
    if (look(k, from + third) < look(k, until - third)) {
      until -= third;
    } else {
      from += third;
    }
  }
  return nearest;
}

std::string nearest_thing_text(const NearestThing& nearest, const Scenario& scenario) {
  if (nearest.index < 0) return "";
  return "nearest " + scenario.tracks[static_cast<std::size_t>(nearest.index)].id + " at " + fixed(nearest.gap, 3) +
         " m";
}

}  // namespace tern_host
