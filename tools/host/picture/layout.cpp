// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "host/picture/layout.hpp"

#include <algorithm>

namespace tern_host {
namespace {

constexpr double kLeft = 62.0;   // tick labels and title of a vertical axis
constexpr double kBelow = 48.0;  // those of a horizontal axis
constexpr double kTitle = 34.0;  // a panel's title
constexpr double kProfileHeight = 280.0;
constexpr double kYawHeight = 220.0;
constexpr double kColumn = 0.53 * kContentWidth;
constexpr double kMaxViews = 690.0;  // height of both views of a long map
constexpr double kMaxColumnViews = 760.0;
constexpr double kMaxLoneViews = 900.0;

struct Extents {
  double across;  // metres along the page's width
  double top;     // metres of the top view's height
  double side;
};

/// Both views, one above the other, at `scale` pixels a metre. Returns where they end.
double stack_views(PageLayout& page, const Extents& map, double scale, double y) {
  const double x = kPageMargin + kLeft;
  page.top_frame = {x, y + kTitle, scale * map.across, scale * map.top};
  page.side_frame = {x, page.top_frame.bottom() + kBelow + kTitle, scale * map.across, scale * map.side};
  return page.side_frame.bottom() + kBelow;
}

void lay_out_wide(PageLayout& page, const Extents& map, double scale, double y) {
  const double below = stack_views(page, map, scale, y) + kTitle + 8.0;
  const double width = 0.5 * (kContentWidth - 24.0) - kLeft;
  page.velocity_frame = {kPageMargin + kLeft, below, width, kProfileHeight};
  page.acceleration_frame = {kPageMargin + kContentWidth - width, below, width, kProfileHeight};
  page.height = below + kProfileHeight + kBelow;
}

void lay_out_columns(PageLayout& page, const Extents& map, double scale, double y) {
  const double end = std::max(stack_views(page, map, scale, y), y + 2.0 * (kTitle + kBelow + 240.0));
  const double x = page.top_frame.right() + 28.0 + kLeft;
  const double width = kPageMargin + kContentWidth - x;
  const double height = 0.5 * (end - y) - kTitle - kBelow;
  page.velocity_frame = {x, y + kTitle, width, height};
  page.acceleration_frame = {x, page.velocity_frame.bottom() + kBelow + kTitle, width, height};
  page.height = end;
}

/// Without a trajectory there are no profiles: the views have the page.
void lay_out_views_only(PageLayout& page, const Extents& map, double y) {
  const double scale = std::min((kContentWidth - kLeft) / map.across, kMaxLoneViews / (map.top + map.side));
  page.height = stack_views(page, map, scale, y);
}

void lay_out_yaw(PageLayout& page) {
  const double y = page.height + kTitle + 8.0;
  const double width = 0.5 * (kContentWidth - 24.0) - kLeft;
  page.yaw_frame = {kPageMargin + kLeft, y, width, kYawHeight};
  page.turning_frame = {kPageMargin + kContentWidth - width, y, width, kYawHeight};
  page.height = y + kYawHeight + kBelow;
}

}  // namespace

PageLayout lay_out_page(const PlanResult& result, double y) {
  const double extents[3] = {view_range(result, 0).extent(), view_range(result, 1).extent(),
                             view_range(result, 2).extent()};
  const bool turned = extents[1] > 1.05 * extents[0];
  PageLayout page{};
  // Seen from above with y to the right, x comes towards the reader; seen from there, z is up.
  page.top = turned ? Projection{1, 0, 2, true} : Projection{0, 1, 2, false};
  page.side = turned ? Projection{1, 2, 0, false} : Projection{0, 2, 1, false};
  const Extents map{extents[page.top.horizontal], extents[page.top.vertical], extents[2]};
  const double wide = std::min((kContentWidth - kLeft) / map.across, kMaxViews / (map.top + map.side));
  const double column = std::min((kColumn - kLeft) / map.across, kMaxColumnViews / (map.top + map.side));
  if (!result.ok()) {
    lay_out_views_only(page, map, y);
  } else if (wide * map.across > 0.8 * (kContentWidth - kLeft)) {
    lay_out_wide(page, map, wide, y);
  } else {
    lay_out_columns(page, map, column, y);
  }
  if (result.yaw != nullptr) lay_out_yaw(page);
  page.height += 12.0;
  return page;
}

}  // namespace tern_host
