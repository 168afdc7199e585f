// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The occupancy grid: two layers of bits in storage of yours. The obstacle layer holds the voxels that you marked; each
// is a solid closed cube. The blocked layer is made from it by inflate(). A voxel is free only if the robot's centre
// may be anywhere in the voxel's closed cube: at least the radius and the tracking margin away from every obstacle
// cube, and inside the boundary (contract C5). If the boundary holds no whole voxel, this holds for the part of the
// cube inside the boundary. docs/grid.md has the details.
#ifndef TERN_GRID_HPP
#define TERN_GRID_HPP

#include <stddef.h>
#include <stdint.h>

#include "tern/config.hpp"
#include "tern/status.hpp"
#include "tern/vec3.hpp"
#include "tern/work.hpp"

namespace tern {

/// Where a grid lies and how fine it is. World frame, metres.
struct GridSpec {
  /// Lower corner of voxel (0, 0, 0). It must be so near to the world's origin that doubles resolve a thousandth of a
  /// cell there.
  Vec3 origin;
  /// Edge of a voxel, within [kMinCell, kMaxCell].
  double cell;
  /// Voxels along each axis, 1 .. kMaxDimension. Their product is at most kMaxCells.
  Voxel dims;
  /// Where the robot's centre may be, faces included. It must lie inside the grid; its faces need not be voxel faces. A
  /// voxel that the boundary cuts is blocked, but not on an axis on which the boundary holds no whole voxel. So a
  /// boundary with equal lower.z and upper.z makes flights at one height. If obstacles beyond the boundary matter, make
  /// the grid wider than the boundary by the radius, because a grid knows no obstacles outside itself.
  Box boundary;
  /// Radius of the robot's body, >= 0.
  double radius;
  /// How far the vehicle may be off the plan while it flies, >= 0. docs/simulator.md has measurements. The margin is
  /// part of the grid and not of a request, because the blocked layer depends on it.
  double tracking_margin;

  /// Least distance that a plan keeps from every obstacle. At most kMaxDimension voxels. A nanometre or less counts as
  /// 0: radius and tracking_margin of Grid::spec() are then 0.
  double clearance() const noexcept { return radius + tracking_margin; }
};

/// An upright cylinder, closed. World frame, metres.
struct Cylinder {
  Vec3 base;      ///< the centre of its lower face
  double radius;  ///< >= 0
  double height;  ///< >= 0
};

/// Voxels along an edge of the coarse cell that Grid::mark_grid() makes of them.
constexpr int32_t kFineVoxels = 4;

/// Smallest and largest voxel edge, metres.
constexpr double kMinCell = 1e-6;
constexpr double kMaxCell = 1e6;

/// Number of 64-bit words that a grid of these dimensions needs; 0 if a dimension is out of range. They hold two bits a
/// voxel, a header of 8 words, and about a 32nd more to note changes. Each row along x takes whole words.
size_t grid_words(const Voxel& dims) noexcept;

/// Identifies the content of an inflated grid at one time. Equal versions mean equal voxels, but for a chance of 2^-64.
/// The planner uses it to notice changes.
struct GridVersion {
  const uint64_t* words;  ///< the storage; null if the grid is not bound or not inflated
  uint64_t binding;       ///< a number for the bind of that storage, and for its spec
  uint64_t revision;      ///< Grid::revision()
  uint64_t content;       ///< a hash of all marks and clears since the bind

  /// True if all four agree.
  bool equals(const GridVersion& other) const noexcept {
    return words == other.words && binding == other.binding && revision == other.revision && content == other.content;
  }
};

/// A view of a grid in storage of yours, which must outlive it.
///
/// Copies: copying a Grid copies the view, not the bits. Any copy may mark, clear and inflate, and all copies see it.
/// Binding the storage through one Grid ends the binding of all others over it.
///
/// Frames: arguments called `world` are in the world frame. The stages compute in the local frame, world minus
/// spec().origin, so that precision does not depend on where the map lies.
///
/// Threads: not thread-safe. Change a grid only while nobody reads it or plans on it.
class Grid {
 public:
  /// Binds the grid to `words` and clears it: there is no obstacle, and nothing is free before inflate(). `words` is
  /// yours: `word_count` words, at least grid_words(spec.dims) of them, with any content. Nobody else may write to
  /// them.
  ///
  /// kOk, kNonFiniteInput or kInvalidArgument. `field` gets the field that is wrong, kNone with kOk; it may be null. A
  /// bind that is refused leaves the grid and the words as they were.
  Status bind(const GridSpec& spec, uint64_t* words, size_t word_count, Field* field = nullptr) noexcept;

