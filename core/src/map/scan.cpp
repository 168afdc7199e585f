// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// A scan. Its beams are sorted into images on the six faces of a cube around the sensor. These images are then used
// like that of a camera. docs/map.md has the proof.
#include "base/math.hpp"
#include "base/work.hpp"
#include "map/map_state.hpp"

namespace tern {
namespace {

/// The depth of a pixel into which no beam has fallen.
constexpr Depth kNoPoint = 32767;
/// Outlines are widened by this many pixels, as an angle. No point of a pixel is further than that from a beam in the
/// same pixel. The diagonal of a pixel is at most 1.246 pixels, in the measure of scan_pixel.
constexpr double kReach = 1.25;
/// Between thin beams half a pixel apart, a surface can be nearer to the sensor than the beams show. The difference is
/// at most this part of its distance for each radian of scan_pixel: sqrt(3) times half a diagonal of the beams'
/// lattice.
constexpr double kRelief = 0.6125;

/// Pixels along an edge of a face, times scan_pixel.
constexpr double kScanWidth = 2.5;
/// The most pixels along an edge of a face.
constexpr std::int32_t kMaxFacePixels = 4096;

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
  view.fx = view.fy = state.face / (2.0 * bent(kFaceTangent));
  view.cx = view.cy = 0.5 * (state.face - 1);
  view.growth = state.spec.pose_margin;
  view.growth_ahead = state.spec.angle_margin;
  view.reach = kReach * kScanWidth / state.face;
  view.units = kDepthUnits / state.spec.range;
  const std::int64_t entries = DepthPyramid::entries(state.face, state.face);
  view.pyramid = DepthPyramid(state.face, state.face, state.image + f * entries);
  return view;
}

/// The vectors from the sensor to four points, and the free depth of each ray. Single precision is enough: depths are
/// rounded towards the sensor, and a point is off by less than a ten thousandth of a pixel.
struct FourRays {
  Four axes[3];
  Four returned;   ///< 1 if something sent the beam back, else 0
  Four most;       ///< the most metres that the ray can show as free
  FourInts depth;  ///< depth up to which the ray is certainly free, in units
  FourInts hits;   ///< not 0 if the point is within the range
};

/// Points further away than this are skipped, like points that are not finite. Up to this distance, sums of squares are
/// finite.
constexpr double kFarthest = 1e18;
/// The largest range that is not infinite.
constexpr double kMostFinite = 3.4028234663852886e38;

/// The vector from the sensor to a point; 0 if the point is skipped.
Vec3 ray_to(const Vec3& point, const Vec3& origin) {
  const Vec3 ray = point - origin;
  const bool near = absolute(ray.x) < kFarthest && absolute(ray.y) < kFarthest && absolute(ray.z) < kFarthest;
  return near ? ray : kZero;
}

/// The vectors from the sensor to the points of a piece, axis by axis. A piece that is not full ends in zeros.
class PieceOfRays {
 public:
  PieceOfRays(const Vec3* points, std::size_t count, const Vec3& origin, const MapSpec& spec) {
    for (std::size_t k = 0; k < kPiecePoints; ++k) {
      put(k, k < count ? ray_to(points[k], origin) : kZero, true, spec.range);
    }
  }
  /// Beams from `first` on. Those without a return end beyond the range, where they hit nothing.
  PieceOfRays(const Beams& beams, std::size_t first, std::size_t count, const MapSpec& spec) {
    for (std::size_t k = 0; k < kPiecePoints; ++k) {
      const Vec3 unit = k < count ? unit_of(beams.directions[first + k]) : kZero;
      const double range = k < count ? static_cast<double>(beams.ranges[first + k]) : 0.0;
      const bool none = range > kMostFinite;
      const bool known = none || (range > 0.0 && range < kFarthest && range >= beams.min && range < beams.max);
      const bool returned = known && !none;
      const double most = none ? spec.range * (1.0 - kRelief * spec.scan_pixel) : spec.range;
      put(k, (returned ? range : 2.0 * spec.range) * unit, returned, known ? most : 0.0);
    }
  }
  FourRays four(std::size_t k) const {
    return {{fours_[0][k], fours_[1][k], fours_[2][k]}, fours_[3][k], fours_[4][k], FourInts{}, FourInts{}};
  }

