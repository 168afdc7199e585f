// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The occupancy grid: two bit layers in the caller's storage. The obstacle layer holds what was
// marked, each voxel a solid closed cube. The blocked layer holds every voxel where the robot's centre may
// not be at some point of the voxel's closed cube: closer than the radius to an obstacle cube, or
// outside the boundary (contract C5).
#ifndef TERN_GRID_HPP
#define TERN_GRID_HPP

#include <stddef.h>
#include <stdint.h>

#include "tern/config.hpp"
#include "tern/status.hpp"
#include "tern/vec3.hpp"

namespace tern {

/// Where a grid lies and how fine it is. World frame, metres.
struct GridSpec {
  Vec3 origin;    ///< lower corner of voxel (0, 0, 0); so near that a coordinate there rounds by < 0.001 cell
  double cell;    ///< voxel edge, within [kMinCell, kMaxCell]
  Voxel dims;     ///< voxels per axis, 1 .. kMaxDimension each, product <= kMaxCells
  Box boundary;   ///< where the robot's centre may be; need not lie on the lattice, and must lie
                  ///< inside the grid. Make the grid wider than the boundary by the radius where
                  ///< obstacles beyond the boundary matter.
  double radius;  ///< clearance of the robot's centre from every obstacle, 0 .. kMaxDimension cells;
                  ///< a nanometre or less counts as 0, and is 0 in Grid::spec()
};

/// Voxel edges that a grid accepts, metres: a micrometre to a thousand kilometres, far from where doubles end.
constexpr double kMinCell = 1e-6;
constexpr double kMaxCell = 1e6;

/// 64-bit words that a grid of these dimensions needs: a header of 8, both layers, one bit for each word of a layer to
/// note what changed, and one word for 64 to tell contents apart; 0 for dimensions that do not fit.
size_t grid_words(const Voxel& dims) noexcept;

/// What an inflated grid holds at one time: equal versions mean equal voxels, but for a chance of 2^-64.
struct GridVersion {
  const uint64_t* words;  ///< the storage; null where the grid is not bound or not inflated
  uint64_t binding;       ///< which bind of the storage, and to which spec
  uint64_t revision;
  uint64_t content;  ///< of the obstacle layer

  bool equals(const GridVersion& other) const noexcept {
    return words == other.words && binding == other.binding && revision == other.revision && content == other.content;
  }
};

/// A grid over the caller's storage, which must outlive it. Copying copies the view, not the bits: revision and all
/// else that tells of the bits lie in the storage with them, so that any copy may mark, clear and inflate, and all
/// agree. Binding a storage through one grid ends the binding of all others over it.
///
/// Frames: `world` arguments are in the world frame; everything past the grid computes in the local
/// frame, world minus spec().origin, so that precision does not depend on where the map lies.
class Grid {
 public:
  /// Binds the grid to `words` (at least grid_words(spec.dims), any content) and clears it: no obstacle, and nothing
  /// free before inflate(). kNonFiniteInput / kInvalidArgument, with the field in *field where given; the grid and the
  /// words are then as they were.
  Status bind(const GridSpec& spec, uint64_t* words, size_t word_count, Field* field = nullptr) noexcept;

  // Every mark and clear answers kInvalidArgument on a grid that is not bound, and changes nothing unless kOk. Voxels,
  // rows and contents that are read from a grid whose binding ended have no meaning.

  /// Marks or clears each voxel whose interior the box meets (by more than kLatticeTolerance and the rounding of its
  /// world coordinates); a flat box on a lattice plane takes the voxels above the plane, at the grid's upper face
  /// those below it. Parts outside the grid are ignored. kNonFiniteInput; kInvalidArgument where lower > upper.
  Status mark_box(const Box& world) noexcept;
  Status clear_box(const Box& world) noexcept;
  /// Marks or clears one voxel; kOutOfMap outside the grid.
  Status mark_voxel(const Voxel& voxel) noexcept;
  Status clear_voxel(const Voxel& voxel) noexcept;
  /// Marks the voxel that holds each point (lower faces closed); points outside the grid are skipped. Returns how many
  /// were inside through *inside where given. kNonFiniteInput where any point is not finite, marking none;
  /// kInvalidArgument for null with count > 0.
  Status mark_points(const Vec3* world, size_t count, size_t* inside = nullptr) noexcept;

  /// Brings the blocked layer up to date with the obstacle layer, the radius and the boundary: only the words near
  /// obstacles that changed since the last time are made again, equal to making all. Does nothing where nothing
  /// changed, or on a grid that is not bound. The revision stays: the blocked layer belongs to the obstacles' revision.
  /// Planning on a grid whose obstacles changed since answers kInvalidArgument (field kNotInflated).
  void inflate() noexcept;

