// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "host/closed_start.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "host/number.hpp"

namespace tern_host {
namespace {

using tern::Vec3;

/// s: what is closed for longer, by `tern airspace`, has no end.
constexpr double kNoEnd = 1e9;

/// A keep-out for a while: s of the scenario's clock, and how far the start is outside it, metres.
struct Closed {
  double from;
  double until;
  double gap;
};

std::optional<Closed> closed(const FenceRecord& record, const Vec3& start) {
  const tern::Fence& fence = record.fence;
  if (fence.kind != tern::FenceKind::kKeepOut || !tern::is_timed(fence)) return std::nullopt;
  const FenceSpan span = span_of(fence);
  return Closed{span.from, span.until, fence_gap(record, start)};
}

/// Of a keep-out box, which is a thing that stands there.
std::optional<Closed> closed(const TrackRecord& record, const Vec3& start) {
  if (!record.is_fence) return std::nullopt;
  const tern::Track& box = record.track;
  const auto beyond = [](double at, double middle, double half) {
    return std::max(0.0, std::fabs(at - middle) - half);
  };
  const double gap =
      std::hypot(beyond(start.x, box.position.x, box.half.x), beyond(start.y, box.position.y, box.half.y),
                 beyond(start.z, box.position.z, box.half.z));
  return Closed{static_cast<double>(box.measured) / 1e9, static_cast<double>(box.until) / 1e9, gap};
}

/// What the answer is about, if that is closed for a while.
std::optional<Closed> closed_of(const PlanResult& result) {
  const Scenario& scenario = result.scenario;
  const auto fence = static_cast<std::size_t>(result.report.fence),
             track = static_cast<std::size_t>(result.report.track);
  if (result.report.fence >= 0 && fence < scenario.fences.size()) {
    return closed(scenario.fences[fence], scenario.start.position);
  }
  if (result.report.track < 0 || track >= scenario.tracks.size()) return std::nullopt;
  return closed(scenario.tracks[track], scenario.start.position);
}

/// The end of all that is closed for a while and that the start is in, one after the other.
double start_is_free_at(const Scenario& scenario) {
  std::vector<Closed> around;
  const auto add = [&](const std::optional<Closed>& found) {
    if (found && found->gap < scenario.clearance()) around.push_back(*found);
  };
  for (const FenceRecord& record : scenario.fences) add(closed(record, scenario.start.position));
  for (const TrackRecord& record : scenario.tracks) add(closed(record, scenario.start.position));
  double free = scenario.start_time;
  // Each round passes an end.
  for (std::size_t round = 0; round < around.size(); ++round) {
    double next = free;
    for (const Closed& one : around) {
      if (one.from <= free && free < one.until) next = std::max(next, one.until);
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

}  // namespace

std::string clock_text(const Scenario& scenario, double time) {
  const double ms = whole_milliseconds(time);
  const std::string text = fixed(ms / 1e3, 3) + " s of the clock";
  if (scenario.earth.epoch.empty() || !(std::fabs(time) < kNoEnd)) return text;
  const Instant at = *parse_instant(scenario.earth.epoch) + static_cast<Instant>(ms) * (kSecond / 1000);
  return text + " (" + instant_text(at) + ")";
}

std::string describe_closed_start(const PlanResult& result) {
  const Scenario& scenario = result.scenario;
  const std::optional<Closed> met = closed_of(result);
  if (!met) return "";
  if (met->until >= kNoEnd)
    return "; it is closed without end: choose another start or goal, or leave it out if you may fly there";
  std::string text = "; it is closed until " + clock_text(scenario, met->until);
  const double free = start_is_free_at(scenario);
  if (!(free > scenario.start_time)) {
    const bool crosses = result.report.status == tern::Status::kNoClearTime;
    return crosses ? text + ": wait until then, or choose another goal" : text;
  }
  text += "; the start is in it: it is free at " + clock_text(scenario, free);
  return text + ". Begin then (start_time " + shortest(whole_milliseconds(free) / 1e3) + "), or elsewhere";
}

}  // namespace tern_host
