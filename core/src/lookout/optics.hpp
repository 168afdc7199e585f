// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// What the sensor sees of a voxel from a place: whether the voxel comes into its view whole, and whether anything that
// was seen is in between.
#ifndef TERN_LOOKOUT_OPTICS_HPP
#define TERN_LOOKOUT_OPTICS_HPP

#include "base/work.hpp"
#include "tern/flight_sensor.hpp"
#include "tern/map.hpp"
#include "tern/yaw.hpp"

namespace tern {

/// How the sensor looks from a place: its position and its axes, which are at right angles. World frame.
struct SensorPose {
  Vec3 eye;
  Vec3 ahead;
  Vec3 right;
  Vec3 down;
};

class Optics {
 public:
  Optics() noexcept = default;
  Optics(const FlightSensor& sensor, const MapSpec& map) noexcept;

  /// The vehicle is at `place` with this heading, of length 1, and a gimbal turns the sensor up or down to `look`, as
  /// far as it can.
  SensorPose pose(const Vec3& place, const Heading& heading, const Vec3& look) const noexcept;
  /// True if the whole cube with this centre is in view and within the range, for all errors of pose and depth.
  bool in_view(const SensorPose& pose, const Vec3& centre) const noexcept;
  /// True if nothing that was seen is on the way to the cube's centre, nor so near behind it that the cube would not
  /// count as seen. `map` must be bound.
  bool in_sight(const RollingMap& map, const Vec3& eye, const Vec3& centre, Work& work) const noexcept;
  /// The same for all of the cube: lines to its centre and to four corners of its outline, which is grown by the errors
  /// of the pose, and narrower by this part of a voxel on each side. Where a floor is right below a voxel, only flat
  /// lines pass.
  bool in_wide_sight(const RollingMap& map, const SensorPose& pose, const Vec3& centre, double narrower,
                     Work& work) const noexcept;
  /// Only up to the cube's centre. A thing that was hit may fill a part of its voxels alone, so that the sensor sees
  /// past it what the other lines do not.
  static bool in_short_sight(const RollingMap& map, const Vec3& eye, const Vec3& centre, Work& work) noexcept;
  bool is_scanner() const noexcept { return is_scanner_; }

 private:
  bool in_pyramid(const SensorPose& pose, const Vec3& way, double grown) const noexcept;
  bool in_ring(const SensorPose& pose, const Vec3& way, double grown) const noexcept;

  FlightSensor sensor_{};
  bool is_scanner_ = false;
  double tangent_right_ = 0.0;  ///< of half the angles of view
  double tangent_down_ = 0.0;
  double cosine_side_ = 0.0;  ///< of half the horizontal angle
  double tangent_low_ = 0.0;  ///< of the axis' lowest and highest pitch
  double tangent_high_ = 0.0;
  double tangent_bottom_ = 0.0;  ///< of a scanner's lowest and highest beams
  double tangent_top_ = 0.0;
  double cell_ = 0.0;
  double range_ = 0.0;
  double margin_ = 0.0;  ///< of depths, as MapSpec::depth_margin and depth_margin_square
  double margin_square_ = 0.0;
  double pose_margin_ = 0.0;
  double angle_margin_ = 0.0;  ///< also of a scan's pixels
};

}  // namespace tern

#endif
