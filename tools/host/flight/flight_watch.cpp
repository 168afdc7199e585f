// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "host/flight/flight_watch.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

#include "host/flight/full_knowledge.hpp"
#include "host/number.hpp"

namespace tern_host {
namespace {

using tern::Sample;
using tern::Vec3;

constexpr int kMostTicks = 1000000;           // of a plan: the slowest take some ten thousand
constexpr int kPicks = 6;                     // instants that are compared where nothing was committed
constexpr double kLimitExcess = 1e-6;         // relative
constexpr double kDistanceError = 1e-6;       // metres
constexpr double kRounding = 1e-9;            // metres
constexpr double kSearchVoxels = 1.5;         // beyond the radius, in which the nearest solid voxel is looked for
constexpr std::int64_t kLeastStep = 5000000;  // nanoseconds between two points where the way is narrow

double length(const Vec3& v) {
  return std::sqrt(v.x * v.x + v.y * v.y + v.z * v.z);
}

Vec3 off(const Vec3& a, const Vec3& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}

/// a - b - h c - h^2 / 2 d.
double beyond(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d, double h) {
  const auto axis = [h](double a1, double b1, double c1, double d1) { return a1 - b1 - h * (c1 + 0.5 * h * d1); };
  return length({axis(a.x, b.x, c.x, d.x), axis(a.y, b.y, c.y, d.y), axis(a.z, b.z, c.z, d.z)});
}

bool same_bits(const Sample& a, const Sample& b) {
  return std::memcmp(&a, &b, sizeof a) == 0;
}

bool nearly_same(const Sample& a, const Sample& b) {
  return length(off(a.position, b.position)) <= kRounding && length(off(a.velocity, b.velocity)) <= 1e-7 &&
         length(off(a.acceleration, b.acceleration)) <= 1e-5 && length(off(a.jerk, b.jerk)) <= 1e-3;
}

bool is_finite(const Sample& s) {
  const double all = length(s.position) + length(s.velocity) + length(s.acceleration) + length(s.jerk);
  return std::isfinite(all);
}

bool at_rest(const Sample& s, const Vec3& end) {
  const double moves = length(s.velocity) + length(s.acceleration) + length(s.jerk);
  return !(moves > 0.0) && length(off(s.position, end)) <= kRounding;
}

/// Distances of a point from voxels, which are solid cubes.
class VoxelGaps {
 public:
  VoxelGaps(const Vec3& p, const tern::GridSpec& grid)
      : at_{p.x - grid.origin.x, p.y - grid.origin.y, p.z - grid.origin.z}, cell_(grid.cell) {}
  double to(const tern::Voxel& v) const { return length({gap(v.x, at_.x), gap(v.y, at_.y), gap(v.z, at_.z)}); }
  double to_faces(const tern::GridSpec& grid) const {
    return std::min(
        {at_.x, at_.y, at_.z, grid.dims.x * cell_ - at_.x, grid.dims.y * cell_ - at_.y, grid.dims.z * cell_ - at_.z});
  }
  /// The voxel that holds the point moved by `by` along every axis; it may be outside.
  tern::Voxel voxel_at(double by) const { return {index(at_.x + by), index(at_.y + by), index(at_.z + by)}; }

