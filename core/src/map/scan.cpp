// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// A scan. Its points are sorted into images on the six faces of a cube around the sensor. These images are then used
// like that of a camera.
#include "base/math.hpp"
#include "base/work.hpp"
#include "map/map_state.hpp"

namespace tern {
namespace {

/// Points of a piece.
constexpr std::size_t kPiecePoints = 64;
/// Instructions of a piece of points; of a row of a face, and a pixel of it.
constexpr std::uint32_t kPointsEffort = 13500;
constexpr std::uint32_t kFaceRowEffort = 120;
constexpr std::uint32_t kFacePixelEffort = 3;
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

/// The vectors from the sensor to four points, and what they mean. Single precision is enough: depths are rounded
/// towards the sensor, and a point is off by less than a ten thousandth of a pixel.
struct FourRays {
  Four axes[3];
  Four free;      ///< the part of each vector that is certainly free, as a factor
  FourInts hits;  ///< not 0 if the point is within the range
};

/// Points further than this away are skipped, like those that are not finite. Their squares still have finite sums.
constexpr double kFarthest = 1e18;

/// The vector from the sensor to a point; 0 if the point is skipped.
Vec3 ray_to(const Vec3& point, const Vec3& origin) {
  const Vec3 ray = point - origin;
  const bool near = absolute(ray.x) < kFarthest && absolute(ray.y) < kFarthest && absolute(ray.z) < kFarthest;
  return near ? ray : kZero;
}

/// The vectors from the sensor to the points of a piece, axis by axis. A piece that is not full ends in zeros.
struct PieceOfRays {
  Four fours[3][kPiecePoints / 4];

  PieceOfRays(const Vec3* points, std::size_t count, const Vec3& origin) {
    float* numbers[3];
    for (int a = 0; a < 3; ++a) numbers[a] = reinterpret_cast<float*>(fours[a]);
    for (std::size_t k = 0; k < kPiecePoints; ++k) {
      const Vec3 ray = k < count ? ray_to(points[k], origin) : kZero;
      for (int a = 0; a < 3; ++a) numbers[a][k] = static_cast<float>(axis(ray, a));
    }
  }
  FourRays four(std::size_t k) const { return {{fours[0][k], fours[1][k], fours[2][k]}, all(0.0f), FourInts{}}; }
};

/// Finds out how far the rays are free. A point beyond the range shows that the ray is free up to the range.
void set_free(FourRays& rays, const MapSpec& spec) {
  const Four* r = rays.axes;
  const Four square = r[0] * r[0] + r[1] * r[1] + r[2] * r[2];
  const Four far = square_root(square);
  const float range = static_cast<float>(spec.range);
  const Four margin = static_cast<float>(spec.depth_margin) + static_cast<float>(spec.depth_margin_square) * square;
  const Four least = far - margin;
  rays.free = (least < range ? least : all(range)) / far;
  rays.hits = (far > 0.0f) & (far <= range);
}

/// What a ray shows in a face: a pixel, and the depth up to which it is free.
struct FourPixels {
  FourInts u, v, depth;
};

/// The pixels of four rays in the two faces across one axis. Beside these faces, the depth is that of no point.
FourPixels pixels_across(const FourRays& rays, int a, const View& face) {
  const Four ahead = absolute(rays.axes[a]);
  const Four across = rays.axes[(a + 1) % 3];
  const Four down = rays.axes[(a + 2) % 3];
  const Four widest = static_cast<float>(kFaceTangent) * ahead;
  const FourInts within = (absolute(across) < widest) & (absolute(down) < widest);
  const Four scale = static_cast<float>(face.fx) / (ahead > 0.0f ? ahead : all(1.0f));
  const float middle = static_cast<float>(face.cx + 0.5);
  const float last = static_cast<float>(face.width) - 0.5f;
  const Four units = ahead * rays.free * static_cast<float>(face.units) - 1.0f;
  const FourInts depth = whole(clamp(units, 0.0f, static_cast<float>(kDepthUnits)));
  return {whole(clamp(across * scale + middle, 0.0f, last)), whole(clamp(down * scale + middle, 0.0f, last)),
          within ? depth : FourInts{kNoPoint, kNoPoint, kNoPoint, kNoPoint}};
}

/// Lowers the depths of the pixels that four rays fall into, on each face that they meet.
void lower(const Frame& frame, const FourRays& rays) {
  for (int a = 0; a < 3; ++a) {
    const FourPixels pixels = pixels_across(rays, a, frame.views[0]);
    for (int k = 0; k < 4; ++k) {
      const DepthPyramid& face = frame.views[2 * a + (rays.axes[a][k] > 0.0f ? 0 : 1)].pyramid;
      Depth& least = face.row(pixels.v[k])[pixels.u[k]];
      const Depth depth = static_cast<Depth>(pixels.depth[k]);
      least = depth < least ? depth : least;
    }
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

std::uint32_t MapState::clear_face_row(std::int32_t index) noexcept {
  Depth* row = frame.views[index / face].pyramid.row(index % face);
  for (std::int32_t u = 0; u < face; ++u) row[u] = kNoPoint;
  return kFaceRowEffort + effort_of(kFacePixelEffort, face);
}

std::uint32_t MapState::close_face_row(std::int32_t index) noexcept {
  Depth* row = frame.views[index / face].pyramid.row(index % face);
  for (std::int32_t u = 0; u < face; ++u) row[u] = row[u] == kNoPoint ? Depth{0} : row[u];
  return kFaceRowEffort + effort_of(kFacePixelEffort, face);
}

std::uint32_t MapState::read_points(std::int64_t index) const noexcept {
  const std::size_t begin = static_cast<std::size_t>(index) * kPiecePoints;
  const std::size_t left = frame.point_count - begin;
  const std::size_t count = left < kPiecePoints ? left : kPiecePoints;
  const float per_cell = static_cast<float>(1.0 / spec.cell);
  const Vec3 from = (1.0 / spec.cell) * frame.origin;
  HitWriter writer = hit_writer();
  const PieceOfRays piece_of_rays(frame.points + begin, count, frame.world_origin);
  for (std::size_t k = 0; k < kPiecePoints / 4; ++k) {
    FourRays rays = piece_of_rays.four(k);
    set_free(rays, spec);
    lower(frame, rays);
    Four cells[3];
    for (int a = 0; a < 3; ++a) cells[a] = static_cast<float>(axis(from, a)) + per_cell * rays.axes[a];
    writer.add(cells, rays.hits);
  }
  return kPointsEffort;
}

}  // namespace tern
