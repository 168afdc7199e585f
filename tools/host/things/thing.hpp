// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Things that move in a simulated world: what each is, how it moves in truth, and what it may do.
#ifndef TERN_HOST_THINGS_THING_HPP
#define TERN_HOST_THINGS_THING_HPP

#include <string>
#include <variant>
#include <vector>

#include "tern/track.hpp"
#include "tern/vec3.hpp"

namespace tern_host {

/// A trefoil knot: with u = (t + ahead) / slower and f = phase, `center` plus `scale` times
/// (sin(u + f) + 2 sin(2u + f), cos(u + f) - 2 cos(2u + f), -sin(3u + f)), axis by axis, m.
struct Trefoil {
  tern::Vec3 center{};
  tern::Vec3 scale{};
  double slower = 1.0;  ///< s, > 0
  double phase = 0.0;
  double ahead = 0.0;  ///< s
};

/// A point of a walk: where, m, and for how long it stands there, s; 0: it passes.
struct WalkPoint {
  tern::Vec3 place;
  double wait;
};

/// From point to point on straight lines at one speed, m/s. It turns, stops and sets off with one acceleration, m/s^2,
/// so it cuts corners. It begins at rest at the first point, where it was at time -ahead, s. A loop leads back to the
/// first point and begins anew; otherwise it stays at the last one.
struct Walk {
  double speed = 1.0;
  double acceleration = 1.0;
  double ahead = 0.0;
  bool is_loop = false;
  std::vector<WalkPoint> points;
};

/// It steers at the vehicle, as hard and as fast as it can, while that is within `sight`, m; otherwise it keeps its
/// velocity. Begins at rest.
struct Hunt {
  tern::Vec3 start{};
  double acceleration = 1.0;  ///< m/s^2, > 0
  double speed = 1.0;         ///< m/s, > 0
  double sight = 10.0;
};

/// What a thing can do at most.
struct ThingBounds {
  double speed = 0.0;         ///< m/s
  double acceleration = 0.0;  ///< m/s^2
};

struct Thing {
  std::string name;
  tern::TrackShape shape = tern::TrackShape::kBall;
  double radius = 0.0;  ///< m, of a ball or a cylinder
  tern::Vec3 half{};    ///< m, of a box; of a cylinder, z is half its height
  std::variant<Trefoil, Walk, Hunt> motion;
  /// What detectors take for its bounds; both 0: those of its motion.
  ThingBounds claimed;
};

}  // namespace tern_host

#endif
