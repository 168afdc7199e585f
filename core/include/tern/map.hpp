// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// A map that is discovered in flight: a window of voxels that follows the vehicle. Depth images or lidar scans fill it.
// The map keeps two grids over the window. In the route grid, voxels that were never seen are free; in the safe grid
// they are solid. A voxel counts as seen only if every pixel that covers it measured a depth behind the whole cube.
// docs/map.md has the rules.
#ifndef TERN_MAP_HPP
#define TERN_MAP_HPP

#include <stddef.h>
#include <stdint.h>

#include "tern/config.hpp"
#include "tern/grid.hpp"
#include "tern/status.hpp"
#include "tern/track.hpp"
#include "tern/vec3.hpp"
#include "tern/work.hpp"

namespace tern {

/// The window, its resolution, and the errors of the sensor. Metres, world frame. Zero-initialise it and fill in what
/// you use, or start from the common values of map_spec().
struct MapSpec {
  /// Lower corner of voxel (0, 0, 0) at bind(). From there the window moves by whole voxels.
  Vec3 origin;
  /// Edge of a voxel, within [kMinCell, kMaxCell].
  double cell;
  /// Voxels along each axis, as for a grid. Along x the window moves by 64 voxels at a time, so choose at least 128
  /// there.
  Voxel dims;
  /// Radius of the vehicle's body plus the error of its pose, and how far it may be off the plan, as GridSpec::radius
  /// and tracking_margin.
  double radius;
  double tracking_margin;

  /// Depth up to which a frame is used, > 0, at most kMaxCell. Nothing beyond it is marked or seen.
  double range;
  /// Error of a depth z: at most depth_margin + depth_margin_square * z * z. Both >= 0; metres, and 1 / metre.
  double depth_margin;
  double depth_margin_square;
  /// Error of the pose: at most this distance and this angle. Both >= 0; metres, and radians up to 0.5.
  double pose_margin;
  double angle_margin;
  /// For scans: the angle of the pixels that beams are sorted into, radians; at least twice the largest angle between
  /// neighbouring beams. Beams says what the sensor must promise. A scan sees nothing within about 1.25 scan_pixel of
  /// the direction of a thing, or of the edge of the view. Within [kMinScanPixel, 1], or 0 if you use no scans. From
  /// 0.2 on, hardly anything is seen.
  double scan_pixel;

  /// Hits that block a voxel, and misses that clear a blocked one (a hit starts the count again). Within 1 ..
  /// kMaxEvidence.
  int32_t hits;
  int32_t misses;
  /// For depth images: how many of the eight pixels around a pixel must measure about the same depth, at most a voxel
  /// and their errors apart. A pixel with fewer is taken for an error of the sensor. It hits nothing, and sees no
  /// further than the nearest pixel around it. 0 .. 8; 0: every pixel counts.
  int32_t support;
  /// A voxel counts as seen for at most this time after the last frame that saw it, in nanoseconds. 0: for ever. At
  /// most a day.
  int64_t age;
  /// The window moves when the point given to follow() is more than this many voxels from its middle; 0 ..
  /// kMaxDimension.
  int32_t slack;
  /// Pixels of the largest image, width * height; 1 .. kMaxPixels. With scans, at least 6 * (2.5 / scan_pixel)^2.
  int32_t pixels;

