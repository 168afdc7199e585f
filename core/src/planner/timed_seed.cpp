// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "planner/timed_seed.hpp"

#include "base/capacity.hpp"
#include "base/math.hpp"
#include "curve/hermite.hpp"
#include "curve/rest.hpp"
#include "grid/lattice.hpp"
#include "planner/validate.hpp"
#include "times/trapezoid.hpp"

namespace tern {
namespace {

struct FloodTry {
  double share;  ///< of the speed
  double more;   ///< to keep off things, in cells
  double size;   ///< of a cell, in robot's diameters
};
constexpr FloodTry kTries[kTimedSeeds] = {{1.0, 0.4, 1.0}, {0.95, 0.4, 0.67}, {0.95, 0.4, 1.0},   {0.92, 0.15, 1.0},
                                          {0.7, 0.4, 1.0}, {0.55, 0.4, 1.0},  {0.55, 0.15, 0.67}, {0.4, -0.1, 0.67}};

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

/// The via that the seed's leg comes from, or leads to; null: the start, or the goal.
const Via* via_from(const Problem& problem, const TimedSeed& seed) {
  return seed.leg == 0 ? nullptr : problem.vias + seed.leg - 1;
}
const Via* via_to(const Problem& problem, const TimedSeed& seed) {
  return seed.leg == problem.via_count ? nullptr : problem.vias + seed.leg;
}

bool is_passed(const Via* via) {
  return via != nullptr && !via->stop;
}

/// Lengthens the legs beside an end or a rest that are shorter than it takes to gain speed, or to lose it. The flood's
/// cells are too wide to tell; with durations in which its first leg cannot be flown, no programme has a solution.
void allow_for_gaining(const Problem& problem, const Ends& ends, TimedSeed& seed, Work& work) {
  TimedWay& way = seed.way;
  work.spend(2 * kGainOperations * (way.count - seed.first));
  const bool comes_from_via = seed.leg > 0;
  Run run{comes_from_via ? 0.0 : length(ends.start.velocity), 0.0, 0.0};
  for (int i = seed.first; i < way.count && !is_passed(via_from(problem, seed)); ++i)
    allow_for_gaining(way.points[i + 1] - way.points[i], problem.limits, run, way.duration[i]);
  const MotionLimits braking = backwards(problem.limits);
  const bool leads_to_via = seed.leg < problem.via_count;
  run = {leads_to_via ? 0.0 : length(ends.goal.velocity), 0.0, 0.0};
  for (int i = way.count - 1; i >= seed.first && !is_passed(via_to(problem, seed)); --i)
    allow_for_gaining(way.points[i] - way.points[i + 1], braking, run, way.duration[i]);
}

/// Begins the flood of the seed's leg. False if it lacks room.
bool leg_begin(const Problem& problem, const Ends& ends, TimedFlood& flood, TimedSeed& seed) {
  const FloodTry& of = kTries[seed.number];
  const Grid& grid = voxels_of(problem);
  const Via* const from = via_from(problem, seed);
  const Via* const to = via_to(problem, seed);
  FloodQuery query{};
  query.things = things_of(problem, grid.spec().origin);
  query.from = from == nullptr ? ends.start_in_grid : to_local(grid, from->position);
  query.to = to == nullptr ? ends.goal_in_grid : to_local(grid, to->position);
  query.velocity = from == nullptr ? ends.start.velocity : kZero;
  query.begins_in_flight = is_passed(from);
  query.ends_in_flight = is_passed(to);
  query.fastest = symmetric(problem.limits.velocity);
  query.strongest = symmetric(problem.limits.acceleration);
  query.sharpest = symmetric(problem.limits.jerk);
  query.begin = seed.begin;
  query.rest = to != nullptr ? to->dwell : at_rest(problem.asked.goal) ? problem.asked.rest_clear : 0.0;
  query.longest = seed.longest;
  query.share = of.share;
  query.more = of.more;
  query.edge = edge_of(problem, of.size, larger(query.fastest.x, query.fastest.y));
  seed.first = seed.way.count;
  seed.is_led = false;
  seed.lacking = timed_flood_begin(flood, grid, query);
  if (seed.lacking != Status::kRunning) return false;
  seed.lacking = Status::kOk;
  raise(seed.words, static_cast<std::int32_t>(words_of(flood)));
  return true;
}

/// Goes on to the next leg, once this one has its way. False if there is no room, or no time.
bool next_leg(const Problem& problem, const Ends& ends, TimedFlood& flood, TimedSeed& seed) {
  double lasts = problem.vias[seed.leg].dwell;
  for (int i = seed.first; i < seed.way.count; ++i) lasts += seed.way.duration[i];
  seed.waypoint[seed.leg] = seed.way.count;
  seed.begin += lasts;
  seed.longest -= lasts;
  ++seed.leg;
  return seed.longest > 0.0 && leg_begin(problem, ends, flood, seed);
}

}  // namespace

bool timed_seed_begin(const Problem& problem, const Ends& ends, const EndStop& start_stop, int number, double longest,
                      TimedFlood& flood, TimedSeed& seed) noexcept {
  seed.way.count = 0;
  seed.number = number;
  seed.leg = 0;
  seed.longest = longest / (kTries[number].share * kTries[number].share);
  seed.begin = 0.0;
  seed.words = 0;
  for (int i = 0; i < start_stop.count; ++i) seed.begin += start_stop.segments[i].duration;
  return leg_begin(problem, ends, flood, seed);
}

Progress timed_seed_advance(const Problem& problem, const Ends& ends, TimedFlood& flood, TimedSeed& seed,
                            Work& work) noexcept {
  const Grid& grid = voxels_of(problem);
  for (std::int32_t k = 0; k <= kMaxVias; ++k) {
    if (!seed.is_led) {
      const Progress progress = timed_flood_advance(flood, grid, work);
      if (progress != Progress::kDone) return progress;
      timed_way_begin(flood, 3 * kMaxSegments / (4 * (problem.via_count + 1)), seed.way);
      seed.is_led = true;
    }
    const Progress progress = timed_way_advance(flood, grid, seed.way, work);
    if (progress != Progress::kDone) return progress;
    allow_for_gaining(problem, ends, seed, work);
    if (seed.leg == problem.via_count) return Progress::kDone;
    if (!next_leg(problem, ends, flood, seed)) return Progress::kFailed;
  }
  return Progress::kFailed;
}

void take_way(const TimedSeed& seed, Path& path, ViaMarks& marks) noexcept {
  const TimedWay& way = seed.way;
  path.count = way.count + 1;
  path.length = 0.0;
  for (int i = 0; i <= way.count; ++i) path.points[i] = way.points[i];
  for (int i = 0; i < way.count; ++i) path.length += distance(way.points[i], way.points[i + 1]);
  for (std::int32_t v = 0; v < marks.count; ++v) marks.waypoint[v] = seed.waypoint[v];
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
