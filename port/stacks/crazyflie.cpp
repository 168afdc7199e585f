// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "base/math.hpp"
#include "bound.hpp"
#include "pieces.hpp"
#include "tern_stacks/stacks.hpp"
#include "yaw_piece.hpp"

namespace tern {
namespace {

static_assert(sizeof(Poly4d) == 132, "the firmware stores a piece in 132 bytes");

constexpr double kShortestRaw = 0.1;  // s: halving makes no shorter piece

/// The binomial coefficients C(7, k).
constexpr double kBinomial[kControlPoints] = {1.0, 7.0, 21.0, 35.0, 35.0, 21.0, 7.0, 1.0};

/// Writes the coefficients by rising powers of t: the k-th is C(7, k) / T^k times the k-th difference of the control
/// points. Then replaces the control points by those of the rounded coefficients.
void powers(double (&points)[kControlPoints], double duration, float (&out)[8]) {
  double scale = 1.0;
  for (int k = 0; k <= kDegree; ++k) {
    out[k] = static_cast<float>(kBinomial[k] * points[0] / scale);
    for (int i = 0; i < kDegree - k; ++i) points[i] = points[i + 1] - points[i];
    scale *= duration;
  }
  scale = 1.0;
  for (int k = 0; k <= kDegree; ++k) {
    points[k] = static_cast<double>(out[k]) * scale / kBinomial[k];
    scale *= duration;
  }
  for (int first = kDegree; first > 0; --first) {
    for (int k = first; k <= kDegree; ++k) points[k] += points[k - 1];
  }
}

void fill_piece(const Trajectory& trajectory, const YawPlan* yaw, const Span& span, double begin, const Vec3& origin,
                Poly4d& piece, ExportError& error) {
  Segment flown;
  flown.duration = static_cast<double>(piece.duration);
  flown.polyhedron = 0;
  piece_points(trajectory, span, begin, begin + flown.duration, origin, flown.points);
  double points[kControlPoints];
  for (int a = 0; a < 3; ++a) {
    for (int i = 0; i < kControlPoints; ++i) points[i] = axis(flown.points[i], a);
    powers(points, flown.duration, piece.p[a]);
    for (int i = 0; i < kControlPoints; ++i) axis(flown.points[i], a) = points[i];
  }
  yaw_piece(yaw, begin, flown.duration, points);
  powers(points, flown.duration, piece.p[3]);
  widen_by_curve(trajectory, flown, origin, begin, error);
  widen_by_yaw(yaw, points, begin, flown.duration, error);
}

}  // namespace

Status crazyflie_raw(const Trajectory& trajectory, const YawPlan* yaw, const Vec3& origin, Poly4d* pieces, int32_t room,
                     int32_t& count, ExportError& error) noexcept {
  Spans spans;
  const int32_t most = room < kCrazyfliePieces ? room : kCrazyfliePieces;
  if (pieces == nullptr || !cut_spans(trajectory, yaw, most, kShortestRaw, spans)) return Status::kInvalidArgument;
  ExportError found{};
  double begin = 0.0;  // as flown: sums of rounded durations
  for (int32_t i = 0; i < spans.count; ++i) {
    pieces[i].duration = static_cast<float>(spans.at[i].end - begin);
    if (!(pieces[i].duration > 0.0f)) return Status::kInvalidArgument;
    fill_piece(trajectory, yaw, spans.at[i], begin, origin, pieces[i], found);
    begin += static_cast<double>(pieces[i].duration);
  }
  count = spans.count;
  error = found;
  return Status::kOk;
}

}  // namespace tern