  /// Obstacles known before the flight: boxes and upright cylinders of yours, which must outlive the map and not
  /// change. The map marks the part of each that is in the window, at bind() and after every slide. Misses clear these
  /// voxels like any others.
  const Box* prior;
  int32_t prior_count;
  const Cylinder* prior_cylinders;
  int32_t prior_cylinder_count;
};

/// Largest value of MapSpec::hits and misses.
constexpr int32_t kMaxEvidence = 4;
/// Smallest MapSpec::scan_pixel.
constexpr double kMinScanPixel = 0.002;
/// The most by which a frame or scan may be older than the latest one that was entered, nanoseconds.
constexpr int64_t kMaxFrameDelay = 1000000000;

/// For how long before and after its measurement a thing that moves explains hits, seconds, and the largest error with
/// which it does, metres: see RollingMap::explain_hits().
constexpr double kExplainsFor = 0.5;
constexpr double kExplainsWithin = 1.0;

/// A spec with common values: 1 hit blocks, 3 misses clear, range 10 m, depth margin 0.05 m, pose margin 0.05 m, slack
/// 4, pixels for 320 x 240, nothing ages, no scans, no prior.
MapSpec map_spec(const Vec3& origin, double cell, const Voxel& dims, double radius) noexcept;

/// Number of 64-bit words that a map of this spec needs; 0 if dimensions, pixels or scan_pixel are out of range.
size_t map_words(const MapSpec& spec) noexcept;

/// A camera's pose in the world: the position of its centre, and the unit quaternion (w, x, y, z) that rotates its axes
/// into the world's. The camera looks along its z; its x points right, its y down. The quaternion is normalised if its
/// norm is within 1e-3 of 1.
struct Pose {
  Vec3 position;
  double quaternion[4];
};

/// A depth image of yours. Depth is measured along the optical axis. Pixel (u, v) covers [u - 1/2, u + 1/2] by
/// [v - 1/2, v + 1/2]; a ray through (u, v) has the direction ((u - cx) / fx, (v - cy) / fy, 1).
///
/// A pixel has no measurement if its depth is 0, NaN, below `min`, at least `max`, or 65535 in an image of 16 bits.
/// Nothing is seen in such a pixel, not even close to the camera, unless `no_return` says otherwise.
struct DepthView {
  /// Rows of numbers, `stride` numbers from one row to the next. Set one of the two; the other one is null.
  const uint16_t* z16;
  const float* z32;
  int32_t width, height, stride;
  /// Focal lengths and principal point, pixels. fx, fy > 0; the tangent of a ray's angle to the axis is at most 100.
  double fx, fy, cx, cy;
  /// Metres per unit, > 0.
  double scale;
  /// Depths that the sensor can measure, metres: 0 <= min < max.
  double min, max;
  /// What a pixel says that nothing came back to: one of 0, or of +infinity in an image of floats. 0: nothing is known
  /// there. More than 0: you state that nothing is nearer than this depth, in metres; the pixel is then free up to it,
  /// and at most up to MapSpec::range. What the sensor cannot see is then flown into: docs/map.md has the risk. Write
  /// NaN where your driver knows of a pixel that it says nothing.
  double no_return;
};

/// The beams of a scan, yours: beam k looked along directions[k], in the world's axes and of any length, and measured
/// ranges[k], metres from the sensor. As in ROS (REP 117), a range says one of three things:
///
/// - within [min, max): something is there;
/// - +infinity: the beam came back with nothing within MapSpec::range;
/// - anything else, as NaN: nothing is known, and nothing is seen around that direction.
///
/// A direction that is 0 or not finite is skipped.
///
/// A scan shows free space only as far as the sensor keeps this promise, which docs/map.md explains. Take any direction
/// with beams all around it, in which the nearest thing is at a distance d < range. A beam at most 1.25 scan_pixel away
/// must show a distance of at most d, but for the depth's error. Sensors keep it in one of two ways:
///
/// - Wide beams: each shows the nearest thing in a part of the view, and the parts leave no gap.
/// - Thin beams: no direction of the view is further than 0.35 scan_pixel from a beam. Things thinner than
///   0.75 scan_pixel * d may then be missed.
///
/// If beams are missing, not even passed as unknown, the map notices the hole if it is 3 scan_pixel wide.
struct Beams {
  const Vec3* directions;
  const float* ranges;
  size_t count;
  /// Ranges that the sensor can measure, metres: 0 <= min < max. `max` may be infinite.
  double min, max;
};

class MapState;

/// A view of a map that lies in words of yours, which must outlive it. Copies share the map. It is not thread-safe.
///
/// The map does one job at a time: a frame, a scan, a slide or a snapshot. begin_frame(), begin_scan(), follow() or
/// begin_snapshot() begins it, and step() does it in slices. The result does not depend on the slices (contract C3).
class RollingMap {
 public:
  /// Binds the map to `words`, at least map_words(spec) of them with any content. Nothing is seen, and the prior
  /// is solid. kOk, kNonFiniteInput, kInvalidArgument, kPixelsFull or kPriorFull; `field` receives the field
  /// that is wrong; it may be null. A call that is refused changes nothing.
  Status bind(const MapSpec& spec, uint64_t* words, size_t word_count, Field* field = nullptr) noexcept;
  /// False before the first bind.
  bool bound() const noexcept { return state_ != nullptr; }

