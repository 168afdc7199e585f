// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Tells whether one piece of the curve, or of a derivative, is within the grant, and its excess otherwise.
#include "base/math.hpp"
#include "prove/allowed.hpp"
#include "prove/cut_off.hpp"
#include "prove/fences.hpp"
#include "prove/grants.hpp"
#include "prove/hull_clear.hpp"
#include "prove/turning.hpp"
#include "tern/corridor.hpp"
#include "tern/flatness.hpp"
#include "tern/proof.hpp"

namespace tern {
namespace {

/// True if a piece in this box is so wide that it is halved before its surroundings are read.
bool is_wide(const Box& box, double cell) {
  for (int a = 0; a < 3; ++a) {
    if (axis(box.upper, a) - axis(box.lower, a) > kProofSpan * cell) return true;
  }
  return false;
}

/// True if the boxes are at least this far apart along some axis.
bool are_apart(const Box& a, const Box& b, double distance) {
  for (int k = 0; k < 3; ++k) {
    if (axis(b.lower, k) - axis(a.upper, k) >= distance || axis(a.lower, k) - axis(b.upper, k) >= distance) return true;
  }
  return false;
}

bool is_inside(const Box& inner, const Box& outer) {
  for (int a = 0; a < 3; ++a) {
    if (!(axis(inner.lower, a) >= axis(outer.lower, a) && axis(inner.upper, a) <= axis(outer.upper, a))) return false;
  }
  return true;
}

/// By how much the point is outside the box, on the axis where that is most.
Excess outside_by(const Box& box, const Vec3& point) {
  Excess most{-1, 0.0};
  for (int a = 0; a < 3; ++a) {
    const double beyond = larger(axis(box.lower, a) - axis(point, a), axis(point, a) - axis(box.upper, a));
    if (beyond > most.amount) most = {a, beyond};
  }
  return most;
}

}  // namespace

/// The hints that the corridor gives the current segment.
Hints Proof::hints() const noexcept {
  if (hints_ == nullptr || hints_->corridor == nullptr) return {nullptr, 0};
  const Corridor& corridor = *hints_->corridor;
  const int index = trajectory_->segments[segment_].polyhedron;
  if (index < 0 || index >= corridor.count || index >= kMaxSegments) return {nullptr, 0};
  return hints_of(corridor.polyhedra[index]);
}

bool Proof::keeps_clear(const Piece& piece, Finding& end) noexcept {
  const GridSpec& spec = grid_->spec();
  const Box box = box_around(piece.c, kControlPoints);
  end = Finding::kOutside;
  if (!is_inside(box, boundary_)) return false;
  if (has_added_ && are_apart(box, added_, spec.clearance())) return true;
  end = Finding::kFence;
  if (!keeps_fences(piece)) {
    report_.voxel = {-1, -1, -1};
    return false;
  }
  end = Finding::kObstacle;
  if (hints_ != nullptr && cut_off(*grid_, piece.c, kControlPoints, hints(), distance_, *work_)) return true;
  if (is_wide(box, spec.cell)) return false;
  const Pardon pardon{
      pardoned_, {pardon_begin_.x, pardon_end_.x}, {pardon_begin_.y, pardon_end_.y}, {pardon_begin_.z, pardon_end_.z}};
  const Clearance clearance{distance_, has_departed_ ? &departed_ : nullptr, near_, pardon, ground_};
  return hull_clear(*grid_, piece.c, kControlPoints, clearance, report_.voxel, *work_);
}

bool Proof::keeps_fences(const Piece& piece) noexcept {
  const FenceRule rule{grid_->spec().origin, distance_, outside_};
  for (int32_t k = 0; k < fence_count_; ++k) {
    if (is_timed(fences_[k])) continue;  // proven with the tracks
    if (fence_clear(fences_[k], rule, piece.c, kControlPoints, *work_)) continue;
    if (is_cut_off(k, piece)) continue;
    report_.fence = k;
    return false;
  }
  return true;
}

/// Hints are for eighths of a segment at the smallest. Pieces much smaller than that are not tried: what no hint cuts
/// off from the eighth around them is hardly ever cut off from them. A curve that meets a keep-out is halved down to
/// such pieces before it is refused.
constexpr int kHintedDepth = 5;

/// True if the fence is a keep-out that is cut off along a hint. A whole segment is looked at even without hints.
bool Proof::is_cut_off(int fence, const Piece& piece) noexcept {
  if (hints_ == nullptr || fences_[fence].kind != FenceKind::kKeepOut) return false;
  const Apart hull{piece.c, kControlPoints, distance_};
  const auto cuts_off = [&](const Hints& known) {
    return keep_out_cut_off(*grid_, fences_, fence_count_, fence, known, hull, hints_->scratch, *work_);
  };
  const Hints of_corridor = hints();
  if ((piece.depth == 0 || of_corridor.count > 0) && cuts_off(of_corridor)) return true;
  if (segment_ >= hints_->hinted || piece.depth > kHintedDepth) return false;
  const FenceHints& own = hints_->fences[segment_];
  return own.count > 0 && cuts_off({own.planes, own.count});
}

/// What rounding may do to a derivative of the current segment.
double Proof::rounding_of(int derivative) const noexcept {
  const Segment& segment = trajectory_->segments[segment_];
  return is_cut_ ? derivative_rounding(segment, derivative) : hodograph_rounding(segment, derivative);
}

/// What the limits allow the current part.
Allowed Proof::allowed() const noexcept {
  return allowed_by(limits_, part_, excess_, rounding_of(part_));
}

/// What the limits allow the body rates. Rounding of the thrust counts as so much more rate.
TurningRule Proof::turning() const noexcept {
  const double thrust = limits_.thrust_min > 0.0 ? limits_.thrust_min : kGravity;
  const double rounding = 4.0 * rounding_of(kAcceleration) / thrust;
  return {(1.0 + excess_ + rounding) * limits_.rate_max, 2.0 * rounding_of(kJerk)};
}

bool Proof::holds(const Piece& piece, int count, Finding& end) noexcept {
  if (part_ == kPosition) return keeps_clear(piece, end);
  constexpr Finding kEnds[] = {Finding::kObstacle, Finding::kVelocity, Finding::kAcceleration, Finding::kJerk,
                               Finding::kBodyRate};
  end = kEnds[part_];
  if (part_ == kTurning) {
    work_->spend(kTurningOperations);
    return turning_allowed(trajectory_->segments[segment_], piece.begin, piece.begin + length_of(piece), turning());
  }
  return hull_allowed(allowed(), piece.c, count);
}

/// The excess of a point of the curve, or of its derivative, over the grant.
Excess Proof::excess_at(const Vec3& point, Finding end) const noexcept {
  if (end == Finding::kOutside) return outside_by(boundary_, point);
  if (end == Finding::kFence)
    return {-1, fence_excess(fences_[report_.fence], {grid_->spec().origin, distance_, outside_}, point)};
  if (part_ != kPosition) return excess_of(allowed(), point);
  if (end != Finding::kObstacle || report_.voxel.x < 0) return {-1, 0.0};
  return {-1, distance_ - distance_to_cube(*grid_, report_.voxel, point)};
}

/// Notes the worst excess at the ends of a piece that is not proven; both are points of the curve.
void Proof::note_excess(const Piece& piece, int degree, Finding end) noexcept {
  if (part_ == kTurning) {
    const double rate = turning_at(trajectory_->segments[segment_], piece.begin);
    worst_ = larger(worst_, rate - turning().most);
    return;
  }
  for (int i = 0; i <= degree; i += degree) {
    const Excess excess = excess_at(piece.c[i], end);
    if (!(excess.amount > worst_)) continue;
    worst_ = excess.amount;
    worst_axis_ = excess.axis;
  }
}

}  // namespace tern
