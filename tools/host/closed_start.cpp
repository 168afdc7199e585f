// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "host/closed_start.hpp"

#include <algorithm>
#include <cmath>

#include "host/number.hpp"

namespace tern_host {
namespace {

bool is_closed_for_a_while(const tern::Fence& fence) {
  return fence.kind == tern::FenceKind::kKeepOut && tern::is_timed(fence);
}

/// s of the scenario's clock.
double begin_of(const tern::Fence& fence) {
  return 1e-9 * static_cast<double>(fence.from) - fence.clock_error;
}

double end_of(const tern::Fence& fence) {
  return 1e-9 * static_cast<double>(fence.until) + fence.clock_error;
}

/// The end of all fences for a while that the start is in, one after the other.
double start_is_free_at(const Scenario& scenario) {
  double free = scenario.start_time;
  // Each round passes the end of a fence.
  for (std::size_t round = 0; round < scenario.fences.size(); ++round) {
    double next = free;
    for (const FenceRecord& record : scenario.fences) {
      const bool holds =
          is_closed_for_a_while(record.fence) && begin_of(record.fence) <= free && free < end_of(record.fence);
      if (!holds || fence_gap(record, scenario.start.position) >= scenario.clearance()) continue;
      next = std::max(next, end_of(record.fence));
    }
    if (!(next > free)) break;
    free = next;
  }
  return free;
}

/// Rounded upwards, but for rounding errors.
double whole_milliseconds(double time) {
  return std::ceil(1e3 * time - 1e-6);
}

std::string time_text(const Scenario& scenario, double time) {
  const double ms = whole_milliseconds(time);
  const std::string text = fixed(ms / 1e3, 3) + " s of the clock";
  if (scenario.earth.epoch.empty() || !(std::fabs(time) < 1e9)) return text;
  const Instant at = *parse_instant(scenario.earth.epoch) + static_cast<Instant>(ms) * (kSecond / 1000);
  return text + " (" + instant_text(at) + ")";
}

}  // namespace

std::string describe_closed_start(const PlanResult& result) {
  const tern::Report& report = result.report;
  const Scenario& scenario = result.scenario;
  if (report.fence < 0 || static_cast<std::size_t>(report.fence) >= scenario.fences.size()) return "";
  const FenceRecord& record = scenario.fences[static_cast<std::size_t>(report.fence)];
  if (!is_closed_for_a_while(record.fence)) return "";
  std::string text = "; it is closed until " + time_text(scenario, end_of(record.fence));
  const double free = start_is_free_at(scenario);
  if (!(free > scenario.start_time)) return text;
  text += "; the start is in it: it is free at " + time_text(scenario, free);
  return text + ". Begin then (start_time " + shortest(whole_milliseconds(free) / 1e3) + "), or elsewhere";
}

}  // namespace tern_host
