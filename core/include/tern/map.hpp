// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// A map that is discovered in flight: a window of voxels that follows the vehicle, fed with depth images or scans. It
// keeps two grids over the window. The route grid takes what was never seen for free, the safe grid takes it for solid.
// Free means seen: a voxel counts as seen only where its whole cube was in front of every pixel that covers it.
// docs/map.md has the rules.
#ifndef TERN_MAP_HPP
#define TERN_MAP_HPP

#include <stddef.h>
#include <stdint.h>

#include "tern/config.hpp"
#include "tern/grid.hpp"
#include "tern/status.hpp"
#include "tern/vec3.hpp"

namespace tern {

/// Where the window begins, how fine it is, and how the sensor errs. Metres, world frame. Zero-initialise it and fill
/// in what you use; map_spec() does that with common values.
struct MapSpec {
  /// Lower corner of voxel (0, 0, 0) at first. The window moves by whole voxels from there.
  Vec3 origin;
  /// Edge of a voxel, within [kMinCell, kMaxCell].
  double cell;
  /// Voxels along each axis, as for a grid. Along x the window moves by 64 voxels at a time: let it have 128 or more.
  Voxel dims;
  /// What the vehicle's centre keeps from every obstacle, as GridSpec::radius.
  double radius;

  /// Depth up to which a frame is used, > 0. Beyond it nothing is marked, and nothing is seen.
  double range;
  /// Error of a depth z: at most depth_margin + depth_margin_square * z * z. Both >= 0; metres, and 1 / metre.
  double depth_margin;
  double depth_margin_square;
  /// Error of the pose: at most this distance and this angle. Both >= 0; metres, and radians up to 0.5.
  double pose_margin;
  double angle_margin;
  /// For scans: edge of a pixel of the image that a scan is sorted into, as a tangent. At least twice the largest angle
  /// between neighbouring beams, in radians. 0 where no scans are used; else within [kMinScanPixel, 1].
  double scan_pixel;

  /// Hits that block a voxel, and misses in a row that clear a blocked one. Within 1 .. kMaxEvidence.
  int32_t hits;
  int32_t misses;
  /// Time after which a voxel counts as unseen again unless a frame shows it, in nanoseconds. 0: never. At most a day.
  int64_t age;
  /// Voxels by which the centre that follow() is given may be off the window's middle before the window moves; >= 0.
  int32_t slack;
  /// Pixels of the largest image: width * height. With scans, 6 * (2.5 / scan_pixel)^2 where that is more.
  int32_t pixels;

  /// Obstacles known beforehand: `prior_count` boxes of yours, which must outlive the map and not change. Each is
  /// marked where the window meets it, at bind() and whenever the window comes to it. Misses clear them as any other.
  const Box* prior;
  int32_t prior_count;
};

/// Largest value of MapSpec::hits and misses.
constexpr int32_t kMaxEvidence = 4;
/// Smallest MapSpec::scan_pixel.
constexpr double kMinScanPixel = 0.002;

/// A spec with common values: 1 hit blocks, 3 misses clear, range 10 m, depth margin 0.05 m, pose margin 0.05 m, slack
/// 4, pixels for 320 x 240, nothing ages, no scans, no prior.
MapSpec map_spec(const Vec3& origin, double cell, const Voxel& dims, double radius) noexcept;

/// Number of 64-bit words that a map of this spec needs; 0 where dimensions, pixels or scan_pixel are out of range.
size_t map_words(const MapSpec& spec) noexcept;

/// A camera's pose in the world: where its centre is, and the unit quaternion (w, x, y, z) that turns its axes into the
/// world's. The camera looks along its z; its x points right, its y down. A norm that is off 1 by up to 1e-3 is mended.
struct Pose {
  Vec3 position;
  double quaternion[4];
};

/// A depth image of yours. Depth is measured along the optical axis. Pixel (u, v) covers [u - 1/2, u + 1/2] by
/// [v - 1/2, v + 1/2]; a ray through (u, v) has the direction ((u - cx) / fx, (v - cy) / fy, 1).
///
/// A pixel says nothing where its depth is 0, NaN, below `min`, not below `max`, or the number 65535. Nothing is seen
/// in it then, however near.
struct DepthView {
  /// Row after row, `stride` numbers apart. One of the two is set, the other one null.
  const uint16_t* z16;
  const float* z32;
  int32_t width, height, stride;
  /// Focal lengths and principal point, pixels. fx, fy > 0; the rays' tangents are 100 at most.
  double fx, fy, cx, cy;
  /// Metres a unit, > 0.
  double scale;
  /// Depths that the sensor can measure, metres: 0 <= min < max.
  double min, max;
};

class MapState;

/// A view of a map in words of yours, which must outlive it. Copies share the map. It is not thread-safe.
///
/// One job is in work at a time: a frame, a scan or a slide. It begins with begin_frame(), begin_scan() or follow(),
/// and step() does it in slices. The result does not depend on the slices (contract C3).
class RollingMap {
 public:
  /// Binds the map to `words`, at least map_words(spec) of them with any content. Nothing is seen, and the prior's
  /// boxes are obstacles. kOk, kNonFiniteInput, kInvalidArgument, kPixelsFull or kPriorFull; `field` gets the field
  /// that is wrong and may be null. A bind that is refused changes nothing.
  Status bind(const MapSpec& spec, uint64_t* words, size_t word_count, Field* field = nullptr) noexcept;
  /// False before the first bind.
  bool bound() const noexcept { return state_ != nullptr; }

