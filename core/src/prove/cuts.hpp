// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Finds which voxels of a block of rows some half-spaces cut off.
#ifndef TERN_PROVE_CUTS_HPP
#define TERN_PROVE_CUTS_HPP

#include <cstdint>

#include "base/math.hpp"
#include "tern/config.hpp"
#include "tern/vec3.hpp"

namespace tern {

/// A block of rows along x: voxels lo to hi, both included.
struct RowBlock {
  Voxel lo;
  Voxel hi;
};

/// A half-space in the form that tells which voxels of a row along x it cuts off. Voxels are closed cubes.
struct PlaneCut {
  double y;  ///< of the normal
  double z;
  double reach;  ///< a cube this far along the normal, or further, is cut off, metres
  double per_x;  ///< 1 / (normal.x * cell): voxels along x for a metre along the normal; 0: all voxels of a row count
                 ///< alike

  /// The end of a row of cubes in y, and in z, that is cut off last: 0 the lower, 1 the upper.
  int far_y() const { return y < 0.0 ? 1 : 0; }
  int far_z() const { return z < 0.0 ? 1 : 0; }
};

/// Cuts, sorted by the sign of per_x: zero, negative, positive.
struct PlaneCuts {
  PlaneCut cut[kMaxPlanes];
  int end[3];  ///< end of each sign's cuts
};

/// Voxels [begin, end) of x.
struct RowSpan {
  std::int32_t begin;
  std::int32_t end;
};

/// The lower and the upper end of a block of rows in y and z, metres.
struct BlockEnds {
  double y[2];
  double z[2];

  BlockEnds(double cell, const RowBlock& block)
      : y{block.lo.y * cell, (block.hi.y + 1) * cell}, z{block.lo.z * cell, (block.hi.z + 1) * cell} {}

  /// By how many metres, along the half-space's normal, the nearest cubes of the block are too near, apart from their
  /// x.
  double missing(const PlaneCut& cut) const { return cut.reach - (cut.y * y[cut.far_y()] + cut.z * z[cut.far_z()]); }
  /// By how many metres the cubes at the block's opposite edge are too near: no row of the block lacks less.
  double least_missing(const PlaneCut& cut) const {
    return cut.reach - (cut.y * y[1 - cut.far_y()] + cut.z * z[1 - cut.far_z()]);
  }
};

/// The voxels of x that no half-space cuts off in all rows of the block. `cut` gives the half-spaces, sorted as in
/// PlaneCuts, with the ends of each sign's in `ends_of_signs`. A half-space that cuts off a voxel also cuts off all
/// voxels behind it in the same sense of x. So one span is left; it is empty if begin >= end.
template <typename CutAt>
RowSpan uncut(double cell, const int (&ends_of_signs)[3], const RowBlock& block, const CutAt& cut) {
  const BlockEnds ends(cell, block);
  double begin = block.lo.x;
  double end = block.hi.x + 1.0;
  int p = 0;
  for (; p < ends_of_signs[0]; ++p) {
    if (ends.missing(cut(p)) <= 0.0) return {0, 0};
  }
  for (; p < ends_of_signs[1]; ++p) begin = larger(begin, ends.missing(cut(p)) * cut(p).per_x);
  for (; p < ends_of_signs[2]; ++p) end = smaller(end, ends.missing(cut(p)) * cut(p).per_x);
  if (begin >= end) return {0, 0};
  // A voxel is cut off from above if it begins at `end` or later, and from below if it ends at `begin` or earlier.
  const auto last = static_cast<std::int32_t>(end);
  return {static_cast<std::int32_t>(begin), last + (static_cast<double>(last) < end ? 1 : 0)};
}

inline RowSpan uncut(double cell, const PlaneCuts& cuts, const RowBlock& block) {
  return uncut(cell, cuts.end, block, [&](int p) -> const PlaneCut& { return cuts.cut[p]; });
}

/// Some of the cuts, by index, in the same order.
struct FewCuts {
  std::int16_t cut[kMaxPlanes];
  int end[3];
};

inline RowSpan uncut(double cell, const PlaneCuts& cuts, const FewCuts& few, const RowBlock& block) {
  return uncut(cell, few.end, block, [&](int p) -> const PlaneCut& { return cuts.cut[few.cut[p]]; });
}

/// The cuts that can take voxels of the span from some row of the block. They are few.
inline FewCuts cuts_within(double cell, const PlaneCuts& cuts, const RowBlock& block, const RowSpan& span) {
  const BlockEnds ends(cell, block);
  FewCuts few;
  int count = 0;
  int p = 0;
  for (int sign = 0; sign < 3; ++sign) {
    for (; p < cuts.end[sign]; ++p) {
      const PlaneCut& cut = cuts.cut[p];
      const double missing = ends.least_missing(cut);
      const bool cuts_none = sign == 0   ? missing > 0.0
                             : sign == 1 ? missing * cut.per_x <= span.begin
                                         : missing * cut.per_x >= span.end;
      if (!cuts_none) few.cut[count++] = static_cast<std::int16_t>(p);
    }
    few.end[sign] = count;
  }
  return few;
}

}  // namespace tern

#endif
