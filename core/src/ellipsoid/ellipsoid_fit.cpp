// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ellipsoid/ellipsoid_fit.hpp"

namespace tern {
namespace {

constexpr double kFitTolerance = 1e-3;
constexpr double kThinnest = 0.01;
/// Shrinking steps in each of the two phases, at most. Each step shortens the axis; most fits need two or three.
constexpr int kFitSteps = 16;

/// The obstacles that may still meet the ellipsoid. It only shrinks, so a dropped one never comes back.
struct Candidates {
  std::int32_t* index;
  int count;
};

void turn_y_towards(EllipsoidFrame& frame, const Vector& unit) {
  frame.direction.col(1) = unit;
  frame.direction.col(2) = cross(frame.direction.col(0), unit);
}

/// The obstacles that the sphere of radius `reach` about the centre meets.
Candidates boxes_within(const Obstacles& obstacles, const Vec3& center, double reach, std::int32_t* index) {
  Candidates found{index, 0};
  const double limit = (reach + obstacles.radius) * (reach + obstacles.radius);
  for (int i = 0; i < obstacles.count; ++i) {
    const LocalBox& box = obstacles.boxes[i];
    const double x = center.x - clamp(center.x, box.lower[0], box.upper[0]);
    const double y = center.y - clamp(center.y, box.lower[1], box.upper[1]);
    const double z = center.z - clamp(center.z, box.lower[2], box.upper[2]);
    if ((x * x + y * y) + z * z < limit) index[found.count++] = i;
  }
  return found;
}

/// Drops the candidates that the ellipsoid does not meet. Returns whether any are left; `first` is then the contact
/// that the ellipsoid meets first.
bool first_contact(const EllipsoidFrame& frame, const Obstacles& obstacles, Candidates& candidates, Contact& first) {
  const EllipsoidMetric metric = metric_of(frame);
  int kept = 0;
  for (int k = 0; k < candidates.count; ++k) {
    const std::int32_t i = candidates.index[k];
    if (least_scale(metric, obstacles.boxes[i], obstacles.radius) >= 1.0) continue;
    const Contact contact = contact_of(metric, obstacles.boxes[i], obstacles.radius);
    if (contact.scale >= 1.0 - kFitTolerance) continue;
    candidates.index[kept] = i;
    if (kept == 0 || contact.scale < first.scale) first = contact;
    ++kept;
  }
  candidates.count = kept;
  return kept > 0;
}

double square(double x) {
  return x * x;
}

/// Radius of the unit ball's cross-section where the other axes have used up `used` of the squared radius; 0 beyond the
/// tips.
double remaining(double used) {
  return used < 1.0 ? square_root(1.0 - used) : 0.0;
}

/// Shrinks y and z together, so the ellipsoid stays round about the segment. In the end, y points towards the last
/// contact.
void shrink_both(EllipsoidFrame& frame, const Obstacles& obstacles, Candidates candidates, double thinnest) {
  Contact contact{};
  for (int step = 0; step < kFitSteps && frame.semi_axis[1] > thinnest; ++step) {
    if (!first_contact(frame, obstacles, candidates, contact)) return;
    const double along = dot(contact.point, frame.direction.col(0));
    const Vector across = contact.point - along * frame.direction.col(0);
    const double distance_across = length(across);
    if (distance_across > 0.0) turn_y_towards(frame, (1.0 / distance_across) * across);
    const double left = remaining(square(along / frame.semi_axis[0]));
    const double touching = left > 0.0 ? distance_across / left : 0.0;
    frame.semi_axis[1] = clamp(touching, thinnest, frame.semi_axis[1]);
    frame.semi_axis[2] = frame.semi_axis[1];
  }
}

/// Stretches z to the length of x and shrinks it again, but no further than y: the round ellipsoid was already clear.
void stretch_z(EllipsoidFrame& frame, const Obstacles& obstacles, Candidates candidates) {
  frame.semi_axis[2] = frame.semi_axis[0];
  Contact contact{};
  for (int step = 0; step < kFitSteps && frame.semi_axis[2] > frame.semi_axis[1]; ++step) {
    if (!first_contact(frame, obstacles, candidates, contact)) return;
    const double along = dot(contact.point, frame.direction.col(0));
    const double aside = dot(contact.point, frame.direction.col(1));
    const double up = absolute(dot(contact.point, frame.direction.col(2)));
    const double left = remaining(square(along / frame.semi_axis[0]) + square(aside / frame.semi_axis[1]));
    const double touching = left > 0.0 ? up / left : 0.0;
    frame.semi_axis[2] = clamp(touching, frame.semi_axis[1], frame.semi_axis[2]);
  }
}

/// The ball for a hover, where no direction is special.
EllipsoidFrame ball_about(const Vec3& center, double cell) {
  return {to_vector(center), Matrix::Identity(), Vector::Constant(0.5 * cell)};
}

}  // namespace

EllipsoidFrame sphere_over(const Vec3& from, const Vec3& to) noexcept {
  const double half = 0.5 * distance(from, to);
  EllipsoidFrame frame;
  const Vec3 along = (0.5 / half) * (to - from);
  frame.center = to_vector(0.5 * (from + to));
  frame.semi_axis.fill(half);
  frame.direction.col(0) = to_vector(along);
  turn_y_towards(frame, to_vector(perpendicular(along)));
  return frame;
}

EllipsoidFrame at_least_as_thick(const EllipsoidFrame& frame, double share) noexcept {
  EllipsoidFrame thick = frame;
  for (int k = 0; k < 3; ++k) thick.semi_axis[k] = larger(frame.semi_axis[k], share * frame.semi_axis[0]);
  return thick;
}

EllipsoidFrame fit_ellipsoid(const Vec3& from, const Vec3& to, const Obstacles& obstacles, double cell,
                             std::int32_t* inside) noexcept {
  const Vec3 middle = 0.5 * (from + to);
  const double half = 0.5 * distance(from, to);
  if (2.0 * half < kPointLike) return ball_about(middle, cell);

  EllipsoidFrame frame = sphere_over(from, to);
  Candidates candidates = boxes_within(obstacles, middle, half, inside);
  shrink_both(frame, obstacles, candidates, kThinnest * half);
  candidates = boxes_within(obstacles, middle, half, inside);
  stretch_z(frame, obstacles, candidates);
  return frame;
}

}  // namespace tern
