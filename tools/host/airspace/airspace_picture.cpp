// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>

#include "host/airspace/airspace.hpp"
#include "host/number.hpp"
#include "host/picture/canvas.hpp"
#include "host/picture/colours.hpp"

namespace tern_host {
namespace {

constexpr double kSize = 760.0, kEdge = 40.0;
/// Below the boundary: the scale, and the legend.
constexpr double kFoot = 44.0;
/// A round number of metres, about a fifth of the length.
double round_length(double length) {
  const double power = std::pow(10.0, std::floor(std::log10(0.2 * length)));
  for (const double step : {5.0, 2.0}) {
    if (step * power <= 0.2 * length) return step * power;
  }
  return power;
}

class PlanPicture {
 public:
  explicit PlanPicture(const Airspace& airspace) : airspace_(airspace), box_(airspace.settings.fit.boundary) {
    const double longest = std::max(box_.upper.x - box_.lower.x, box_.upper.y - box_.lower.y);
    scale_ = kSize / longest;
    room_ = {kEdge, kEdge, scale_ * (box_.upper.x - box_.lower.x), scale_ * (box_.upper.y - box_.lower.y)};
  }

  std::string draw() {
    canvas_.rect({0.0, 0.0, room_.right() + kEdge, room_.bottom() + kEdge + kFoot}, R"(class="paper")");
    canvas_.begin_clipped(room_);
    // What always holds is behind what holds for a while.
    for (const bool timed : {false, true}) {
      for (const AirspaceEntry& entry : airspace_.entries) {
        if (entry.spans.empty() != timed) draw_fences(entry);
      }
    }
    draw_mission();
    canvas_.end_group();
    canvas_.rect(room_, R"(class="frame")");
    for (const AirspaceEntry& entry : airspace_.entries) name(entry);
    draw_scale();
    draw_legend();
    return canvas_.document(room_.right() + kEdge, room_.bottom() + kEdge + kFoot, style_sheet());
  }

 private:
  Pixel pixel(double x, double y) const {
    return {kEdge + scale_ * (x - box_.lower.x), room_.bottom() - scale_ * (y - box_.lower.y)};
  }

  static const char* style_of(const AirspaceEntry& entry, const FittedFence& fence) {
    if (fence.kind == tern::FenceKind::kKeepIn) return kKeepIn;
    return entry.spans.empty() ? kKeepOut : kForAWhile;
  }

  bool has_fence(const char* style) const {
    return std::any_of(airspace_.entries.begin(), airspace_.entries.end(), [style](const AirspaceEntry& entry) {
      return std::any_of(entry.fit.fences.begin(), entry.fit.fences.end(),
                         [&](const FittedFence& fence) { return style_of(entry, fence) == style; });
    });
  }

  void draw_fences(const AirspaceEntry& entry) {
    for (const FittedFence& fence : entry.fit.fences) {
      std::vector<Pixel> pixels;
      for (const ConvexPiece::Vertex& v : fence.outline) pixels.push_back(pixel(v.x, v.y));
      canvas_.polygon(pixels, style_of(entry, fence));
    }
  }

  /// At the middle of its first piece, where that is in the picture and nothing is written yet.
  void name(const AirspaceEntry& entry) {
    if (entry.fit.fences.empty()) return;
    Pixel middle{0.0, 0.0};
    const auto& outline = entry.fit.fences[0].outline;
    for (const ConvexPiece::Vertex& v : outline) {
      const Pixel p = pixel(std::clamp(v.x, box_.lower.x, box_.upper.x), std::clamp(v.y, box_.lower.y, box_.upper.y));
      middle.x += p.x / static_cast<double>(outline.size());
      middle.y += p.y / static_cast<double>(outline.size());
    }
    const std::string style = R"(class="number" text-anchor="middle")";
    const std::string text = printable(entry.zone.name, 24);
    if (canvas_.clear_of_text(text_room(middle, text, style))) canvas_.text(middle, text, style);
  }

  void draw_mission() {
    std::vector<Pixel> way;
    for (const LocalPoint& p : airspace_.points) way.push_back(pixel(p.position.x, p.position.y));
    if (way.size() > 1) canvas_.polyline(way, R"(class="shortcut")");
    for (const Pixel& p : way) canvas_.circle(p, 3.5, R"(class="via")");
    for (const LocalPoint& p : airspace_.rally) {
      canvas_.circle(pixel(p.position.x, p.position.y), 4.0, R"(class="waypoint")");
    }
  }

  void draw_scale() {
    const double length = round_length(box_.upper.x - box_.lower.x);
    const double y = room_.bottom() + 24.0;
    canvas_.line({kEdge, y}, {kEdge + scale_ * length, y}, R"(class="shortcut")");
    canvas_.text({kEdge + scale_ * length + 8.0, y + 4.0}, brief(length) + " m, north is up", R"(class="number")");
  }

  /// What there is in the picture, from left to right.
  void draw_legend() {
    const double y = room_.bottom() + 48.0;
    double x = kEdge;
    const auto caption = [&](const char* text) {
      const std::string style = R"(class="number")";
      canvas_.text({x + 22.0, y + 4.0}, text, style);
      x += 22.0 + text_room({0.0, 0.0}, text, style).width + 20.0;
    };
    const std::pair<const char*, const char*> fences[] = {
        {kKeepOut, "keep out"}, {kForAWhile, "keep out for a while"}, {kKeepIn, "keep in"}};
    for (const auto& [style, text] : fences) {
      if (!has_fence(style)) continue;
      canvas_.rect({x, y - 6.0, 16.0, 12.0}, style);
      caption(text);
    }
    if (!airspace_.points.empty()) {
      canvas_.line({x, y}, {x + 16.0, y}, R"(class="shortcut")");
      canvas_.circle({x + 8.0, y}, 3.5, R"(class="via")");
      caption("mission");
    }
    if (airspace_.rally.empty()) return;
    canvas_.circle({x + 8.0, y}, 4.0, R"(class="waypoint")");
    caption("rally point");
  }

  static constexpr const char* kKeepIn = R"(class="keepin")";
  static constexpr const char* kKeepOut = R"(class="keepout")";
  static constexpr const char* kForAWhile = R"(class="keepout-for-a-while")";

  const Airspace& airspace_;
  const tern::Box& box_;
  double scale_ = 1.0;
  Rect room_{};
  Canvas canvas_;
};

}  // namespace

std::string airspace_svg(const Airspace& airspace) {
  return PlanPicture(airspace).draw();
}

}  // namespace tern_host
