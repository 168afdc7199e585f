// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// A depth image: checks it, places its view in the window, and enters its hits and misses into the map.
#include "base/capacity.hpp"
#include "base/math.hpp"
#include "base/work.hpp"
#include "map/evidence.hpp"
#include "map/grid_words.hpp"
#include "map/map_state.hpp"

namespace tern {
namespace {

constexpr double kNormTolerance = 1e-3;
/// The cubes that the first part of a scan's view divides: the first half of a brick.
constexpr CubeBits kFirstHalf = 0x0f;
/// Largest tangent of a ray.
constexpr double kMaxTangent = 100.0;

/// The camera's axes in the world, from a unit quaternion: the columns of its rotation matrix.
void axes_of(const double (&q)[4], Vec3 (&axes)[3]) {
  const double w = q[0];
  const double x = q[1];
  const double y = q[2];
  const double z = q[3];
  axes[0] = {1.0 - 2.0 * (y * y + z * z), 2.0 * (x * y + w * z), 2.0 * (x * z - w * y)};
  axes[1] = {2.0 * (x * y - w * z), 1.0 - 2.0 * (x * x + z * z), 2.0 * (y * z + w * x)};
  axes[2] = {2.0 * (x * z + w * y), 2.0 * (y * z - w * x), 1.0 - 2.0 * (x * x + y * y)};
}

/// Normalises a quaternion whose norm is nearly 1.
bool normalise(const double (&given)[4], double (&unit)[4]) {
  const double square = (given[0] * given[0] + given[1] * given[1]) + (given[2] * given[2] + given[3] * given[3]);
  if (!finite(square)) return false;
  const double norm = square_root(square);
  if (absolute(norm - 1.0) > kNormTolerance) return false;
  for (int k = 0; k < 4; ++k) unit[k] = given[k] / norm;
  return true;
}

bool numbers_are_finite(const DepthView& view) {
  return finite(view.fx) && finite(view.fy) && finite(view.cx) && finite(view.cy) && finite(view.scale) &&
         finite(view.min) && finite(view.max) && finite(view.no_return);
}

/// The larger of the tangents of the rays through the image's two edges on one axis.
double tangent(double focal, double center, std::int32_t count) {
  return larger(absolute(-0.5 - center), absolute(count - 0.5 - center)) / focal;
}

bool optics_fit(const DepthView& view) {
  if (!(view.fx > 0.0) || !(view.fy > 0.0) || !(view.scale > 0.0) || !(view.min >= 0.0) || !(view.min < view.max)) {
    return false;
  }
  if (!(view.no_return >= 0.0)) return false;
  return tangent(view.fx, view.cx, view.width) <= kMaxTangent && tangent(view.fy, view.cy, view.height) <= kMaxTangent;
}

Status check_image(const MapState& state, const DepthView& view) {
  if ((view.z16 == nullptr) == (view.z32 == nullptr)) return Status::kInvalidArgument;
  if (view.width < 1 || view.height < 1 || view.stride < view.width) return Status::kCameraInvalid;
  if (!numbers_are_finite(view) || !optics_fit(view)) return Status::kCameraInvalid;
  if (is_full(std::int64_t{view.width} * view.height > state.spec.pixels)) return Status::kPixelsFull;
  if (DepthPyramid::entries(view.width, view.height) > state.image_entries) return Status::kPixelsFull;
  return Status::kOk;
}

/// The view of a camera image, in the window's frame.
View view_of(const MapState& state, const DepthView& image, const Vec3 (&axes)[3], const Vec3& origin) {
  View view{};
  place(view, axes, origin, state.spec.cell);
  view.fx = image.fx;
  view.fy = image.fy;
  view.cx = image.cx;
  view.cy = image.cy;
  view.width = image.width;
  view.height = image.height;
  view.growth = state.spec.pose_margin;
  // A point at depth z is at most z * sqrt(1 + across^2 + down^2) away from the camera. An angular error turns the
  // point around the camera.
  const double across = tangent(image.fx, image.cx, image.width);
  const double down = tangent(image.fy, image.cy, image.height);
  view.growth_ahead = state.spec.angle_margin * square_root(1.0 + across * across + down * down);
  view.units = kDepthUnits / state.spec.range;
  view.pyramid = DepthPyramid(image.width, image.height, state.image);
  return view;
}

}  // namespace

Status check_sensor(const MapState& state, const Vec3& position, std::int64_t t) noexcept {
  if (state.task != Task::kIdle) return Status::kInvalidArgument;
  if (state.lateness(t) > std::uint64_t{kMaxFrameDelay}) return Status::kClockBehind;
  if (!finite(position)) return Status::kNonFiniteInput;
  return state.route.inside(state.route.voxel_of(state.route.to_local(position))) ? Status::kOk : Status::kOutOfMap;
}

std::uint64_t MapState::lateness(std::int64_t t) const noexcept {
  // The difference may not fit into 63 bits; unsigned, it is exact.
  return timed && t < time ? static_cast<std::uint64_t>(time) - static_cast<std::uint64_t>(t) : 0;
}

void MapState::age_to(std::int64_t t) noexcept {
  frame.time = t;
  frame.late = lateness(t) > 0;
  const bool passes = timed && !frame.late;
  const std::uint64_t since = passes ? static_cast<std::uint64_t>(t) - static_cast<std::uint64_t>(time) : 0;
  if (!frame.late) time = t;
  timed = true;
  ++frames;
  frame.forgotten[0] = frame.forgotten[1] = {0, 0};
  if (spec.age == 0) return;
  const std::int32_t count = layers();
  ageing += (since < static_cast<std::uint64_t>(spec.age) ? static_cast<std::int64_t>(since) : spec.age) * count;
  const std::int64_t due = ageing / spec.age;
  ageing %= spec.age;
  const std::int32_t layers_due = due < count ? static_cast<std::int32_t>(due) : count;
  const std::int32_t end = forget + layers_due;
  frame.forgotten[0] = {forget, end < count ? end : count};
  frame.forgotten[1] = {0, end - count};
  forget = end % count;
}

bool MapState::forgets(std::int32_t layer) const noexcept {
  const IndexRange* f = frame.forgotten;
  return contains(f[0], layer) || contains(f[1], layer);
}

Status RollingMap::begin_frame(const DepthView& view, const Pose& pose, int64_t t) noexcept {
  if (state_ == nullptr) return Status::kInvalidArgument;
  const Status sensor = check_sensor(*state_, pose.position, t);
  if (sensor != Status::kOk) return sensor;
  double quaternion[4];
  if (!normalise(pose.quaternion, quaternion)) return Status::kPoseInvalid;
  const Status image = check_image(*state_, view);
  if (image != Status::kOk) return image;
  Vec3 axes[3];
  axes_of(quaternion, axes);
  Frame& frame = state_->frame;
  frame.image = view;
  frame.origin = state_->route.to_local(pose.position);
  frame.views[0] = view_of(*state_, view, axes, frame.origin);
  frame.view_count = 1;
  frame.box = reach(frame.views[0], state_->spec.range, state_->route.spec());
  state_->prepare_views();
  state_->age_to(t);
  state_->begin(Task::kPixels);
  return Status::kRunning;
}

void MapState::make_pyramid_row(std::int64_t index, Work& work) noexcept {
  // All views of a frame have the same size.
  const std::int64_t per_view = pieces() / frame.view_count;
  const DepthPyramid& pyramid = frame.views[index / per_view].pyramid;
  std::int64_t row = index % per_view;
  std::int32_t level = 1;
  while (level + 1 < pyramid.levels() && row >= pyramid.height(level)) row -= pyramid.height(level++);
  pyramid.make_row(level, static_cast<std::int32_t>(row));
  work.spend(ops::kPiece + (ops::kTurn + ops::kMultiplyAdd) * pyramid.width(level));
}

VoxelBox MapState::brick_at(std::int64_t index) const noexcept {
  const std::int32_t bricks_y = (spec.dims.y + kBrick - 1) / kBrick;
  const std::int32_t x = static_cast<std::int32_t>(index % row_words()) * 64;
  const std::int32_t y = static_cast<std::int32_t>(index / row_words() % bricks_y) * kBrick;
  const std::int32_t z = static_cast<std::int32_t>(index / row_words() / bricks_y) * kBrick;
  VoxelBox brick{{x, x + 64}, overlap({y, y + kBrick}, {0, spec.dims.y}), overlap({z, z + kBrick}, {0, spec.dims.z})};
  if (forgets(z / kBrick)) return brick;
  const bool met = meets(brick.x, frame.box.x) && meets(brick.y, frame.box.y) && meets(brick.z, frame.box.z);
  if (!met) brick.x.end = brick.x.begin;
  return brick;
}

void MapState::store(std::int32_t y, std::int32_t z, std::int32_t k, std::uint64_t blocked) noexcept {
  const std::uint64_t unseen = ~seen[row(y, z) + static_cast<std::size_t>(k)] & GridWords::valid_bits(route, k);
  const std::uint64_t solid = blocked | unseen;
  if ((solid & ~GridWords(safe).obstacles()[row(y, z) + static_cast<std::size_t>(k)]) != 0) note_added(y, z, k);
  GridWords(route).store(y, z, k, blocked);
  GridWords(safe).store(y, z, k, solid);
}

/// Extends `added` by word k of row (y, z), all of whose 64 voxels count as added.
void MapState::note_added(std::int32_t y, std::int32_t z, std::int32_t k) noexcept {
  const VoxelBox word{{kWordBits * k, kWordBits * (k + 1)}, {y, y + 1}, {z, z + 1}};
  if (added.x.begin >= added.x.end) added = word;
  const auto grow = [](IndexRange& range, const IndexRange& by) {
    range = {by.begin < range.begin ? by.begin : range.begin, by.end > range.end ? by.end : range.end};
  };
  grow(added.x, word.x);
  grow(added.y, word.y);
  grow(added.z, word.z);
}

void MapState::prepare_views() noexcept {
  // The camera and the voxels are in the window, or at most a brick outside it.
  const double extent = 2.0 * spec.cell * (spec.dims.x + spec.dims.y + spec.dims.z + 128);
  for (int v = 0; v < frame.view_count; ++v) frame.projectors[v] = Projector(frame.views[v], extent);
}

Evidence MapState::evidence_at(std::size_t word, bool forgotten) const noexcept {
  return {forgotten ? 0 : seen[word], low[word], high[word], route.obstacle_row(0, 0)[word]};
}

void MapState::want_brick(const VoxelBox& brick, std::int64_t latest_hit) noexcept {
  const std::int32_t k = brick.x.begin / 64;
  const std::uint64_t valid = GridWords::valid_bits(route, k);
  const bool forget_first = forgets(brick.z.begin / kBrick);
  frame.clears = !frame.late || (frame.time >= marked && frame.time >= latest_hit);
  frame.wanted = frame.free = BrickWords{};
  for (std::int32_t z = brick.z.begin; z < brick.z.end; ++z) {
    for (std::int32_t y = brick.y.begin; y < brick.y.end; ++y) {
      const std::size_t at = row(y, z) + static_cast<std::size_t>(k);
      const Evidence now = evidence_at(at, forget_first);
      const std::uint64_t open = frame.clears ? open_to_misses(now) : open_to_sight(now);
      frame.wanted.words[z - brick.z.begin][y - brick.y.begin] = open & ~hit[at] & valid;
    }
  }
}

void MapState::enter_brick(const VoxelBox& brick, std::int64_t& latest_hit, Work& work) noexcept {
  const std::int32_t k = brick.x.begin / 64;
  const std::uint64_t valid = GridWords::valid_bits(route, k);
  const bool forget_first = forgets(brick.z.begin / kBrick);
  const Threshold hits(spec.hits);
  const Threshold misses(spec.misses);
  bool any_hit = false;
  int entered = 0;
  for (std::int32_t z = brick.z.begin; z < brick.z.end; ++z) {
    for (std::int32_t y = brick.y.begin; y < brick.y.end; ++y) {
      const std::size_t at = row(y, z) + static_cast<std::size_t>(k);
      const std::uint64_t wanted = frame.clears ? valid : frame.wanted.words[z - brick.z.begin][y - brick.y.begin];
      const std::uint64_t miss = frame.free.words[z - brick.z.begin][y - brick.y.begin] & wanted;
      any_hit = any_hit || hit[at] != 0;
      if (miss == 0 && hit[at] == 0 && !forget_first) continue;
      const Evidence now = after(evidence_at(at, forget_first), hit[at], miss, hits, misses);
      if ((now.seen & ~seen[at]) != 0) ++learned;
      seen[at] = now.seen;
      low[at] = now.low;
      high[at] = now.high;
      hit[at] = 0;
      store(y, z, k, now.blocked);
      ++entered;
    }
  }
  if (any_hit && latest_hit < frame.time) latest_hit = frame.time;
  // Each word is read twice, with its evidence in four layers; one that changes is written in seven.
  work.spend(ops::kWord * (8 * kBrick * kBrick + 18 * entered));
}

void MapState::carve_brick(std::int64_t index, Work& work) noexcept {
  const VoxelBox brick = brick_at(index);
  work.spend(ops::kPiece);
  if (brick.x.begin >= brick.x.end) return;
  std::int64_t& latest_hit = hit_times[index];
  if (frame.part == 0) want_brick(brick, latest_hit);
  const int parts = frame.parts_of_view();
  const Voxel first{brick.x.begin, brick.y.begin, brick.z.begin};
  int view = frame.part / parts;
  const bool begins = frame.part == view * parts;
  while (begins && view < frame.view_count && misses(frame.views[view], frame.projectors[view], first)) ++view;
  work.spend(kMissesOperations * (view + 1));
  if (begins) frame.part = view * parts;
  if (view < frame.view_count) {
    const CarvePart part{begins, begins && parts > 1 ? kFirstHalf : kAllCubes};
    carve(frame.views[view], frame.projectors[view], first, frame.wanted, frame.free, part, frame.left, work);
    frame.part = frame.left != 0 ? frame.part + 1 : (view + 1) * parts;  // usually, no cube is left for a second part
  }
  if (frame.part < frame.view_count * parts) return;
  frame.part = 0;
  enter_brick(brick, latest_hit, work);
}

}  // namespace tern
