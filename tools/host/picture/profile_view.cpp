// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "host/picture/profile_view.hpp"

#include <algorithm>
#include <cmath>

#include "host/picture/colours.hpp"
#include "host/picture/map_view.hpp"

namespace tern_host {
namespace {

using tern::Vec3;

constexpr int kSamples = 600;

struct Curves {
  std::vector<double> times;
  std::vector<double> values[4];  // x, y, z, norm
};

Curves sample(const tern::Trajectory& trajectory, Profile profile) {
  Curves curves;
  const double end = tern::duration(trajectory);
  for (int i = 0; i <= kSamples; ++i) {
    const double t = end * i / kSamples;
    const tern::Sample s = tern::evaluate(trajectory, t);
    const Vec3& v = profile == Profile::kVelocity ? s.velocity : s.acceleration;
    curves.times.push_back(t);
    for (int a = 0; a < 3; ++a) curves.values[a].push_back(component(v, a));
    curves.values[3].push_back(std::sqrt(v.x * v.x + v.y * v.y + v.z * v.z));
  }
  return curves;
}

Range value_range(const Curves& curves, const LimitRange& limit) {
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

void draw_level(Canvas& canvas, const Axes& axes, double value, const std::string& style) {
  canvas.line(axes.at(axes.horizontal.low, value), axes.at(axes.horizontal.high, value), style);
}

bool equal(const Vec3& v) {
  return !(v.x < v.y) && !(v.y < v.x) && !(v.y < v.z) && !(v.z < v.y);
}

/// One pair of red lines where the axes share their limits, else a pair in each axis' colour; and the horizontal limit.
void draw_limits(Canvas& canvas, const Axes& axes, const LimitRange& limit) {
  const bool shared = equal(limit.upper) && equal(limit.lower);
  for (int a = 0; a < (shared ? 1 : 3); ++a) {
    const std::string style = std::string("class=\"limit\" stroke=\"") + (shared ? "#8b2e2e" : kAxisColours[a]) + "\"";
    draw_level(canvas, axes, component(limit.upper, a), style);
    draw_level(canvas, axes, component(limit.lower, a), style);
  }
  if (limit.horizontal > 0.0) draw_level(canvas, axes, limit.horizontal, "class=\"limit\" stroke=\"#333333\"");
}

void draw_joints(Canvas& canvas, const Axes& axes, const tern::Trajectory& trajectory) {
  double t = 0.0;
  for (int i = 0; i + 1 < trajectory.count; ++i) {
    t += trajectory.segments[i].duration;
    canvas.line(axes.at(t, axes.vertical.low), axes.at(t, axes.vertical.high), "class=\"joint\"");
  }
}

/// The key, right-aligned above the frame.
void draw_key(Canvas& canvas, const Rect& frame, const char* norm) {
  const struct {
    const char* name;
    std::string style;
    double width;
  } entries[] = {{"x", std::string("class=\"curve\" stroke=\"") + kAxisColours[0] + "\"", 46.0},
                 {"y", std::string("class=\"curve\" stroke=\"") + kAxisColours[1] + "\"", 46.0},
                 {"z", std::string("class=\"curve\" stroke=\"") + kAxisColours[2] + "\"", 46.0},
                 {norm, "class=\"norm\"", 54.0},
                 {"limit per axis", "class=\"limit\" stroke=\"#8b2e2e\"", 118.0}};
  double x = frame.right() - (3 * 46.0 + 54.0 + 118.0);
  const double y = frame.y - 17.0;
  for (const auto& entry : entries) {
    canvas.line({x, y}, {x + 20.0, y}, entry.style);
    canvas.text({x + 25.0, y + 4.5}, entry.name, "class=\"number\"");
    x += entry.width;
  }
}

}  // namespace

void draw_profile(Canvas& canvas, const Rect& frame, Profile profile, const PlanResult& result) {
  const bool velocity = profile == Profile::kVelocity;
  const tern::Limits& limits = result.scenario.limits;
  const LimitRange limit = velocity ? velocity_range(limits) : acceleration_range(limits);
  const Curves curves = sample(result.trajectory, profile);
  const Axes axes{frame, {0.0, tern::duration(result.trajectory)}, value_range(curves, limit)};
  canvas.begin_clipped(frame);
  draw_grid(canvas, axes);
  draw_joints(canvas, axes, result.trajectory);
  draw_level(canvas, axes, 0.0, "class=\"zero\"");
  draw_curve(canvas, axes, curves, 3, "class=\"norm\"");
  for (int a = 0; a < 3; ++a) {
    draw_curve(canvas, axes, curves, a, std::string("class=\"curve\" stroke=\"") + kAxisColours[a] + "\"");
  }
  draw_limits(canvas, axes, limit);
  canvas.end_group();
  draw_frame(canvas, axes, "time (s)", velocity ? "velocity (m/s)" : "acceleration (m/s\u00b2)");
  canvas.text({frame.x, frame.y - 12.0}, velocity ? "Velocity" : "Acceleration", "class=\"heading\"");
  draw_key(canvas, frame, velocity ? "|v|" : "|a|");
}

}  // namespace tern_host
