// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "tern/proof.hpp"

#include "base/capacity.hpp"
#include "base/fence_fault.hpp"
#include "base/math.hpp"
#include "grid/lattice.hpp"
#include "proof/fence_clear.hpp"
#include "proof/hull_clear.hpp"
#include "proof/proven_limits.hpp"

namespace tern {
namespace {

/// A unit in the last place, relative: 2^-52.
constexpr double kLastPlace = 1.0 / 4503599627370496.0;
/// Rounding of positions, in units in the last place of world coordinates and extents.
constexpr double kPlaceUlps = 32.0;
/// Rounding of the control points that derivatives are differences of, in units in the last place of their coordinates.
constexpr double kPointUlps = 40.0;

/// Instructions of a piece, besides its surroundings; of a fence; of a face of a fence; and of an edge between two
/// faces.
constexpr std::uint32_t kPieceEffort = 1200;
constexpr std::uint32_t kFenceEffort = 200;
constexpr std::uint32_t kFaceEffort = 150;
constexpr std::uint32_t kEdgeEffort = 250;

std::uint32_t fence_effort(const Fence& fence) {
  const auto faces = static_cast<std::uint32_t>(fence.count);
  return kFenceEffort + kFaceEffort * faces + (fence.kind == FenceKind::kKeepOut ? kEdgeEffort * faces * faces / 2 : 0);
}

double size_of(const Vec3& v) {
  return (absolute(v.x) + absolute(v.y)) + absolute(v.z);
}

/// Tolerance of a proof, metres: what the check tolerates of a plan, and rounding.
double place_tolerance(const Grid& grid, const Trajectory& trajectory) {
  const GridSpec& spec = grid.spec();
  const Vec3 extent{spec.dims.x * spec.cell, spec.dims.y * spec.cell, spec.dims.z * spec.cell};
  const double size = (size_of(spec.origin) + size_of(trajectory.origin)) + size_of(extent);
  return kProofTolerance * larger(1.0, spec.cell) + kPlaceUlps * kLastPlace * size;
}

/// Error of a derivative of a segment whose control points are rounded. It is a difference of 2^order of them, divided
/// by the duration to the power of `order`.
double derivative_rounding(const Segment& segment, int order) {
  double size = 0.0;
  for (const Vec3& point : segment.points) size = larger(size, size_of(point));
  double factor = 1.0;
  for (int k = 0; k < order; ++k) factor *= 2.0 * (kDegree - k) / segment.duration;
  return kPointUlps * kLastPlace * size * factor;
}

/// `points` become the control points of the derivative with respect to time, which are one fewer.
void derive(Vec3* points, int degree, double duration) {
  const double factor = degree / duration;
  for (int i = 0; i < degree; ++i) points[i] = factor * (points[i + 1] - points[i]);
}

Vec3 blend(const Vec3& a, const Vec3& b, double u) {
  return (1.0 - u) * a + u * b;
}

/// de Casteljau: `points` becomes the part before u, `after` the part behind it.
void cut(Vec3* points, int degree, double u, Vec3* after) {
  for (int level = 0; level <= degree; ++level) {
    after[degree - level] = points[degree];
    for (int i = degree; i > level; --i) points[i] = blend(points[i - 1], points[i], u);
  }
}

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

/// True if every point is inside the box, grown by `margin`.
bool inside_box(const Box& points, const Box& box, double margin) {
  for (int a = 0; a < 3; ++a) {
    if (!(axis(points.lower, a) >= axis(box.lower, a) - margin)) return false;
    if (!(axis(points.upper, a) <= axis(box.upper, a) + margin)) return false;
  }
  return true;
}

constexpr Voxel kNoVoxel{-1, -1, -1};

}  // namespace

Status Proof::begin(const Grid& grid, const Trajectory& trajectory, double from, const Limits* limits, Beyond beyond,
                    const ProofGrounds& grounds) noexcept {
  const Status begun = begin_accepted(grid, trajectory, from, limits, beyond, grounds);
  if (begun != Status::kRunning) return begun;
  const FenceFault fault = find_fence_fault(grounds.fences, grounds.fence_count, grid.spec());
  if (fault.status == Status::kOk) return begun;
  refuse(from);
  report_.fence = fault.fence;
  return fault.status;
}

/// Resets the report: nothing is proven, and there is nothing to do.
void Proof::refuse(double from) noexcept {
  running_ = false;
  report_ = {from > 0.0 ? from : 0.0, ProofEnd::kMalformed, kNoVoxel, 0, kNoFence};
}

/// Begins a proof with fences that find_fence_fault() has accepted.
Status Proof::begin_accepted(const Grid& grid, const Trajectory& trajectory, double from, const Limits* limits,
                             Beyond beyond, const ProofGrounds& grounds) noexcept {
  refuse(from);
  if (!grid.bound() || !(grid.spec().clearance() > 0.0)) return Status::kInvalidArgument;
  if (trajectory.count < 1 || trajectory.count > kMaxSegments) return Status::kInvalidArgument;
  grid_ = &grid;
  trajectory_ = &trajectory;
  beyond_ = beyond;
  has_limits_ = limits != nullptr;
  if (has_limits_) limits_ = *limits;
  has_added_ = grounds.added != nullptr;
  if (has_added_) added_ = {grid.to_local(grounds.added->lower), grid.to_local(grounds.added->upper)};
  has_left_ = grounds.left != nullptr;
  if (has_left_) left_ = grid.to_local(*grounds.left);
  fences_ = grounds.fences;
  fence_count_ = grounds.fence_count;
  pardoned_ = nullptr;
  if (grounds.alarm != nullptr) pardon(*grounds.alarm);
  segment_ = 0;
  begin_ = 0.0;
  while (segment_ + 1 < trajectory.count && report_.until >= begin_ + trajectory.segments[segment_].duration) {
    begin_ += trajectory.segments[segment_].duration;
    ++segment_;
  }
  running_ = true;
  report_.end = ProofEnd::kProven;
  const double into = (report_.until - begin_) / trajectory.segments[segment_].duration;
  first_ = into >= 0.0 ? smaller(into, 1.0) : 0.0;
  enter_segment();
  return Status::kRunning;
}

/// Pardons seen voxels whose centres are in the alarm's box.
void Proof::pardon(const Alarm& alarm) noexcept {
  const GridSpec& spec = grid_->spec();
  pardoned_ = alarm.seen;
  const Vec3 lower = grid_->to_local(alarm.box.lower);
  const Vec3 upper = grid_->to_local(alarm.box.upper);
  const auto begin = [&](int a, std::int32_t count) { return ceil_index(axis(lower, a) / spec.cell - 0.5, 0, count); };
  const auto end = [&](int a, std::int32_t count) {
    return floor_index(axis(upper, a) / spec.cell - 0.5, -1, count - 1) + 1;
  };
  pardon_begin_ = {begin(0, spec.dims.x), begin(1, spec.dims.y), begin(2, spec.dims.z)};
  pardon_end_ = {end(0, spec.dims.x), end(1, spec.dims.y), end(2, spec.dims.z)};
}

/// True if the segment is finite, has a duration, and begins where the segment before ends.
bool Proof::sound(const Segment& segment) const noexcept {
  if (!finite(segment.duration) || !(segment.duration > 0.0)) return false;
  for (const Vec3& point : segment.points) {
    if (!finite(point)) return false;
  }
  if (segment_ == 0) return finite(trajectory_->origin);
  const Vec3 step = segment.points[0] - trajectory_->segments[segment_ - 1].points[kDegree];
  return size_of(step) <= place_tolerance(*grid_, *trajectory_);
}

void Proof::enter_segment() noexcept {
  lost_ = 1.0;
  if (!sound(trajectory_->segments[segment_])) return lose(first_, ProofEnd::kMalformed);
  enter_part(kPosition);
}

/// Begins a part, position or a derivative: loads its curve from the parameter at which the proof begins.
void Proof::enter_part(int part) noexcept {
  part_ = part;
  pieces_ = 0;
  const Segment& segment = trajectory_->segments[segment_];
  Piece& piece = stack_[0];
  piece.begin = first_;
  piece.depth = 0;
  const Vec3 place = part == kPosition ? trajectory_->origin - grid_->spec().origin : kZero;
  for (int i = 0; i <= kDegree; ++i) piece.c[i] = segment.points[i];
  for (int k = 0; k < part; ++k) derive(piece.c, kDegree - k, segment.duration);
  Vec3 rest[kControlPoints];
  if (first_ > 0.0) {
    cut(piece.c, kDegree - part, first_, rest);
    for (int i = 0; i <= kDegree - part; ++i) piece.c[i] = rest[i];
  }
  for (int i = 0; i <= kDegree; ++i) piece.c[i] = piece.c[i] + place;
  height_ = 1;
}

bool Proof::keeps_clear(const Piece& piece, ProofEnd& end) noexcept {
  const GridSpec& spec = grid_->spec();
  const double tolerance = place_tolerance(*grid_, *trajectory_);
  const Box box = box_around(piece.c, kControlPoints);
  end = ProofEnd::kOutside;
  const double margin = beyond_ == Beyond::kSolid ? -spec.clearance() : 0.0;
  if (!inside_box(box, grid_->local_boundary(), margin + tolerance)) return false;
  if (has_added_ && are_apart(box, added_, spec.clearance())) return true;
  end = ProofEnd::kFence;
  if (!keeps_fences(piece, tolerance)) {
    report_.voxel = kNoVoxel;
    return false;
  }
  end = ProofEnd::kObstacle;
  if (is_wide(box, spec.cell)) return false;
  const Pardon pardon{
      pardoned_, {pardon_begin_.x, pardon_end_.x}, {pardon_begin_.y, pardon_end_.y}, {pardon_begin_.z, pardon_end_.z}};
  const Clearance clearance{spec.clearance() - tolerance, has_left_ ? &left_ : nullptr, tolerance, pardon};
  return hull_clear(*grid_, piece.c, kControlPoints, clearance, report_.voxel, effort_);
}

bool Proof::keeps_fences(const Piece& piece, double tolerance) noexcept {
  const GridSpec& spec = grid_->spec();
  const FenceRule rule{spec.origin, spec.clearance() - tolerance, tolerance};
  for (int32_t k = 0; k < fence_count_; ++k) {
    effort_ += fence_effort(fences_[k]);
    if (fence_clear(fences_[k], rule, piece.c, kControlPoints)) continue;
    report_.fence = k;
    return false;
  }
  return true;
}

bool Proof::keeps_limit(const Piece& piece, int count) const noexcept {
  const double rounding = derivative_rounding(trajectory_->segments[segment_], part_);
  if (part_ == kJerk) return hull_allowed(allowed_jerk(limits_, rounding), piece.c, count);
  const Allowed allowed =
      part_ == kVelocity ? allowed_velocity(limits_, rounding) : allowed_acceleration(limits_, rounding);
  return hull_allowed(allowed, piece.c, count);
}

bool Proof::holds(const Piece& piece, int count, ProofEnd& end) noexcept {
  if (part_ == kPosition) return keeps_clear(piece, end);
  constexpr ProofEnd kEnds[] = {ProofEnd::kObstacle, ProofEnd::kVelocity, ProofEnd::kAcceleration, ProofEnd::kJerk};
  end = kEnds[part_];
  return keeps_limit(piece, count);
}

/// Notes a loss. Of the losses in a segment's parts, the earliest counts.
void Proof::lose(double u, ProofEnd end) noexcept {
  height_ = 0;
  if (report_.end != ProofEnd::kProven && u >= lost_) return;
  lost_ = u;
  report_.end = end;
  if (part_ != kPosition) report_.voxel = kNoVoxel;
  if (end != ProofEnd::kFence) report_.fence = kNoFence;
}

/// The piece on top of the stack is proven, halved, or lost.
void Proof::look_at_piece() noexcept {
  Piece& piece = stack_[height_ - 1];
  const int degree = kDegree - part_;
  ProofEnd end = ProofEnd::kPieces;
  ++report_.work;
  effort_ += kPieceEffort;
  if (is_full(pieces_++ == kProofPieces)) return lose(piece.begin, end);
  if (holds(piece, degree + 1, end)) {
    --height_;
    return;
  }
  if (is_full(piece.depth == kProofDepth)) return lose(piece.begin, end);
  Piece first = piece;
  ++first.depth;
  piece.depth = first.depth;
  cut(first.c, degree, 0.5, piece.c);
  double length = 1.0 - first_;
  for (int k = 0; k < first.depth; ++k) length *= 0.5;
  piece.begin = first.begin + length;
  stack_[height_++] = first;
}

/// The part that follows; kPosition after the last one.
int Proof::part_after(int part) const noexcept {
  if (part == kPosition && has_limits_) return kVelocity;
  if (part == kVelocity) return kAcceleration;
  return part == kAcceleration && limits_jerk(limits_) ? kJerk : kPosition;
}

/// Goes on with the next part, then with the next segment, unless the segment was lost somewhere.
void Proof::end_part() noexcept {
  const Segment& segment = trajectory_->segments[segment_];
  const int next = part_after(part_);
  if (next != kPosition && report_.end != ProofEnd::kMalformed) return enter_part(next);
  const double end = begin_ + segment.duration;
  if (report_.end == ProofEnd::kProven) {
    report_.voxel = kNoVoxel;
    report_.fence = kNoFence;
  }
  if (report_.end != ProofEnd::kProven || segment_ + 1 == trajectory_->count) {
    running_ = false;
    const double until = lost_ < 1.0 ? begin_ + lost_ * segment.duration : end;
    report_.until = larger(report_.until, smaller(until, end));
    return;
  }
  report_.until = begin_ = end;
  first_ = 0.0;
  ++segment_;
  enter_segment();
}

Status Proof::step(uint32_t work) noexcept {
  if (!running_ && trajectory_ == nullptr) return Status::kInvalidArgument;
  for (uint32_t left = work; running_;) {
    if (height_ == 0) {
      end_part();
      continue;
    }
    if (left-- == 0) return Status::kRunning;
    look_at_piece();
  }
  return Status::kOk;
}

double clear_until(const Grid& grid, const Trajectory& trajectory, double from, const Limits* limits, Beyond beyond,
                   ProofReport* report) noexcept {
  Proof proof;
  const bool begun = proof.begin_accepted(grid, trajectory, from, limits, beyond, {}) == Status::kRunning;
  // A segment takes 4 * (kProofPieces + 1) pieces at most.
  for (int i = 0; begun && i <= kMaxSegments && proof.step(5u * kProofPieces) == Status::kRunning; ++i) {
  }
  if (report != nullptr) *report = proof.report();
  return proof.report().until;
}

}  // namespace tern
