// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// An image of depths, with coarser and coarser images of its minima and maxima. The least or the largest depth in any
// rectangle of pixels takes nine reads.
#ifndef TERN_VIEW_DEPTH_PYRAMID_HPP
#define TERN_VIEW_DEPTH_PYRAMID_HPP

#include <cstddef>
#include <cstdint>

namespace tern {

/// A depth in units of the frame's range / kDepthUnits. 0: no measurement.
using Depth = std::int16_t;
constexpr std::int32_t kDepthUnits = 32766;

/// The most levels. A rectangle that spans more than three entries of the last level has no answer.
constexpr std::int32_t kPyramidLevels = 11;

/// The most entries along each axis that a close look at a rectangle reads.
constexpr std::int32_t kCloseEntries = 6;

/// A rectangle of pixels, first and last ones included.
struct PixelBox {
  std::int32_t u0, u1, v0, v1;
};

/// A pyramid in the map's storage. Level k has one entry for each 2^k x 2^k pixels.
class DepthPyramid {
 public:
  DepthPyramid() noexcept = default;
  DepthPyramid(std::int32_t width, std::int32_t height, Depth* entries) noexcept;

  /// Number of entries of an image of this size, all levels together.
  static std::int64_t entries(std::int32_t width, std::int32_t height) noexcept;

  std::int32_t levels() const noexcept { return levels_; }
  std::int32_t width(std::int32_t level) const noexcept { return (width_ + (1 << level) - 1) >> level; }
  std::int32_t height(std::int32_t level) const noexcept { return (height_ + (1 << level) - 1) >> level; }

  /// A row of the image itself, for writing.
  Depth* row(std::int32_t v) const noexcept { return least_[0] + static_cast<std::ptrdiff_t>(v) * width_; }
  /// Makes a row of a level >= 1 from the level below.
  void make_row(std::int32_t level, std::int32_t row) const noexcept;

  /// The level at which a rectangle inside the image spans at most three entries along each axis; levels() if there is
  /// none.
  std::int32_t level_for(const PixelBox& box) const noexcept {
    const std::int32_t across = box.u1 - box.u0;
    const std::int32_t down = box.v1 - box.v0;
    const std::int32_t span = across > down ? across : down;
    if (span <= 2) return 0;
    const std::int32_t level = 32 - __builtin_clz(static_cast<unsigned>(span - 1) / 2);
    return level < levels_ ? level : levels_;
  }
  /// A lower bound of the depths in the rectangle; most() is an upper bound.
  Depth least(const PixelBox& box, std::int32_t level) const noexcept {
    return reduce(least_[level], box, level, [](Depth a, Depth b) { return b < a ? b : a; });
  }
  /// A closer lower bound than least(), from up to kCloseEntries entries along each axis: a finer level rounds the
  /// rectangle's edges outwards by less. 0 if there is no answer.
  Depth least_closely(const PixelBox& box) const noexcept;
  /// True if least_closely() is at least `far`, which is positive. Reads eight entries at a time where the target can.
  bool reaches(const PixelBox& box, std::int32_t far) const noexcept;
  Depth most(const PixelBox& box, std::int32_t level) const noexcept {
    return reduce(most_[level], box, level, [](Depth a, Depth b) { return a < b ? b : a; });
  }

 private:
  /// Combines nine entries: three columns of three rows. Some of them may coincide, which saves branches.
  template <typename Pick>
  Depth reduce(const Depth* entries, const PixelBox& box, std::int32_t level, Pick pick) const noexcept {
    const std::ptrdiff_t stride = width(level);
    const std::int32_t u0 = box.u0 >> level;
    const std::int32_t u2 = box.u1 >> level;
    const std::int32_t u1 = (u0 + u2) >> 1;
    const std::int32_t v0 = box.v0 >> level;
    const std::int32_t v2 = box.v1 >> level;
    const Depth* rows[] = {entries + v0 * stride, entries + ((v0 + v2) >> 1) * stride, entries + v2 * stride};
    Depth result = rows[0][u0];
    for (const Depth* row : rows) result = pick(result, pick(pick(row[u0], row[u1]), row[u2]));
    return result;
  }

  /// The finest level at which a rectangle spans at most kCloseEntries entries along each axis; may be levels() or
  /// more.
  static std::int32_t close_level(const PixelBox& box) noexcept;

  std::int32_t width_ = 0;
  std::int32_t height_ = 0;
  std::int32_t levels_ = 0;
  Depth* least_[kPyramidLevels] = {};
  Depth* most_[kPyramidLevels] = {};
};

}  // namespace tern

#endif
