// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// A far way: its searches, and how it leads along what they find. far_way_doubt.cpp says when a way is given up.
#include "tern/far_way.hpp"

#include "base/math.hpp"
#include "base/work.hpp"
#include "flight/far_cell.hpp"
#include "grid/lattice.hpp"
#include "path/polyline.hpp"
#include "path/sight.hpp"

namespace tern {
namespace {

/// Limits that are valid: a way has no speed.
constexpr Limits kAnyLimits{{1.0, 1.0, 1.0}, {1.0, 1.0, 1.0}};
/// In coarse cells: steps of a look along the way, and how far the vehicle gets on from one look to the next; how far a
/// near goal is ahead at least, within a step; and how much further a new one is than the last. So a look that finds
/// none is always followed by another one before the vehicle is at the near goal: kLeastAhead leaves room for all
/// three.
constexpr double kLookStep = 0.5;
constexpr double kLeast = 2.0;
constexpr double kFurther = 1.0;
static_assert(kLeastAhead >= kLeast + kFurther, "else a vehicle arrives at a near goal before there is a new one");

bool lacks_start(const Report& found) {
  const bool is_closed = found.status == Status::kStartOccupied || found.status == Status::kStartTooNarrow;
  return is_closed && found.has_nearest_free;
}

}  // namespace

Status FarWay::start(const FarWaySpec& spec, Grid& coarse, Planner& planner) noexcept {
  if (!finite(spec.ahead)) return Status::kNonFiniteInput;
  if (spec.patience <= 0 || !coarse.inflated()) return Status::kInvalidArgument;
  const double cell = coarse.spec().cell;
  if (!(spec.ahead >= kLeastAhead * cell && spec.ahead <= kMostAhead * cell)) return Status::kInvalidArgument;
  *this = FarWay{};
  spec_ = spec;
  coarse_ = &coarse;
  planner_ = &planner;
  return Status::kOk;
}

Status FarWay::set_goal(const Vec3& goal) noexcept {
  if (planner_ == nullptr) return Status::kInvalidArgument;
  if (!finite(goal)) return Status::kNonFiniteInput;
  if (state_ == FarState::kNoGoal) near_goal_ = goal;
  goal_ = goal;
  is_last_ = same(near_goal_, goal);
  state_ = FarState::kSearching;
  job_ = coarse_->inflated() ? Job::kBegin : Job::kInflate;
  piece_ = 0;
  return Status::kOk;
}

bool FarWay::tick(const Vec3& position, const FlightReport& flight, const RollingMap& map, std::int64_t t,
                  std::uint32_t work) noexcept {
  if (state_ == FarState::kNoGoal || !finite(position)) return false;
  position_ = position;
  if (work_.left()) work_ = Work{};
  work_.add(work);
  if (job_ == Job::kFollow && work_.left() && follow(flight, map, t)) return true;
  if (job_ == Job::kLearn) learn(map);
  if (job_ == Job::kLearn && cell_.z >= end_.z && work_.left() && end_learning()) return true;
  if (job_ == Job::kInflate) inflate();
  if (job_ == Job::kBegin && work_.left()) {
    ++searches_;
    choose_start(map);
    begin_search();
  }
  since_ = job_ == Job::kSearch ? t : since_;
  return job_ == Job::kSearch && search();
}

const Path& FarWay::path() const noexcept {
  return *planner_->path();
}

double FarWay::left() const noexcept {
  return state_ == FarState::kLeads ? length_ - done_ : 0.0;
}

/// The vehicle's place or, if its cell is not free, the nearest free cell that the rolling map shows the way to.
void FarWay::choose_start(const RollingMap& map) noexcept {
  from_ = position_;
  is_moved_ = false;
  const bool is_closed = !coarse_->free(coarse_->voxel_of(coarse_->to_local(position_)));
  if (is_closed && has_grid(map)) find_open_cell(*coarse_, map.route(), position_, from_, work_);
}

void FarWay::begin_search() noexcept {
  Request request{};
  request.start.position = from_;
  request.goal.position = goal_;
  request.limits = kAnyLimits;
  request.goal_mode = GoalMode::kNearest;
  planner_->begin_way(*coarse_, request);
  state_ = FarState::kSearching;
  job_ = Job::kSearch;
}

/// True if it leads to a new near goal.
bool FarWay::search() noexcept {
  return planner_->step(work_) != Status::kRunning && end_search();
}

bool FarWay::end_search() noexcept {
  Report found;
  const Status status = planner_->finish_route(found);
  if (lacks_start(found) && !is_moved_) {
    from_ = found.nearest_free;
    is_moved_ = true;
    begin_search();
    return false;
  }
  if (status == Status::kMapChanged && coarse_->inflated()) {
    job_ = Job::kBegin;
    return false;
  }
  if (status != Status::kOk) return lead_to_goal(FarState::kNoWay);
  state_ = FarState::kLeads;
  job_ = Job::kFollow;
  length_ = polyline_length(path().raw, path().raw_count);
  leg_ = 0;
  place_ = path().raw[0];
  done_ = noted_ = looked_ = near_at_ = 0.0;
  is_last_ = false;
  return work_.left() && choose_near_goal();
}

bool FarWay::lead_to_goal(FarState state) noexcept {
  near_goal_ = goal_;
  is_last_ = true;
  state_ = state;
  job_ = Job::kFollow;
  return true;
}

/// Notes the point of the way that is nearest to the vehicle: of those at most `ahead` beyond the last one, because the
/// way may come near it again further on.
void FarWay::get_on(std::int64_t t) noexcept {
  const Path& way = path();
  const Vec3 local = coarse_->to_local(position_);
  Vec3 from = place_;
  double before = done_;
  double least = distance(place_, local);
  const double most = done_ + spec_.ahead;
  const std::int32_t first = leg_;
  std::int32_t leg = first;
  for (; leg + 1 < way.raw_count && before <= most; ++leg) {
    const Vec3 along = way.raw[leg + 1] - from;
    const double square = dot(along, along);
    const double part = square > 0.0 ? clamp(dot(local - from, along) / square, 0.0, 1.0) : 0.0;
    const Vec3 at = from + part * along;
    if (distance(at, local) < least) {
      least = distance(at, local);
      leg_ = leg;
      place_ = at;
      done_ = before + part * square_root(square);
    }
    before += square_root(square);
    from = way.raw[leg + 1];
  }
  work_.spend(ops::kPiece + 6 * ops::kDot * (leg - first));
  if (done_ - noted_ < coarse_->spec().cell) return;
  noted_ = done_;
  since_ = t;
}

/// The point furthest along the way, at most `ahead` on, that the coarse grid sees from where the vehicle has come to.
FarWay::Point FarWay::furthest_in_sight() noexcept {
  const Path& way = path();
  const Grid& grid = *coarse_;
  const double cell = grid.spec().cell;
  Point found{place_, done_, false};
  Vec3 from = place_;
  double before = done_;
  for (std::int32_t leg = leg_; leg + 1 < way.raw_count && before <= done_ + spec_.ahead; ++leg) {
    const Vec3 along = way.raw[leg + 1] - from;
    const double size = length(along);
    const std::int32_t steps = ceil_index(size / (kLookStep * cell), 1, 4 * kMaxDimension);
    for (std::int32_t k = 1; k <= steps; ++k) {
      const double part = static_cast<double>(k) / steps;
      const Point next{k < steps ? from + part * along : way.raw[leg + 1], before + part * size,
                       leg + 2 == way.raw_count && k == steps};
      if (next.way > done_ + spec_.ahead) return found;
      work_.spend(ops::kPiece + sight_operations(grid, place_, next.place));
      if (next.way <= done_ + kLeast * cell || line_of_sight(grid, place_, next.place)) found = next;
    }
    before += size;
    from = way.raw[leg + 1];
  }
  return found;
}

/// True if there is a new one.
bool FarWay::choose_near_goal() noexcept {
  const double cell = coarse_->spec().cell;
  if (is_last_ || (near_at_ > 0.0 && done_ < looked_ + kLookStep * cell)) return false;
  looked_ = done_;
  const Point found = furthest_in_sight();
  if (found.is_end) return lead_to_goal(FarState::kLeads);
  if (near_at_ > 0.0 && found.way < near_at_ + kFurther * cell) return false;
  near_at_ = found.way;
  near_goal_ = coarse_->spec().origin + found.place;
  return true;
}

}  // namespace tern
