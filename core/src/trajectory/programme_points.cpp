// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "trajectory/programme_points.hpp"

#include "base/math.hpp"

namespace tern {
namespace {

/// True if the point depends on an unknown of that end.
bool depends_on(const Piece& piece, int end, const EndWeights& weights) {
  if (!weights.touches[end] || !piece.free[end]) return false;
  if (!piece.held) return true;
  for (int e = end * kJointOrder; e < (end + 1) * kJointOrder; ++e) {
    if (!piece.given[e] && absolute(weights.of[e]) > 0.0) return true;
  }
  return false;
}

void add_given(const Piece& piece, int end, const EndWeights& weights, double multiplier, QpPoint& point) {
  for (int e = end * kJointOrder; e < (end + 1) * kJointOrder; ++e) {
    point.offset = point.offset + (multiplier * weights.of[e]) * piece.fixed[e];
  }
}

/// Adds the contribution of one end to the point.
void add_end(const Piece& piece, int end, const EndWeights& weights, double multiplier, QpPoint& point) {
  if (!piece.free[end] || piece.held) add_given(piece, end, weights, multiplier, point);
  if (!depends_on(piece, end, weights)) return;
  if (point.terms == 0) point.first = static_cast<std::int16_t>(unknown_of(piece, end * kJointOrder));
  double* const coefficient = point.coefficient + point.terms;
  for (int j = 0; j < kJointOrder; ++j) {
    const int e = end * kJointOrder + j;
    coefficient[j] = (multiplier * weights.of[e]) * piece.factor[e];
  }
  point.terms = static_cast<std::int16_t>(point.terms + kJointOrder);
}

}  // namespace

bool add_point(const Piece& piece, const EndWeights& weights, double multiplier, const PointOrigin& origin,
               ProgrammeScale& scale, QpProblem& problem) noexcept {
  QpPoint& point = problem.points[problem.point_count];
  point.offset = kZero;
  point.first = point.terms = 0;
  for (int end = 0; end < 2; ++end) {
    if (weights.touches[end]) add_end(piece, end, weights, multiplier, point);
  }
  if (point.terms == 0) return false;
  for (int k = point.terms; k < kQpPointTerms; ++k) point.coefficient[k] = 0.0;
  scale.origin[problem.point_count] = origin;
  ++problem.point_count;
  return true;
}

void add_group(int point_begin, int plane_begin, int plane_end, QpProblem& problem) noexcept {
  if (point_begin == problem.point_count) return;
  problem.groups[problem.group_count] = QpGroup{point_begin, problem.point_count, plane_begin, plane_end};
  ++problem.group_count;
}

void drift_of(const Vec3* points, Vec3* drift) noexcept {
  for (int k = 0; k < kJointOrder; ++k) {
    drift[k] = k == 0 ? kZero : k * (points[k] - points[k - 1]);
    drift[kDegree - k] = k == 0 ? kZero : k * (points[kDegree - k] - points[kDegree - k + 1]);
  }
}

}  // namespace tern
