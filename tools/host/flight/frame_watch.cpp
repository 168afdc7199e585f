// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "host/flight/frame_watch.hpp"

#include <algorithm>
#include <cmath>
#include <unordered_set>
#include <utility>

#include "host/number.hpp"

namespace tern_host {
namespace {

using tern::Vec3;
using tern::Voxel;

constexpr int kVoxels = 48;  // a frame
constexpr int kHits = 32;
constexpr double kNearest = 0.3;                      // metres from a lidar
constexpr double kFrameRounding = 1e-6;               // metres
constexpr double kHalfDiagonal = 0.8660254037844387;  // of a cube
constexpr double kFaceRoom = 2e-3;  // metres from a voxel's faces within which a hit may be either side's

/// The camera's axes in the world, from its quaternion.
struct CameraAxes {
  explicit CameraAxes(const tern::Pose& pose) {
    const double w = pose.quaternion[0];
    const double x = pose.quaternion[1];
    const double y = pose.quaternion[2];
    const double z = pose.quaternion[3];
    right = {1.0 - 2.0 * (y * y + z * z), 2.0 * (x * y + w * z), 2.0 * (x * z - w * y)};
    down = {2.0 * (x * y - w * z), 1.0 - 2.0 * (x * x + z * z), 2.0 * (y * z + w * x)};
    ahead = {2.0 * (x * z + w * y), 2.0 * (y * z - w * x), 1.0 - 2.0 * (x * x + y * y)};
  }
  Vec3 right{}, down{}, ahead{};
};

double dot(const Vec3& a, const Vec3& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}

/// A point at a depth behind a pixel.
Vec3 point_behind(const DepthFrame& frame, const CameraAxes& axes, double u, double v, double depth) {
  const double r = depth * (u - frame.view.cx) / frame.view.fx;
  const double d = depth * (v - frame.view.cy) / frame.view.fy;
  const Vec3& p = frame.pose.position;
  return {p.x + r * axes.right.x + d * axes.down.x + depth * axes.ahead.x,
          p.y + r * axes.right.y + d * axes.down.y + depth * axes.ahead.y,
          p.z + r * axes.right.z + d * axes.down.z + depth * axes.ahead.z};
}

std::string place(const Vec3& p) {
  return "(" + fixed(p.x, 2) + ", " + fixed(p.y, 2) + ", " + fixed(p.z, 2) + ")";
}

}  // namespace

FrameWatch::FrameWatch(const FlightWorld& world, const tern::MapSpec& spec, const tern::RollingMap& map,
                       Explains explains)
    : world_(world), spec_(spec), map_(map), explains_(std::move(explains)), noise_(world.settings.seed) {}

bool FrameWatch::voxel_at(const Vec3& point, Voxel& voxel) const {
  const tern::GridSpec& grid = map_.safe().spec();
  voxel = {static_cast<int>(std::floor((point.x - grid.origin.x) / grid.cell)),
           static_cast<int>(std::floor((point.y - grid.origin.y) / grid.cell)),
           static_cast<int>(std::floor((point.z - grid.origin.z) / grid.cell))};
  return voxel.x >= 0 && voxel.y >= 0 && voxel.z >= 0 && voxel.x < grid.dims.x && voxel.y < grid.dims.y &&
         voxel.z < grid.dims.z;
}

bool FrameWatch::begin() {
  unseen_.clear();
  watches_ = map_.safe().bound();
  return watches_;
}

bool FrameWatch::end() {
  const bool watched = watches_ && !map_.busy() && map_.safe().bound();
  if (watched) watches_ = false;
  return watched;
}

Vec3 FrameWatch::center_of(const Voxel& voxel) const {
  const tern::GridSpec& grid = map_.safe().spec();
  return {grid.origin.x + grid.cell * (voxel.x + 0.5), grid.origin.y + grid.cell * (voxel.y + 0.5),
          grid.origin.z + grid.cell * (voxel.z + 0.5)};
}

/// Remembers the centre of the point's voxel, unless that was seen before.
void FrameWatch::note_unseen(const Vec3& point) {
  Voxel voxel;
  if (voxel_at(point, voxel) && !map_.seen(voxel)) unseen_.push_back(center_of(voxel));
}

/// Of those that are seen now, is_whole(centre) must hold.
template <typename IsWhole>
void FrameWatch::check_seen(IsWhole is_whole) {
  for (const Vec3& center : unseen_) {
    Voxel voxel;
    if (!voxel_at(center, voxel) || !map_.seen(voxel)) continue;
    ++seen_;
    if (!is_whole(center) && broken_.empty()) {
      broken_ = "invariant 6: the voxel at " + place(center) + " became free, but was not seen whole";
    }
  }
}

void FrameWatch::before(const DepthFrame& frame) {
  if (!begin()) return;
  const CameraAxes axes(frame.pose);
  for (int k = 0; k < kVoxels; ++k) {
    const double u = noise_.within(0.0, frame.view.width - 1.0);
    const double v = noise_.within(0.0, frame.view.height - 1.0);
    note_unseen(point_behind(frame, axes, u, v, noise_.within(0.3, spec_.range)));
  }
}

void FrameWatch::after(const DepthFrame& frame) {
  if (!end()) return;
  check_seen([&](const Vec3& center) { return wholly_in_front(frame, center); });
  check_hits(hits_of(frame), frame.taken);
}

void FrameWatch::before(const LidarScan& scan) {
  if (!begin()) return;
  for (int k = 0; k < kVoxels; ++k) {
    const auto beam = static_cast<std::size_t>(noise_.below(static_cast<int>(scan.ranges.size())));
    const double range = static_cast<double>(scan.ranges[beam]);
    const double part = noise_.within(0.0, 1.0);
    note_unseen(scan.point(beam, part * (range < spec_.range ? range : spec_.range)));
  }
}

/// Scans have no pixels of their own to look into: what they show is compared with the true world.
void FrameWatch::after(const LidarScan& scan) {
  if (!end()) return;
  const double inside = 0.5 * spec_.cell - spec_.pose_margin - kFrameRounding;
  check_seen([&](const Vec3& center) { return !knows_world_ || clearance(world_, center) >= inside; });
  check_hits(hits_of(scan), scan.taken);
}

bool FrameWatch::wholly_in_front(const DepthFrame& frame, const Vec3& center) const {
  const CameraAxes axes(frame.pose);
  const tern::DepthView& view = frame.view;
  const double half = 0.5 * spec_.cell;
  double u[2] = {1e9, -1e9};
  double v[2] = {1e9, -1e9};
  double back = 0.0;
  for (int corner = 0; corner < 8; ++corner) {
    const Vec3 from{center.x - frame.pose.position.x + ((corner & 1) != 0 ? half : -half),
                    center.y - frame.pose.position.y + ((corner & 2) != 0 ? half : -half),
                    center.z - frame.pose.position.z + ((corner & 4) != 0 ? half : -half)};
    const double depth = dot(from, axes.ahead);
    if (depth <= 0.0) return false;
    back = std::max(back, depth);
    const double at_u = view.cx + view.fx * dot(from, axes.right) / depth;
    const double at_v = view.cy + view.fy * dot(from, axes.down) / depth;
    u[0] = std::min(u[0], at_u);
    u[1] = std::max(u[1], at_u);
    v[0] = std::min(v[0], at_v);
    v[1] = std::max(v[1], at_v);
  }
  const auto pixel = [](double x) { return static_cast<int>(std::floor(x + 0.5)); };
  if (pixel(u[0]) < 0 || pixel(v[0]) < 0 || pixel(u[1]) >= view.width || pixel(v[1]) >= view.height) return false;
  for (int y = pixel(v[0]); y <= pixel(v[1]); ++y) {
    for (int x = pixel(u[0]); x <= pixel(u[1]); ++x) {
      const double z = view.scale * static_cast<double>(view.z32[y * view.stride + x]);
      const bool nothing = view.no_return > 0.0 && (z == 0.0 || (std::isinf(z) && z > 0.0));
      const bool measured = z > 0.0 && z >= view.min && z < view.max;
      const double free = nothing ? view.no_return : z - spec_.depth_margin - spec_.depth_margin_square * z * z;
      if ((!nothing && !measured) || free < back) return false;
    }
  }
  return back <= spec_.range;
}

/// True where it is clear in which voxel a point is that was hit.
bool FrameWatch::is_hit(const Vec3& point, Voxel& voxel) const {
  if (!voxel_at(point, voxel)) return false;
  const tern::GridSpec& grid = map_.safe().spec();
  const double from[3] = {point.x - grid.origin.x, point.y - grid.origin.y, point.z - grid.origin.z};
  return std::all_of(std::begin(from), std::end(from),
                     [&grid](double f) { return std::abs(std::remainder(f, grid.cell)) >= kFaceRoom; });
}

/// As many neighbours as MapSpec::support asks for are as deep but for a voxel: their errors may come on top.
bool FrameWatch::is_supported(const DepthFrame& frame, int u, int v) const {
  const tern::DepthView& view = frame.view;
  const float at = view.z32[v * view.stride + u];
  if (spec_.support == 0) return true;
  int agreeing = -1;  // the pixel itself
  for (int y = std::max(0, v - 1); y <= std::min(view.height - 1, v + 1); ++y) {
    for (int x = std::max(0, u - 1); x <= std::min(view.width - 1, u + 1); ++x) {
      const float z = view.z32[y * view.stride + x];
      agreeing += z >= static_cast<float>(view.min) && std::abs(z - at) < 0.999f * static_cast<float>(spec_.cell);
    }
  }
  return agreeing >= spec_.support;
}

/// Some points that were hit; all of them where a voxel needs several.
std::vector<Vec3> FrameWatch::hits_of(const DepthFrame& frame) {
  const CameraAxes axes(frame.pose);
  const tern::DepthView& view = frame.view;
  std::vector<Vec3> points;
  const int pixels = view.width * view.height;
  const int count = spec_.hits > 1 ? pixels : kHits;
  for (int k = 0; k < count; ++k) {
    const int pixel = spec_.hits > 1 ? k : noise_.below(pixels);
    const int u = pixel % view.width;
    const int v = pixel / view.width;
    const double z = static_cast<double>(view.z32[v * view.stride + u]);
    if (!(z >= view.min && z < 0.999 * spec_.range) || !is_supported(frame, u, v)) continue;
    points.push_back(point_behind(frame, axes, u, v, z));
  }
  return points;
}

std::vector<Vec3> FrameWatch::hits_of(const LidarScan& scan) const {
  std::vector<Vec3> points;
  for (std::size_t beam = 0; beam < scan.ranges.size(); ++beam) {
    const double range = static_cast<double>(scan.ranges[beam]);
    if (range > kNearest && range < 0.999 * spec_.range) points.push_back(scan.point(beam, range));
  }
  return points;
}

/// Of the voxels that are remembered, those that these points hit once more must be solid if that makes enough; the
/// others begin anew. Some of those that are hit now are remembered.
void FrameWatch::check_hits(const std::vector<Vec3>& points, std::int64_t taken) {
  const tern::GridSpec& grid = map_.safe().spec();
  const auto key = [&grid](const Voxel& v) { return (std::int64_t{v.z} * grid.dims.y + v.y) * grid.dims.x + v.x; };
  Voxel voxel;
  std::unordered_set<std::int64_t> hit;
  if (spec_.hits > 1) {
    for (const Vec3& point : points) {
      if (is_hit(point, voxel)) hit.insert(key(voxel));
    }
  }
  const auto is_over = [&](HitVoxel& h) {
    ++h.frames;
    return !voxel_at(h.center, voxel) || hit.count(key(voxel)) == 0;
  };
  hit_.erase(std::remove_if(hit_.begin(), hit_.end(), is_over), hit_.end());
  for (int k = 0; k < kHits && !points.empty(); ++k) {
    const Vec3& point = points[static_cast<std::size_t>(noise_.below(static_cast<int>(points.size())))];
    if (is_hit(point, voxel)) hit_.push_back({center_of(voxel), 1, false});
  }
  const double room = spec_.pose_margin + spec_.depth_margin + spec_.depth_margin_square * spec_.range * spec_.range +
                      kHalfDiagonal * spec_.cell + kFrameRounding;
  for (HitVoxel& h : hit_) {
    h.may_move = h.may_move || (explains_ && explains_(h.center, taken, room));
    if (h.may_move || h.frames < spec_.hits || !voxel_at(h.center, voxel)) continue;
    ++hits_;
    if (!map_.safe().obstacle(voxel) && broken_.empty()) {
      broken_ = "invariant 6: the voxel at " + place(h.center) + " was hit and is free";
    }
  }
  const auto is_done = [this](const HitVoxel& h) { return h.frames >= spec_.hits; };
  hit_.erase(std::remove_if(hit_.begin(), hit_.end(), is_done), hit_.end());
}

}  // namespace tern_host
