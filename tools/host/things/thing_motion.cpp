// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "host/things/thing_motion.hpp"

#include <algorithm>
#include <cmath>

#include "host/flight/vectors.hpp"

namespace tern_host {
namespace {

using tern::Vec3;

constexpr Vec3 kAtRest{0.0, 0.0, 0.0};

ThingState trefoil_at(const Trefoil& knot, double t) {
  const double u = (t + knot.ahead) / knot.slower;
  const Vec3& s = knot.scale;
  const double f = knot.phase;
  const Vec3 way{std::sin(u + f) + 2.0 * std::sin(2.0 * u + f), std::cos(u + f) - 2.0 * std::cos(2.0 * u + f),
                 -std::sin(3.0 * u + f)};
  const Vec3 rate{std::cos(u + f) + 4.0 * std::cos(2.0 * u + f), -std::sin(u + f) + 4.0 * std::sin(2.0 * u + f),
                  -3.0 * std::cos(3.0 * u + f)};
  return {{knot.center.x + s.x * way.x, knot.center.y + s.y * way.y, knot.center.z + s.z * way.z},
          {s.x * rate.x / knot.slower, s.y * rate.y / knot.slower, s.z * rate.z / knot.slower}};
}

double trefoil_acceleration(const Trefoil& knot, double u) {
  const Vec3& s = knot.scale;
  const double f = knot.phase;
  const Vec3 second{-std::sin(u + f) - 8.0 * std::sin(2.0 * u + f), -std::cos(u + f) + 8.0 * std::cos(2.0 * u + f),
                    9.0 * std::sin(3.0 * u + f)};
  return length({s.x * second.x, s.y * second.y, s.z * second.z}) / (knot.slower * knot.slower);
}

/// The largest values at samples, and what a curve can gain between two of them at the rate of the next derivative.
ThingBounds trefoil_bounds(const Trefoil& knot) {
  constexpr int kSamples = 1024;
  const double step = 2.0 * std::acos(-1.0) / kSamples;
  ThingBounds found;
  for (int k = 0; k < kSamples; ++k) {
    found.speed = std::max(found.speed, length(trefoil_at(knot, step * k * knot.slower).velocity));
    found.acceleration = std::max(found.acceleration, trefoil_acceleration(knot, step * k));
  }
  const Vec3& s = knot.scale;
  const double most_acceleration = length({9.0 * s.x, 9.0 * s.y, 9.0 * s.z}) / knot.slower;
  const double most_jerk = length({17.0 * s.x, 17.0 * s.y, 27.0 * s.z}) / (knot.slower * knot.slower);
  return {found.speed + 0.5 * step * most_acceleration, found.acceleration + 0.5 * step * most_jerk};
}

/// One velocity for a while; the changes to the next one are centred at its ends.
struct Leg {
  Vec3 velocity;
  double time;
};

double change_time(const Vec3& from, const Vec3& to, double acceleration) {
  return length(along(to, -1.0, from)) / acceleration;
}

std::vector<WalkPoint> points_of(const Walk& walk) {
  std::vector<WalkPoint> points = walk.points;
  if (walk.is_loop && !points.empty()) points.push_back({points.front().place, 0.0});
  return points;
}

/// Standing takes the halves of the changes before and after it, too.
std::vector<Leg> legs_of(const Walk& walk) {
  const std::vector<WalkPoint> points = points_of(walk);
  const double half_change = 0.5 * walk.speed / walk.acceleration;
  std::vector<Leg> legs;
  for (std::size_t k = 0; k < points.size(); ++k) {
    const bool is_end = k == 0 || k + 1 == points.size();
    if (is_end || points[k].wait > 0.0) legs.push_back({kAtRest, points[k].wait + (is_end ? 1.0 : 2.0) * half_change});
    if (k + 1 == points.size()) break;
    const Vec3 way = along(points[k + 1].place, -1.0, points[k].place);
    const double far = length(way);
    legs.push_back({along(kAtRest, walk.speed / far, way), far / walk.speed});
  }
  return legs;
}

/// As long as the steady part of a leg is.
double steady_time(const std::vector<Leg>& legs, std::size_t k, double acceleration) {
  double time = legs[k].time;
  if (k > 0) time -= 0.5 * change_time(legs[k - 1].velocity, legs[k].velocity, acceleration);
  if (k + 1 < legs.size()) time -= 0.5 * change_time(legs[k].velocity, legs[k + 1].velocity, acceleration);
  return time;
}

double limited(double value, double most) {
  return std::min(value, most);
}

}  // namespace

ThingState SteadyPart::at(double t) const {
  const double s = t - begin;
  return {along(along(from.position, s, from.velocity), 0.5 * s * s, acceleration),
          along(from.velocity, s, acceleration)};
}

std::string walk_fault(const Walk& walk) {
  if (walk.points.empty()) return "a walk needs a point";
  const std::vector<WalkPoint> points = points_of(walk);
  for (std::size_t k = 1; k < points.size(); ++k) {
    if (!(length(along(points[k].place, -1.0, points[k - 1].place)) > 0.0)) {
      return "two points of a walk in a row are the same: give the first one a longer wait";
    }
  }
  const std::vector<Leg> legs = legs_of(walk);
  for (std::size_t k = 0; k < legs.size(); ++k) {
    if (steady_time(legs, k, walk.acceleration) < -1e-12) {
      return "a part of a walk is too short to change its velocity at both ends: make it longer, or the walk slower";
    }
  }
  return "";
}

std::vector<SteadyPart> parts_of(const Walk& walk) {
  const std::vector<Leg> legs = legs_of(walk);
  std::vector<SteadyPart> parts;
  double t = 0.0;
  ThingState state{walk.points.front().place, kAtRest};
  const auto go_on = [&](double time, const Vec3& acceleration) {
    parts.push_back({t, state, acceleration});
    state = parts.back().at(t + time);
    t += time;
  };
  for (std::size_t k = 0; k < legs.size(); ++k) {
    state.velocity = legs[k].velocity;
    go_on(std::max(0.0, steady_time(legs, k, walk.acceleration)), kAtRest);
    if (k + 1 == legs.size()) break;
    const double change = change_time(legs[k].velocity, legs[k + 1].velocity, walk.acceleration);
    const Vec3 difference = along(legs[k + 1].velocity, -1.0, legs[k].velocity);
    go_on(change, change > 0.0 ? along(kAtRest, 1.0 / change, difference) : kAtRest);
  }
  parts.push_back({t, {points_of(walk).back().place, kAtRest}, kAtRest});
  return parts;
}

ThingMotion::ThingMotion(const Thing& thing) : motion_(thing.motion) {
  if (const auto* const knot = std::get_if<Trefoil>(&motion_)) bounds_ = trefoil_bounds(*knot);
  if (const auto* const walk = std::get_if<Walk>(&motion_)) {
    parts_ = parts_of(*walk);
    if (walk->is_loop) period_ = parts_.back().begin;
    bounds_ = {walk->speed, walk->acceleration};
  }
  if (const auto* const hunt = std::get_if<Hunt>(&motion_)) {
    chase_.from.position = hunt->start;
    bounds_ = {hunt->speed, hunt->acceleration};
  }
}

ThingState ThingMotion::at(double t) const {
  if (const auto* const knot = std::get_if<Trefoil>(&motion_)) return trefoil_at(*knot, t);
  const auto* const walk = std::get_if<Walk>(&motion_);
  if (walk == nullptr) return chase_.at(t);
  double since = t + walk->ahead;
  if (period_ > 0.0) since = std::fmod(since, period_);
  const auto later = std::upper_bound(parts_.begin() + 1, parts_.end(), since,
                                      [](double time, const SteadyPart& part) { return time < part.begin; });
  return std::prev(later)->at(since);
}

std::vector<ThingMotion> motions_of(const std::vector<Thing>& things) {
  return {things.begin(), things.end()};
}

void ThingMotion::hunt(double t, double step, const Vec3& prey) {
  const auto* const hunt = std::get_if<Hunt>(&motion_);
  if (hunt == nullptr) return;
  chase_.from = chase_.at(t);
  chase_.begin = t;
  chase_.acceleration = kAtRest;
  const Vec3 way = along(prey, -1.0, chase_.from.position);
  const double far = length(way);
  if (far > hunt->sight || !(far > 0.0)) return;
  const double push = step * hunt->acceleration;
  Vec3 next = along(chase_.from.velocity, push / far, way);
  next = along(kAtRest, limited(1.0, hunt->speed / length(next)), next);
  const Vec3 change = along(next, -1.0, chase_.from.velocity);
  // Back to its top speed, it may have to turn harder than it can: then it does what it can.
  chase_.acceleration = along(kAtRest, limited(1.0, push / std::max(length(change), 1e-12)) / step, change);
}

}  // namespace tern_host