  /// Begins to enter a depth image that was taken at `pose` and time `t`, in nanoseconds of your clock. The image must
  /// stay until the job is done. kRunning; or kNonFiniteInput, kPoseInvalid (no unit quaternion), kCameraInvalid,
  /// kOutOfMap (the pose is not in the window), kPixelsFull, or kInvalidArgument (not bound, another job is in work, no
  /// image, or `t` before the last frame's). Whatever is refused changes nothing.
  Status begin_frame(const DepthView& view, const Pose& pose, int64_t t) noexcept;
  /// Begins to enter a scan: `count` points of yours, world frame, metres, measured from `origin`. Points that are not
  /// finite are skipped. A point beyond the range marks nothing, and all up to the range is seen in its direction. The
  /// points must stay until the job is done. Answers as begin_frame(); kInvalidArgument where scan_pixel is 0.
  Status begin_scan(const Vec3* points, size_t count, const Vec3& origin, int64_t t) noexcept;
  /// Begins to move the window so that `center`, world frame, comes near its middle. kOk where it need not move, or
  /// kRunning; kNonFiniteInput; kOutOfMap where doubles are too coarse there; kInvalidArgument as begin_frame().
  /// What enters the window is unknown, but for the prior. What leaves it is forgotten. While the slide is in work both
  /// grids count as not bound.
  Status follow(const Vec3& center) noexcept;
  /// Goes on with the job. kRunning: there is more to do. kOk: there is none, and both grids are inflated.
  /// kInvalidArgument where the map is not bound.
  ///
  /// A unit is at most 64 voxels looked up or updated, 64 pixels or points read, or 1024 voxels inflated or moved. A
  /// piece of several units is done once all of them were given, so that no call does more than `work` and one piece.
  Status step(uint32_t work) noexcept;
  /// True where a job is in work.
  bool busy() const noexcept;
  /// Units that a frame of this size takes at most, or a scan of so many points. A slide takes no more than
  /// scan_work(0).
  uint32_t frame_work(int32_t width, int32_t height) const noexcept;
  uint32_t scan_work(size_t count) const noexcept;

  // At once, and not for use in flight: each takes as long as a frame. kInvalidArgument where a job is in work.

  /// Takes every voxel wholly in the ball for seen: the operator's word, before take-off. It clears no obstacle. World
  /// frame, metres. kNonFiniteInput; kInvalidArgument for a radius below 0.
  Status assume_free(const Vec3& center, double radius) noexcept;
  /// Marks the voxels of a box as obstacles in both grids, as Grid::mark_box does, until misses clear them.
  Status mark_box(const Box& world) noexcept;
  /// Marks the voxels that hold the points, as Grid::mark_points does, likewise.
  Status mark_points(const Vec3* world, size_t count) noexcept;

  // Reading. Both grids are ordinary grids whose boundary is the window. Their address is constant; do not copy them,
  // because a slide ends the binding of copies. Only for a map that is bound.

  /// What was hit is solid, everything else is free. For planning.
  const Grid& route() const noexcept;
  /// What was hit or never seen is solid. For proofs. Between two slices of a frame, each word of its obstacle layer is
  /// that before the frame or after it.
  const Grid& safe() const noexcept;
  /// Copies the route grid, for plans that go on while frames are entered. `words` is yours: `word_count` words, at
  /// least grid_words(spec.dims) of them, which must outlive `grid`. Keep one grid with its words for all snapshots: it
  /// is bound again only where the window has moved. The planner keeps what it learned of voxels that are the same.
  /// kOk, and the grid is inflated; kInvalidArgument where the map is not bound, a job is in work, or the words are too
  /// few. Not sliced: it copies two layers, a byte for four voxels.
  Status snapshot(Grid& grid, uint64_t* words, size_t word_count) const noexcept;
  /// True where the voxel was seen free, and not forgotten since. It may be an obstacle now. False outside.
  bool seen(const Voxel& voxel) const noexcept;
  /// Grows with every change of either grid.
  uint64_t revision() const noexcept;

 private:
  MapState* state_ = nullptr;
};

}  // namespace tern

#endif
