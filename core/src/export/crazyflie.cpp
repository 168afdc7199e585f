// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "base/math.hpp"
#include "export/yaw_piece.hpp"
#include "tern/export.hpp"

namespace tern {
namespace {

static_assert(sizeof(Poly4d) == 132, "the firmware stores a piece in 132 bytes");

/// C(7, k).
constexpr double kBinomial[kControlPoints] = {1.0, 7.0, 21.0, 35.0, 35.0, 21.0, 7.0, 1.0};

/// Coefficients by rising powers of t: the k-th is C(7, k) / T^k times the k-th difference of the control points.
void powers(double (&points)[kControlPoints], double duration, float (&out)[8]) {
  double scale = 1.0;
  for (int k = 0; k <= kDegree; ++k) {
    out[k] = static_cast<float>(kBinomial[k] * points[0] / scale);
    for (int i = 0; i < kDegree - k; ++i) points[i] = points[i + 1] - points[i];
    scale *= duration;
  }
}

}  // namespace

Status poly4d(const Trajectory& trajectory, const YawPlan* yaw, int32_t segment, Poly4d& piece) noexcept {
  if (segment < 0 || segment >= trajectory.count || trajectory.count > kMaxSegments) return Status::kInvalidArgument;
  const Segment& from = trajectory.segments[segment];
  double begin = 0.0;
  for (int32_t i = 0; i < segment; ++i) begin += trajectory.segments[i].duration;
  double points[kControlPoints];
  for (int a = 0; a < 3; ++a) {
    for (int i = 0; i < kControlPoints; ++i) points[i] = axis(from.points[i], a) + axis(trajectory.origin, a);
    powers(points, from.duration, piece.p[a]);
  }
  yaw_piece(yaw, begin, from.duration, points);
  powers(points, from.duration, piece.p[3]);
  piece.duration = static_cast<float>(from.duration);
  return Status::kOk;
}

}  // namespace tern