  // Marking and clearing. Each call answers kInvalidArgument on a grid that is not bound, and changes nothing unless it
  // answers kOk. Call inflate() afterwards, once for any number of marks and clears.

  /// Marks each voxel whose interior the box meets, in metres and the world frame. A face that lies on a voxel face but
  /// for rounding takes no further voxel. A flat box on a voxel face marks the voxels above it, or below it at the
  /// grid's upper face. Parts outside the grid are ignored. kNonFiniteInput; kInvalidArgument if lower > upper.
  Status mark_box(const Box& world) noexcept;
  /// Marks each voxel whose interior the cylinder meets. A cylinder of radius 0 marks what mark_box marks for its axis.
  /// One of height 0 is treated as a flat box is. kNonFiniteInput; kInvalidArgument for a radius or height below 0.
  Status mark_cylinder(const Cylinder& world) noexcept;
  /// Clears the same voxels that mark_box would mark, whoever marked them.
  Status clear_box(const Box& world) noexcept;
  /// Marks one voxel. kOutOfMap outside the grid.
  Status mark_voxel(const Voxel& voxel) noexcept;
  /// Clears one voxel. kOutOfMap outside the grid.
  Status clear_voxel(const Voxel& voxel) noexcept;
  /// Marks the voxel that holds each of `count` points, for example a sensor's point cloud. A point on a face belongs
  /// to the voxel above it. Points outside the grid are skipped; `inside`, which may be null, gets the number of the
  /// others. kNonFiniteInput if any point is not finite; kInvalidArgument if `world` is null and count > 0.
  Status mark_points(const Vec3* world, size_t count, size_t* inside = nullptr) noexcept;
  /// Marks what a fine grid closes in this coarse one, whose cells are 4 x 4 x 4 (kFineVoxels) voxels of the fine grid.
  /// A cell is closed if less than half of it is one connected part of free voxels, or if its part does not meet that
  /// of a neighbour through their common face, and is the smaller of the two (of equal ones, the one further along the
  /// axis). So through any two cells that share a face, that the fine grid holds and that are not closed, there is a
  /// way from free voxel to free voxel. A cell that is wholly free is never closed.
  ///
  /// The fine grid's first voxel must be that of a coarse cell. Cells that it does not hold as a whole, or that are
  /// outside this grid, stay as they are. A world that is too large for one fine grid is marked in overlapping parts:
  /// docs/far_way.md. Each cell that is closed counts as a mark of its own for revision(). Not sliced: for the time
  /// before a flight.
  ///
  /// kOk; kInvalidArgument, and `field`, which may be null, says why: kStorage: a grid is not bound; kNotInflated: the
  /// fine grid is not inflated; kCell: this grid's cell is not 4 times the fine one's; kOrigin: the fine grid does not
  /// begin at a corner of a cell.
  Status mark_grid(const Grid& fine, Field* field = nullptr) noexcept;

  /// Brings the blocked layer up to date with the obstacle layer, the radius and the boundary. It computes only the
  /// words near changed obstacles; the result is the same as for all words. It does nothing if nothing changed, or on a
  /// grid that is not bound. Planning on a grid that is not up to date answers kInvalidArgument, field kNotInflated.
  void inflate() noexcept;

  // Reading. The answers of a grid that is not bound have no meaning, unless a value is stated.

  /// The spec of the last bind.
  const GridSpec& spec() const noexcept { return spec_; }
  /// False before the first bind, and after the storage was bound through another grid or overwritten.
  bool bound() const noexcept { return words_ != nullptr && words_[kBinding] == binding_; }
  /// True if the blocked layer is up to date, so that plans are possible.
  bool inflated() const noexcept { return bound() && words_[kInflated] == words_[kRevision]; }
  /// Grows by one with every mark or clear that answers kOk, through any copy, and by more with every bind. It never
  /// falls for the same grid or the same storage. inflate() does not change it. 0 if the grid is not bound.
  uint64_t revision() const noexcept { return bound() ? words_[kRevision] : 0; }
  /// What the grid holds now. All zero if the grid is not inflated.
  GridVersion version() const noexcept {
    return inflated() ? GridVersion{words_, binding_, words_[kRevision], words_[kContent]} : GridVersion{};
  }

