// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// What a level camera or lidar sees: the nearest thing in the whole area of a pixel or a beam, and not only at its
// corners. Everything in a world stands upright, so a column of pixels cuts a thing to a range of depths, and a pixel's
// upper and lower border cut that further.
#ifndef TERN_HOST_FLIGHT_PIXEL_COLUMNS_HPP
#define TERN_HOST_FLIGHT_PIXEL_COLUMNS_HPP

#include <vector>

#include "host/flight/flight_world.hpp"

namespace tern_host {

/// A range of depths between two heights.
struct DepthRange {
  double enter, leave, bottom, top;
};

class PixelColumns {
 public:
  /// Columns between borders, from left to right. A border is the upright plane of the rays that go `right` metres to
  /// the right for each metre ahead. `far` is the greatest depth. `world` need not outlive it.
  PixelColumns(const FlightWorld& world, const tern::Vec3& eye, double yaw, double far,
               const std::vector<double>& borders);

  /// Depth of the nearest point of any thing, or of the space beyond the boundary, that lies in a column between the
  /// rays that fall by `upper` and by `lower` for each metre ahead, upper < lower. A thing that only touches the area
  /// counts.
  double depth(int column, double upper, double lower) const;
  /// The same, but how far that point is from the eye.
  double distance(int column, double upper, double lower) const;

 private:
  struct View;

  template <typename Thing>
  void add(const Thing& thing, const View& view);

  double depth_of(const DepthRange& thing, double upper, double lower) const;
  double distance_of(const DepthRange& thing, double upper, double lower) const;

  double height_;
  double bottom_, top_;                          ///< of the boundary
  std::vector<double> walls_;                    ///< depth of the boundary's nearest wall, for each column
  std::vector<std::vector<DepthRange>> things_;  ///< for each column, nearest first
};

}  // namespace tern_host

#endif