 private:
  int index(double x) const { return static_cast<int>(std::floor(x / cell_)); }
  double gap(int k, double x) const { return std::max({k * cell_ - x, x - (k + 1) * cell_, 0.0}); }
  Vec3 at_;
  double cell_;
};

}  // namespace

FlightWatch::FlightWatch(const FlightWorld& world, const tern::FlightSpec& spec, const tern::RollingMap& map,
                         const tern::Flight& flight)
    : world_(world),
      spec_(spec),
      map_(map),
      flight_(flight),
      radius_(radius_of(world.settings)),
      speed_(std::hypot(spec.limits.v_horizontal, spec.limits.v_max.z) * (1.0 + kLimitExcess)) {
  ahead_.push_back(at(0));
}

Sample FlightWatch::at(std::int64_t tick) const {
  return flight_.command(tick).sample;
}

void FlightWatch::fail(int invariant, const std::string& what, std::int64_t t) {
  if (!broken_.empty()) return;
  broken_ =
      "invariant " + std::to_string(invariant) + " at t = " + fixed(1e-9 * static_cast<double>(t), 3) + ": " + what;
}

void FlightWatch::look(std::int64_t t, const tern::FlightReport& report) {
  ++counts_.ticks;
  if (report.work > spec_.work_per_tick) fail(7, "a tick spent " + std::to_string(report.work) + " units", t);
  // A threat may take back what was committed but is not flown yet.
  const bool threat = report.mode == tern::FlightMode::kThreat;
  if (report.committed == committed_ && !threat) {
    check_unchanged(t);
  } else {
    take_commit(t, !threat);
  }
  committed_ = report.committed;
  if (ahead_.size() > 1) ahead_.pop_front();
}

/// Without a commit, the commands that are to come are the same bits as before; the window may move.
void FlightWatch::check_unchanged(std::int64_t t) {
  const std::size_t count = ahead_.size();
  for (int k = 0; k < kPicks; ++k) {
    const std::size_t pick = (count - 1) * static_cast<std::size_t>(k) / (kPicks - 1);
    if (!same_bits(at(t + static_cast<std::int64_t>(pick) * spec_.tick), ahead_[pick])) {
      fail(1, "commands changed without a commit", t);
    }
  }
  check_window(t);
}

void FlightWatch::take_commit(std::int64_t t, bool proven) {
  ++counts_.commits;
  const Vec3 end = flight_.rest_position();
  // Near rest is not enough: the vehicle may rest where a plan that hardly moves it is about to take over.
  const Sample rest = at(t + static_cast<std::int64_t>(kMostTicks) * spec_.tick);
  std::vector<Sample> fresh;
  do {
    fresh.push_back(at(t + static_cast<std::int64_t>(fresh.size()) * spec_.tick));
    if (!is_finite(fresh.back())) fail(1, "a command is not finite", t);
  } while (!same_bits(fresh.back(), rest) && fresh.size() < kMostTicks);
  const std::int64_t last = t + static_cast<std::int64_t>(fresh.size() - 1) * spec_.tick;
  if (!at_rest(fresh.back(), end) || !at_rest(at(last + 60 * 1000000000LL), end)) {
    fail(1, "the committed plan does not end at rest", t);
  }
  check_before_takeover(fresh, t);
  check_joints(fresh, t);
  check_motion(fresh, t);
  if (proven) {
    for (const Sample& sample : fresh) check_limits(sample, t);
    note_place();
  }
  // Whatever alarms it raised: the true world stands still.
  if (map_.safe().bound()) check_clear(t, proven ? t + old_ticks(fresh) * spec_.tick : last + 1, last);
  ahead_.assign(fresh.begin(), fresh.end());
  constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
  origin_ = {kNone, kNone, kNone};
  check_window(t);
}

/// What was committed for this tick and for the next one is still flown, but for rounding: where a plan is extended,
/// its last segment is cut in another place.
void FlightWatch::check_before_takeover(const std::vector<Sample>& fresh, std::int64_t t) {
  for (std::size_t k = 0; k < std::min<std::size_t>(2, fresh.size()); ++k) {
    if (!nearly_same(fresh[k], ahead_[std::min(k, ahead_.size() - 1)])) fail(4, "a commit took over too early", t);
  }
}

/// Plans take over at ticks: both sides of each must agree, position to jerk.
void FlightWatch::check_joints(const std::vector<Sample>& fresh, std::int64_t t) {
  constexpr std::size_t kTakeovers = 64;
  constexpr double kNanosecond = 1e-9;
  for (std::size_t k = 1; k < std::min(fresh.size(), kTakeovers); ++k) {
    const Sample& after = fresh[k];
    const Sample before = at(t + static_cast<std::int64_t>(k) * spec_.tick - 1);
    const bool agree =
        length(off(after.position, before.position)) <= kNanosecond * length(after.velocity) + kRounding &&
        length(off(after.velocity, before.velocity)) <= kNanosecond * length(after.acceleration) + 1e-8 &&
        length(off(after.acceleration, before.acceleration)) <= kNanosecond * length(after.jerk) + 1e-6 &&
        length(off(after.jerk, before.jerk)) <= kNanosecond * (length(after.snap) + length(before.snap)) + 1e-3;
    if (!agree) fail(3, "a joint jumps", t + static_cast<std::int64_t>(k) * spec_.tick);
  }
}

/// From tick to tick, the motion changes no more than its largest jerk allows.
void FlightWatch::check_motion(const std::vector<Sample>& fresh, std::int64_t t) {
  const double h = 1e-9 * static_cast<double>(spec_.tick);
  double jerk = 0.0;
  for (const Sample& s : fresh) jerk = std::max(jerk, length(s.jerk));
  const Vec3& most = spec_.limits.j_max;
  jerk = most.x > 0.0 ? length(most) * (1.0 + kLimitExcess) : 2.0 * jerk + 1.0;
  for (std::size_t k = 0; k + 1 < fresh.size(); ++k) {
    const Sample& a = fresh[k];
    const Sample& b = fresh[k + 1];
    const bool smooth =
        beyond(b.position, a.position, a.velocity, a.acceleration, h) <= jerk * h * h * h / 6.0 + kRounding &&
        beyond(b.velocity, a.velocity, a.acceleration, {}, h) <= jerk * h * h / 2.0 + kRounding &&
        length(off(b.acceleration, a.acceleration)) <= jerk * h + kRounding;
    if (!smooth) fail(1, "the committed plan is not smooth", t + static_cast<std::int64_t>(k) * spec_.tick);
  }
}

void FlightWatch::check_limits(const Sample& s, std::int64_t t) {
  const tern::Limits& limits = spec_.limits;
  const double wider = 1.0 + kLimitExcess;
  const double lowest = limits.a_min.z < 0.0 ? limits.a_min.z : -limits.a_max.z;
  if (std::hypot(s.velocity.x, s.velocity.y) > wider * limits.v_horizontal ||
      std::abs(s.velocity.z) > wider * limits.v_max.z) {
    fail(2, "a committed plan is faster than its limit", t);
  }
  if (std::hypot(s.acceleration.x, s.acceleration.y) > wider * limits.a_horizontal ||
      s.acceleration.z > wider * limits.a_max.z || s.acceleration.z < wider * lowest) {
    fail(2, "a committed plan accelerates beyond its limit", t);
  }
  const double jerk = std::max({std::abs(s.jerk.x), std::abs(s.jerk.y), std::abs(s.jerk.z)});
  if (limits.j_max.x > 0.0 && jerk > wider * limits.j_max.x) fail(2, "a committed plan jerks beyond its limit", t);
}

/// A vehicle that rests, or will at the takeover, with something within the radius may leave that place, as long as it
/// comes no nearer to it.
void FlightWatch::note_place() {
  if (ahead_.size() > lead_ticks() + 3 || !map_.safe().bound()) return;
  leaves_ = false;
  left_ = ahead_.back().position;
  leaves_ = solid_room(left_) < 0.0;
}

/// Ticks from the beginning of a plan to its takeover, at most: late plans get more time, up to eight times as much.
std::size_t FlightWatch::lead_ticks() const {
  return 8 * (spec_.plan_work / (spec_.work_per_tick / 2)) + 2;
}

/// Ticks for which a commit leaves everything as it was, up to the latest takeover. That part was proven at its own
/// commit, on the map of that time.
std::int64_t FlightWatch::old_ticks(const std::vector<Sample>& fresh) const {
  std::size_t k = 0;
  while (k < std::min({lead_ticks(), fresh.size(), ahead_.size()}) && nearly_same(fresh[k], ahead_[k])) ++k;
  return static_cast<std::int64_t>(k);
}

/// The whole way, not points of it alone: from a point, the vehicle cannot come nearer than the room there allows.
/// Where that is less than a few milliseconds' way, points lie that near to each other. Unproven space counts from
/// `fresh` on.
void FlightWatch::check_clear(std::int64_t from, std::int64_t fresh, std::int64_t to) {
  const double kept = world_.settings.body_radius + world_.settings.tracking_margin;
  for (std::int64_t t = from; t <= to;) {
    ++counts_.points;
    const Vec3 p = at(t).position;
    const double real = clearance(world_, p) - kept;
    const double solid = t < fresh ? real : solid_room(p);
    const std::string when = fixed(1e-9 * static_cast<double>(t - from), 3) + " s after its commit";
    if (real < -kDistanceError) fail(6, fixed(-real, 4) + " m too near to the true world, " + when, from);
    if (solid < -kDistanceError) fail(2, fixed(-solid, 4) + " m too near to unproven space, " + when, from);
    const double fenced = fence_room(p);
    if (fenced < -kDistanceError) fail(2, fixed(-fenced, 4) + " m into a fence, " + when, from);
    t += std::max(kLeastStep, static_cast<std::int64_t>(1e9 * std::min({solid, real, fenced}) / speed_));
  }
}

/// From where the fences allow the centre to be; keep-outs are left alone by the radius.
double FlightWatch::fence_room(const Vec3& p) const {
  double room = std::numeric_limits<double>::infinity();
  for (const FenceRecord& fence : world_.fences) {
    room = std::min(room, fence_gap(fence, p) - (fence.kind == tern::FenceKind::kKeepOut ? radius_ : 0.0));
  }
  return room;
}

void FlightWatch::check_window(std::int64_t t) {
  const tern::Grid& safe = map_.safe();
  if (!safe.bound()) return;
  const tern::GridSpec& spec = safe.spec();
  if (!(length(off(spec.origin, origin_)) > 0.0) && !std::isnan(origin_.x)) return;
  origin_ = spec.origin;
  const tern::Box& b = spec.boundary;
  const double r = radius_ - kDistanceError;
  for (const Sample& s : ahead_) {
    const Vec3& p = s.position;
    if (p.x - r < b.lower.x || p.y - r < b.lower.y || p.z - r < b.lower.z || p.x + r > b.upper.x ||
        p.y + r > b.upper.y || p.z + r > b.upper.z) {
      return fail(5, "the window cuts what is flown", t);
    }
  }
}

/// How much further than it must be a point is from all voxels that are not known to be free, and from the window's
/// faces; at most a little more than a voxel.
double FlightWatch::solid_room(const Vec3& p) const {
  const tern::Grid& safe = map_.safe();
  const tern::GridSpec& grid = safe.spec();
  const VoxelGaps here(p, grid);
  const VoxelGaps there(left_, grid);
  const double most = radius_ + kSearchVoxels * grid.cell;
  double room = std::min(most, here.to_faces(grid)) - radius_;
  const tern::Voxel low = here.voxel_at(-most);
  const tern::Voxel high = here.voxel_at(most);
  for (int z = low.z; z <= high.z; ++z) {
    for (int y = low.y; y <= high.y; ++y) {
      for (int x = low.x; x <= high.x; ++x) {
        const double distance = here.to({x, y, z});
        const double kept = leaves_ ? std::min(radius_, there.to({x, y, z})) : radius_;
        if (distance - kept < room && safe.obstacle({x, y, z})) room = distance - kept;
      }
    }
  }
  return room;
}

}  // namespace tern_host