  /// Begins to enter a depth image that was taken at `pose` and time `t`, in nanoseconds of your clock. The image must
  /// stay until the job is done. Frames of several sensors may come in any order: one may be older than the latest
  /// frame by kMaxFrameDelay. It clears no obstacle that a newer frame may have hit. kRunning; or kNonFiniteInput,
  /// kPoseInvalid (no unit quaternion), kCameraInvalid, kOutOfMap (the pose is not in the window), kPixelsFull,
  /// kClockBehind (`t` is further behind), or kInvalidArgument (not bound, another job is not finished, or no image).
  /// A call that is refused changes nothing.
  Status begin_frame(const DepthView& view, const Pose& pose, int64_t t) noexcept;
  /// Begins to enter a scan: `count` points of yours, world frame, metres, measured from `origin`. The sensor must
  /// promise what Beams says. A point that is not finite is skipped: its beam is missing. A point beyond the range
  /// marks nothing; in its direction, everything up to the range is seen. The points must stay until the job is done.
  /// Answers as begin_frame(); also kInvalidArgument if scan_pixel is 0.
  Status begin_scan(const Vec3* points, size_t count, const Vec3& origin, int64_t t) noexcept;
  /// Begins to enter a scan of beams, which can also say that nothing came back, or that nothing is known. Directions
  /// and ranges must stay until the job is done. Answers as for points; also kInvalidArgument for null pointers, or if
  /// not 0 <= min < max.
  Status begin_scan(const Beams& beams, const Vec3& origin, int64_t t) noexcept;
  /// Begins to move the window so that `center`, world frame, comes near its middle. kOk if it need not move, or
  /// kRunning; kNonFiniteInput; kOutOfMap if doubles are too coarse there; kInvalidArgument as begin_frame(). Space
  /// that enters the window is unknown, except for the prior. Space that leaves it is forgotten. Until the slide is
  /// finished, both grids count as not bound.
  Status follow(const Vec3& center) noexcept;
  /// Begins to copy the route grid, for plans that go on while frames are entered. `words` is yours: `word_count`
  /// words, at least grid_words(spec.dims) of them, which must outlive `grid`. Keep one grid with its words for all
  /// snapshots: the planner keeps what it learned of voxels that are the same. A grid that is not bound to these words
  /// yet is bound first, which takes as long as a frame. The grid must stay where it is until the job is done; until
  /// then it counts as not bound, and afterwards it is inflated. kRunning; kInvalidArgument if the map is not bound, a
  /// job is not finished, or the words are too few.
  Status begin_snapshot(Grid& grid, uint64_t* words, size_t word_count) noexcept;
  /// The clock of the frames was set: the next one may have any time. Call Flight::set_clock() instead if a flight uses
  /// the map: it does this, and records know it. kInvalidArgument if the map is not bound.
  Status forget_time() noexcept;
  /// Continues the job. kRunning: there is more to do. kOk: no job is left, and both grids are inflated.
  /// kInvalidArgument if the map is not bound.
  ///
  /// A piece of work is a row of pixels, 64 points, a block of 64 x 8 x 8 voxels, or some planes of the window. It may
  /// begin as long as work is left, so a call takes at most one piece more.
  Status step(Work& work) noexcept;
  /// The same with `work` more units. What a call takes beyond them, the next calls take less.
  Status step(uint32_t work) noexcept;
  /// From now on, what a frame or scan hits in one of these things marks no voxel: `count` tracks of yours, whose times
  /// count from `begin` of the frames' clock. They must stay until the next call; null ends it. A flight does this by
  /// itself in every tick, with the things of Flight::update_track().
  ///
  /// A thing explains the hits in voxels whose centre is in its shape at the time of the frame. Its radius and its half
  /// extents are grown by its error then, by the errors of pose and depth, and by half the diagonal of a voxel. It
  /// explains none in frames taken more than kExplainsFor before it was measured, or after, unless it has pieces; none
  /// once its error exceeds kExplainsWithin; and none after Track::until if that counts, unless it has pieces and
  /// stays. Its voxels are not seen free by that either: what was never seen stays unknown.
  void explain_hits(const Track* tracks, int32_t count, int64_t begin = 0) noexcept;
  /// True while a job is not finished.
  bool busy() const noexcept;
  /// The most units that a frame of this size takes, or a scan of this many points, without explain_hits(). A slide or
  /// a snapshot takes at most scan_work(0).
  uint32_t frame_work(int32_t width, int32_t height) const noexcept;
  uint32_t scan_work(size_t count) const noexcept;

