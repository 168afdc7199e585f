// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TERN_HOST_PICTURE_LEGEND_HPP
#define TERN_HOST_PICTURE_LEGEND_HPP

#include <functional>
#include <string>
#include <vector>

#include "host/picture/canvas.hpp"
#include "tern/fence.hpp"

namespace tern_host {

/// What stands for a thing in the picture, and its name.
struct LegendEntry {
  std::string name;
  std::function<void(Canvas&, const Rect&)> sample;  ///< draws into the rectangle that it is given
  double sample_width = 28.0;
};

/// How fences look.
constexpr const char* kKeepoutStyle = "class=\"keepout\" opacity=\"0.6\"";
constexpr const char* kKeepoutForAWhileStyle = "class=\"keepout-for-a-while\"";
constexpr const char* kKeepinStyle = "class=\"keepin\"";
const char* fence_style(const tern::Fence& fence);

constexpr double kLegendRow = 22.0;  ///< pixels from one row to the next

LegendEntry area_entry(const std::string& name, const std::string& style, double corner_radius = 0.0);
LegendEntry line_entry(const std::string& name, const std::string& style);
LegendEntry dot_entry(const std::string& name, double radius, const std::string& style);
LegendEntry keepout_entry();
LegendEntry keepout_for_a_while_entry();
LegendEntry keepin_entry();
/// A bar of the speed colours. Defines the gradient that it is filled with.
LegendEntry speed_entry(const std::string& name);

/// Rows that the entries take in a given width.
int legend_rows(const std::vector<LegendEntry>& entries, double width);
/// Draws the entries from left to right in rows; `top_left` is where the first row's samples begin.
void draw_legend(Canvas& canvas, const std::vector<LegendEntry>& entries, Pixel top_left, double width);

}  // namespace tern_host

#endif
