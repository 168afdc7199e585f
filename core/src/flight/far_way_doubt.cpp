// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// When a far way is given up. The rolling map sees finely, and a Flight finds ways that a coarse grid cannot know. So
// what it sees counts only once the vehicle gets no further: then the coarse grid learns it, and a new way is sought.
#include "base/direction.hpp"
#include "base/math.hpp"
#include "base/work.hpp"
#include "flight/far_cell.hpp"
#include "flight/far_rest.hpp"
#include "grid/lattice.hpp"
#include "map/grid_words.hpp"
#include "tern/far_way.hpp"

namespace tern {
namespace {

/// Within so many coarse cells of the end of the way, the near map alone decides.
constexpr double kAtEnd = 2.0;
/// Steps of a walk along the way, in coarse cells.
constexpr double kMarkStep = 0.5;

/// Nanoseconds from one time to a later one, for any two.
std::uint64_t between(std::int64_t from, std::int64_t to) {
  return to > from ? static_cast<std::uint64_t>(to) - static_cast<std::uint64_t>(from) : 0;
}

}  // namespace

/// True if the near goal is a new one.
bool FarWay::follow(const FlightReport& flight, const RollingMap& map, std::int64_t t) noexcept {
  if (state_ != FarState::kLeads) return false;
  get_on(t);
  if (choose_near_goal()) return true;
  const bool has_time = between(since_, t) < static_cast<std::uint64_t>(spec_.patience);
  const NearGoalEnd end = is_last_ ? NearGoalEnd::kNone : end_of_near_goal(flight);
  gave_up_ = end == NearGoalEnd::kForGood;
  waits_ = end == NearGoalEnd::kForNow;
  const bool is_doubtful = gave_up_ || (!has_time && (waits_ || left() > kAtEnd * coarse_->spec().cell));
  if (!is_doubtful || !has_grid(map)) return false;
  since_ = t;
  begin_learning(map);
  return false;
}

void FarWay::begin_learning(const RollingMap& map) noexcept {
  found_ = 0;
  bool is_empty = false;
  for (int a = 0; a < 3; ++a) {
    const IndexRange met = cells_met(*coarse_, map.route(), a);
    axis(begin_, a) = met.begin;
    axis(end_, a) = met.end;
    is_empty = is_empty || met.begin >= met.end;
  }
  cell_ = begin_;
  if (is_empty) cell_.z = end_.z;
  job_ = Job::kLearn;
}

void FarWay::mark(const Voxel& cell) noexcept {
  coarse_->mark_voxel(cell);
  ++found_;
  ++marked_;
}

/// Goes through the coarse cells that the window met. A piece is a cell. While the window slides, it waits.
void FarWay::learn(const RollingMap& map) noexcept {
  while (cell_.z < end_.z && has_grid(map) && work_.left()) {
    if (!coarse_->obstacle(cell_) && shows_more(*coarse_, map.route(), cell_, work_)) mark(cell_);
    if (++cell_.x < end_.x) continue;
    cell_.x = begin_.x;
    if (++cell_.y < end_.y) continue;
    cell_.y = begin_.y;
    ++cell_.z;
  }
}

/// True if nothing can be learned, and only the goal is left to fly to, or the near goal once more.
bool FarWay::end_learning() noexcept {
  if (found_ == 0 && gave_up_) mark_ahead();
  piece_ = 0;
  job_ = found_ > 0 ? Job::kInflate : Job::kFollow;
  if (found_ == 0 && gave_up_) return lead_to_goal(FarState::kNoWay);
  return found_ == 0 && waits_;
}

/// The vehicle has given up, and the near map does not say why: the first cell of the way that it is not in leads
/// nowhere.
void FarWay::mark_ahead() noexcept {
  const Path& way = path();
  const Voxel here = coarse_->voxel_of(coarse_->to_local(position_));
  const double step = kMarkStep * coarse_->spec().cell;
  Vec3 from = place_;
  for (std::int32_t leg = leg_; leg + 1 < way.raw_count; ++leg) {
    const Vec3 along = way.raw[leg + 1] - from;
    const std::int32_t steps = ceil_index(length(along) / step, 1, 4 * kMaxDimension);
    work_.spend(ops::kPiece);
    for (std::int32_t k = 1; k <= steps; ++k) {
      work_.spend(ops::kDot + ops::kTurn);
      const Voxel cell = coarse_->voxel_of(from + (static_cast<double>(k) / steps) * along);
      if (same(cell, here) || !coarse_->free(cell)) continue;
      return mark(cell);
    }
    from = way.raw[leg + 1];
  }
}

/// Then the search begins.
void FarWay::inflate() noexcept {
  const std::int32_t pieces = GridWords::inflation_pieces(coarse_->spec().dims);
  for (; piece_ < pieces && work_.left(); ++piece_) GridWords(*coarse_).inflate_piece(piece_, work_);
  if (piece_ == pieces) job_ = Job::kBegin;
}

}  // namespace tern
