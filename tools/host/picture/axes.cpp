// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "host/picture/axes.hpp"

#include <algorithm>
#include <cmath>

#include "host/number.hpp"
#include "host/picture/lettering.hpp"

namespace tern_host {
namespace {

constexpr double kPixelsPerTick = 70.0;
constexpr int kMaxTicks = 60;

double tick_step(const AxisRange& range, double wanted) {
  const double rough = range.extent() / std::max(2.0, wanted);
  const double power = std::pow(10.0, std::floor(std::log10(rough)));
  for (const double factor : {1.0, 2.0, 5.0}) {
    if (rough <= factor * power * 1.0001) return factor * power;
  }
  return 10.0 * power;
}

/// As many decimals as the distance of the ticks needs.
int decimals(const std::vector<double>& values) {
  if (values.size() < 2) return 1;
  const double step = values[1] - values[0];
  return std::max(0, static_cast<int>(std::ceil(-std::log10(step) - 1e-6)));
}

std::vector<double> horizontal_ticks(const Axes& axes) {
  return ticks(axes.horizontal, axes.frame.width / kPixelsPerTick);
}

std::vector<double> vertical_ticks(const Axes& axes) {
  return ticks(axes.vertical, axes.frame.height / (0.65 * kPixelsPerTick));
}

/// A tick's number, unless another text is too close.
void draw_number(Canvas& canvas, Pixel at, const std::string& text, const char* anchor) {
  const std::string style = std::string("class=\"number\" text-anchor=\"") + anchor + "\"";
  const Rect room = text_room(at, text, style);
  if (canvas.clear_of_text({room.x - 3.0, room.y, room.width + 6.0, room.height})) canvas.text(at, text, style);
}

/// Returns how wide the widest number is.
double draw_vertical_ticks(Canvas& canvas, const Axes& axes) {
  const std::vector<double> values = vertical_ticks(axes);
  double widest = 0.0;
  for (const double v : values) {
    const Pixel at{axes.frame.x, axes.at(axes.horizontal.low, v).y};
    const std::string text = fixed(v, decimals(values));
    canvas.line({at.x - 4.0, at.y}, at, "class=\"tick\"");
    draw_number(canvas, {at.x - 8.0, at.y + 4.5}, text, "end");
    widest = std::max(widest, text_width(text, kNumber));
  }
  return widest;
}

void draw_horizontal_ticks(Canvas& canvas, const Axes& axes) {
  const std::vector<double> values = horizontal_ticks(axes);
  const double y = axes.frame.bottom();
  for (const double h : values) {
    const double x = axes.at(h, axes.vertical.low).x;
    canvas.line({x, y}, {x, y + 4.0}, "class=\"tick\"");
    draw_number(canvas, {x, y + 19.0}, fixed(h, decimals(values)), "middle");
  }
}

}  // namespace

Pixel Axes::at(double h, double v) const {
  const double along = (h - horizontal.low) / horizontal.extent();
  const double across = (v - vertical.low) / vertical.extent();
  return {frame.x + along * frame.width, frame.y + (down ? across : 1.0 - across) * frame.height};
}

std::vector<double> ticks(const AxisRange& range, double wanted) {
  std::vector<double> values;
  if (!(range.extent() > 0.0)) return values;
  const double step = tick_step(range, wanted);
  const double first = std::ceil(range.low / step - 1e-6);
  for (int i = 0; i < kMaxTicks && (first + i) * step <= range.high + 1e-6 * step; ++i) {
    values.push_back((first + i) * step);
  }
  return values;
}

void draw_grid(Canvas& canvas, const Axes& axes) {
  canvas.rect(axes.frame, "class=\"paper\"");
  for (const double h : horizontal_ticks(axes)) {
    canvas.line(axes.at(h, axes.vertical.low), axes.at(h, axes.vertical.high), "class=\"grid\"");
  }
  for (const double v : vertical_ticks(axes)) {
    canvas.line(axes.at(axes.horizontal.low, v), axes.at(axes.horizontal.high, v), "class=\"grid\"");
  }
}

void draw_level(Canvas& canvas, const Axes& axes, double value, const std::string& style) {
  canvas.line(axes.at(axes.horizontal.low, value), axes.at(axes.horizontal.high, value), style);
}

void draw_frame(Canvas& canvas, const Axes& axes, const std::string& horizontal_title,
                const std::string& vertical_title) {
  const Rect& frame = axes.frame;
  canvas.rect(frame, "class=\"frame\"");
  draw_horizontal_ticks(canvas, axes);
  const double left = frame.x - std::max(44.0, 20.0 + draw_vertical_ticks(canvas, axes));
  canvas.text({frame.x + 0.5 * frame.width, frame.bottom() + 38.0}, horizontal_title,
              "class=\"label\" text-anchor=\"middle\"");
  canvas.upward_text({left, frame.y + 0.5 * frame.height}, vertical_title, "class=\"label\"");
}

}  // namespace tern_host
