// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Marks the voxels that points lie in, four points at a time. Neighbouring points often lie in the same word: its bits
// are collected and written together.
#ifndef TERN_MAP_HIT_WRITER_HPP
#define TERN_MAP_HIT_WRITER_HPP

#include <cstddef>
#include <cstdint>

#include "view/four.hpp"
#include "view/view.hpp"

namespace tern {

class HitWriter {
 public:
  /// Writes into a layer of the window with rows of `row_words` words, `rows` rows a plane. Points outside the box are
  /// left out.
  HitWriter(std::uint64_t* layer, std::int32_t row_words, std::int32_t rows, const VoxelBox& box) noexcept
      : layer_(layer), row_words_(static_cast<float>(row_words)), rows_(static_cast<float>(rows)), box_(box) {}
  ~HitWriter() { write(); }
  HitWriter(const HitWriter&) = delete;
  HitWriter& operator=(const HitWriter&) = delete;

  /// Marks the voxels of the points that are valid. Coordinates in voxels from the window's corner.
  void add(const Four (&cells)[3], FourInts valid) noexcept {
    const FourInts x = on_axis(cells[0], box_.x, valid);
    const FourInts y = on_axis(cells[1], box_.y, valid);
    const FourInts z = on_axis(cells[2], box_.z, valid);
    const FourInts rows = whole((decimal(z) * rows_ + decimal(y)) * row_words_);
    const FourInts words = choose(valid, rows + (x >> 6), FourInts{-1, -1, -1, -1});
    for (int k = 0; k < 4; ++k) mark(words[k], x[k]);
  }

 private:
  /// The voxels' indices on one axis. Points outside the range are no longer valid.
  static FourInts on_axis(Four cells, const IndexRange& range, FourInts& valid) noexcept {
    const FourInts index = floor_index(cells, static_cast<float>(range.end));
    valid &= (index >= range.begin) & (index < range.end);
    return index;
  }
  void mark(std::int32_t word, std::int32_t x) noexcept {
    if (word < 0) return;
    if (word != word_) write();
    word_ = word;
    bits_ |= std::uint64_t{1} << (x & 63);
  }
  void write() noexcept {
    layer_[word_] |= bits_;
    bits_ = 0;
  }

  std::uint64_t* const layer_;
  const float row_words_;  ///< a layer has less than 2^24 words, whose indices single precision holds exactly
  const float rows_;
  const VoxelBox box_;
  std::int32_t word_ = 0;
  std::uint64_t bits_ = 0;
};

}  // namespace tern

#endif
