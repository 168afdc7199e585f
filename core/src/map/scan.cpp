// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// A scan. Its points are sorted into images on the six faces of a cube around the sensor. These images are then used
// like that of a camera.
#include "base/math.hpp"
#include "map/map_state.hpp"

namespace tern {
namespace {

/// Points of a piece.
constexpr std::size_t kPiecePoints = 64;
/// The depth of a pixel into which no point has fallen.
constexpr Depth kNoPoint = 32767;

/// The view of face f looks along axis f / 2, in its positive direction if f is even. The image's axes are the next two
/// axes.
Vec3 unit(int a) {
  return {a == 0 ? 1.0 : 0.0, a == 1 ? 1.0 : 0.0, a == 2 ? 1.0 : 0.0};
}

View face_view(const MapState& state, int f, const Vec3& origin) {
  View view{};
  const int a = f / 2;
  const Vec3 axes[3] = {unit((a + 1) % 3), unit((a + 2) % 3), (f % 2 == 0 ? 1.0 : -1.0) * unit(a)};
  place(view, axes, origin, state.spec.cell);
  view.width = view.height = state.face;
  view.fx = view.fy = state.face / (2.0 * kFaceTangent);
  view.cx = view.cy = 0.5 * (state.face - 1);
  view.growth = state.spec.pose_margin;
  view.growth_ahead = state.spec.angle_margin * square_root(1.0 + 2.0 * kFaceTangent * kFaceTangent);
  view.units = kDepthUnits / state.spec.range;
  const std::int64_t entries = DepthPyramid::entries(state.face, state.face);
  view.pyramid = DepthPyramid(state.face, state.face, state.image + f * entries);
  return view;
}

/// Lowers the depth of the pixel that a ray falls into, on each face that the ray meets.
void lower(const Frame& frame, const Vec3& ray, double margin) {
  const View& any = frame.views[0];
  for (int a = 0; a < 3; ++a) {
    const double along = axis(ray, a);
    const double ahead = absolute(along);
    const double across = axis(ray, (a + 1) % 3);
    const double down = axis(ray, (a + 2) % 3);
    if (!(absolute(across) < kFaceTangent * ahead && absolute(down) < kFaceTangent * ahead)) continue;
    const double scale = any.fx / ahead;
    const std::int32_t u = floor_index(across * scale + (any.cx + 0.5), 0, any.width - 1);
    const std::int32_t v = floor_index(down * scale + (any.cx + 0.5), 0, any.width - 1);
    // An error along the beam moves the point by at most as much along the axis.
    const Depth depth = static_cast<Depth>(floor_index((ahead - margin) * any.units - 1.0, 0, kDepthUnits));
    Depth& least = frame.views[2 * a + (along > 0.0 ? 0 : 1)].pyramid.row(v)[u];
    if (depth < least) least = depth;
  }
}

/// The window's voxels within the range, plus one more on each side.
VoxelBox ball_box(const Vec3& origin, double range, const GridSpec& window) {
  const auto on = [&](int a) {
    const double cells = axis(origin, a) / window.cell;
    const double reach = range / window.cell + 1.0;
    return IndexRange{floor_index(cells - reach, 0, axis(window.dims, a)),
                      ceil_index(cells + reach, 0, axis(window.dims, a))};
  };
  return {on(0), on(1), on(2)};
}

}  // namespace

std::int32_t face_pixels(const MapSpec& spec) noexcept {
  if (!(spec.scan_pixel >= kMinScanPixel)) return 0;
  return floor_index(2.0 * kFaceTangent / spec.scan_pixel, 3, 4096);
}

Status RollingMap::begin_scan(const Vec3* points, size_t count, const Vec3& origin, int64_t t) noexcept {
  if (state_ == nullptr || state_->face == 0 || (points == nullptr && count > 0)) return Status::kInvalidArgument;
  const Status sensor = check_sensor(*state_, origin, t);
  if (sensor != Status::kOk) return sensor;
  Frame& frame = state_->frame;
  frame.points = points;
  frame.point_count = count;
  frame.world_origin = origin;
  frame.origin = state_->route.to_local(origin);
  frame.view_count = kFaces;
  for (int f = 0; f < kFaces; ++f) frame.views[f] = face_view(*state_, f, frame.origin);
  frame.box = ball_box(frame.origin, state_->spec.range, state_->route.spec());
  state_->prepare_views();
  state_->age_to(t);
  state_->begin(Task::kClearFaces);
  return Status::kRunning;
}

void MapState::clear_face_row(std::int32_t index) noexcept {
  Depth* row = frame.views[index / face].pyramid.row(index % face);
  for (std::int32_t u = 0; u < face; ++u) row[u] = kNoPoint;
}

void MapState::close_face_row(std::int32_t index) noexcept {
  Depth* row = frame.views[index / face].pyramid.row(index % face);
  for (std::int32_t u = 0; u < face; ++u) row[u] = row[u] == kNoPoint ? Depth{0} : row[u];
}

void MapState::read_points(std::int64_t index) const noexcept {
  const std::size_t begin = static_cast<std::size_t>(index) * kPiecePoints;
  const std::size_t left = frame.point_count - begin;
  const std::size_t end = begin + (left < kPiecePoints ? left : kPiecePoints);
  const double per_cell = 1.0 / spec.cell;
  for (std::size_t k = begin; k < end; ++k) {
    if (!finite(frame.points[k])) continue;
    const Vec3 ray = frame.points[k] - frame.world_origin;
    const double far = length(ray);
    if (!finite(far)) continue;
    const double margin = spec.depth_margin + spec.depth_margin_square * far * far;
    if (far > spec.range) {
      lower(frame, (spec.range / far) * ray, margin);
      continue;
    }
    lower(frame, ray, margin);
    const Vec3 cells = per_cell * (frame.origin + ray);
    mark_hit({floor_index(cells.x, -1, spec.dims.x), floor_index(cells.y, -1, spec.dims.y),
              floor_index(cells.z, -1, spec.dims.z)});
  }
}

}  // namespace tern
