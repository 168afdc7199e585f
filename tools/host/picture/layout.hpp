// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TERN_HOST_PICTURE_LAYOUT_HPP
#define TERN_HOST_PICTURE_LAYOUT_HPP

#include "host/picture/map_view.hpp"

namespace tern_host {

constexpr double kPageWidth = 1200.0;
constexpr double kPageMargin = 34.0;
constexpr double kContentWidth = kPageWidth - 2.0 * kPageMargin;

/// Where everything stands on the page.
struct PageLayout {
  Projection top;
  Projection side;
  Rect top_frame;
  Rect side_frame;
  Rect velocity_frame;
  Rect acceleration_frame;
  Rect yaw_frame;  ///< with a yaw plan only, as the next one
  Rect turning_frame;
  double height;
};

/// Lays the page out below `y`. The longer horizontal axis of the map runs across the page, both views share it and
/// one scale. A long map's views take the whole width, with the profiles below; other maps leave them the right half. A
/// failed plan has no profiles. The profiles of a yaw plan stand below everything else.
PageLayout lay_out_page(const PlanResult& result, double y);

}  // namespace tern_host

#endif
