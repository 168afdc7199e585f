// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// What the tests of proofs against tracks and fences for a while share.
#ifndef TERN_TESTS_SUPPORT_TIMED_PROOF_HPP
#define TERN_TESTS_SUPPORT_TIMED_PROOF_HPP

#include <cstdint>

#include "tern/track_proof.hpp"

namespace tern_test {

constexpr std::int64_t kSecond = 1000000000;
/// A stretch is halved 18 times over.
constexpr double kEarly = 1e-4;

/// From the origin along x, 2 m/s for 2 s.
inline tern::Trajectory along_x(const tern::Vec3& origin = {0.0, 0.0, 0.0}, std::int64_t begin = 0) {
  tern::Trajectory plan{};
  plan.begin = begin;
  plan.count = 1;
  plan.origin = origin;
  plan.segments[0].duration = 2.0;
  for (int k = 0; k < tern::kControlPoints; ++k) plan.segments[0].points[k] = {4.0 * k / 7.0, 0.0, 0.0};
  return plan;
}

/// Until when a trajectory is proven, and why no longer.
struct TimedAnswer {
  double until;
  tern::ProofReport report;
};

inline TimedAnswer prove_from(double from, const tern::Trajectory& plan, const tern::TrackGrounds& grounds) {
  TimedAnswer answer{};
  answer.until = tern::clear_until(plan, from, grounds, &answer.report);
  return answer;
}

}  // namespace tern_test

#endif
