// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "cli/summary.hpp"

#include <algorithm>
#include <cmath>

#include "host/figures.hpp"
#include "host/nanoseconds.hpp"
#include "host/nearest_fence.hpp"
#include "host/nearest_thing.hpp"
#include "host/number.hpp"
#include "host/peaks.hpp"
#include "host/plan_file.hpp"
#include "host/presence.hpp"

namespace tern_cli {
namespace {

using tern::Stage;
using tern_host::fixed;
using tern_host::PlanResult;

std::string right(const std::string& text, std::size_t width) {
  return text.size() < width ? std::string(width - text.size(), ' ') + text : text;
}

std::string left(const std::string& text, std::size_t width) {
  return text.size() < width ? text + std::string(width - text.size(), ' ') : text;
}

std::string clearance_text(double clearance) {
  return std::isfinite(clearance) ? fixed(clearance, 3) : "-";
}

std::string percent(double part) {
  return fixed(100.0 * part, 1);
}

double largest(const tern::Vec3& v) {
  return std::max({v.x, v.y, v.z});
}

std::string search_lines(const PlanResult& result) {
  const tern::Path& path = *result.path;
  return "  jump points " + fixed(path.raw_length, 3) + " m over " + std::to_string(path.raw_count) + " points\n" +
         "  shortcut    " + fixed(path.length, 3) + " m over " + std::to_string(path.count) + " waypoints\n";
}

std::string corridor_line(const PlanResult& result) {
  const tern::Corridor& corridor = *result.corridor;
  int half_spaces = 0;
  for (int i = 0; i < corridor.count; ++i) half_spaces += corridor.polyhedra[i].count;
  return "  corridor    " + std::to_string(corridor.count) + " polyhedra, " + std::to_string(half_spaces) +
         " half-spaces" + (result.report.diagnostics.detours != 0 ? ", along the motion first" : "") + "\n";
}

std::string timing_line(const tern_host::Timing& timing) {
  const auto entry = [](const char* name, double us) { return std::string(name) + " " + fixed(us, 0) + "  "; };
  std::string others;
  for (const Stage stage :
       {Stage::kWorld, Stage::kDetour, Stage::kPrevious, Stage::kStopFirst, Stage::kReach, Stage::kTracks}) {
    if (timing.of(stage) > 0.0) others += entry(tern::stage_name(stage), timing.of(stage));
  }
  return "  time (us)   " + entry("inflate", timing.inflate) + entry("search", timing.of(Stage::kSearch)) +
         entry("shortcut", timing.of(Stage::kShortcut)) + entry("corridor", timing.of(Stage::kCorridor)) +
         entry("times", timing.of(Stage::kTimes)) + entry("optimise", timing.of(Stage::kTrajectory)) +
         entry("check", timing.of(Stage::kCheck)) + others + "total " + fixed(timing.total(), 0) + "\n";
}

/// The distance is that from what stands still: tracks_line() is about the rest.
std::string clearance_line(double clearance, const PlanResult& result) {
  const tern_host::Scenario& scenario = result.scenario;
  const std::size_t fences = scenario.fences.size();
  std::string text = std::isfinite(clearance) ? fixed(clearance, 4) + " m from the blocks" : "no blocks";
  if (fences > 0) text += ", " + std::to_string(fences) + (fences == 1 ? " geofence kept" : " geofences kept");
  const tern_host::NearestFence nearest = tern_host::nearest_fence(result.trajectory, scenario);
  if (nearest.index >= 0) {
    const std::string& zone = scenario.fences[static_cast<std::size_t>(nearest.index)].zone;
    text += ", nearest " + (zone.empty() ? "fence " + std::to_string(nearest.index + 1) : zone) + " at " +
            fixed(nearest.gap, 3) + " m";
  }
  if (scenario.tracking_margin > 0.0) text += ", tracking margin " + fixed(scenario.tracking_margin, 3) + " m";
  return "  clearance   " + text + "\n";
}

/// What was not kept clear of: the things that the plan has nothing to do with, and the one that it begins too near to.
std::string exceptions_of(const PlanResult& result) {
  const double begin = tern_host::seconds_of(result.trajectory.begin);
  const double end = begin + tern::duration(result.trajectory) + result.scenario.rest_clear;
  const std::string absent = tern_host::absence_text(tern_host::presences_of(result.scenario), begin, end);
  std::string text;
  if (result.report.track >= 0) {
    text += ", but for " + result.track_name() + ": the start is too near to it, and the plan leaves it";
  }
  return absent.empty() ? text : text + "; " + absent;
}

/// What the plan keeps clear of that moves.
std::string tracks_line(const PlanResult& result) {
  const tern_host::Scenario& scenario = result.scenario;
  const std::size_t count = scenario.tracks.size();
  if (!scenario.depends_on_time()) return "";
  const tern::Report& report = result.report;
  std::string text = count == 0 ? "fences for a while kept"
                                : std::to_string(count) + (count == 1 ? " thing that moves: " : " things that move: ") +
                                      fixed(scenario.clearance(), 3) +
                                      (count == 1 ? " m and its error kept" : " m and their errors kept");
  const tern_host::NearestThing nearest = tern_host::nearest_thing(result.trajectory, scenario);
  if (nearest.index >= 0) text += ", " + tern_host::nearest_thing_text(nearest, scenario);
  text += exceptions_of(result);
  if (report.waits > 0.0) text += ", waits " + fixed(report.waits, 2) + " s";
  const double slow = result.limits.v_max.x / scenario.limits.v_max.x;
  if (slow < 1.0) text += ", at " + fixed(100.0 * slow, 0) + " % of the speed for the sake of the keep-ins";
  const double until = report.rest_clear_until;
  text += std::isfinite(until) ? ", rest clear until " + fixed(until, 3) + " s" : ", rest stays clear";
  return "  tracks      " + text + "\n";
}

/// Each peak beside the limit that holds for it: norms are above what an axis may have, and break no limit.
std::string peaks_line(const char* name, const tern_host::PeakRange& peaks, const tern_host::LimitRange& limits,
                       const char* unit, double use) {
  std::string text;
  for (const tern_host::LimitedPeak& peak : tern_host::limited_peaks(peaks, limits, 3)) {
    text += (text.empty() ? "" : "; ") + peak.name + " " + peak.text;
  }
  return "  " + left(name, 12) + text + " " + unit + ", limits used to " + percent(use) + " %\n";
}

/// When the plan passes each via, and how far from it.
std::string via_lines(const PlanResult& result) {
  std::string text;
  for (std::size_t v = 0; v < result.scenario.vias.size(); ++v) {
    const tern::ViaPassage& passage = result.report.vias[v];
    const tern::Via& via = result.scenario.vias[v];
    text += "  via " + left(std::to_string(v + 1), 8) + fixed(passage.time, 3) + " s, " + fixed(passage.distance, 3) +
            " m from it" + (via.stop ? ", at rest" : "") +
            (via.dwell > 0.0 ? " for " + fixed(via.dwell, 1) + " s" : "") + "\n";
  }
  return text;
}

/// "3.1 to 19.6 of 3.0 to 19.6 m/s^2" and so on, of the limits that were given.
std::string thrust_line(const tern_host::Figures& figures, const tern::Limits& limits) {
  constexpr double kDegrees = 57.295779513082321;
  std::string text;
  const auto add = [&text](const std::string& part) { text += (text.empty() ? "" : "; ") + part; };
  if (limits.thrust_min > 0.0) {
    add("least " + fixed(figures.thrust_least, 3) + " of " + fixed(limits.thrust_min, 3) + " m/s^2");
  }
  if (limits.thrust_max > 0.0) {
    add("most " + fixed(figures.thrust_most, 3) + " of " + fixed(limits.thrust_max, 3) + " m/s^2");
  }
  if (limits.tilt_tangent > 0.0) {
    const double most = kDegrees * std::atan(limits.tilt_tangent);
    add("tilt " + fixed(kDegrees * figures.tilt, 2) + " of " + fixed(most, 2) + " degrees");
  }
  if (limits.rate_max > 0.0) {
    add("body rate " + fixed(figures.rate, 3) + " of " + fixed(limits.rate_max, 3) + " rad/s");
  }
  return text.empty() ? text : "  thrust      " + text + "\n";
}

std::string trajectory_lines(const PlanResult& result) {
  const tern::Limits& limits = result.scenario.limits;
  const tern_host::Figures figures = tern_host::measure(result.trajectory, result.scenario);
  const tern_host::LimitRange jerk = tern_host::jerk_range(limits);
  const std::string jerk_line =
      tern_host::limits_jerk(limits) ? peaks_line("jerk", figures.j_range, jerk, "m/s^3", figures.j_use) : "";
  return "  trajectory  " + fixed(figures.length, 3) + " m in " + fixed(figures.duration, 3) + " s, " +
         std::to_string(result.trajectory.count) + " segments, snap " + fixed(figures.snap, 2) + "\n" +
         via_lines(result) +
         peaks_line("velocity", figures.v_range, tern_host::velocity_range(limits), "m/s", figures.v_use) +
         peaks_line("accel.", figures.a_range, tern_host::acceleration_range(limits), "m/s^2", figures.a_use) +
         jerk_line + thrust_line(figures, limits) + clearance_line(figures.clearance, result) + tracks_line(result);
}

std::string yaw_line(const PlanResult& result) {
  const tern_host::YawWish& wish = result.scenario.yaw;
  const tern_host::YawPeaks peaks = tern_host::yaw_peaks(*result.yaw);
  return "  yaw         " + std::string(tern_host::yaw_mode_word(wish.mode)) + ", ends after " +
         fixed(tern::duration(*result.yaw), 3) + " s; rate " + fixed(peaks.rate, 3) + " of " + fixed(wish.rate_max, 3) +
         " rad/s, accel. " + fixed(peaks.acceleration, 3) + " of " + fixed(wish.acceleration_max, 3) + " rad/s^2\n";
}

/// What a status means where the yaw planner answers it.
const char* yaw_meaning(tern::Status status) {
  switch (status) {
    case tern::Status::kLimitsInvalid:
      return "'yaw_rate_max' must lie in 0.01 to 100 rad/s, 'yaw_acceleration_max' in 0.01 to 1000 rad/s^2";
    case tern::Status::kStartExceedsLimits:
      return "'start_yaw_acceleration' is beyond 'yaw_acceleration_max'";
    case tern::Status::kInvalidArgument:
      return "the times of 'yaw timed' must rise, from 0 on";
    default:
      return tern::status_meaning(status);
  }
}

struct Column {
  const char* head;
  const char* unit;
  std::size_t width;
};

constexpr std::size_t kNameWidth = 14;
constexpr std::size_t kStatusWidth = 12;
constexpr Column kColumns[] = {
    {"path", "m", 8},     {"way-", "points", 7}, {"seg-", "ments", 6}, {"duration", "s", 9},  {"snap", "m2/s7", 9},
    {"v peak", "m/s", 7}, {"a peak", "m/s2", 7}, {"v use", "%", 7},    {"a use", "%", 7},     {"clear", "m", 7},
    {"inflate", "us", 8}, {"search", "us", 8},   {"shortc.", "us", 8}, {"corridor", "us", 9}, {"times", "us", 6},
    {"optim.", "us", 8},  {"check", "us", 7},    {"total", "us", 8},
};

std::vector<std::string> cells(const PlanResult& result) {
  const tern_host::Figures figures = tern_host::measure(result.trajectory, result.scenario);
  const tern_host::Timing& timing = result.timing;
  return {fixed(result.path->length, 3),
          std::to_string(result.path->count),
          std::to_string(result.trajectory.count),
          fixed(figures.duration, 2),
          fixed(figures.snap, figures.snap < 10000.0 ? 2 : 0),
          fixed(largest(figures.v_peak), 3),
          fixed(largest(figures.a_peak), 3),
          percent(figures.v_use),
          percent(figures.a_use),
          clearance_text(figures.clearance),
          fixed(timing.inflate, 0),
          fixed(timing.of(Stage::kSearch), 0),
          fixed(timing.of(Stage::kShortcut), 0),
          fixed(timing.of(Stage::kCorridor), 0),
          fixed(timing.of(Stage::kTimes), 0),
          fixed(timing.of(Stage::kTrajectory), 0),
          fixed(timing.of(Stage::kCheck), 0),
          fixed(timing.total(), 0)};
}

}  // namespace

std::string plan_summary(const PlanResult& result) {
  const std::string detail = tern_host::describe_status(result);
  std::string text = result.scenario.name + ": ok" + (detail.empty() ? "" : " (" + detail + ")") + "\n";
  if (result.path != nullptr) text += search_lines(result);
  if (result.corridor != nullptr) text += corridor_line(result);
  text += trajectory_lines(result);
  if (result.yaw != nullptr) text += yaw_line(result);
  return text + timing_line(result.timing);
}

std::string failure_summary(const PlanResult& result) {
  return result.scenario.name + ": no plan: " + tern::status_name(result.report.status) + ": " +
         tern_host::describe_status(result) + "\n";
}

std::string yaw_failure(const PlanResult& result) {
  return result.scenario.name + ": no yaw plan: " + tern::status_name(result.yaw_status) + ": " +
         yaw_meaning(result.yaw_status) + "\n";
}

std::string table_header() {
  std::string heads = left("scenario", kNameWidth) + left("status", kStatusWidth);
  std::string units = std::string(kNameWidth + kStatusWidth, ' ');
  for (const Column& column : kColumns) {
    heads += right(column.head, column.width);
    units += right(column.unit, column.width);
  }
  return heads + "\n" + units + "\n";
}

std::string table_row(const std::string& name, const PlanResult& result) {
  std::string row = left(name, kNameWidth) + left(tern::status_name(result.report.status), kStatusWidth);
  if (!result.ok()) return row + "  " + tern_host::describe_status(result) + "\n";
  const std::vector<std::string> values = cells(result);
  for (std::size_t i = 0; i < values.size(); ++i) row += right(values[i], kColumns[i].width);
  return row + "\n";
}

}  // namespace tern_cli
