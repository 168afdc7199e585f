// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "host/picture/profile_view.hpp"

#include <algorithm>
#include <cmath>

#include "host/number.hpp"
#include "host/peaks.hpp"
#include "host/picture/colours.hpp"
#include "host/picture/legend.hpp"
#include "host/picture/map_view.hpp"

namespace tern_host {
namespace {

using tern::Vec3;

constexpr int kProfileSamples = 600;
constexpr double kBeforeEnd = 1.0 - 1e-9;  // at the end itself the robot holds, whatever its velocity was
constexpr int kHorizontal = 3;
constexpr int kNorm = 4;

struct Curves {
  std::vector<double> times;
  std::vector<double> values[5];  // x, y, z, horizontal norm, norm
};

Curves sample(const tern::Trajectory& trajectory, Profile profile) {
  Curves curves;
  const double end = tern::duration(trajectory);
  for (int i = 0; i <= kProfileSamples; ++i) {
    const double t = end * i / kProfileSamples;
    const tern::Sample s = tern::evaluate(trajectory, std::min(t, kBeforeEnd * end));
    const Vec3& v = profile == Profile::kVelocity ? s.velocity : s.acceleration;
    curves.times.push_back(t);
    for (int a = 0; a < 3; ++a) curves.values[a].push_back(component(v, a));
    curves.values[kHorizontal].push_back(std::hypot(v.x, v.y));
    curves.values[kNorm].push_back(std::sqrt(v.x * v.x + v.y * v.y + v.z * v.z));
  }
  return curves;
}

AxisRange value_range(const Curves& curves, const LimitRange& limit) {
  double high = std::max({limit.upper.x, limit.upper.y, limit.upper.z, limit.horizontal});
  for (const std::vector<double>& values : curves.values) {
    for (const double v : values) high = std::max(high, std::fabs(v));
  }
  return {1.1 * std::min({limit.lower.x, limit.lower.y, limit.lower.z}), 1.1 * high};
}

void draw_curve(Canvas& canvas, const Axes& axes, const Curves& curves, int index, const std::string& style) {
  std::vector<Pixel> points;
  for (std::size_t i = 0; i < curves.times.size(); ++i) {
    points.push_back(axes.at(curves.times[i], curves.values[index][i]));
  }
  canvas.polyline(points, style);
}

const char* colour_of(int index) {
  return index < kHorizontal ? kAxisColours[index] : kHorizontalColour;
}

std::string stroke(int index) {
  return std::string("stroke=\"") + colour_of(index) + "\"";
}

/// The `turn`th of `count` dashed lines in one place: each shows in the others' gaps.
std::string dashes(int index, int turn, int count) {
  constexpr int kDash = 7;
  constexpr int kPitch = 11;
  return "class=\"limit\" " + stroke(index) + " style=\"stroke-dasharray:" + std::to_string(kDash) + " " +
         std::to_string(kPitch * count - kDash) + ";stroke-dashoffset:" + std::to_string(-kPitch * turn) + "\"";
}

/// A limit's level and whose it is: an axis or kHorizontal.
struct Level {
  int index;
  double value;
};

std::vector<Level> levels_of(const LimitRange& limit) {
  std::vector<Level> levels;
  for (int a = 0; a < 3; ++a) levels.push_back({a, component(limit.upper, a)});
  if (limit.horizontal > 0.0) levels.push_back({kHorizontal, limit.horizontal});
  for (int a = 0; a < 3; ++a) levels.push_back({a, component(limit.lower, a)});
  return levels;
}

/// Each limit in the colour of what it holds for.
void draw_limits(Canvas& canvas, const Axes& axes, const LimitRange& limit) {
  const std::vector<Level> levels = levels_of(limit);
  for (std::size_t i = 0; i < levels.size(); ++i) {
    const auto same = [&](const Level& other) { return std::fabs(other.value - levels[i].value) < 1e-9; };
    const auto at = levels.begin() + static_cast<std::ptrdiff_t>(i);
    const int turn = static_cast<int>(std::count_if(levels.begin(), at, same));
    const int count = static_cast<int>(std::count_if(levels.begin(), levels.end(), same));
    draw_level(canvas, axes, levels[i].value, dashes(levels[i].index, turn, count));
  }
}

void draw_joints(Canvas& canvas, const Axes& axes, const tern::Trajectory& trajectory) {
  double t = 0.0;
  for (int i = 0; i + 1 < trajectory.count; ++i) {
    t += trajectory.segments[i].duration;
    canvas.line(axes.at(t, axes.vertical.low), axes.at(t, axes.vertical.high), "class=\"joint\"");
  }
}

LegendEntry limits_entry(bool horizontal) {
  const int count = horizontal ? 4 : 3;
  return {horizontal ? "limits" : "limits, each axis its own",
          [=](Canvas& canvas, const Rect& r) {
            const double y = r.y + 0.5 * r.height;
            for (int i = 0; i < count; ++i) canvas.line({r.x, y}, {r.right(), y}, dashes(i, i, count));
          },
          11.0 * count - 4.0};
}

/// What each curve is, with its peak beside its limit.
std::vector<LegendEntry> key(Profile profile, const PlanResult& result, const Figures& figures) {
  const bool velocity = profile == Profile::kVelocity;
  const tern::Limits& limits = result.scenario.limits;
  const std::vector<LimitedPeak> peaks = velocity ? limited_peaks(figures.v_range, velocity_range(limits), 2)
                                                  : limited_peaks(figures.a_range, acceleration_range(limits), 2);
  std::vector<LegendEntry> entries;
  for (std::size_t i = 0; i < peaks.size(); ++i) {
    entries.push_back(
        line_entry(peaks[i].name + " " + peaks[i].text, "class=\"curve\" " + stroke(static_cast<int>(i))));
    entries.back().sample_width = 18.0;
  }
  entries.push_back(limits_entry(peaks.size() > 3));
  const std::string norm = velocity ? "|v| " + fixed(figures.speed, 2) : "|a| " + fixed(figures.acceleration, 2);
  entries.push_back(line_entry(norm + ", no limit", "class=\"norm\""));
  entries.back().sample_width = 18.0;
  return entries;
}

/// Heading and key take their room from the top of `frame`; returns what is left for the axes.
Rect draw_heading(Canvas& canvas, const Rect& frame, const char* heading, const std::vector<LegendEntry>& entries) {
  canvas.text({frame.x, frame.y - 12.0}, heading, "class=\"heading\"");
  draw_legend(canvas, entries, {frame.x, frame.y - 2.0}, frame.width);
  const double room = kLegendRow * legend_rows(entries, frame.width);
  return {frame.x, frame.y + room, frame.width, frame.height - room};
}

void draw_curves(Canvas& canvas, const Axes& axes, const Curves& curves, bool horizontal) {
  draw_curve(canvas, axes, curves, kNorm, "class=\"norm\"");
  for (int i = 0; i < (horizontal ? 4 : 3); ++i) draw_curve(canvas, axes, curves, i, "class=\"curve\" " + stroke(i));
}

}  // namespace

void draw_profile(Canvas& canvas, const Rect& frame, Profile profile, const PlanResult& result,
                  const Figures& figures) {
  const bool velocity = profile == Profile::kVelocity;
  const tern::Limits& limits = result.scenario.limits;
  const LimitRange limit = velocity ? velocity_range(limits) : acceleration_range(limits);
  const Rect plot =
      draw_heading(canvas, frame, velocity ? "Velocity: peaks and limits" : "Acceleration: peaks and limits",
                   key(profile, result, figures));
  const Curves curves = sample(result.trajectory, profile);
  const Axes axes{plot, {0.0, tern::duration(result.trajectory)}, value_range(curves, limit)};
  canvas.begin_clipped(plot);
  draw_grid(canvas, axes);
  draw_joints(canvas, axes, result.trajectory);
  draw_level(canvas, axes, 0.0, "class=\"zero\"");
  draw_limits(canvas, axes, limit);
  draw_curves(canvas, axes, curves, limit.horizontal > 0.0);
  canvas.end_group();
  draw_frame(canvas, axes, "time (s)", velocity ? "velocity (m/s)" : "acceleration (m/s\u00b2)");
}

}  // namespace tern_host
