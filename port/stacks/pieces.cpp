// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "pieces.hpp"

#include "base/math.hpp"
#include "bound.hpp"
#include "curve/bezier.hpp"
#include "yaw_piece.hpp"

namespace tern {
namespace {

double yaw_off(const YawPlan* yaw, const Span& span) {
  double points[kControlPoints];
  yaw_piece(yaw, span.begin, span.end - span.begin, points);
  ExportError error{};
  widen_by_yaw(yaw, points, span.begin, span.end - span.begin, error);
  return error.yaw;
}

int worst_of(const double* off, int32_t count) {
  int worst = 0;
  for (int i = 1; i < count; ++i) {
    if (off[i] > off[worst]) worst = i;
  }
  return worst;
}

void halve(Spans& spans, double* off, int at) {
  for (int i = spans.count; i > at; --i) {
    spans.at[i] = spans.at[i - 1];
    off[i] = off[i - 1];
  }
  ++spans.count;
  spans.at[at].end = spans.at[at + 1].begin = 0.5 * (spans.at[at].begin + spans.at[at].end);
}

}  // namespace

bool cut_spans(const Trajectory& trajectory, const YawPlan* yaw, int32_t most, double shortest, Spans& spans) noexcept {
  if (trajectory.count < 1 || trajectory.count > most || trajectory.count > kMaxSegments) return false;
  double off[kMostPieces];
  double begin = 0.0;
  spans.count = trajectory.count;
  for (int i = 0; i < spans.count; ++i) {
    const double end = begin + trajectory.segments[i].duration;
    spans.at[i] = {i, begin, begin, end};
    off[i] = yaw_off(yaw, spans.at[i]);
    begin = end;
  }
  // Each turn halves a span or gives one up.
  for (int turn = 0; turn < 2 * kMostPieces && spans.count < most; ++turn) {
    const int at = worst_of(off, spans.count);
    if (!(off[at] > kCrazyflieYaw)) break;
    if (spans.at[at].end - spans.at[at].begin < 2.0 * shortest) {
      off[at] = 0.0;
      continue;
    }
    halve(spans, off, at);
    off[at] = yaw_off(yaw, spans.at[at]);
    off[at + 1] = yaw_off(yaw, spans.at[at + 1]);
  }
  return true;
}

void piece_points(const Trajectory& trajectory, const Span& span, double begin, double end, const Vec3& origin,
                  Vec3 (&points)[kControlPoints]) noexcept {
  const Segment& segment = trajectory.segments[span.segment];
  const Vec3 shift = trajectory.origin - origin;
  const double first = begin - span.segment_begin;
  const double last = end - span.segment_begin;
  for (int i = 0; i < kControlPoints; ++i) points[i] = segment.points[i];
  if (last < segment.duration || last > segment.duration) keep_first_part(last / segment.duration, points);
  if (first < 0.0 || first > 0.0) keep_last_part(first / last, points);
  for (Vec3& point : points) point = shift + point;
}

}  // namespace tern
