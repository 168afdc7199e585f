// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Places that the vehicle can reach through known space, and how long it takes to get there.
#ifndef TERN_LOOKOUT_PLACES_HPP
#define TERN_LOOKOUT_PLACES_HPP

#include <cstdint>

#include "base/math.hpp"
#include "base/work.hpp"
#include "lookout/wave.hpp"

namespace tern {

/// Places that a search for a lookout compares, at most. If a wave reaches more, they are thinned, in turn to every
/// second octet along x and y and along z, and those near the vehicle later.
constexpr std::int32_t kMaxPlaces = 200;

struct ReachedPlace {
  std::int32_t octet;  ///< its index
  std::int32_t steps;  ///< of the wave; 0 where it began
};

/// Octets from one place to the next along x and y, and along z: powers of two.
struct Lattice {
  std::int32_t stride;
  std::int32_t stride_up;

  bool has(const Voxel& octet) const noexcept {
    return octet.x % stride == 0 && octet.y % stride == 0 && octet.z % stride_up == 0;
  }
};

struct Places {
  ReachedPlace place[kMaxPlaces];
  std::int32_t count;
  std::int32_t level;  ///< how often they were thinned

  void begin(std::int32_t octet) noexcept;
  /// Takes what the wave's last step reached: the known octets of it or, `everywhere`, all of it.
  void take_front(const Octets& octets, const Wave& wave, bool everywhere, Work& work) noexcept;

  /// The lattice that places so many steps away are taken from.
  Lattice lattice(std::int32_t steps) const noexcept;

 private:
  void thin(const Octets& octets) noexcept;
};

/// Seconds from rest to rest over a distance, or an angle.
inline double seconds_over(double way, double speed, double acceleration) noexcept {
  if (!(way > 0.0)) return 0.0;
  const bool cruises = way > speed * speed / acceleration;
  return cruises ? way / speed + speed / acceleration : 2.0 * square_root(way / acceleration);
}

/// How fast the vehicle moves and turns.
struct Agility {
  double speed;              ///< m/s
  double acceleration;       ///< m/s^2
  double turn_rate;          ///< rad/s
  double turn_acceleration;  ///< rad/s^2

  double seconds(double metres) const noexcept { return seconds_over(metres, speed, acceleration); }
  double seconds_to_turn(double angle) const noexcept { return seconds_over(angle, turn_rate, turn_acceleration); }
};

}  // namespace tern

#endif
