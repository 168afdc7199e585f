// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Proofs against tracks, beside samples in long double by code of its own: no proof ends late, and none needlessly
// early.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "support/random.hpp"
#include "support/track_pairs.hpp"
#include "tern/track_proof.hpp"

namespace {

using namespace tern;
using tern_test::Random;
using tern_test::TrackPair;
using Real = long double;

struct RealPoint {
  Real c[3];
};

RealPoint bernstein_sum(const Vec3* points, Real u) {
  constexpr Real kBinomial[] = {1, 7, 21, 35, 35, 21, 7, 1};
  RealPoint sum{};
  for (int i = 0; i < kControlPoints; ++i) {
    const Real weight = kBinomial[i] * std::pow(u, Real(i)) * std::pow(1 - u, Real(7 - i));
    sum.c[0] += weight * points[i].x;
    sum.c[1] += weight * points[i].y;
    sum.c[2] += weight * points[i].z;
  }
  return sum;
}

/// On a chain of curves, `t` seconds after it begins; at its end from then on.
template <typename PieceAt>
RealPoint on_chain(int count, const PieceAt& piece_at, Real t) {
  Real begin = 0;
  for (int i = 0; i < count; ++i) {
    const auto& piece = piece_at(i);
    if (t < begin + piece.duration) return bernstein_sum(piece.points, std::max(Real(0), (t - begin) / piece.duration));
    begin += piece.duration;
  }
  return bernstein_sum(piece_at(count - 1).points, 1);
}

/// Distance of p, relative to the shape's centre, from the shape.
Real distance_from_shape(const Track& track, const Real* p) {
  if (track.shape == TrackShape::kBall) return std::sqrt(p[0] * p[0] + p[1] * p[1] + p[2] * p[2]) - track.radius;
  const Real z = std::max(Real(0), std::fabs(p[2]) - track.half.z);
  if (track.shape == TrackShape::kCylinder) {
    const Real across = std::max(Real(0), std::sqrt(p[0] * p[0] + p[1] * p[1]) - track.radius);
    return std::sqrt(across * across + z * z);
  }
  const Real x = std::max(Real(0), std::fabs(p[0]) - track.half.x);
  const Real y = std::max(Real(0), std::fabs(p[1]) - track.half.y);
  return std::sqrt(x * x + y * y + z * z);
}

/// How much more than what is needed the plan is away from the thing, `t` seconds after the plan's beginning.
Real gap_at(const TrackPair& pair, Real t) {
  const Track& track = pair.track;
  const RealPoint p = on_chain(
      pair.plan.count, [&](int i) -> const Segment& { return pair.plan.segments[i]; }, t);
  const Real since = t + static_cast<Real>(pair.plan.begin - track.measured) * 1e-9L;
  if (since < 0) return 1e9L;
  Real known = since;
  Real beyond = 0;
  if (track.end != TrackEnd::kGoesOn) {
    const Real valid = static_cast<Real>(track.until - track.measured) * 1e-9L;
    known = std::min(since, valid);
    beyond = since - known;
    if (beyond > 0 && track.end == TrackEnd::kGone) return 1e9L;
  }
  const Vec3& origin = pair.plan.origin;
  const Real base[] = {Real(track.position.x) - origin.x, Real(track.position.y) - origin.y,
                       Real(track.position.z) - origin.z};
  RealPoint o{{known * track.velocity.x, known * track.velocity.y, known * track.velocity.z}};
  RealPoint first{};
  if (track.piece_count > 0) {
    const auto piece_at = [&](int i) -> const TrackPiece& { return track.pieces[i]; };
    o = on_chain(track.piece_count, piece_at, known);
    first = on_chain(track.piece_count, piece_at, 0);
  }
  Real d[3];
  Real d0[3];
  for (int a = 0; a < 3; ++a) {
    d[a] = p.c[a] - base[a] - o.c[a];
    d0[a] = p.c[a] - base[a] - first.c[a];
  }
  const Real growth = track.end == TrackEnd::kReach ? track.reach * beyond : 0;
  const Real error = track.error + known * (track.error_speed + track.error_growth * known / 2) + growth;
  Real gap = distance_from_shape(track, d) - error;
  if (track.reach > 0) gap = std::max(gap, distance_from_shape(track, d0) - track.error - track.reach * since);
  return gap - pair.grounds.radius;
}

struct Tally {
  int proven = 0;
  int refused = 0;
};

void judge(const TrackPair& pair, int samples, Tally& tally) {
  ProofReport report;
  const double until = clear_until(pair.plan, 0.0, pair.grounds, &report);
  const Real all = Real(duration(pair.plan)) + pair.grounds.rest;
  // A sum in long double and one in doubles differ by rounding, and the pair moves meanwhile.
  constexpr Real kRounding = 2e-10L;
  for (int k = 0; k <= samples && until > 0.0; ++k) {
    const Real t = until * (1 - 1e-13L) * Real(k) / samples;
    ASSERT_GE(gap_at(pair, t), -kTrackTolerance - kRounding) << "at " << double(t) << " of " << until;
  }
  if (report.finding == Finding::kNone) {
    ++tally.proven;
    EXPECT_NEAR(until, double(all), 1e-12);
    return;
  }
  ++tally.refused;
  ASSERT_EQ(report.finding, Finding::kTrack);
  Real least = 1e9L;
  for (int k = 0; k <= 64; ++k) least = std::min(least, gap_at(pair, until + all * Real(k) / 64 / 100000));
  EXPECT_LT(least, 1e-4L) << "refused at " << until << " of " << double(all);
}

TEST(TrackSampled, ProofsBesideSamples) {
  Random random(2026);
  Tally tally;
  for (int i = 0; i < tern_test::scaled(3000); ++i) {
    TrackPair pair = tern_test::random_pair(random);
    tern_test::hold_pieces(pair);
    SCOPED_TRACE(i);
    judge(pair, 300, tally);
    if (HasFatalFailure()) return;
  }
  EXPECT_GT(tally.proven, tally.refused / 20);
  EXPECT_GT(tally.refused, tally.proven / 20);
}

}  // namespace