 private:
  /// The direction scaled to length 1; 0 if its length is 0, too small or too large to scale.
  static Vec3 unit_of(const Vec3& direction) {
    const double far = length(direction);
    return far > 1.0 / kFarthest && far < kFarthest ? (1.0 / far) * direction : kZero;
  }
  void put(std::size_t k, const Vec3& ray, bool returned, double most) {
    const double numbers[] = {ray.x, ray.y, ray.z, returned ? 1.0 : 0.0, most};
    for (int a = 0; a < 5; ++a) reinterpret_cast<float*>(fours_[a])[k] = static_cast<float>(numbers[a]);
  }

  Four fours_[5][kPiecePoints / 4];
};

/// Finds out how far the rays are free. A point beyond the range shows that the ray is free up to the range.
void set_free(FourRays& rays, const MapSpec& spec, double units) {
  const Four* r = rays.axes;
  const Four square = r[0] * r[0] + r[1] * r[1] + r[2] * r[2];
  const Four far = square_root(square);
  const Four margin = static_cast<float>(spec.depth_margin) + static_cast<float>(spec.depth_margin_square) * square;
  const Four least = static_cast<float>(1.0 - kRelief * spec.scan_pixel) * far - rays.returned * margin;
  const Four free = smaller(least, rays.most) * static_cast<float>(units) - 1.0f;
  rays.depth = whole(clamp(free, 0.0f, static_cast<float>(kDepthUnits)));
  rays.hits = (rays.returned > 0.0f) & (far > 0.0f) & (far <= static_cast<float>(spec.range));
}

/// Four rays in a face: the pixel of each, and the depth up to which the ray is free.
struct FourPixels {
  FourInts u, v, depth;
};

/// The pixels of four rays in the two faces across one axis. The depth is kNoPoint if the ray misses both faces.
FourPixels pixels_across(const FourRays& rays, int a, const View& face) {
  const Four ahead = absolute(rays.axes[a]);
  const Four across = rays.axes[(a + 1) % 3];
  const Four down = rays.axes[(a + 2) % 3];
  const Four widest = static_cast<float>(kFaceTangent) * ahead;
  const FourInts within = (absolute(across) < widest) & (absolute(down) < widest);
  // t / (1 + bend * |t|), where t = across / ahead, is across / (ahead + bend * |across|).
  const float bend = static_cast<float>(kFaceBend);
  const float scale = static_cast<float>(face.fx);
  const Four some = choose(ahead > 0.0f, ahead, all(1.0f));
  const float middle = static_cast<float>(face.cx + 0.5);
  const float last = static_cast<float>(face.width) - 0.5f;
  const Four u = across / (some + bend * absolute(across)) * scale + middle;
  const Four v = down / (some + bend * absolute(down)) * scale + middle;
  return {whole(clamp(u, 0.0f, last)), whole(clamp(v, 0.0f, last)),
          choose(within, rays.depth, FourInts{kNoPoint, kNoPoint, kNoPoint, kNoPoint})};
}

/// The images of all faces, which have the same size.
struct FaceImages {
  Depth* rows[kFaces];
  float width;  ///< a face has at most 2^24 pixels, whose indices single precision holds exactly

