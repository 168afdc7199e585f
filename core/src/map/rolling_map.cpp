// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// A map's jobs, task by task and piece by piece.
#include "base/math.hpp"
#include "grid/regions.hpp"
#include "map/grid_words.hpp"
#include "map/map_state.hpp"

namespace tern {
namespace {

/// The most tasks of a job.
constexpr int kTasks = 8;
/// Words that one unit inflates or moves.
constexpr std::size_t kUnitWords = 16;
/// Rows of all coarser levels of all views. One piece makes one row.
std::int64_t pyramid_rows(const Frame& frame) {
  std::int64_t rows = 0;
  const DepthPyramid& pyramid = frame.views[0].pyramid;
  for (std::int32_t level = 1; level < pyramid.levels(); ++level) rows += pyramid.height(level);
  return rows * frame.view_count;
}

std::uint32_t units(std::size_t amount, std::size_t per_unit) {
  return static_cast<std::uint32_t>((amount + per_unit - 1) / per_unit);
}

std::size_t blocks(const MapState& state) {
  return static_cast<std::size_t>(state.row_words()) *
         static_cast<std::size_t>((state.spec.dims.y + kBlock - 1) / kBlock) * static_cast<std::size_t>(state.layers());
}

std::uint32_t plane_units(const MapState& state) {
  return units(state.row(0, 1), kUnitWords);
}

/// Units of a piece of an inflation.
std::uint32_t inflation_price(const MapState& state) {
  const std::int32_t rows = state.spec.dims.y < kBlockRows ? state.spec.dims.y : kBlockRows;
  return units(state.row(rows, 0) * kInflatedPlanes, kUnitWords);
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
      return Task::kPyramids;
    case Task::kPyramids:
      return Task::kBlocks;
    case Task::kBlocks:
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

/// Units for moving a plane and going through the prior.
std::uint32_t slide_price(const MapState& state) {
  const std::size_t prior =
      static_cast<std::size_t>(state.spec.prior_count) + static_cast<std::size_t>(state.spec.prior_cylinder_count);
  return plane_units(state) + units(prior, kUnitWords);
}

/// Units of the next part of a block; the parts share the units of the block.
std::uint32_t part_price(const Frame& frame) {
  const int parts = frame.view_count * frame.parts_of_view();
  const int before = kBlock * kBlock * frame.part / parts;
  return static_cast<std::uint32_t>(kBlock * kBlock * (frame.part + 1) / parts - before);
}

/// Units of all blocks, both inflations and one slide.
std::uint32_t grids_work(const MapState& state) {
  const std::uint32_t planes =
      static_cast<std::uint32_t>(GridWords::inflation_pieces(state.spec.dims)) * inflation_price(state);
  const std::uint32_t slide = static_cast<std::uint32_t>(state.spec.dims.z) * slide_price(state);
  return static_cast<std::uint32_t>(blocks(state)) * kBlock * kBlock + 2 * planes + slide;
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
    case Task::kPyramids:
      return pyramid_rows(frame);
    case Task::kBlocks:
      return static_cast<std::int64_t>(blocks(*this));
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
std::uint32_t MapState::do_piece() noexcept {
  const std::int32_t index = static_cast<std::int32_t>(piece);
  switch (task) {
    case Task::kIdle: return 0;
    case Task::kPixels: return read_pixels(index);
    case Task::kClearFaces: return clear_face_row(index);
    case Task::kPoints: return read_points(piece);
    case Task::kCloseFaces: return close_face_row(index);
    case Task::kPyramids: return make_pyramid_row(index);
    case Task::kBlocks: return carve_block(piece);
    case Task::kInflateRoute: return GridWords(route).inflate_piece(index);
    case Task::kInflateSafe: return GridWords(safe).inflate_piece(index);
    case Task::kSlide: return slide_plane(index);
    case Task::kCopy: return copy_plane(index);
  }
  return 0;
}
// clang-format on

void MapState::begin(Task first) noexcept {
  task = first;
  piece = 0;
  paid = 0;
  frame.part = 0;
  for (int skipped = 0; skipped < kTasks && task != Task::kIdle && pieces() == 0; ++skipped) task = task_after(task);
}

std::uint32_t MapState::advance() noexcept {
  const std::uint32_t effort = do_piece();
  if (frame.part > 0) return effort;  // the block is not done yet
  if (++piece >= pieces()) begin(task_after(task));
  return effort;
}

std::uint32_t MapState::price() const noexcept {
  switch (task) {
    case Task::kIdle:
    case Task::kPoints:
      return 1;
    case Task::kPixels:
    case Task::kPyramids:
      return units(static_cast<std::size_t>(frame.views[0].width), 64);
    case Task::kClearFaces:
    case Task::kCloseFaces:
      return units(static_cast<std::size_t>(face), 64);
    case Task::kBlocks:
      return frame.part > 0 || touches(block_at(piece)) ? part_price(frame) : 1;
    case Task::kInflateRoute:
    case Task::kInflateSafe:
      return inflation_price(*this);
    case Task::kSlide:
      return slide_price(*this);
    case Task::kCopy:
      return plane_units(*this);
  }
  return 1;
}

Status RollingMap::step(uint32_t work) noexcept {
  if (state_ == nullptr) return Status::kInvalidArgument;
  MapState& state = *state_;
  Work slice{work};
  while (state.task != Task::kIdle) {
    const std::uint32_t price = state.price();
    const std::uint32_t given = least(slice.left, price - state.paid);
    slice.left -= given;
    state.paid += given;
    if (state.paid < price) return Status::kRunning;
    state.paid = 0;
    state.advance();
  }
  return Status::kOk;
}

bool RollingMap::busy() const noexcept {
  return state_ != nullptr && state_->task != Task::kIdle;
}

uint32_t RollingMap::frame_work(int32_t width, int32_t height) const noexcept {
  if (state_ == nullptr || width < 1 || height < 1) return 0;
  // Together, the coarser levels have at most `height` rows and a few more.
  const std::uint32_t image = units(static_cast<std::size_t>(width), 64) * static_cast<std::uint32_t>(2 * height + 16);
  return image + grids_work(*state_);
}

uint32_t RollingMap::scan_work(size_t count) const noexcept {
  if (state_ == nullptr) return 0;
  const std::uint32_t face = static_cast<std::uint32_t>(state_->face);
  const std::uint32_t rows = kFaces * (4 * face + 16);
  return units(count, 64) + rows * units(face, 64) + grids_work(*state_);
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

int32_t RollingMap::slack() const noexcept {
  return state_ == nullptr ? 0 : state_->spec.slack;
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
