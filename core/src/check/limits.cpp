// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "base/math.hpp"
#include "check/check_stage.hpp"
#include "check/hodograph.hpp"

namespace tern {
namespace {

using checked::Curve;
using checked::derivative;
using checked::position_of;

/// How often a part of a curve is halved before its proof is given up. Each halving makes the hull's excess over the
/// curve four times smaller.
constexpr int kMaxDepth = 16;
/// The most pieces of one derivative of one segment. A curve that needs more is refused.
constexpr int kMaxPieces = 4096;
/// Stands for the limit of an axis whose jerk is not limited, m/s^3.
constexpr double kAnyJerk = 1e300;

/// de Casteljau at 1/2: `curve` becomes its left half, the right half is returned.
Curve split(Curve& curve) {
  Curve right;
  right.degree = curve.degree;
  for (int level = 0; level < curve.degree; ++level) {
    right.c[curve.degree - level] = curve.c[curve.degree];
    for (int i = curve.degree; i > level; --i) curve.c[i] = 0.5 * (curve.c[i - 1] + curve.c[i]);
  }
  right.c[0] = curve.c[curve.degree];
  return right;
}

/// The values that the request allows a velocity, an acceleration or a jerk, with the check's tolerance.
struct Allowed {
  Vec3 most;
  Vec3 least;
  double horizontal_squared;  ///< 0: no limit on the horizontal norm
};

/// `rounding` is that of the values that are compared with the limits.
Allowed allowed(const Vec3& most, const Vec3& least, double horizontal, double rounding) {
  constexpr double kWider = 1.0 + kCheckRelative;
  Allowed result{kWider * most, kWider * least, 0.0};
  for (int a = 0; a < 3; ++a) {
    if (!(axis(least, a) < 0.0)) axis(result.least, a) = -axis(result.most, a);
    axis(result.most, a) += rounding;
    axis(result.least, a) -= rounding;
  }
  if (horizontal > 0.0) {
    const double norm = kWider * horizontal + 2.0 * rounding;
    result.horizontal_squared = norm * norm;
  }
  return result;
}

bool allows(const Allowed& limit, const Vec3& value) {
  for (int a = 0; a < 3; ++a) {
    if (axis(value, a) > axis(limit.most, a) || axis(value, a) < axis(limit.least, a)) return false;
  }
  return !(limit.horizontal_squared > 0.0) || value.x * value.x + value.y * value.y <= limit.horizontal_squared;
}

constexpr int kHorizontal = 3;  // CheckReport::axis

/// Notes the first axis on which the value is not allowed, and by how much. Notes nothing if the value is allowed: then
/// the proof took too many pieces.
void describe(const Allowed& limit, const Vec3& value, CheckReport& found) {
  if (allows(limit, value)) return;
  for (int a = 0; a < 3; ++a) {
    found.axis = a;
    found.excess = larger(axis(value, a) - axis(limit.most, a), axis(limit.least, a) - axis(value, a));
    if (found.excess > 0.0) return;
  }
  found.axis = kHorizontal;
  const double norm = square_root(value.x * value.x + value.y * value.y);
  found.excess = larger(0.0, norm - square_root(limit.horizontal_squared));
}

/// True if all control points are allowed. The allowed values form a convex set, so the whole curve is then allowed.
bool allows_hull(const Allowed& limit, const Curve& curve) {
  for (int i = 0; i <= curve.degree; ++i) {
    if (!allows(limit, curve.c[i])) return false;
  }
  return true;
}

/// A control point of the piece that is not allowed, preferably one of its two ends, which are points of the curve.
Vec3 offending(const Curve& piece, const Allowed& limit) {
  const bool begins_well = allows(limit, piece.c[0]);
  if (begins_well && !allows(limit, piece.c[piece.degree])) return piece.c[piece.degree];
  for (int i = 0; i < piece.degree; ++i) {
    if (!allows(limit, piece.c[i])) return piece.c[i];
  }
  return piece.c[0];
}

/// True if the curve is allowed for all u in [0, 1], which hulls of smaller and smaller pieces prove. If false, `curve`
/// becomes the piece for which there is no proof.
bool allowed_throughout(Curve& curve, const Allowed& limit) {
  Curve stack[kMaxDepth];
  int depth_of[kMaxDepth];
  int height = 0;
  int depth = 0;
  for (int piece = 0; piece < kMaxPieces; ++piece) {
    if (allows_hull(limit, curve)) {
      if (height == 0) return true;
      --height;
      curve = stack[height];
      depth = depth_of[height];
      continue;
    }
    // The first and the last control point are values of the curve: if one is not allowed, no halving helps.
    if (!allows(limit, curve.c[0]) || !allows(limit, curve.c[curve.degree]) || depth == kMaxDepth) return false;
    ++depth;
    stack[height] = split(curve);
    depth_of[height] = depth;
    ++height;
  }
  return false;
}

bool keeps(Curve curve, const Allowed& limit, int derivative, Finding finding, CheckReport& found) {
  if (allowed_throughout(curve, limit)) return true;
  found.derivative = derivative;
  describe(limit, offending(curve, limit), found);
  return refuse(finding, found);
}

/// True if the jerk keeps its limits, or has none. An axis without a limit may have any jerk.
bool jerk_holds(const Segment& segment, const Curve& jerk, const Limits& limits, CheckReport& found) {
  Vec3 most = limits.j_max;
  bool limited = limits.j_horizontal > 0.0;
  for (int a = 0; a < 3; ++a) {
    limited = limited || axis(most, a) > 0.0;
    if (!(axis(most, a) > 0.0)) axis(most, a) = kAnyJerk;
  }
  const Allowed jolt = allowed(most, Vec3{0.0, 0.0, 0.0}, limits.j_horizontal, hodograph_rounding(segment, 3));
  return !limited || keeps(jerk, jolt, 3, Finding::kJerk, found);
}

}  // namespace

bool limits_hold(const Segment& segment, const Limits& limits, CheckReport& found) noexcept {
  const Curve velocity = derivative(position_of(segment), segment.duration);
  const Allowed speed = allowed(limits.v_max, limits.v_min, limits.v_horizontal, hodograph_rounding(segment, 1));
  if (!keeps(velocity, speed, 1, Finding::kVelocity, found)) return false;
  const Curve acceleration = derivative(velocity, segment.duration);
  const Allowed pull = allowed(limits.a_max, limits.a_min, limits.a_horizontal, hodograph_rounding(segment, 2));
  return keeps(acceleration, pull, 2, Finding::kAcceleration, found) &&
         jerk_holds(segment, derivative(acceleration, segment.duration), limits, found);
}

}  // namespace tern
