// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "paper/figure.hpp"

#include <algorithm>

#include "host/atomic_file.hpp"
#include "host/picture/colours.hpp"

namespace tern_bench {
namespace {

using tern::Vec3;

constexpr double kKeyLine = 30.0;
constexpr double kKeyHeight = 22.0;
constexpr double kPixelsPerLetter = 7.4;
constexpr double kMaxViewsHeight = 640.0;

AxisRange range_of(const tern::Box& box, int axis) {
  return {tern_host::component(box.lower, axis), tern_host::component(box.upper, axis)};
}

Axes panel(const Rect& frame, const Projection& projection, const tern::Box& box) {
  return {frame, range_of(box, projection.horizontal), range_of(box, projection.vertical), projection.down};
}

void draw_chain(Canvas& canvas, const Axes& axes, const Projection& projection, const std::vector<Vec3>& points,
                const std::string& style, const std::string& dot_style) {
  std::vector<Pixel> pixels;
  for (const Vec3& p : points) pixels.push_back(tern_host::project(axes, projection, p));
  canvas.polyline(pixels, style);
  if (dot_style.empty()) return;
  for (const Pixel& p : pixels) canvas.circle(p, 3.4, dot_style);
}

void finish_view(Canvas& canvas, const Axes& axes, const Projection& projection, const tern_host::Scenario& scenario,
                 const std::vector<Vec3>& way, const char* heading) {
  const auto title = [](int axis) { return std::string(1, "xyz"[axis]) + " (m)"; };
  std::vector<Pixel> pixels;
  for (const Vec3& p : way) pixels.push_back(tern_host::project(axes, projection, p));
  tern_host::draw_frame(canvas, axes, title(projection.horizontal), title(projection.vertical));
  canvas.text({axes.frame.x, axes.frame.y - 10.0}, heading, "class=\"heading\"");
  tern_host::draw_ends(canvas, axes, projection, scenario, pixels);
}

}  // namespace

Figure::Figure(const std::string& title, const std::string& part) : top_(86.0) {
  canvas_.text({kFigureMargin, 36.0}, title, "class=\"title\"");
  canvas_.text({kFigureMargin, 60.0}, "tools/paper --only " + part, "class=\"subtitle\"");
}

void Figure::legend(const std::vector<Key>& keys) {
  double x = kFigureMargin;
  double y = top_ + 4.0;
  for (const Key& key : keys) {
    const double width = kKeyLine + 8.0 + kPixelsPerLetter * static_cast<double>(key.name.size()) + 18.0;
    if (x + width > kFigureWidth - kFigureMargin && x > kFigureMargin) {
      x = kFigureMargin;
      y += kKeyHeight;
    }
    if (key.dot) {
      canvas_.circle({x + 0.5 * kKeyLine, y}, 4.5, key.style);
    } else {
      canvas_.line({x, y}, {x + kKeyLine, y}, key.style);
    }
    canvas_.text({x + kKeyLine + 8.0, y + 4.5}, key.name, "class=\"label\"");
    x += width;
  }
  top_ = y + kKeyHeight;
}

void Figure::write(const Run& run, const std::string& name, double height) const {
  Canvas page;
  page.rect({0.0, 0.0, kFigureWidth, height}, "fill=\"#ffffff\"");
  page.raw(canvas_.body());
  tern_host::write_file(run.folder + "/" + name, page.document(kFigureWidth, height, tern_host::style_sheet()));
}

void draw_plot(Canvas& canvas, const Axes& axes, const std::vector<Curve>& curves, const std::string& heading,
               const std::string& horizontal_title, const std::string& vertical_title) {
  canvas.begin_clipped(axes.frame);
  tern_host::draw_grid(canvas, axes);
  for (const Curve& curve : curves) {
    std::vector<Pixel> points;
    for (std::size_t i = 0; i < curve.x.size(); ++i) points.push_back(axes.at(curve.x[i], curve.y[i]));
    canvas.polyline(points, curve.style);
  }
  canvas.end_group();
  tern_host::draw_frame(canvas, axes, horizontal_title, vertical_title);
  canvas.text({axes.frame.x, axes.frame.y - 10.0}, heading, "class=\"heading\"");
}

MapViews lay_out_views(const tern_host::Scenario& scenario, double y) {
  const tern::Box& box = scenario.boundary;
  MapViews views{};
  const bool turned = range_of(box, 1).extent() > 1.05 * range_of(box, 0).extent();
  views.top = turned ? Projection{1, 0, 2, true} : Projection{0, 1, 2, false};
  views.side = turned ? Projection{1, 2, 0, false} : Projection{0, 2, 1, false};
  const double across = range_of(box, views.top.horizontal).extent();
  const double top = range_of(box, views.top.vertical).extent();
  const double side = range_of(box, 2).extent();
  const double width = kFigureWidth - 2.0 * kFigureMargin;
  const double stacked = std::min((width - kPanelLeft) / across, kMaxViewsHeight / (top + side));
  const double beside = std::min((0.5 * width - kPanelLeft) / across, kMaxViewsHeight / std::max(top, side));
  // Beside each other they need less of the page.
  const bool above = stacked > 1.2 * beside;
  const double scale = above ? stacked : beside;
  const double x = kFigureMargin + kPanelLeft;
  const Rect first{x, y + kPanelAbove, scale * across, scale * top};
  const Rect below{x, first.bottom() + kPanelBelow + kPanelAbove, scale * across, scale * side};
  const Rect right{x + 0.5 * width, y + kPanelAbove, scale * across, scale * side};
  const Rect& second = above ? below : right;
  views.top_axes = panel(first, views.top, box);
  views.side_axes = panel(second, views.side, box);
  views.bottom = std::max(first.bottom(), second.bottom()) + kPanelBelow;
  return views;
}

void draw_map(Canvas& canvas, const MapViews& views, const tern_host::Scenario& scenario) {
  const auto draw = [&](const Axes& axes, const Projection& projection) {
    canvas.begin_clipped(axes.frame);
    tern_host::draw_grid(canvas, axes);
    tern_host::draw_obstacles(canvas, axes, projection, scenario);
    canvas.end_group();
  };
  draw(views.top_axes, views.top);
  draw(views.side_axes, views.side);
}

void draw_route(Canvas& canvas, const MapViews& views, const std::vector<Vec3>& points, const std::string& style,
                const std::string& dot_style) {
  draw_chain(canvas, views.top_axes, views.top, points, style, dot_style);
  draw_chain(canvas, views.side_axes, views.side, points, style, dot_style);
}

void finish_map(Canvas& canvas, const MapViews& views, const tern_host::Scenario& scenario,
                const std::vector<Vec3>& way) {
  finish_view(canvas, views.top_axes, views.top, scenario, way, "Top view");
  finish_view(canvas, views.side_axes, views.side, scenario, way, "Side view");
}

}  // namespace tern_bench
