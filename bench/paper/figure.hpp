// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The pictures of docs/paper.md: a page with title, origin and legend, and panels on it.
#ifndef TERN_BENCH_PAPER_FIGURE_HPP
#define TERN_BENCH_PAPER_FIGURE_HPP

#include <string>
#include <vector>

#include "host/picture/axes.hpp"
#include "host/picture/map_view.hpp"
#include "paper/run.hpp"

namespace tern_bench {

using tern_host::Axes;
using tern_host::AxisRange;
using tern_host::Canvas;
using tern_host::Pixel;
using tern_host::Projection;
using tern_host::Rect;

constexpr double kFigureWidth = 1000.0;
constexpr double kFigureMargin = 24.0;
/// Room left of and below a panel for its numbers and titles, and above it for its heading.
constexpr double kPanelLeft = 64.0;
constexpr double kPanelBelow = 50.0;
constexpr double kPanelAbove = 30.0;

/// An entry of a legend: a line in its style, or a dot where `dot` is set.
struct Key {
  std::string name;
  std::string style;
  bool dot = false;
};

/// One picture. `origin` says which command made it, below the title.
class Figure {
 public:
  Figure(const std::string& title, const std::string& part);

  Canvas& canvas() { return canvas_; }
  /// Entries in rows below the title. Call once, before anything is drawn at top().
  void legend(const std::vector<Key>& keys);
  /// Where panels may begin.
  double top() const { return top_; }
  /// Writes folder/name with this height in all.
  void write(const Run& run, const std::string& name, double height) const;

 private:
  Canvas canvas_;
  double top_;
};

/// A curve of a plot.
struct Curve {
  std::vector<double> x;
  std::vector<double> y;
  std::string style;
};

/// A plot in `frame`: grid, curves (clipped), frame and titles; the heading stands above.
void draw_plot(Canvas& canvas, const Axes& axes, const std::vector<Curve>& curves, const std::string& heading,
               const std::string& horizontal_title, const std::string& vertical_title);

/// Top and side view of a map to one scale.
struct MapViews {
  Projection top;
  Projection side;
  Axes top_axes;
  Axes side_axes;
  double bottom;  ///< where the panels with their titles end
};

/// Lays the views out below `y`: one above the other, or beside each other where that makes them larger. The longer
/// horizontal side of the map runs across.
MapViews lay_out_views(const tern_host::Scenario& scenario, double y);

/// Grid and obstacles of both views.
void draw_map(Canvas& canvas, const MapViews& views, const tern_host::Scenario& scenario);
/// A chain of points in both views, with dots at its points where `dot_style` is not empty.
void draw_route(Canvas& canvas, const MapViews& views, const std::vector<tern::Vec3>& points, const std::string& style,
                const std::string& dot_style = "");
/// Frames, titles, start and goal; above everything else.
void finish_map(Canvas& canvas, const MapViews& views, const tern_host::Scenario& scenario,
                const std::vector<tern::Vec3>& way);

}  // namespace tern_bench

#endif
