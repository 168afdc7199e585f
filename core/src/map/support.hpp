// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Lone pixels: too few of the pixels around them agree with them. A real surface nearly always covers more than one
// pixel, so a lone pixel is most often an error of the sensor. Its depth may neither block a voxel nor free one.
#ifndef TERN_MAP_SUPPORT_HPP
#define TERN_MAP_SUPPORT_HPP

#include <cstdint>

namespace tern {

/// Pixels around one.
constexpr std::int32_t kNeighbours = 8;
/// The depth of a pixel that nothing came back to, if that says something (DepthView::no_return). It hits nothing.
constexpr float kNoReturn = __builtin_inff();

/// Two depths agree if they differ by at most a voxel and both of their errors; kNoReturn agrees with itself alone.
struct Support {
  float cell, margin, margin_square;
  std::int32_t least;  ///< pixels that must agree

  float tolerance(float z) const noexcept { return cell + 2.0f * (margin + margin_square * z * z); }
};

/// The depth up to which a pixel sees, and the depth that it hits; 0 for none.
struct Judged {
  float sees, hits;
};

/// Judges the pixel at[1]. `above`, `at` and `below` are three rows of the image, each from the pixel's left neighbour
/// on; NaN beyond the image's edges. `kHasNone`: some depths may be kNoReturn.
template <bool kHasNone>
Judged judge_pixel(const Support& support, const float* above, const float* at, const float* below) noexcept {
  const float z = at[1];
  const float around[kNeighbours] = {above[0], above[1], above[2], at[0], at[2], below[0], below[1], below[2]};
  const float tolerance = kHasNone && !(z < kNoReturn) ? 0.0f : support.tolerance(z);
  std::int32_t agreeing = 0;
  float nearest = z;
  for (const float n : around) {
    const float off = kHasNone && n <= z && n >= z ? 0.0f : n - z;
    agreeing += (off <= tolerance && -off <= tolerance) ? 1 : 0;
    nearest = n < nearest ? n : nearest;
  }
  return agreeing >= support.least ? Judged{z, z} : Judged{nearest, 0.0f};
}

}  // namespace tern

#endif
