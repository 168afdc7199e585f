// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ellipsoid/ellipsoid_fit.hpp"

namespace tern {
namespace {

constexpr double kFitTolerance = 1e-3;
constexpr double kThinnest = 0.01;
/// Shrinking steps in each of the two phases, at most. Each step shortens the axis; most fits need two or three.
constexpr int kFitSteps = 16;

void turn_y_towards(EllipsoidFrame& frame, const Vector& unit) {
  frame.direction.col(1) = unit;
  frame.direction.col(2) = cross(frame.direction.col(0), unit);
}

/// Lists the obstacles that the sphere over the segment meets.
void collect(EllipsoidFit& fit, const Obstacles& obstacles, std::int32_t* index, Work& work) {
  const Vector& center = fit.frame.center;
  const double limit = (fit.half + obstacles.radius) * (fit.half + obstacles.radius);
  fit.count = 0;
  for (int i = 0; i < obstacles.count; ++i) {
    const LocalBox& box = obstacles.boxes[i];
    const double x = center[0] - clamp(center[0], box.lower[0], box.upper[0]);
    const double y = center[1] - clamp(center[1], box.lower[1], box.upper[1]);
    const double z = center[2] - clamp(center[2], box.lower[2], box.upper[2]);
    if ((x * x + y * y) + z * z < limit) index[fit.count++] = i;
  }
  work.spend(ops::kPiece + ops::kDot * obstacles.count);
}

/// Looks at the next candidates. Drops those that the ellipsoid does not meet: it only shrinks, so they never come
/// back.
void look(EllipsoidFit& fit, const Obstacles& obstacles, std::int32_t* index, Work& work) {
  const int begin = fit.next;
  const int end = fit.count - begin < kFitScreens ? fit.count : begin + kFitScreens;
  int contacts = 0;
  for (; fit.next < end && contacts < kFitContacts; ++fit.next) {
    const std::int32_t i = index[fit.next];
    if (least_scale(fit.metric, obstacles.boxes[i], obstacles.radius) >= 1.0) continue;
    const BoxContact contact = contact_of(fit.metric, obstacles.boxes[i], obstacles.radius);
    ++contacts;
    if (contact.scale >= 1.0 - kFitTolerance) continue;
    index[fit.kept] = i;
    if (fit.kept == 0 || contact.scale < fit.first.scale) fit.first = contact;
    ++fit.kept;
  }
  work.spend(ops::kPiece + kScaleOperations * (fit.next - begin) + kContactOperations * contacts);
}

double square(double x) {
  return x * x;
}

/// Radius of the unit ball's cross-section at a point whose other coordinates have squares of sum `used`; 0 outside the
/// ball.
double remaining(double used) {
  return used < 1.0 ? square_root(1.0 - used) : 0.0;
}

/// Shrinks y and z together until the ellipsoid touches the contact, and turns y towards it. After the last round, y
/// points towards the last contact.
void shrink_both(EllipsoidFrame& frame, const BoxContact& contact, double thinnest) {
  const double along = dot(contact.point, frame.direction.col(0));
  const Vector across = contact.point - along * frame.direction.col(0);
  const double distance_across = length(across);
  if (distance_across > 0.0) turn_y_towards(frame, (1.0 / distance_across) * across);
  const double left = remaining(square(along / frame.semi_axis[0]));
  const double touching = left > 0.0 ? distance_across / left : 0.0;
  frame.semi_axis[1] = clamp(touching, thinnest, frame.semi_axis[1]);
  frame.semi_axis[2] = frame.semi_axis[1];
}

/// Shrinks z, but no further than y: with z equal to y, the ellipsoid was already clear.
void shrink_z(EllipsoidFrame& frame, const BoxContact& contact) {
  const double along = dot(contact.point, frame.direction.col(0));
  const double aside = dot(contact.point, frame.direction.col(1));
  const double up = absolute(dot(contact.point, frame.direction.col(2)));
  const double left = remaining(square(along / frame.semi_axis[0]) + square(aside / frame.semi_axis[1]));
  const double touching = left > 0.0 ? up / left : 0.0;
  frame.semi_axis[2] = clamp(touching, frame.semi_axis[1], frame.semi_axis[2]);
}

/// Begins a round with the candidates that are left. False if the phase is over.
bool begin_round(EllipsoidFit& fit) {
  const EllipsoidFrame& frame = fit.frame;
  const double least = fit.phase == FitPhase::kShrink ? kThinnest * fit.half : frame.semi_axis[1];
  const double shrinking = fit.phase == FitPhase::kShrink ? frame.semi_axis[1] : frame.semi_axis[2];
  fit.metric = metric_of(frame);
  fit.next = fit.kept = 0;
  return fit.step < kFitSteps && shrinking > least;
}

/// Ends a round: shrinks the ellipsoid, and begins the next round. False if the phase is over.
bool end_round(EllipsoidFit& fit) {
  if (fit.kept == 0) return false;
  if (fit.phase == FitPhase::kShrink) {
    shrink_both(fit.frame, fit.first, kThinnest * fit.half);
  } else {
    shrink_z(fit.frame, fit.first);
  }
  fit.count = fit.kept;
  ++fit.step;
  return begin_round(fit);
}

void end_phase(EllipsoidFit& fit) {
  fit.phase = fit.phase == FitPhase::kShrink ? FitPhase::kCollectAgain : FitPhase::kDone;
}

/// Begins to shrink or to stretch, once the candidates are collected.
void begin_phase(EllipsoidFit& fit) {
  const bool again = fit.phase == FitPhase::kCollectAgain;
  fit.phase = again ? FitPhase::kStretch : FitPhase::kShrink;
  if (again) fit.frame.semi_axis[2] = fit.frame.semi_axis[0];
  fit.step = 0;
  if (!begin_round(fit)) end_phase(fit);
}

/// The sphere whose diameter is the segment, with x along it. The segment must not be a point (kPointLike).
EllipsoidFrame sphere_over(const Vec3& from, const Vec3& to) {
  const double half = 0.5 * distance(from, to);
  EllipsoidFrame frame;
  const Vec3 along = (0.5 / half) * (to - from);
  frame.center = to_vector(0.5 * (from + to));
  frame.semi_axis.fill(half);
  frame.direction.col(0) = to_vector(along);
  turn_y_towards(frame, to_vector(perpendicular(along)));
  return frame;
}

/// The ball for a hover, which has no direction.
EllipsoidFrame ball_about(const Vec3& center, double cell) {
  return {to_vector(center), Matrix::Identity(), Vector::Constant(0.5 * cell)};
}

}  // namespace

EllipsoidFrame at_least_as_thick(const EllipsoidFrame& frame, double share) noexcept {
  EllipsoidFrame thick = frame;
  for (int k = 0; k < 3; ++k) thick.semi_axis[k] = larger(frame.semi_axis[k], share * frame.semi_axis[0]);
  return thick;
}

void fit_begin(EllipsoidFit& fit, const Vec3& from, const Vec3& to, double cell) noexcept {
  fit.half = 0.5 * distance(from, to);
  const bool is_point = 2.0 * fit.half < kPointLike;
  fit.frame = is_point ? ball_about(0.5 * (from + to), cell) : sphere_over(from, to);
  fit.phase = is_point ? FitPhase::kDone : FitPhase::kCollect;
}

Progress fit_advance(EllipsoidFit& fit, const Obstacles& obstacles, std::int32_t* inside, Work& work) noexcept {
  while (fit.phase != FitPhase::kDone) {
    if (!work.left()) return Progress::kMore;
    if (fit.phase == FitPhase::kCollect || fit.phase == FitPhase::kCollectAgain) {
      collect(fit, obstacles, inside, work);
      begin_phase(fit);
      continue;
    }
    look(fit, obstacles, inside, work);
    if (fit.next == fit.count && !end_round(fit)) end_phase(fit);
  }
  return Progress::kDone;
}

}  // namespace tern
