// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "planner/timed_seed.hpp"

#include "base/capacity.hpp"
#include "base/math.hpp"
#include "curve/hermite.hpp"
#include "curve/rest.hpp"
#include "grid/lattice.hpp"
#include "times/trapezoid.hpp"

namespace tern {
namespace {

struct FloodTry {
  double share;  ///< of the speed
  double more;   ///< to keep off things, in cells
  double size;   ///< of a cell, in robot's diameters
};
constexpr FloodTry kTries[kTimedSeeds] = {{1.0, 0.4, 1.0},  {0.95, 0.4, 0.67},  {0.85, 0.4, 1.0}, {0.7, 0.4, 1.0},
                                          {0.55, 0.4, 1.0}, {0.55, 0.15, 0.67}, {0.4, -0.1, 0.67}};

/// s: no layer is shorter, whatever the robot's size.
constexpr double kLeastLayer = 0.1;
/// m: points of a way and of its corridor that are nearer to each other are the same.
constexpr double kSamePlace = 1e-6;

/// The speed along an axis, either way.
Vec3 symmetric(const Bounds& bounds) {
  Vec3 least{};
  for (int a = 0; a < 3; ++a) {
    axis(least, a) = smaller(axis(bounds.upper, a), -axis(bounds.lower, a));
    if (a < 2 && bounds.horizontal > 0.0) axis(least, a) = smaller(axis(least, a), bounds.horizontal);
  }
  return least;
}

std::int32_t edge_of(const Problem& problem, double size, double speed) {
  const GridSpec& spec = problem.grid->spec();
  const double wanted = larger(2.0 * size * spec.clearance(), kLeastLayer * speed);
  return floor_index(wanted / spec.cell + 0.5, 1, kMaxDimension);
}

/// Appends a straight segment to the seed. False if there is no room.
bool append(std::int32_t polyhedron, double duration, const Vec3& from, const Vec3& to, Trajectory& seed) {
  if (is_full(seed.count == kMaxSegments)) return false;
  Segment& segment = seed.segments[seed.count];
  segment.polyhedron = polyhedron;
  segment.duration = larger(kMinDuration, duration);
  for (int k = 0; k < kControlPoints; ++k) segment.points[k] = from + (k / 7.0) * (to - from);
  ++seed.count;
  return true;
}

/// The share of a leg at which a point lies on it; negative if it does not lie strictly within.
double share_on(const Vec3& point, const Vec3& from, const Vec3& to) {
  const Vec3 along = to - from;
  const double squared = dot(along, along);
  if (!(squared > kSamePlace * kSamePlace)) return -1.0;
  const double share = dot(point - from, along) / squared;
  if (!(share > 1e-9) || !(share < 1.0 - 1e-9)) return -1.0;
  return distance(from + share * along, point) < kSamePlace ? share : -1.0;
}

/// Accelerations that are tried, each half of the one before.
constexpr int kAccelerations = 6;
constexpr Operations kGainOperations = (kAccelerations + 8) * ops::kDot;

/// Seconds in which `far` metres can be covered along a direction, at `speed` m/s first, within the limits on
/// acceleration and jerk. To take up an acceleration delays the motion, so a smaller one may be sooner there.
double gaining_time(double far, double speed, const Vec3& delta, const MotionLimits& limits) {
  double acceleration = limits_along(delta, limits).acceleration;
  const double stiffness = ramp_gauge(limits, (1.0 / length(delta)) * delta);
  double least = 1e300;
  for (int i = 0; i < kAccelerations; ++i, acceleration *= 0.5) {
    const double motion = (square_root(speed * speed + 2.0 * acceleration * far) - speed) / acceleration;
    least = smaller(least, motion + 0.5 * acceleration * stiffness);
  }
  return least;
}

/// Seen from one end of the way: how far it has led since it last rested, and how long that took.
struct Run {
  double speed;  ///< at its beginning
  double length;
  double time;
};

/// Lengthens the duration of a leg so that its end is not reached before it can be.
void allow_for_gaining(const Vec3& delta, const MotionLimits& limits, Run& run, double& duration) {
  const double far = length(delta);
  if (!(far > kSamePlace)) {
    run = Run{};
    return;
  }
  run.length += far;
  duration = larger(duration, gaining_time(run.length, run.speed, delta, limits) - run.time);
  run.time += duration;
}

/// Lengthens the legs beside an end or a rest that are shorter than it takes to gain speed, or to lose it. The flood's
/// cells are too wide to tell; with durations in which its first leg cannot be flown, no programme has a solution.
void allow_for_gaining(const Problem& problem, const Ends& ends, TimedWay& way, Work& work) {
  work.spend(2 * kGainOperations * way.count);
  Run run{length(ends.start.velocity), 0.0, 0.0};
  for (int i = 0; i < way.count; ++i)
    allow_for_gaining(way.points[i + 1] - way.points[i], problem.limits, run, way.duration[i]);
  const MotionLimits braking = backwards(problem.limits);
  run = {length(ends.goal.velocity), 0.0, 0.0};
  for (int i = way.count - 1; i >= 0; --i)
    allow_for_gaining(way.points[i] - way.points[i + 1], braking, run, way.duration[i]);
}

}  // namespace

bool may_flood(const Problem& problem) noexcept {
  return problem.via_count == 0;
}

Status timed_seed_begin(const Problem& problem, const Ends& ends, const EndStop& start_stop, int seed, double longest,
                        TimedFlood& flood, TimedWay& way) noexcept {
  const FloodTry& of = kTries[seed];
  const Grid& grid = voxels_of(problem);
  FloodQuery query{};
  query.things = things_of(problem, grid.spec().origin);
  query.from = ends.start_in_grid;
  query.to = ends.goal_in_grid;
  query.velocity = ends.start.velocity;
  query.fastest = symmetric(problem.limits.velocity);
  query.strongest = symmetric(problem.limits.acceleration);
  query.sharpest = symmetric(problem.limits.jerk);
  for (int i = 0; i < start_stop.count; ++i) query.begin += start_stop.segments[i].duration;
  query.rest = at_rest(problem.asked.goal) ? problem.asked.rest_clear : 0.0;
  query.longest = longest / (of.share * of.share);
  query.share = of.share;
  query.more = of.more;
  query.edge = edge_of(problem, of.size, larger(query.fastest.x, query.fastest.y));
  way.count = -1;
  return timed_flood_begin(flood, grid, query);
}

Progress timed_seed_advance(const Problem& problem, const Ends& ends, TimedFlood& flood, TimedWay& way,
                            Work& work) noexcept {
  const Grid& grid = voxels_of(problem);
  if (way.count < 0) {
    const Progress progress = timed_flood_advance(flood, grid, work);
    if (progress != Progress::kDone) return progress;
    timed_way_begin(flood, way);
  }
  const Progress progress = timed_way_advance(flood, grid, way, work);
  if (progress == Progress::kDone) allow_for_gaining(problem, ends, way, work);
  return progress;
}

void take_way(const TimedWay& way, Path& path) noexcept {
  path.count = way.count + 1;
  path.length = 0.0;
  for (int i = 0; i <= way.count; ++i) path.points[i] = way.points[i];
  for (int i = 0; i < way.count; ++i) path.length += distance(way.points[i], way.points[i + 1]);
}

bool make_seed(const TimedWay& way, const Corridor& corridor, const Ends& ends, Trajectory& seed) noexcept {
  seed.count = 0;
  const int last = corridor.count - 1;
  int polyhedron = 0;
  for (int i = 0; i < way.count; ++i) {
    const Vec3& end = way.points[i + 1];
    const Vec3 to = i + 1 == way.count ? ends.goal.position : end - ends.origin_in_grid;
    Vec3 from = i == 0 ? ends.start.position : way.points[i] - ends.origin_in_grid;
    double done = 0.0;
    // A leg that was halved: its polyhedra end within it.
    for (; polyhedron < last; ++polyhedron) {
      const double share = share_on(corridor.polyhedra[polyhedron].to, way.points[i], end);
      if (share < 0.0) break;
      const Vec3 middle = corridor.polyhedra[polyhedron].to - ends.origin_in_grid;
      if (!append(polyhedron, (share - done) * way.duration[i], from, middle, seed)) return false;
      done = share;
      from = middle;
    }
    if (!append(polyhedron, (1.0 - done) * way.duration[i], from, to, seed)) return false;
    if (polyhedron < last && distance(corridor.polyhedra[polyhedron].to, end) < kSamePlace) ++polyhedron;
  }
  return seed.count > 0 && seed.segments[seed.count - 1].polyhedron == last;
}

}  // namespace tern
