// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TERN_REQUEST_HPP
#define TERN_REQUEST_HPP

#include <stdint.h>

#include "tern/fence.hpp"
#include "tern/trajectory.hpp"
#include "tern/vec3.hpp"

namespace tern {

/// A boundary state: world frame, metres and seconds. Jerk at both ends of a plan is zero.
struct State {
  Vec3 position;
  Vec3 velocity;
  Vec3 acceleration;
};

/// What velocity and acceleration keep for all t: upper and lower limits per axis (z is up, so that climbing and
/// sinking may differ) and, where given, the Euclidean norm of the horizontal vector (x, y). Magnitudes within
/// [kMinLimit, kMaxLimit]. Where only v_max and a_max are given they hold both ways.
struct Limits {
  Vec3 v_max;                 ///< m/s, > 0
  Vec3 a_max;                 ///< m/s^2, > 0
  Vec3 v_min{};               ///< m/s, < 0; an axis of 0 stands for -v_max
  Vec3 a_min{};               ///< m/s^2, < 0; an axis of 0 stands for -a_max
  double v_horizontal = 0.0;  ///< m/s, limit of sqrt(vx^2 + vy^2); 0: none
  double a_horizontal = 0.0;  ///< m/s^2, likewise
};
constexpr double kMinLimit = 1e-3;
constexpr double kMaxLimit = 1e3;

/// What duration is worth against smoothness: a plan minimises (integral of squared snap) + time_weight a^6 / v^4 T,
/// where v and a are the largest limits of an axis and T is the duration (a^3 / v^2 is the scale of snap at the limits:
/// the same weight means the same style of flight to slow and to fast vehicles). More is faster: 40, the default,
/// flies the forests of docs/trajectory.md within a tenth of the fastest; 10 is gentle; 1000 is as fast as limits
/// allow.
constexpr double kDefaultTimeWeight = 40.0;
constexpr double kMinTimeWeight = 1e-3;
constexpr double kMaxTimeWeight = 1e6;

/// Work that a plan may spend, counted, never timed (contract C7). The stage bounds of config.hpp hold besides.
struct Budget {
  uint32_t expansions = 0xFFFFFFFFu;   ///< nodes taken off the open list
  uint32_t sight_lines = 0xFFFFFFFFu;  ///< steps of the shortcut, each a line of sight or a trial
  uint32_t planes = 0xFFFFFFFFu;       ///< half-spaces made by the corridor
  uint32_t iterations = 0xFFFFFFFFu;   ///< iterations of the quadratic programmes, all together
};

/// How the front end shortens the jump-point path. Any other number is refused (field kShortcut).
enum class ShortcutMode : uint8_t {
  kShortestChain = 0,  ///< the shortest chain of mutually visible waypoints; lines of sight never cut a corner
};

/// One planning query.
struct Request {
  State start{};
  State goal{};
  Limits limits{};
  Budget budget{};
  ShortcutMode shortcut = ShortcutMode::kShortestChain;
  double time_weight = kDefaultTimeWeight;  ///< within [kMinTimeWeight, kMaxTimeWeight]
  const Fence* fences = nullptr;            ///< geofences; the caller's, read while a plan begins
  int32_t fence_count = 0;                  ///< 0 .. kMaxFences

  /// The plan that is being flown, or null; the caller's, read while a plan begins. `start` must then be what
  /// evaluate(*previous, previous_time) gives, bit for bit. Where nothing new is found, the rest of it is flown on: to
  /// its end, and from there to the goal if that is another one (Report::detours is 3). On an unchanged map, with the
  /// same limits and fences, a plan is then found wherever `previous` has a millisecond left of its segment at hand.
  const Trajectory* previous = nullptr;
  double previous_time = 0.0;  ///< seconds, >= 0
};

}  // namespace tern

#endif
