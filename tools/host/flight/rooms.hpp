// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// How much further than it must be a commanded centre is from what it may not come near to. Metres; negative where it
// is too near. None changes faster than the centre moves.
#ifndef TERN_HOST_FLIGHT_ROOMS_HPP
#define TERN_HOST_FLIGHT_ROOMS_HPP

#include <functional>
#include <vector>

#include "host/flight/flight_pads.hpp"
#include "host/flight/flight_world.hpp"
#include "tern/map.hpp"

namespace tern_host {

class Rooms {
 public:
  /// Both must outlive it.
  Rooms(const FlightWorld& world, const tern::RollingMap& map);

  /// The map can be read: it does not slide.
  bool readable() const { return map_.safe().bound(); }
  const tern::GridSpec& window() const { return map_.safe().spec(); }

  /// From all voxels that are not known to be free, and from the window's faces; at most a little more than a voxel.
  /// Right above a pad, the vehicle may be as near to voxels that reach below its ground as it stands, and no lower.
  /// Voxels for whose centre `leave_out` answers true do not count; it may be empty.
  using LeaveOut = std::function<bool(const tern::Vec3& center)>;
  double from_solid(const tern::Vec3& p, const LeaveOut& leave_out = {}) const;
  /// From the window's faces alone.
  double from_faces(const tern::Vec3& p) const;
  /// From where the fences that hold at time t let the centre be; it keeps the radius from keep-outs. `change` becomes
  /// the next time at which one of them begins or ends, if that is sooner.
  double from_fences(const tern::Vec3& p, std::int64_t t, std::int64_t& change) const;
  /// From the true world, for a body that is off the command by the tracking error.
  double from_world(const tern::Vec3& p) const;

  /// It rests with something within the radius: whether that is called a threat is the flight's choice.
  bool leaves() const { return leaves_; }
  /// The vehicle rests here. If something is within the radius, from_solid() lets it stay as near to that as it is.
  void rest_at(const tern::Vec3& place);

 private:
  const FlightWorld& world_;
  const tern::RollingMap& map_;
  double radius_;
  std::vector<Pad> pads_;
  bool leaves_ = false;  ///< something is within the radius of
  tern::Vec3 left_{};    ///< this place
};

}  // namespace tern_host

#endif