  const GridSpec& spec() const noexcept { return spec_; }
  /// False before the first bind, and once the storage was bound anew through another grid or overwritten.
  bool bound() const noexcept { return words_ != nullptr && words_[kBinding] == binding_; }
  /// True where the blocked layer is up to date.
  bool inflated() const noexcept { return bound() && words_[kInflated] == words_[kRevision]; }
  /// Grows with every bind, and by one with every mark or clear that answered kOk, whichever copy it came through;
  /// never begins again for the same grid or the same storage. 0 where the grid is not bound.
  uint64_t revision() const noexcept { return bound() ? words_[kRevision] : 0; }
  /// All zero where the grid is not inflated.
  GridVersion version() const noexcept {
    return inflated() ? GridVersion{words_, binding_, words_[kRevision], words_[kContent]} : GridVersion{};
  }

  bool inside(const Voxel& v) const noexcept {
    return v.x >= 0 && v.y >= 0 && v.z >= 0 && v.x < spec_.dims.x && v.y < spec_.dims.y && v.z < spec_.dims.z;
  }
  /// Outside the grid nothing is an obstacle, and nothing is free.
  bool obstacle(const Voxel& v) const noexcept { return inside(v) && bit(obstacles_, v); }
  bool free(const Voxel& v) const noexcept { return inside(v) && !bit(blocked_, v); }

  /// Words of one row along x, ceil(dims.x / 64). Bits past dims.x are 0 in obstacles, 1 in blocked.
  int32_t row_words() const noexcept { return row_words_; }
  const uint64_t* obstacle_row(int32_t y, int32_t z) const noexcept { return obstacles_ + row(y, z); }
  const uint64_t* blocked_row(int32_t y, int32_t z) const noexcept { return blocked_ + row(y, z); }

  /// Words of one layer.
  size_t layer_words() const noexcept {
    return static_cast<size_t>(spec_.dims.z) * static_cast<size_t>(spec_.dims.y) * static_cast<size_t>(row_words_);
  }
  /// A view whose blocked layer is `words` (layer_words() of them), taken as they are, rows as in this grid's.
  Grid with_blocked(uint64_t* words) const noexcept {
    Grid view = *this;
    view.blocked_ = words;
    view.contents_ = nullptr;
    return view;
  }
  /// A number for each region of the blocked layer (64 voxels along x and along y, one plane) that tells its content:
  /// where two numbers are equal, in one grid at two times or in two grids, so are the regions. Null for a view whose
  /// blocked layer was given. Written by inflate().
  const uint64_t* contents() const noexcept { return contents_; }

  /// Local frame (world minus origin).
  Vec3 to_local(const Vec3& world) const noexcept;
  /// The voxel of a local point: half-open cubes (a point within kLatticeTolerance below a face counts as on it), but
  /// the boundary's upper faces belong to the last voxel. A point that the rounding of its world coordinates left
  /// outside the boundary counts as on its face. Outside the grid for a point outside, never further than one voxel:
  /// coordinates are clamped to -1 .. dims.
  Voxel voxel_of(const Vec3& local) const noexcept;
  /// A voxel's centre, local frame.
  Vec3 center(const Voxel& voxel) const noexcept;
  /// The boundary in the local frame, within the grid; a face on the lattice but for rounding is on it exactly.
  Box local_boundary() const noexcept { return local_boundary_; }

 private:
  /// Words of the storage's header that are in use.
  enum Header : int { kTag, kBinding, kRevision, kInflated, kContent };

  size_t row(int32_t y, int32_t z) const noexcept {
    return (static_cast<size_t>(z) * static_cast<size_t>(spec_.dims.y) + static_cast<size_t>(y)) *
           static_cast<size_t>(row_words_);
  }
  void begin_header() noexcept;
  Status set_box(const Box& world, bool value) noexcept;
  Status set_voxel(const Voxel& voxel, bool value) noexcept;
  void set_row(int32_t y, int32_t z, int32_t begin, int32_t end, bool value) noexcept;
  bool bit(const uint64_t* layer, const Voxel& v) const noexcept {
    return ((layer[row(v.y, v.z) + static_cast<size_t>(v.x >> 6)] >> (v.x & 63)) & 1u) != 0;
  }

  GridSpec spec_{};
  Box local_boundary_{};
  int32_t row_words_ = 0;
  int32_t reach_x_ = 0;   // voxels along x that an obstacle blocks to either side
  uint64_t binding_ = 0;  // what the header holds as long as this view is bound
  uint64_t bound_at_revision_ = 0;
  uint64_t* words_ = nullptr;  // the storage, which begins with the header
  uint64_t* obstacles_ = nullptr;
  uint64_t* blocked_ = nullptr;
  uint64_t* changes_ = nullptr;
  uint64_t* contents_ = nullptr;  // of the blocked layer's regions
};

}  // namespace tern

#endif
