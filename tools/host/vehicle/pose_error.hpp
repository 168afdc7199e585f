// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TERN_HOST_VEHICLE_POSE_ERROR_HPP
#define TERN_HOST_VEHICLE_POSE_ERROR_HPP

#include <cmath>
#include <cstdint>

#include "host/flight/noise.hpp"
#include "host/vehicle/smooth_error.hpp"
#include "host/yaw/yaw_units.hpp"
#include "tern/vec3.hpp"

namespace tern_host {

/// How an estimated position jumps: by `size` metres into a random direction, `every` so many seconds, and back the
/// next time. A size of 0 is none.
struct PoseJumps {
  double size = 0.0;
  double every = 1.0;
};

/// How far a vehicle's estimate of its position is off: by a smooth, seeded error, by jumps, and by a drift of so many
/// m/s into a seeded, level direction. Where the jumps are within the margin, the error without drift is; larger ones
/// come on top of an error up to the margin.
class PoseError {
 public:
  PoseError(double margin, const PoseJumps& jumps, double drift, std::uint64_t seed, Noise& noise)
      : smooth_(jumps.size <= margin ? margin - jumps.size : margin, noise), jumps_(jumps), seed_(seed) {
    const double angle = Noise(seed * 1000003 + kDriftStream).within(0.0, kTurn);
    drift_ = {drift * std::cos(angle), drift * std::sin(angle), 0.0};
  }

  /// At t seconds, metres and m/s. Jumps take no time.
  tern::Vec3 at(double t) const {
    const tern::Vec3 e = smooth_.at(t);
    const tern::Vec3 j = jump_at(t);
    return {e.x + j.x + t * drift_.x, e.y + j.y + t * drift_.y, e.z + j.z};
  }
  tern::Vec3 rate_at(double t) const {
    const tern::Vec3 rate = smooth_.rate_at(t);
    return {rate.x + drift_.x, rate.y + drift_.y, rate.z};
  }

 private:
  static constexpr std::uint64_t kDriftStream = 1000001;  // no jump has this number

  tern::Vec3 jump_at(double t) const {
    if (!(jumps_.size > 0.0)) return {};
    const auto number = static_cast<std::uint64_t>(t / jumps_.every + 1e-9);
    if (number % 2 == 0) return {};
    Noise random(seed_ * 1000003 + number);
    const double z = random.within(-1.0, 1.0);
    const double angle = random.within(0.0, kTurn);
    const double flat = jumps_.size * std::sqrt(1.0 - z * z);
    return {flat * std::cos(angle), flat * std::sin(angle), jumps_.size * z};
  }

  SmoothError smooth_;
  PoseJumps jumps_;
  tern::Vec3 drift_{};
  std::uint64_t seed_;
};

}  // namespace tern_host

#endif
