// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// What the flight was asked for, kept so that it can be asked again: after poses were lost, or after a jump.
#ifndef TERN_ONBOARD_WISH_HPP
#define TERN_ONBOARD_WISH_HPP

#include <cstddef>
#include <vector>

#include "tern/flight.hpp"
#include "tern/flight_record.hpp"
#include "tern_onboard/settings.hpp"

namespace tern_onboard {

/// Not thread-safe. Points are in the estimate's frame. What the flight is told is recorded.
class Wish {
 public:
  explicit Wish(const FlySettings& settings);

  void set_mission(const std::vector<tern::Via>& points, tern::ViaPolicy policy);
  void clear() { points_.clear(); }
  /// What is left of the mission; its last point is the goal.
  const std::vector<tern::Via>& points() const { return points_; }
  /// Tells the flight the points that are left of the mission, moved by -offset; `done` of those it was told last are
  /// behind it.
  tern::Status send(tern::Flight& flight, tern::FlightRecorder& record, std::size_t done, const tern::Vec3& offset);

  void set_yaw(tern::FlightYawMode mode, const tern::Vec3& point, double heading);
  /// Tells the flight how to turn. `start`: the heading now, rad; for the first time after Flight::start().
  tern::Status send_yaw(tern::Flight& flight, tern::FlightRecorder& record, double start,
                        const tern::Vec3& offset) const;

 private:
  std::vector<tern::Via> points_;
  tern::ViaPolicy policy_ = tern::ViaPolicy::kEnd;
  tern::FlightYaw yaw_{};
};

}  // namespace tern_onboard

#endif
