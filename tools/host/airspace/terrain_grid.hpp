// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// A tile of SRTM: heights of the ground, above mean sea level.
#ifndef TERN_HOST_AIRSPACE_TERRAIN_GRID_HPP
#define TERN_HOST_AIRSPACE_TERRAIN_GRID_HPP

#include <string>
#include <vector>

#include "host/airspace/local_frame.hpp"

namespace tern_host {

/// A degree of latitude and longitude as a square of posts, big-endian int16, the north-west corner first. The name of
/// the file is that of the south-west corner: N47E008.hgt.
class TerrainGrid {
 public:
  /// Throws RecordError.
  explicit TerrainGrid(const std::string& path);
  TerrainGrid(const std::string& bytes, const std::string& name);

  /// Widens [low, high] by all posts of the cells that the box meets; the ground between posts is taken to be between
  /// theirs. Throws std::invalid_argument where the box is not all within the tile, or a post has no height.
  void widen(const GeoPoint& south_west, const GeoPoint& north_east, double& low, double& high) const;

 private:
  std::string name_;
  int posts_ = 0;  // along a side
  double south_ = 0.0, west_ = 0.0;
  std::vector<int> heights_;  // from the north-west corner eastwards
};

}  // namespace tern_host

#endif
