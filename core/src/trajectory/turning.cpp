// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "trajectory/turning.hpp"

#include "base/math.hpp"
#include "curve/bezier.hpp"
#include "curve/body_rate.hpp"

namespace tern {
namespace {

/// The least vertical thrust at first, of the hover's.
constexpr double kFirstThrust = 0.6;
/// Of what the last solution allows: more thrust and less jerk, because the next one's are not as well known.
constexpr double kThrustShare = 1.1;
constexpr double kJerkShare = 0.97;
/// What is learned from one solution changes a point's jerk by no more than this factor.
constexpr double kMostChange = 2.0;
/// Both bounds of a segment rise, or fall, by no more than this part of them for what they cost.
constexpr double kStep = 0.1;
/// Of the rate's limit: a lower rate counts as this.
constexpr double kLeastShare = 0.05;
/// A jerk along the thrust turns nothing. It counts as at least this part across it.
constexpr double kLeastAcross = 0.125;
constexpr double kThrustAccuracy = 1e-2;

/// The gauge of the cylinder of which the rows of a point are a part.
constexpr Bounds kCylinder{{-kUnlimited, -kUnlimited, -1.0}, {kUnlimited, kUnlimited, 1.0}, 1.0};

/// Lets the rows of half a segment have a boundary state.
void allow(const JointState& state, const MotionLimits& limits, double* jerk, double& least_thrust) {
  const double norm = length(state.d[2] + Vec3{0.0, 0.0, kGravity});
  const double least = larger(limits.rate * norm, gauge(kCylinder, state.d[3]));
  for (int r = 0; r <= kJerkPoints / 2; ++r) jerk[r] = larger(jerk[r], least);
  least_thrust = smaller(least_thrust, state.d[2].z + kGravity);
}

void allow_ends(const Chain& chain, const MotionLimits& limits, Turning& turning) {
  const int last = chain.count - 1;
  allow(chain.start, limits, turning.jerk[0], turning.thrust[0]);
  allow(chain.goal, limits, turning.jerk[last] + kJerkPoints / 2, turning.thrust[last]);
}

/// What the bounds of each segment cost: the solution's multipliers times what a relative change of them changes.
struct Worth {
  double jerk[kMaxSegments];
  double thrust[kMaxSegments];
};

void weigh(const Candidate& candidate, const QpProblem& problem, const QpSolution& solution,
           const ProgrammeScale& scale, const Turning& turning, Worth& worth) {
  for (int i = 0; i < candidate.chain.count; ++i) worth.jerk[i] = worth.thrust[i] = 0.0;
  for (int r = 0; r < solution.active_count; ++r) {
    const QpConstraint& active = solution.active[r];
    const PointOrigin& origin = scale.origin[active.point];
    const int i = origin.segment;
    if (origin.order == 3) worth.jerk[i] += solution.multiplier[r] * problem.planes[active.plane].offset;
    if (origin.order == 2 && active.plane >= scale.floors) {
      worth.thrust[i] += solution.multiplier[r] * turning.thrust[i] / scale.unit[2];
    }
  }
}

/// The largest jerk of this direction, by the cylinder's gauge, that turns this thrust no faster than the limit.
double allowed_jerk(const Vec3& thrust, const Vec3& jerk, double rate) {
  const double norm = length(thrust);
  const double size = length(jerk);
  if (!(size > 0.0)) return rate * norm;
  const double across = larger(kLeastAcross * size * norm, length(cross(jerk, thrust)));
  return rate * norm * norm * gauge(kCylinder, jerk) / across;
}

/// The least vertical thrust over a curve of accelerations.
double least_thrust(const Curve& acceleration) {
  constexpr Bounds kDown{{-kUnlimited, -kUnlimited, -1.0}, {kUnlimited, kUnlimited, kUnlimited}, 0.0};
  return kGravity - peak_bound(acceleration, kDown, 0.0, kThrustAccuracy);
}

/// Learns the bounds of one segment, and multiplies both by `change`.
void learn(const Segment& segment, double change, const MotionLimits& limits, double* jerks, double& thrust) {
  const Curve acceleration = hodograph(hodograph(curve_of(segment), segment.duration), segment.duration);
  const Curve jerk = hodograph(acceleration, segment.duration);
  for (int r = 0; r < kJerkPoints; ++r) {
    const double u = static_cast<double>(r) / (kJerkPoints - 1);
    const Vec3 force = value(acceleration, u) + Vec3{0.0, 0.0, kGravity};
    const double allowed = kJerkShare * change * allowed_jerk(force, value(jerk, u), limits.rate);
    jerks[r] = clamp(allowed, jerks[r] / kMostChange, jerks[r] * kMostChange);
  }
  const double share = square_root(peak_rate(segment, kLeastShare * limits.rate, kRateAccuracy) / limits.rate);
  thrust = larger(kGravity + limits.acceleration.lower.z, kThrustShare * share * change * least_thrust(acceleration));
}

}  // namespace

void first_turning(const Chain& chain, const MotionLimits& limits, Turning& turning) noexcept {
  for (int i = 0; i < chain.count; ++i) {
    for (double& jerk : turning.jerk[i]) jerk = limits.rate * kGravity;
    turning.thrust[i] = larger(kFirstThrust * kGravity, kGravity + limits.acceleration.lower.z);
  }
  allow_ends(chain, limits, turning);
}

void learn_turning(const Candidate& candidate, double stretch, const QpProblem& problem, const QpSolution& solution,
                   const ProgrammeScale& scale, const MotionLimits& limits, Turning& turning) noexcept {
  Worth worth;
  weigh(candidate, problem, solution, scale, turning, worth);
  for (int i = 0; i < candidate.chain.count; ++i) {
    Segment segment = segment_of(candidate, i);
    segment.duration *= stretch;
    const double both = worth.jerk[i] + worth.thrust[i];
    const double balance = both > 0.0 ? (worth.jerk[i] - worth.thrust[i]) / both : 0.0;
    learn(segment, 1.0 + kStep * balance, limits, turning.jerk[i], turning.thrust[i]);
  }
  allow_ends(candidate.chain, limits, turning);
}

}  // namespace tern
