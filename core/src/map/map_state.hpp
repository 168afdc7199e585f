// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The state of a map. It takes the first of the caller's words; the layers and the images follow it.
#ifndef TERN_MAP_MAP_STATE_HPP
#define TERN_MAP_MAP_STATE_HPP

#include <cstddef>
#include <cstdint>

#include "base/progress.hpp"
#include "base/work.hpp"
#include "grid/lattice.hpp"
#include "map/evidence.hpp"
#include "map/hit_writer.hpp"
#include "tern/map.hpp"
#include "tern/track.hpp"
#include "view/carve.hpp"
#include "view/depth_pyramid.hpp"
#include "view/projector.hpp"
#include "view/view.hpp"

namespace tern {

/// Points or beams of a piece, and the operations of such a piece: each is sorted into a face, and marked.
constexpr std::size_t kPiecePoints = 64;
constexpr Operations kPointsOperations = 64 * 9 * ops::kDot;
/// Operations of marking a word of the prior in the layers of both grids, with their changes.
constexpr Operations kMarkOperations = 11 * ops::kWord;

/// Views of a scan: the faces of a cube around its origin.
constexpr int kFaces = 6;

/// The next task of a job.
enum class Task : std::uint8_t {
  kIdle,
  kPixels,        ///< rows of a depth image
  kClearFaces,    ///< all pixels become "no point", before a scan
  kPoints,        ///< points or beams of a scan
  kCloseFaces,    ///< pixels without a point become "no measurement"
  kExplain,       ///< things that move, whose hits mark nothing
  kPyramids,      ///< coarser levels of the views' images
  kBricks,        ///< carving and evidence
  kInflateRoute,  ///< planes
  kInflateSafe,
  kSlide,  ///< planes
  kCopy,   ///< planes of the route grid, for a snapshot
};

/// Earlier than any frame.
constexpr std::int64_t kNever = INT64_MIN;

/// Bricks of a window.
inline std::size_t brick_count(const Voxel& dims) noexcept {
  return static_cast<std::size_t>((dims.x + 63) / 64) * static_cast<std::size_t>((dims.y + kBrick - 1) / kBrick) *
         static_cast<std::size_t>((dims.z + kBrick - 1) / kBrick);
}

/// The frame or scan that is being processed.
struct Frame {
  DepthView image;     ///< a copy; the depths that it points to are the caller's
  const Vec3* points;  ///< the caller's; null if the scan is one of beams
  Beams beams;         ///< a copy; the arrays that it points to are the caller's
  std::size_t point_count;
  Vec3 origin;        ///< position of the sensor in the window's local frame
  Vec3 world_origin;  ///< position of the sensor in the world
  View views[kFaces];
  Projector projectors[kFaces];  ///< one for each view
  int view_count;
  std::int64_t time;        ///< when it was taken
  bool late;                ///< a newer one was entered before it
  VoxelBox box;             ///< voxels that may change; the bricks that it meets are carved
  IndexRange forgotten[2];  ///< layers of bricks whose voxels have aged; two ranges if they wrap around
  // Progress in the brick that is being carved, one view after the other. A view of a scan takes longer, so it has two
  // parts.
  int part;           ///< the next part, counted over all views; 0 before the first
  bool clears;        ///< its misses may clear voxels of this brick
  CubeBits left;      ///< cubes for the view's second part
  BrickWords wanted;  ///< voxels that a miss would change
  BrickWords free;    ///< voxels that the views so far see whole

  int parts_of_view() const noexcept { return view_count > 1 ? 2 : 1; }
};

/// Things that move, whose hits mark nothing: the caller's, and the time of the frames' clock that is 0 for them.
struct ExplainingThings {
  const Track* tracks;
  std::int32_t count;
  std::int64_t begin;
};

class MapState {
 public:
  MapSpec spec;
  Grid route;
  Grid safe;
  Voxel base;       ///< the window's lower voxel, counted from the spec's origin
  Cylinder column;  ///< of the last assume_column(); its radius is 0 before
  VoxelBox added;   ///< a box around the voxels of the safe grid that became solid since the last take_added()

  // The layers of evidence, with the same rows as the grids, and the images.
  std::uint64_t* seen;
  std::uint64_t* low;
  std::uint64_t* high;
  std::uint64_t* hit;  ///< voxels hit by the current frame; all 0 between frames
  Depth* image;
  std::int64_t image_entries;
  std::int64_t* hit_times;  ///< for each brick, the time of the latest frame that hit a voxel in it

  std::uint64_t learned;  ///< how often a frame saw voxels of a word for the first time
  std::int64_t time;      ///< the latest time of a frame
  bool timed;             ///< false before the first frame
  std::int64_t marked;    ///< frames older than this clear nothing: then something was marked, or bricks moved
  std::uint64_t frames;   ///< number of frames begun, scans included
  std::int64_t ageing;    ///< time since a layer was last forgotten, times the number of layers of bricks
  std::int32_t forget;    ///< the next layer to forget
  std::int32_t face;      ///< pixels along an edge of a scan's face
  Task task;
  Work slice;          ///< the work of step(); between two calls, its debt
  std::int64_t piece;  ///< the next piece of the task
  Frame frame;
  ExplainingThings things;
  Voxel slide_by;  ///< of the slide that is being made: voxel v of the new window is voxel v + slide_by of the old one
  Grid* copy;      ///< the caller's, for a snapshot

