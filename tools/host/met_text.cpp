// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "host/met_text.hpp"

#include <cmath>
#include <limits>

#include "host/closed_start.hpp"
#include "host/nanoseconds.hpp"
#include "host/number.hpp"
#include "host/track_sample.hpp"

namespace tern_host {
namespace {

using tern::Status;
using tern::Track;
using tern::TrackEnd;

/// From when on a thing is where it then stays, s of the clock; infinite if it never stays.
double stays_from(const Track& track) {
  const double never = std::numeric_limits<double>::infinity();
  if (track.end == TrackEnd::kGone) return never;
  double last = never;
  if (track.piece_count > 0) {
    last = seconds_of(track.measured);
    for (std::int32_t p = 0; p < track.piece_count; ++p) last += track.pieces[p].duration;
  } else if (std::hypot(track.velocity.x, track.velocity.y, track.velocity.z) <= 0.0) {
    last = seconds_of(track.measured);
  }
  return track.end == TrackEnd::kGoesOn ? last : std::fmin(last, seconds_of(track.until));
}

/// True if the tube of a thing grows without end, faster than the thing moves.
bool grows_for_good(const Track& track) {
  if (track.end == TrackEnd::kReach) return true;
  if (track.end != TrackEnd::kGoesOn) return false;
  const bool moves = track.piece_count == 0;  // pieces end
  const double speed = moves ? std::hypot(track.velocity.x, track.velocity.y, track.velocity.z) : 0.0;
  return track.error_growth > 0.0 || track.error_speed > speed;
}

/// "; it covers via 1 then": the vias within whose tolerance no point is clear of what was met, when it was met.
std::string vias_text(const PlanResult& result, double time) {
  const Scenario& scenario = result.scenario;
  const tern::Report& report = result.report;
  const std::vector<Track> tracks = tracks_of(scenario.tracks);
  std::string text;
  for (std::size_t v = 0; v < scenario.vias.size(); ++v) {
    const tern::Via& via = scenario.vias[v];
    bool is_covered = false;
    if (report.track >= 0) {
      const Track& track = tracks[static_cast<std::size_t>(report.track)];
      is_covered = tube_gap(track, time, via.position) + via.tolerance < scenario.clearance();
    } else {
      const FenceRecord& fence = scenario.fences[static_cast<std::size_t>(report.fence)];
      is_covered = fence.fence.kind == tern::FenceKind::kKeepOut &&
                   fence_gap(fence, via.position) + via.tolerance < scenario.clearance();
    }
    if (is_covered) text += (text.empty() ? "" : ", ") + std::to_string(v + 1);
  }
  return text.empty() ? "" : "; it covers via " + text + " then";
}

/// What would help where waiting does not.
std::string elsewhere_text(const PlanResult& result, bool covers_via) {
  if (covers_via) return "leave that via out, or move it";
  return result.report.status == Status::kGoalCovered ? "choose another goal"
                                                      : "choose another goal, make it a `block` to find ways around it";
}

/// If the track says that the thing never leaves: that, and what would help. Else empty.
std::string for_good_text(const PlanResult& result, double time, bool covers_via) {
  const std::vector<Track> tracks = tracks_of(result.scenario.tracks);
  const Track& track = tracks[static_cast<std::size_t>(result.report.track)];
  const bool stays = stays_from(track) <= time;
  const std::string error = fixed(sample_of(track, time).error, 2) + " m";
  if (grows_for_good(track)) {
    return std::string(stays ? "; it stays there for good, and" : ";") + " its error grows without end, to " + error +
           " by then, so waiting does not help for long: measure it anew, or say when it leaves (`until T gone`)";
  }
  if (!stays) return "";
  return "; it stays there for good, so waiting does not help: " + elsewhere_text(result, covers_via) +
         ", or say when it leaves (`until T gone`)";
}

std::string leaving_text(const PlanResult& result) {
  const Track& track = result.scenario.tracks[static_cast<std::size_t>(result.report.track)].track;
  const std::string until =
      track.end == TrackEnd::kGone ? "; it is there until " + clock_text(result.scenario, seconds_of(track.until)) : "";
  return until + (result.report.status == Status::kNoClearTime ? "; wait, or choose another goal" : "");
}

/// From when on a goal that is covered would be free.
std::string free_text(const tern::Report& report) {
  if (report.status != Status::kGoalCovered) return "";
  if (std::isfinite(report.goal_free)) return "; the goal is free after " + brief(report.goal_free) + " s";
  return "; the goal was not found free within an hour";
}

}  // namespace

bool is_met(const PlanResult& result) {
  const Status status = result.report.status;
  const bool meets =
      status == Status::kStartInContact || status == Status::kGoalCovered || status == Status::kNoClearTime;
  return meets && (result.report.track >= 0 || result.report.fence >= 0);
}

std::string describe_met(const PlanResult& result) {
  if (!is_met(result)) return "";
  const tern::Report& report = result.report;
  const double time = result.scenario.start_time + report.conflict;
  const std::string name = report.track >= 0 ? "; track: " + result.track_name() : "";
  const std::string met = name + ", " + brief(report.conflict) + " s after the beginning";
  if (report.status == Status::kStartInContact) return met;
  const std::string vias = vias_text(result, time);
  const bool is_thing = report.track >= 0 && !result.scenario.tracks[static_cast<std::size_t>(report.track)].is_fence;
  const std::string for_good = is_thing ? for_good_text(result, time, !vias.empty()) : "";
  if (!for_good.empty()) return met + vias + for_good;
  return met + vias + free_text(report) + (is_thing ? leaving_text(result) : "");
}

}  // namespace tern_host
