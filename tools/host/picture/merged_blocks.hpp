// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Many rectangles drawn as few: the cells of a raster, in runs of one strength. The size of what is drawn depends on
// the raster alone.
#ifndef TERN_HOST_PICTURE_MERGED_BLOCKS_HPP
#define TERN_HOST_PICTURE_MERGED_BLOCKS_HPP

#include <string>
#include <vector>

#include "host/picture/canvas.hpp"

namespace tern_host {

class MergedBlocks {
 public:
  /// A raster of square cells over `frame`.
  explicit MergedBlocks(const Rect& frame);

  /// Covers a rectangle, in pixels, with a weight. Weights add up, to 1 at most.
  void add(const Rect& rect, double weight);

  /// One path for each strength. Cells covered by less than `threshold` are left out; the others' opacity is `base`
  /// and up to `span` more.
  void draw(Canvas& canvas, const std::string& style, double threshold, double base, double span) const;

 private:
  std::vector<int> strengths(double threshold) const;
  std::string runs(const std::vector<int>& strengths, int strength) const;

  Rect frame_;
  double cell_;
  int columns_;
  int rows_;
  std::vector<double> changes_;  ///< of the coverage from cell to cell, along rows and columns
};

}  // namespace tern_host

#endif
