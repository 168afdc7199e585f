// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The part of a plan that one piece of a Crazyflie's trajectory covers: a segment or a part of one.
#ifndef TERN_STACKS_PIECES_HPP
#define TERN_STACKS_PIECES_HPP

#include "tern_stacks/stacks.hpp"

namespace tern {

/// A part of a segment. Seconds since the plan's beginning.
struct Span {
  int32_t segment;
  double segment_begin;
  double begin;
  double end;
};

constexpr int32_t kMostPieces = kMaxSegments > kCrazyfliePieces ? kMaxSegments : kCrazyfliePieces;

struct Spans {
  int32_t count;
  Span at[kMostPieces];
};

/// Makes a span for each segment. Then halves the span whose yaw polynomial is furthest off, while that is off by more
/// than kCrazyflieYaw and there are fewer than `most` spans. Spans whose halves would last less than `shortest` stay.
/// False for an empty plan or one of more than `most` segments.
bool cut_spans(const Trajectory& trajectory, const YawPlan* yaw, int32_t most, double shortest, Spans& spans) noexcept;

/// The control points of the span's polynomial over [begin, end], relative to `origin`. Rounding may put the times a
/// little beyond the span: the same polynomial goes on there.
void piece_points(const Trajectory& trajectory, const Span& span, double begin, double end, const Vec3& origin,
                  Vec3 (&points)[kControlPoints]) noexcept;

}  // namespace tern

#endif
