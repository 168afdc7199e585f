// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TERN_HOST_PICTURE_OBLIQUE_CAMERA_HPP
#define TERN_HOST_PICTURE_OBLIQUE_CAMERA_HPP

#include <vector>

#include "host/picture/canvas.hpp"
#include "host/scenario.hpp"

namespace tern_host {

/// A parallel projection, seen from above and a little from the right. The longer horizontal side of the map runs
/// across the picture, as in the top view; lengths along it, heights and depths are each true to a scale of their own.
class ObliqueCamera {
 public:
  explicit ObliqueCamera(const tern::Box& boundary);

  /// Scales and moves the picture so that the boundary fits into `frame`, at its top and in the middle of its width.
  void fit(const Rect& frame);

  /// World frame, metres, to pixels.
  Pixel project(const tern::Vec3& world) const;
  /// Pixels a metre across the view.
  double scale() const { return scale_; }
  /// Where the boundary ends, below.
  double bottom() const { return bottom_; }

  /// A world point or box along the camera's own axes: across, away, up. The viewer is at high x, low y, high z.
  tern::Vec3 turned(const tern::Vec3& world) const;
  tern::Box turned(const tern::Box& world) const;
  /// The pixel of a turned point.
  Pixel project_turned(const tern::Vec3& point) const;

  /// Whether a turned box stands between a turned point and the viewer.
  static bool hides(const tern::Box& box, const tern::Vec3& point);

 private:
  tern::Box boundary_;
  bool y_across_;
  double scale_ = 1.0;
  Pixel offset_{0.0, 0.0};
  double bottom_ = 0.0;
};

/// The order to draw turned boxes in, from the back to the front.
std::vector<std::size_t> back_to_front(const std::vector<tern::Box>& boxes);

}  // namespace tern_host

#endif
