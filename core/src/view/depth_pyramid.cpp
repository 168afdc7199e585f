// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "view/depth_pyramid.hpp"

#include "base/vectors.hpp"

namespace tern {
namespace {

// Types instead of functions, so that no call goes through a pointer even if it is not inlined.
struct Lesser {
  Depth operator()(Depth a, Depth b) const { return b < a ? b : a; }
};
struct Greater {
  Depth operator()(Depth a, Depth b) const { return a < b ? b : a; }
};

#if TERN_HAS_VECTORS
/// Eight depths at a time, which fit a register.
using EightDepths __attribute__((vector_size(16))) = Depth;
constexpr std::int32_t kEight = 8;
constexpr EightDepths kPlaces = {0, 1, 2, 3, 4, 5, 6, 7};

EightDepths eight(std::int32_t number) {
  const Depth n = static_cast<Depth>(number);
  return EightDepths{n, n, n, n, n, n, n, n};
}
EightDepths load(const Depth* from) {
  EightDepths depths;
  __builtin_memcpy(&depths, from, sizeof depths);
  return depths;
}
bool none(EightDepths mask) {
  std::uint64_t halves[2];
  __builtin_memcpy(halves, &mask, sizeof halves);
  return (halves[0] | halves[1]) == 0;
}
#endif

/// Number of levels until the shorter side has one entry left.
std::int32_t count_levels(std::int32_t width, std::int32_t height) {
  const std::int32_t side = width < height ? width : height;
  std::int32_t levels = 1;
  while (levels < kPyramidLevels && (side >> levels) > 0) ++levels;
  return levels;
}

/// Combines each pair of columns of two rows into one entry; an odd last column is combined alone.
template <typename Pick>
void halve(const Depth* upper, const Depth* lower, std::int32_t width, Depth* __restrict to, Pick pick) {
  for (std::int32_t u = 0; u < width / 2; ++u) {
    to[u] = pick(pick(upper[2 * u], upper[2 * u + 1]), pick(lower[2 * u], lower[2 * u + 1]));
  }
  if (width % 2 != 0) to[width / 2] = pick(upper[width - 1], lower[width - 1]);
}

}  // namespace

DepthPyramid::DepthPyramid(std::int32_t width, std::int32_t height, Depth* entries) noexcept
    : width_(width), height_(height), levels_(count_levels(width, height)) {
  least_[0] = entries;
  most_[0] = entries;
  for (std::int32_t level = 1; level < levels_; ++level) {
    const std::ptrdiff_t below = static_cast<std::ptrdiff_t>(this->width(level - 1)) * this->height(level - 1);
    least_[level] = level == 1 ? entries + below : most_[level - 1] + below;
    most_[level] = least_[level] + static_cast<std::ptrdiff_t>(this->width(level)) * this->height(level);
  }
}

std::int64_t DepthPyramid::entries(std::int32_t width, std::int32_t height) noexcept {
  std::int64_t sum = std::int64_t{width} * height;
  for (std::int32_t level = 1; level < count_levels(width, height); ++level) {
    const std::int64_t round = (std::int64_t{1} << level) - 1;
    sum += 2 * ((width + round) >> level) * ((height + round) >> level);
  }
  return sum;
}

std::int32_t DepthPyramid::close_level(const PixelBox& box) noexcept {
  const std::int32_t across = box.u1 - box.u0;
  const std::int32_t down = box.v1 - box.v0;
  const std::int32_t span = across > down ? across : down;
  static_assert(kCloseEntries > 4 && kCloseEntries <= 8, "span >> level is 4 to 7, and reaches() loads eight entries");
  std::int32_t level = span < 4 ? 0 : 29 - __builtin_clz(static_cast<unsigned>(span));
  level += (span >> level) >= kCloseEntries ? 1 : 0;
  // Where the rectangle lies, it may touch one entry more.
  const auto spans = [&](std::int32_t from, std::int32_t to) { return (to >> level) - (from >> level); };
  return spans(box.u0, box.u1) >= kCloseEntries || spans(box.v0, box.v1) >= kCloseEntries ? level + 1 : level;
}

Depth DepthPyramid::least_closely(const PixelBox& box) const noexcept {
  const std::int32_t level = close_level(box);
  if (level >= levels_) return 0;
  const std::ptrdiff_t stride = width(level);
  Depth result = kDepthUnits;
  for (std::int32_t v = box.v0 >> level; v <= box.v1 >> level; ++v) {
    const Depth* const row = least_[level] + v * stride;
    for (std::int32_t u = box.u0 >> level; u <= box.u1 >> level; ++u) result = row[u] < result ? row[u] : result;
  }
  return result;
}

bool DepthPyramid::reaches(const PixelBox& box, std::int32_t far) const noexcept {
#if TERN_HAS_VECTORS
  const std::int32_t level = close_level(box);
  if (level >= levels_ || far > kDepthUnits) return false;
  const std::ptrdiff_t stride = width(level);
  if (stride >= kEight) {
    const std::int32_t u0 = box.u0 >> level;
    const std::int32_t begin = u0 + kEight <= width(level) ? u0 : width(level) - kEight;
    const std::int32_t first = u0 - begin;
    const std::int32_t last = (box.u1 >> level) - begin;
    const Depth* row = least_[level] + (box.v0 >> level) * stride + begin;
    const EightDepths bound = eight(far);
    EightDepths nearer = {};
    // Always as many rows, the last one again and again: a number of turns that nobody can predict takes longer.
    const std::int32_t rows = (box.v1 >> level) - (box.v0 >> level);
    for (std::int32_t v = 0; v < kCloseEntries; ++v) nearer |= load(row + (v < rows ? v : rows) * stride) < bound;
    return none(nearer & (kPlaces >= eight(first)) & (kPlaces <= eight(last)));
  }
#endif
  return least_closely(box) >= far;
}

void DepthPyramid::make_row(std::int32_t level, std::int32_t row) const noexcept {
  const std::int32_t below = width(level - 1);
  const std::int32_t next = 2 * row + 1 < height(level - 1) ? below : 0;
  const std::ptrdiff_t from = static_cast<std::ptrdiff_t>(2 * row) * below;
  const std::ptrdiff_t to = static_cast<std::ptrdiff_t>(row) * width(level);
  const Depth* least = least_[level - 1] + from;
  const Depth* most = most_[level - 1] + from;
  halve(least, least + next, below, least_[level] + to, Lesser{});
  halve(most, most + next, below, most_[level] + to, Greater{});
}

}  // namespace tern