  // These calls do all their work at once, which takes as long as a frame: do not use them in flight. kInvalidArgument
  // while a job is not finished.

  /// The operator states, before take-off, that a ball is free: every voxel wholly inside it counts as seen. Obstacles
  /// stay. World frame, metres. kNonFiniteInput; kInvalidArgument for a radius below 0.
  Status assume_free(const Vec3& center, double radius) noexcept;
  /// The operator states, before take-off, where the vehicle stands: the column is free, and the ground below it is no
  /// higher than its base. Every voxel wholly inside the column counts as seen; obstacles stay. Flight::start() then
  /// takes the voxels that reach below the base for ground if the vehicle stands in the column, with the clearance and
  /// one and a half voxels around it. Only the latest statement counts for that. World frame, metres.
  /// kNonFiniteInput; kInvalidArgument for a negative radius or height.
  Status assume_column(const Cylinder& column) noexcept;
  /// Marks the voxels of a box as obstacles in both grids, as Grid::mark_box does, until misses clear them.
  Status mark_box(const Box& world) noexcept;
  /// Marks the voxels of a cylinder as obstacles in both grids, as Grid::mark_cylinder does, until misses clear them.
  Status mark_cylinder(const Cylinder& world) noexcept;
  /// Marks the voxels that hold the points in both grids, as Grid::mark_points does, until misses clear them.
  Status mark_points(const Vec3* world, size_t count) noexcept;

  /// begin_snapshot() and all of its work. kOk; kInvalidArgument as there.
  Status snapshot(Grid& grid, uint64_t* words, size_t word_count) noexcept;

  // Reading, only for a map that is bound. Both grids are ordinary grids whose boundary is the window. Their addresses
  // stay the same. Do not copy them, because a slide unbinds the copies.

  /// Voxels that were hit are solid, all others are free. For planning.
  const Grid& route() const noexcept;
  /// Voxels that were hit or never seen are solid. For proofs. Between two slices of a frame, each word of the obstacle
  /// layer is as it was before the frame, or as it will be after it.
  const Grid& safe() const noexcept;
  /// True if the voxel was seen free, and not forgotten since. It may be an obstacle now. False outside.
  bool seen(const Voxel& voxel) const noexcept;
  /// All of seen() as a layer: a bit a voxel, in the rows of Grid::obstacle_row(). The map's; read only. A slide moves
  /// it with the grids.
  const uint64_t* seen_rows() const noexcept;
  /// True if assume_column() told of the ground within `around` metres of a place, seen from above. `height` receives
  /// the z that it does not exceed, and stays otherwise.
  bool ground_at(const Vec3& place, double around, double& height) const noexcept;
  /// Grows by one whenever voxels of one word of seen_rows() are seen for the first time, or again after they were
  /// forgotten. While it stands still, the map learns nothing new.
  uint64_t learned() const noexcept;
  /// Frames and scans that were begun since bind(). While it stands still, the sensor shows nothing.
  uint64_t frames() const noexcept;
  /// Grows with every change of either grid.
  uint64_t revision() const noexcept;
  /// `world` becomes a box around all voxels of safe() that became solid since the last call that answered true; after
  /// bind() and after a slide, it is the window. World frame, metres. False, and `world` stays, if there are none or a
  /// job is not finished. A trajectory that was proven clear on safe() before is still clear outside this box, grown by
  /// the radius.
  bool take_added(Box& world) noexcept;
  /// The spec of the last bind.
  const MapSpec& spec() const noexcept;

 private:
  MapState* state_ = nullptr;
};

}  // namespace tern

#endif
