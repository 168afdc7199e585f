// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "times/time_unit.hpp"

#include "base/math.hpp"

namespace tern {
namespace {

/// The speed that a flight has room for, in parts of the triangular profile's peak along the whole way. At usual
/// weights, the smoothest flight without a speed limit is faster at its peak. So as long as a higher speed limit makes
/// the unit smaller, the limit binds, and the flight gains from raising it.
constexpr double kWholeWay = 0.5;
/// Stands for the length of a way of length 0, metres.
constexpr double kLeastWay = 1e-3;

/// Sums over the legs of a way.
struct Way {
  double length;   ///< metres
  double squares;  ///< of the legs' lengths
  double cruise;   ///< seconds for the way at the speed limit
  double push;     ///< length over the acceleration limit
};

void add(const Vec3& delta, const MotionLimits& limits, Way& way) {
  const double metres = length(delta);
  if (!(metres > 0.0)) return;
  const LineLimits line = limits_along(delta, limits);
  way.length += metres;
  way.squares += metres * metres;
  way.cruise += metres / line.speed;
  way.push += metres / line.acceleration;
}

/// The way from a velocity to rest.
void add_stop(const Vec3& velocity, const MotionLimits& limits, Way& way) {
  const double speed = length(velocity);
  if (!(speed > 0.0)) return;
  add((0.5 * speed / limits_along(velocity, limits).acceleration) * velocity, limits, way);
}

Way way_of(const Chain& chain, const Corridor& corridor, const MotionLimits& limits) {
  Way way{};
  for (int i = 0; i < corridor.count; ++i) add(corridor.polyhedra[i].to - corridor.polyhedra[i].from, limits, way);
  add_stop(chain.start.d[1], limits, way);
  add_stop(chain.goal.d[1], limits, way);
  if (!(way.length > 0.0)) add({kLeastWay, 0.0, 0.0}, limits, way);
  return way;
}

/// The mean length of a leg, averaged over the way and not over the legs.
double mean_leg(const Way& way) {
  return way.squares / way.length;
}

LineLimits reachable(const Way& way) {
  const double a = way.length / way.push;
  const double room = smaller(kWholeWay * square_root(a * way.length), square_root(a * mean_leg(way)));
  return LineLimits{smaller(way.length / way.cruise, larger(room, kMinDuration * a)), a};
}

}  // namespace

LineLimits reachable(const Chain& chain, const Corridor& corridor, const MotionLimits& limits) noexcept {
  return reachable(way_of(chain, corridor, limits));
}

double agility(const Chain& chain, const Corridor& corridor, const MotionLimits& limits) noexcept {
  const Way way = way_of(chain, corridor, limits);
  const LineLimits line = reachable(way);
  return line.acceleration / line.speed * (mean_leg(way) / line.speed);
}

double time_unit(const Chain& chain, const Corridor& corridor, const MotionLimits& limits) noexcept {
  const LineLimits line = reachable(chain, corridor, limits);
  const double jerk = line.acceleration / line.speed * line.acceleration;
  const double snap = jerk / line.speed * line.acceleration;
  return snap * snap;
}

}  // namespace tern
