// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "host/picture/heading_view.hpp"

#include <algorithm>
#include <cmath>

#include "host/number.hpp"
#include "host/picture/colours.hpp"
#include "host/picture/legend.hpp"

namespace tern_host {
namespace {

constexpr int kNoses = 40;
constexpr double kNoseLength = 17.0;  // pixels
constexpr int kSamples = 600;
constexpr const char* kRateColour = kAxisColours[2];
constexpr const char* kAccelerationColour = kAxisColours[0];

std::string curve_style(const char* colour) {
  return std::string("class=\"curve\" stroke=\"") + colour + "\"";
}

std::string limit_style(const char* colour) {
  return std::string("class=\"limit\" stroke=\"") + colour + "\"";
}

using Value = double (*)(const tern::YawSample&);

double angle_of(const tern::YawSample& sample) {
  return sample.angle;
}
double rate_of(const tern::YawSample& sample) {
  return sample.yaw.rate;
}
double acceleration_of(const tern::YawSample& sample) {
  return sample.acceleration;
}

std::vector<double> sampled(const tern::YawPlan& plan, Value value) {
  std::vector<double> values;
  for (int i = 0; i <= kSamples; ++i) {
    values.push_back(value(tern::evaluate(plan, tern::duration(plan) * i / kSamples)));
  }
  return values;
}

void draw_curve(Canvas& canvas, const Axes& axes, const std::vector<double>& values, const char* colour) {
  std::vector<Pixel> points;
  for (std::size_t i = 0; i < values.size(); ++i) {
    points.push_back(axes.at(axes.horizontal.high * static_cast<double>(i) / kSamples, values[i]));
  }
  canvas.polyline(points, curve_style(colour));
}

LegendEntry entry(const std::string& name, double peak, double limit, const char* unit, const char* colour) {
  return line_entry(name + " " + fixed(peak, 2) + " of " + fixed(limit, 2) + " " + unit, curve_style(colour));
}

}  // namespace

void draw_noses(Canvas& canvas, const Axes& axes, const Projection& projection, const PlanResult& result) {
  if (result.yaw == nullptr) return;
  const double end = tern::duration(result.trajectory);
  for (int i = 0; i <= kNoses; ++i) {
    const double t = end * i / kNoses;
    const tern::Vec3 from = tern::evaluate(result.trajectory, t).position;
    const tern::Yaw yaw = tern::evaluate(*result.yaw, t).yaw;
    const Pixel a = project(axes, projection, from);
    const Pixel ahead = project(axes, projection, {from.x + yaw.cosine, from.y + yaw.sine, from.z});
    const double metre = std::hypot(ahead.x - a.x, ahead.y - a.y);
    const double scale = kNoseLength / metre;
    canvas.line(a, {a.x + scale * (ahead.x - a.x), a.y + scale * (ahead.y - a.y)}, "class=\"nose\"");
    canvas.circle(a, 2.2, "class=\"nose-root\"");
  }
}

void draw_heading_profile(Canvas& canvas, const Rect& frame, const PlanResult& result) {
  const std::vector<double> angles = sampled(*result.yaw, angle_of);
  const auto [low, high] = std::minmax_element(angles.begin(), angles.end());
  const double margin = std::max(0.2, 0.08 * (*high - *low));
  canvas.text({frame.x, frame.y - 12.0}, "Yaw", "class=\"heading\"");
  const Axes axes{frame, {0.0, tern::duration(*result.yaw)}, {*low - margin, *high + margin}};
  canvas.begin_clipped(frame);
  draw_grid(canvas, axes);
  draw_curve(canvas, axes, angles, kRateColour);
  canvas.end_group();
  draw_frame(canvas, axes, "time (s)", "yaw (rad)");
}

void draw_turning_profile(Canvas& canvas, const Rect& frame, const PlanResult& result) {
  const YawWish& wish = result.scenario.yaw;
  const YawPeaks peaks = yaw_peaks(*result.yaw);
  const std::vector<LegendEntry> key{
      entry("rate", peaks.rate, wish.rate_max, "rad/s", kRateColour),
      entry("acceleration", peaks.acceleration, wish.acceleration_max, "rad/s\u00b2", kAccelerationColour)};
  canvas.text({frame.x, frame.y - 12.0}, "Turning: peaks and limits", "class=\"heading\"");
  draw_legend(canvas, key, {frame.x, frame.y - 2.0}, frame.width);
  const double room = kLegendRow * legend_rows(key, frame.width);
  const Rect plot{frame.x, frame.y + room, frame.width, frame.height - room};
  const double most = 1.1 * std::max({wish.rate_max, wish.acceleration_max, peaks.rate, peaks.acceleration});
  const Axes axes{plot, {0.0, tern::duration(*result.yaw)}, {-most, most}};
  canvas.begin_clipped(plot);
  draw_grid(canvas, axes);
  draw_level(canvas, axes, 0.0, "class=\"zero\"");
  for (const double sign : {-1.0, 1.0}) {
    draw_level(canvas, axes, sign * wish.rate_max, limit_style(kRateColour));
    draw_level(canvas, axes, sign * wish.acceleration_max, limit_style(kAccelerationColour));
  }
  draw_curve(canvas, axes, sampled(*result.yaw, acceleration_of), kAccelerationColour);
  draw_curve(canvas, axes, sampled(*result.yaw, rate_of), kRateColour);
  canvas.end_group();
  draw_frame(canvas, axes, "time (s)", "rad/s, rad/s\u00b2");
}

}  // namespace tern_host
