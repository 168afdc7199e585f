// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// A map's jobs, task by task and piece by piece.
#include "base/math.hpp"
#include "inflation/patch_maker.hpp"
#include "map/grid_words.hpp"
#include "map/map_state.hpp"

namespace tern {
namespace {

/// The most tasks of a job.
constexpr int kTasks = 9;
/// Rows of all coarser levels of all views. One piece makes one row.
std::int64_t pyramid_rows(const Frame& frame) {
  std::int64_t rows = 0;
  const DepthPyramid& pyramid = frame.views[0].pyramid;
  for (std::int32_t level = 1; level < pyramid.levels(); ++level) rows += pyramid.height(level);
  return rows * frame.view_count;
}

bool touches(const VoxelBox& box) {
  return box.x.begin < box.x.end && box.y.begin < box.y.end && box.z.begin < box.z.end;
}

Task task_after(Task task) {
  switch (task) {
    case Task::kClearFaces:
      return Task::kPoints;
    case Task::kPoints:
      return Task::kCloseFaces;
    case Task::kPixels:
    case Task::kCloseFaces:
      return Task::kExplain;
    case Task::kExplain:
      return Task::kPyramids;
    case Task::kPyramids:
      return Task::kBricks;
    case Task::kBricks:
    case Task::kSlide:
      return Task::kInflateRoute;
    case Task::kInflateRoute:
      return Task::kInflateSafe;
    case Task::kIdle:
    case Task::kInflateSafe:
    case Task::kCopy:
      break;
  }
  return Task::kIdle;
}

/// The most operations of the bricks of a frame.
Operations bricks_operations(const MapState& state, bool around) {
  const Operations brick = ops::kPiece + (around ? kFaces * 2 : 1) * (ops::kPiece + carve_operations(around)) +
                           ops::kWord * 26 * kBrick * kBrick;
  return brick * static_cast<Operations>(brick_count(state.spec.dims));
}

/// The most operations of a slide or a snapshot, without inflations.
Operations slide_operations(const MapState& state) {
  const MapSpec& spec = state.spec;
  const Operations prior = spec.prior_count + spec.prior_cylinder_count;
  const Operations words = static_cast<Operations>(state.row(0, 1));
  const Operations plane = state.moved_operations(false) + (ops::kPiece + kMarkOperations * words) * prior +
                           state.renewed_operations() * spec.dims.y;
  return plane * spec.dims.z;
}

std::uint32_t units(Operations operations) {
  return static_cast<std::uint32_t>((operations + kUnit - 1) / kUnit);
}

}  // namespace

std::int64_t MapState::pieces() const noexcept {
  switch (task) {
    case Task::kIdle:
      return 0;
    case Task::kPixels:
      return frame.image.height;
    case Task::kClearFaces:
    case Task::kCloseFaces:
      return kFaces * face;
    case Task::kPoints:
      return static_cast<std::int64_t>((frame.point_count + 63) / 64);
    case Task::kExplain:
      return things.count;
    case Task::kPyramids:
      return pyramid_rows(frame);
    case Task::kBricks:
      return static_cast<std::int64_t>(brick_count(spec.dims));
    case Task::kInflateRoute:
    case Task::kInflateSafe:
      return GridWords::inflation_pieces(spec.dims);
    case Task::kSlide:
    case Task::kCopy:
      return spec.dims.z;
  }
  return 0;
}

// One line a task: a table.
// clang-format off
void MapState::do_piece(Work& work) noexcept {
  const std::int32_t index = static_cast<std::int32_t>(piece);
  switch (task) {
    case Task::kIdle: return;
    case Task::kPixels: return read_pixels(index, work);
    case Task::kClearFaces: return clear_face_row(index, work);
    case Task::kPoints: return read_points(piece, work);
    case Task::kCloseFaces: return close_face_row(index, work);
    case Task::kExplain: return explain_hits(piece, work);
    case Task::kPyramids: return make_pyramid_row(index, work);
    case Task::kBricks: return carve_brick(piece, work);
    case Task::kInflateRoute: return GridWords(route).inflate_piece(index, work);
    case Task::kInflateSafe: return GridWords(safe).inflate_piece(index, work);
    case Task::kSlide: return slide_plane(index, work);
    case Task::kCopy: return copy_plane(index, work);
  }
}
// clang-format on

void MapState::begin(Task first) noexcept {
  task = first;
  piece = 0;
  frame.part = 0;
  for (int skipped = 0; skipped < kTasks && task != Task::kIdle && pieces() == 0; ++skipped) task = task_after(task);
}

Progress MapState::advance(Work& work) noexcept {
  while (task != Task::kIdle) {
    if (!work.left()) return Progress::kMore;
    do_piece(work);
    // A brick may take several pieces.
    if (frame.part == 0 && ++piece >= pieces()) begin(task_after(task));
  }
  return Progress::kDone;
}

Status RollingMap::step(Work& work) noexcept {
  if (state_ == nullptr) return Status::kInvalidArgument;
  return state_->advance(work) == Progress::kMore ? Status::kRunning : Status::kOk;
}

Status RollingMap::step(uint32_t work) noexcept {
  if (state_ == nullptr) return Status::kInvalidArgument;
  state_->slice.add(work);
  const Status status = step(state_->slice);
  if (status == Status::kOk) state_->slice = Work{};
  return status;
}

bool RollingMap::busy() const noexcept {
  return state_ != nullptr && state_->task != Task::kIdle;
}

uint32_t RollingMap::frame_work(int32_t width, int32_t height) const noexcept {
  if (state_ == nullptr || width < 1 || height < 1) return 0;
  // Together, the coarser levels have at most `height` rows and a few more.
  const Operations image = state_->pixels_operations(width) * (2 * height + 16);
  return units(image + bricks_operations(*state_, false) + 2 * inflation_operations(state_->route));
}

uint32_t RollingMap::scan_work(size_t count) const noexcept {
  if (state_ == nullptr) return 0;
  const Operations pieces = static_cast<Operations>(count / kPiecePoints + 1);
  const Operations rows = kFaces * (4 * state_->face + 16);
  const Operations faces = rows * (ops::kPiece + (ops::kTurn + ops::kMultiplyAdd) * state_->face);
  return units(pieces * kPointsOperations + faces + bricks_operations(*state_, true) + slide_operations(*state_) +
               2 * inflation_operations(state_->route));
}

const Grid& RollingMap::route() const noexcept {
  return state_->route;
}
const Grid& RollingMap::safe() const noexcept {
  return state_->safe;
}

uint64_t RollingMap::learned() const noexcept {
  return state_ == nullptr ? 0 : state_->learned;
}

uint64_t RollingMap::frames() const noexcept {
  return state_ == nullptr ? 0 : state_->frames;
}

uint64_t RollingMap::revision() const noexcept {
  return state_ == nullptr ? 0 : state_->route.revision() + state_->safe.revision();
}

bool RollingMap::take_added(Box& world) noexcept {
  if (state_ == nullptr || busy() || !touches(state_->added)) return false;
  const GridSpec& window = state_->safe.spec();
  const VoxelBox& box = state_->added;
  world.lower = window.origin + window.cell * Vec3{1.0 * box.x.begin, 1.0 * box.y.begin, 1.0 * box.z.begin};
  world.upper = window.origin + window.cell * Vec3{1.0 * box.x.end, 1.0 * box.y.end, 1.0 * box.z.end};
  state_->added = VoxelBox{};
  return true;
}

void MapState::forget_times() noexcept {
  timed = false;
  marked = kNever;
  frame.time = kNever;  // of a frame that is being entered
  for (std::size_t k = 0; k < brick_count(spec.dims); ++k) hit_times[k] = kNever;
}

Status RollingMap::forget_time() noexcept {
  if (state_ == nullptr) return Status::kInvalidArgument;
  state_->forget_times();
  return Status::kOk;
}

const MapSpec& RollingMap::spec() const noexcept {
  return state_->spec;
}

const uint64_t* RollingMap::seen_rows() const noexcept {
  return state_ == nullptr ? nullptr : state_->seen;
}

bool RollingMap::seen(const Voxel& voxel) const noexcept {
  if (state_ == nullptr || !state_->route.inside(voxel)) return false;
  return (state_->seen[state_->row(voxel.y, voxel.z) + static_cast<std::size_t>(voxel.x >> 6)] >> (voxel.x & 63) & 1) !=
         0;
}

}  // namespace tern