  /// True if the grid has such a voxel.
  bool inside(const Voxel& v) const noexcept {
    return v.x >= 0 && v.y >= 0 && v.z >= 0 && v.x < spec_.dims.x && v.y < spec_.dims.y && v.z < spec_.dims.z;
  }
  /// True if the voxel is marked. False outside the grid.
  bool obstacle(const Voxel& v) const noexcept { return inside(v) && bit(obstacles_, v); }
  /// True if the voxel was free at the last inflate(). False outside the grid.
  bool free(const Voxel& v) const noexcept { return inside(v) && !bit(blocked_, v); }

  // Rows, for whoever reads many voxels. A row has bit x % 64 of word x / 64 for voxel x.

  /// Words of one row along x, ceil(dims.x / 64). Bits past dims.x are 0 in the obstacle layer and 1 in the blocked
  /// one.
  int32_t row_words() const noexcept { return row_words_; }
  /// The row at one y and z, which must be inside the grid. A bit of 1 is an obstacle, or a blocked voxel. The words
  /// belong to the grid; do not write to them.
  const uint64_t* obstacle_row(int32_t y, int32_t z) const noexcept { return obstacles_ + row(y, z); }
  const uint64_t* blocked_row(int32_t y, int32_t z) const noexcept { return blocked_ + row(y, z); }

  // Frames.

  /// A world point in the local frame: world minus origin, metres.
  Vec3 to_local(const Vec3& world) const noexcept;
  /// The voxel that holds a point of the local frame. A point on a voxel face, or below it by rounding, belongs to the
  /// voxel above; on the boundary's upper face, to the last voxel inside. A point that is outside the boundary only by
  /// rounding counts as on its face. For a point outside the grid the answer is outside too, clamped to -1 .. dims.
  Voxel voxel_of(const Vec3& local) const noexcept;
  /// The centre of a voxel, local frame, metres.
  Vec3 center(const Voxel& voxel) const noexcept;
  /// The boundary in the local frame, metres, clipped to the grid. A face that is on a voxel face but for rounding is
  /// exactly on it.
  Box local_boundary() const noexcept { return local_boundary_; }

 private:
  friend struct GridAccess;  // reads the rest for the core
  friend class GridWords;    // writes for the rolling map

  /// Words of the storage's header that are in use.
  enum Header : int { kTag, kBinding, kRevision, kInflated, kContent };

  size_t row(int32_t y, int32_t z) const noexcept {
    return (static_cast<size_t>(z) * static_cast<size_t>(spec_.dims.y) + static_cast<size_t>(y)) *
           static_cast<size_t>(row_words_);
  }
  void begin_header() noexcept;
  void inflate_planes(int32_t begin, int32_t end, int32_t first_strip, int32_t end_strip, Work& work) noexcept;
  Status set_box(const Box& world, bool value) noexcept;
  Status set_voxel(const Voxel& voxel, bool value) noexcept;
  void set_voxels(const Voxel& begin, const Voxel& end, bool value) noexcept;
  bool bit(const uint64_t* layer, const Voxel& v) const noexcept {
    return ((layer[row(v.y, v.z) + static_cast<size_t>(v.x >> 6)] >> (v.x & 63)) & 1u) != 0;
  }

  GridSpec spec_{};
  Box local_boundary_{};
  int32_t row_words_ = 0;
  int32_t reach_x_ = 0;   // voxels along x that an obstacle blocks to either side
  uint64_t binding_ = 0;  // the header's kBinding as long as this view is bound
  uint64_t bound_at_revision_ = 0;
  uint64_t* words_ = nullptr;  // the storage, which begins with the header
  uint64_t* obstacles_ = nullptr;
  uint64_t* blocked_ = nullptr;
  uint64_t* changes_ = nullptr;
};

}  // namespace tern

#endif
