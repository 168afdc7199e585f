// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "host/presence.hpp"

#include <limits>

#include "host/nanoseconds.hpp"

namespace tern_host {
namespace {

constexpr std::size_t kNamed = 8;

}  // namespace

std::vector<Presence> presences_of(const Scenario& scenario) {
  std::vector<Presence> all;
  for (const TrackRecord& record : scenario.tracks) {
    const tern::Track& track = record.track;
    const bool leaves = track.end == tern::TrackEnd::kGone;
    all.push_back({record.id, seconds_of(track.measured),
                   leaves ? seconds_of(track.until) : std::numeric_limits<double>::infinity()});
  }
  for (std::size_t k = 0; k < scenario.fences.size(); ++k) {
    const tern::Fence& fence = scenario.fences[k].fence;
    if (!tern::is_timed(fence)) continue;
    const FenceSpan span = span_of(fence);
    all.push_back({"fence " + std::to_string(k + 1) + zone_text(scenario.fences, static_cast<std::int32_t>(k)),
                   span.from, span.until});
  }
  return all;
}

std::string absence_text(const std::vector<Presence>& presences, double begin, double end) {
  std::string names;
  std::size_t absent = 0;
  for (const Presence& one : presences) {
    if (one.from < end && one.until >= begin) continue;
    if (++absent <= kNamed) names += (names.empty() ? "" : ", ") + one.name;
  }
  if (absent == 0) return "";
  if (absent > kNamed) names += " and " + std::to_string(absent - kNamed) + " more";
  return "not there during the plan: " + names;
}

}  // namespace tern_host
