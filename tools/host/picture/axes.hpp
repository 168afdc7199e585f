// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TERN_HOST_PICTURE_AXES_HPP
#define TERN_HOST_PICTURE_AXES_HPP

#include <string>
#include <vector>

#include "host/picture/canvas.hpp"

namespace tern_host {

struct AxisRange {
  double low;
  double high;

  double extent() const { return high - low; }
};

/// A plotting area: its place in the picture and the values along its edges.
struct Axes {
  Rect frame;
  AxisRange horizontal;
  AxisRange vertical;
  bool down = false;  ///< vertical values grow downwards

  Pixel at(double h, double v) const;
};

/// Round values (1, 2 or 5 times a power of ten apart) inside a range, about `wanted` of them.
std::vector<double> ticks(const AxisRange& range, double wanted);

/// Grid lines below the data.
void draw_grid(Canvas& canvas, const Axes& axes);
/// A line across the frame at a vertical value.
void draw_level(Canvas& canvas, const Axes& axes, double value, const std::string& style);
/// Frame, tick labels and axis titles above the data.
void draw_frame(Canvas& canvas, const Axes& axes, const std::string& horizontal_title,
                const std::string& vertical_title);

}  // namespace tern_host

#endif
