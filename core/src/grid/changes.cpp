// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "grid/changes.hpp"

namespace tern {
namespace {

/// Widens a range to hold an index.
void hold(IndexRange& range, std::int32_t index) {
  if (index < range.begin) range.begin = index;
  if (index >= range.end) range.end = index + 1;
}

}  // namespace

std::size_t Changes::words(const Voxel& dims) noexcept {
  const std::int64_t strips = std::int64_t{words_for(dims.y)} * dims.z;
  return static_cast<std::size_t>(words_for(dims.z) + words_for(dims.x) * strips);
}

bool Changes::any() const noexcept {
  for (std::int32_t k = 0; k < words_for(planes_); ++k) {
    if (summary_[k] != 0) return true;
  }
  return false;
}

ChangeExtent Changes::extent(const IndexRange& planes) const noexcept {
  ChangeExtent extent{{planes.end, planes.begin}, {row_words_, 0}, {}};
  for (std::int32_t z = planes.begin; z < planes.end; ++z) {
    if (!plane(z)) continue;
    hold(extent.planes, z);
    for (std::int32_t strip = 0; strip < strips_; ++strip) {
      for (std::int32_t k = 0; k < row_words_; ++k) {
        const std::uint64_t rows = bits_[at(z, strip, k)];
        if (rows == 0) continue;
        extent.rows[strip] |= rows;
        hold(extent.words, k);
      }
    }
  }
  return extent;
}

void Changes::set_plane(std::int32_t z, std::uint64_t value) noexcept {
  std::uint64_t* words = bits_ + at(z, 0, 0);
  for (std::int32_t k = 0; k < strips_ * row_words_; ++k) words[k] = value;
}

void Changes::note_all() noexcept {
  for (std::int32_t k = 0; k < words_for(planes_); ++k) summary_[k] = kAllBits;
  for (std::int32_t z = 0; z < planes_; ++z) set_plane(z, kAllBits);
}

void Changes::clear() noexcept {
  for (std::int32_t z = 0; z < planes_; ++z) {
    if (plane(z)) set_plane(z, 0);
  }
  for (std::int32_t k = 0; k < words_for(planes_); ++k) summary_[k] = 0;
}

}  // namespace tern