  std::int32_t row_words() const noexcept { return (spec.dims.x + 63) / 64; }
  std::int32_t layers() const noexcept { return (spec.dims.z + kBrick - 1) / kBrick; }
  std::size_t row(std::int32_t y, std::int32_t z) const noexcept {
    return (static_cast<std::size_t>(z) * static_cast<std::size_t>(spec.dims.y) + static_cast<std::size_t>(y)) *
           static_cast<std::size_t>(row_words());
  }
  std::size_t layer_words() const noexcept { return row(0, spec.dims.z); }
  /// World position of the window's lower corner, computed from its index only.
  Vec3 window_origin() const noexcept;

  /// The number of pieces of the current task.
  std::int64_t pieces() const noexcept;
  /// Does the job, piece by piece.
  Progress advance(Work& work) noexcept;
  void do_piece(Work& work) noexcept;
  /// Begins this task, or the first task after it that has any pieces.
  void begin(Task first) noexcept;
  /// Voxels of a brick that the frame may change; an empty range along x if there are none.
  VoxelBox brick_at(std::int64_t index) const noexcept;
  bool forgets(std::int32_t layer) const noexcept;

  // One function for each task, which does the piece of this index. v is an image row.
  void read_pixels(std::int32_t v, Work& work) noexcept;
  void clear_face_row(std::int32_t index, Work& work) noexcept;
  void close_face_row(std::int32_t index, Work& work) noexcept;
  void read_points(std::int64_t index, Work& work) const noexcept;
  void explain_hits(std::int64_t index, Work& work) const noexcept;
  void make_pyramid_row(std::int64_t index, Work& work) noexcept;
  void carve_brick(std::int64_t index, Work& work) noexcept;
  /// Enters a frame into a brick: its hits, and a miss for each voxel that was carved.
  void enter_brick(const VoxelBox& brick, std::int64_t& latest_hit, Work& work) noexcept;
  /// Begins a brick: what of it the frame may change.
  void want_brick(const VoxelBox& brick, std::int64_t latest_hit) noexcept;
  Evidence evidence_at(std::size_t word, bool forgotten) const noexcept;
  void slide_plane(std::int32_t index, Work& work) noexcept;
  void copy_plane(std::int32_t z, Work& work) const noexcept;
  void move_plane(std::int32_t z, const VoxelBox& kept) noexcept;
  void move_origin() noexcept;
  /// Makes a row of the safe grid from the route grid's obstacles and the unseen voxels. Notes the row as changed in
  /// both grids.
  void renew_row(std::int32_t y, std::int32_t z) noexcept;

  // Operations of parts of pieces; a job's bound is made of them, too.

  /// Operations of a row of pixels: each is read and marked, and with support compared with its neighbours.
  Operations pixels_operations(std::int32_t width) const noexcept {
    return ops::kPiece + (2 * ops::kDot + (spec.support > 0 ? 6 * ops::kDot : 0)) * width;
  }
  /// Operations of moving a plane in seven layers. If it moves by whole rows, words are copied; otherwise each is
  /// shifted.
  Operations moved_operations(bool rows) const noexcept {
    return ops::kPiece + 7 * (rows ? 2 * ops::kElement : 3 * ops::kWord) * static_cast<Operations>(row(0, 1));
  }
  /// Operations of renew_row().
  Operations renewed_operations() const noexcept { return ops::kRow + 5 * ops::kWord * row_words(); }

  /// Marks hits of the current frame.
  HitWriter hit_writer() const noexcept { return {hit, row_words(), spec.dims.y, frame.box}; }
  /// Writes a word into both grids: the blocked voxels into the route grid, the blocked or unseen ones into the safe
  /// grid.
  void store(std::int32_t y, std::int32_t z, std::int32_t k, std::uint64_t blocked) noexcept;
  void note_added(std::int32_t y, std::int32_t z, std::int32_t k) noexcept;
  /// Marks the prior in plane z of the route grid, except in voxels that stayed in the window.
  void mark_prior(std::int32_t z, const VoxelBox& kept, Work& work) noexcept;
  /// Begins a scan whose points or beams are set.
  void begin_faces(const Vec3& world_origin, std::int64_t t) noexcept;
  /// Prepares the projectors of the frame's views.
  void prepare_views() noexcept;
  /// Inflates both grids at once.
  void inflate() noexcept;
  /// Records the time of a frame, and finds the layers that have aged by then.
  void age_to(std::int64_t t) noexcept;
  /// By how much a frame of this time would be older than the latest one, nanoseconds; 0 if it is not.
  std::uint64_t lateness(std::int64_t t) const noexcept;
  /// Forgets the times of frames and hits.
  void forget_times() noexcept;
};

/// The window in the world.
inline Box window_box(const Vec3& origin, double cell, const Voxel& dims) noexcept {
  const Vec3 size = cell * Vec3{static_cast<double>(dims.x), static_cast<double>(dims.y), static_cast<double>(dims.z)};
  return {origin, origin + size};
}

/// The reason for refusing a sensor's position or time, or a busy map; else kOk.
Status check_sensor(const MapState& state, const Vec3& position, std::int64_t t) noexcept;

/// Pixels along an edge of a scan's face; 0 if the map takes no scans.
std::int32_t face_pixels(const MapSpec& spec) noexcept;

}  // namespace tern

#endif