  explicit FaceImages(const Frame& frame) : width(static_cast<float>(frame.views[0].width)) {
    for (int f = 0; f < kFaces; ++f) rows[f] = frame.views[f].pyramid.row(0);
  }
};
static_assert(kMaxFacePixels * kMaxFacePixels <= 1 << 24, "see FaceImages::width");

/// Lowers the depths of the pixels that four rays fall into, on each face that they meet.
void lower(const FaceImages& faces, const View& view, const FourRays& rays) {
  for (int a = 0; a < 3; ++a) {
    const FourPixels pixels = pixels_across(rays, a, view);
    const FourInts index = whole(decimal(pixels.v) * faces.width + decimal(pixels.u));
    const FourInts face = (rays.axes[a] > 0.0f) + (2 * a + 1);
    for (int k = 0; k < 4; ++k) {
      Depth& least = faces.rows[face[k]][index[k]];
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
  return floor_index(kScanWidth / spec.scan_pixel, 3, kMaxFacePixels);
}

void MapState::begin_faces(const Vec3& world_origin, std::int64_t t) noexcept {
  frame.world_origin = world_origin;
  frame.origin = route.to_local(world_origin);
  frame.view_count = kFaces;
  for (int f = 0; f < kFaces; ++f) frame.views[f] = face_view(*this, f, frame.origin);
  frame.box = ball_box(frame.origin, spec.range, route.spec());
  prepare_views();
  age_to(t);
  begin(Task::kClearFaces);
}

Status RollingMap::begin_scan(const Vec3* points, size_t count, const Vec3& origin, int64_t t) noexcept {
  if (state_ == nullptr || state_->face == 0 || (points == nullptr && count > 0)) return Status::kInvalidArgument;
  const Status sensor = check_sensor(*state_, origin, t);
  if (sensor != Status::kOk) return sensor;
  state_->frame.points = points;
  state_->frame.beams = Beams{};
  state_->frame.point_count = count;
  state_->begin_faces(origin, t);
  return Status::kRunning;
}

Status RollingMap::begin_scan(const Beams& beams, const Vec3& origin, int64_t t) noexcept {
  const bool there = beams.count == 0 || (beams.directions != nullptr && beams.ranges != nullptr);
  const bool can_measure = beams.min >= 0.0 && beams.min < beams.max;
  if (state_ == nullptr || state_->face == 0 || !there || !can_measure) return Status::kInvalidArgument;
  const Status sensor = check_sensor(*state_, origin, t);
  if (sensor != Status::kOk) return sensor;
  state_->frame.points = nullptr;
  state_->frame.beams = beams;
  state_->frame.point_count = beams.count;
  state_->begin_faces(origin, t);
  return Status::kRunning;
}

void MapState::clear_face_row(std::int32_t index, Work& work) noexcept {
  work.spend(ops::kPiece + ops::kElement * face);
  Depth* row = frame.views[index / face].pyramid.row(index % face);
  for (std::int32_t u = 0; u < face; ++u) row[u] = kNoPoint;
}

void MapState::close_face_row(std::int32_t index, Work& work) noexcept {
  work.spend(ops::kPiece + ops::kElement * face);
  Depth* row = frame.views[index / face].pyramid.row(index % face);
  for (std::int32_t u = 0; u < face; ++u) row[u] = row[u] == kNoPoint ? Depth{0} : row[u];
}

void MapState::read_points(std::int64_t index, Work& work) const noexcept {
  work.spend(kPointsOperations);
  const std::size_t begin = static_cast<std::size_t>(index) * kPiecePoints;
  const std::size_t left = frame.point_count - begin;
  const std::size_t count = left < kPiecePoints ? left : kPiecePoints;
  const bool by_range = frame.points == nullptr;
  const float per_cell = static_cast<float>(1.0 / spec.cell);
  const Vec3 from = (1.0 / spec.cell) * frame.origin;
  const FaceImages faces(frame);
  HitWriter writer = hit_writer();
  const PieceOfRays piece_of_rays = by_range ? PieceOfRays(frame.beams, begin, count, spec)
                                             : PieceOfRays(frame.points + begin, count, frame.world_origin, spec);
  for (std::size_t k = 0; k < kPiecePoints / 4; ++k) {
    FourRays rays = piece_of_rays.four(k);
    set_free(rays, spec, frame.views[0].units);
    lower(faces, frame.views[0], rays);
    Four cells[3];
    for (int a = 0; a < 3; ++a) cells[a] = static_cast<float>(axis(from, a)) + per_cell * rays.axes[a];
    writer.add(cells, rays.hits);
  }
}

}  // namespace tern
