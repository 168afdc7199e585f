// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "host/picture/legend.hpp"

#include "host/number.hpp"
#include "host/picture/colours.hpp"
#include "host/picture/lettering.hpp"

namespace tern_host {
namespace {

constexpr double kSampleHeight = 14.0;
constexpr double kNameGap = 8.0;    // from sample to name
constexpr double kEntryGap = 22.0;  // from name to the next sample
constexpr double kSpeedBar = 120.0;

double entry_width(const LegendEntry& entry) {
  return entry.sample_width + kNameGap + text_width(entry.name, kNumber);
}

/// Where each entry begins, counted from the legend's left end and first row.
std::vector<Pixel> places(const std::vector<LegendEntry>& entries, double width) {
  std::vector<Pixel> found;
  Pixel at{0.0, 0.0};
  for (const LegendEntry& entry : entries) {
    if (at.x > 0.0 && at.x + entry_width(entry) > width) at = {0.0, at.y + kLegendRow};
    found.push_back(at);
    at.x += entry_width(entry) + kEntryGap;
  }
  return found;
}

Pixel left_middle(const Rect& r) {
  return {r.x, r.y + 0.5 * r.height};
}

std::string gradient() {
  constexpr int kStops = 12;
  std::string stops;
  for (int i = 0; i <= kStops; ++i) {
    const double t = static_cast<double>(i) / kStops;
    stops += "<stop offset=\"" + fixed(t, 3) + "\" stop-color=\"" + speed_colour(t) + "\"/>";
  }
  return "<defs><linearGradient id=\"speed\">" + stops + "</linearGradient></defs>\n";
}

}  // namespace

LegendEntry area_entry(const std::string& name, const std::string& style, double corner_radius) {
  return {name, [=](Canvas& canvas, const Rect& r) { canvas.rect(r, style, corner_radius); }};
}

LegendEntry line_entry(const std::string& name, const std::string& style) {
  return {name, [=](Canvas& canvas, const Rect& r) {
            const Pixel left = left_middle(r);
            canvas.line(left, {r.right(), left.y}, style);
          }};
}

LegendEntry dot_entry(const std::string& name, double radius, const std::string& style) {
  return {name,
          [=](Canvas& canvas, const Rect& r) {
            canvas.circle({r.x + radius, left_middle(r).y}, radius, style);
          },
          2.0 * radius};
}

LegendEntry keepout_entry() {
  return area_entry("keep-out fence", kKeepoutStyle);
}

LegendEntry keepout_for_a_while_entry() {
  return area_entry("keep-out for a while", kKeepoutForAWhileStyle);
}

const char* fence_style(const tern::Fence& fence) {
  if (fence.kind == tern::FenceKind::kKeepIn) return kKeepinStyle;
  return tern::is_timed(fence) ? kKeepoutForAWhileStyle : kKeepoutStyle;
}

LegendEntry keepin_entry() {
  return area_entry("keep-in fence", kKeepinStyle);
}

LegendEntry speed_entry(const std::string& name) {
  return {name,
          [](Canvas& canvas, const Rect& r) {
            canvas.raw(gradient());
            canvas.rect({r.x, r.y + 1.0, r.width, r.height - 2.0}, "fill=\"url(#speed)\"", 3.0);
          },
          kSpeedBar};
}

int legend_rows(const std::vector<LegendEntry>& entries, double width) {
  return entries.empty() ? 0 : 1 + static_cast<int>(places(entries, width).back().y / kLegendRow + 0.5);
}

void draw_legend(Canvas& canvas, const std::vector<LegendEntry>& entries, Pixel top_left, double width) {
  const std::vector<Pixel> at = places(entries, width);
  for (std::size_t i = 0; i < entries.size(); ++i) {
    const Rect sample{top_left.x + at[i].x, top_left.y + at[i].y, entries[i].sample_width, kSampleHeight};
    entries[i].sample(canvas, sample);
    canvas.text({sample.right() + kNameGap, sample.y + 11.5}, entries[i].name, "class=\"number\"");
  }
}

}  // namespace tern_host
