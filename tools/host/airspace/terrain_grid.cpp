// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "host/airspace/terrain_grid.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "host/text_records.hpp"

namespace tern_host {
namespace {

/// Posts along a side of the tiles that there are: three seconds of arc, and one.
constexpr int kSizes[] = {1201, 3601};
constexpr std::size_t kMostTileBytes = 2u * 3601 * 3601;
constexpr int kNoHeight = -32768;

/// "N47E008" anywhere in the last part of a path.
bool corner_of(const std::string& path, double& south, double& west) {
  const std::string name = path.substr(path.find_last_of('/') + 1);
  if (name.size() < 7) return false;
  const char ns = name[0], ew = name[3];
  if ((ns != 'N' && ns != 'S') || (ew != 'E' && ew != 'W')) return false;
  for (const std::size_t digit : {1u, 2u, 4u, 5u, 6u}) {
    if (name[digit] < '0' || name[digit] > '9') return false;
  }
  south = (ns == 'N' ? 1.0 : -1.0) * std::stoi(name.substr(1, 2));
  west = (ew == 'E' ? 1.0 : -1.0) * std::stoi(name.substr(4, 3));
  return true;
}

}  // namespace

TerrainGrid::TerrainGrid(const std::string& path) : TerrainGrid(read_bytes(path, kMostTileBytes), path) {}

TerrainGrid::TerrainGrid(const std::string& bytes, const std::string& name) : name_(name) {
  for (const int size : kSizes) {
    if (bytes.size() == 2u * static_cast<std::size_t>(size) * static_cast<std::size_t>(size)) posts_ = size;
  }
  if (posts_ == 0) throw RecordError({name, 0}, "not a tile of SRTM: it must have 1201 x 1201 or 3601 x 3601 heights");
  if (!corner_of(name, south_, west_)) {
    throw RecordError({name, 0}, "its name must begin with its south-west corner, such as N47E008.hgt");
  }
  for (std::size_t i = 0; i + 1 < bytes.size(); i += 2) {
    const int high = static_cast<unsigned char>(bytes[i]), low = static_cast<unsigned char>(bytes[i + 1]);
    const int value = high * 256 + low;
    heights_.push_back(value >= 32768 ? value - 65536 : value);
  }
}

void TerrainGrid::widen(const GeoPoint& south_west, const GeoPoint& north_east, double& low, double& high) const {
  const double cells = posts_ - 1;
  const double west = std::remainder(south_west.longitude - west_ - 0.5, 360.0) + 0.5;
  const double east = std::remainder(north_east.longitude - west_ - 0.5, 360.0) + 0.5;
  const double south = south_west.latitude - south_, north = north_east.latitude - south_;
  const bool within = south >= 0.0 && north <= 1.0 && west >= 0.0 && east <= 1.0 && south <= north && west <= east;
  if (!within) throw std::invalid_argument("a zone reaches beyond the terrain of " + name_ + ": lessen the boundary");
  const int row0 = static_cast<int>(std::floor((1.0 - north) * cells)),
            row1 = static_cast<int>(std::ceil((1.0 - south) * cells));
  const int column0 = static_cast<int>(std::floor(west * cells)), column1 = static_cast<int>(std::ceil(east * cells));
  for (int row = row0; row <= row1; ++row) {
    for (int column = column0; column <= column1; ++column) {
      const int height =
          heights_[static_cast<std::size_t>(row) * static_cast<std::size_t>(posts_) + static_cast<std::size_t>(column)];
      if (height == kNoHeight) throw std::invalid_argument("the terrain of " + name_ + " has a hole below a zone");
      low = std::min(low, static_cast<double>(height));
      high = std::max(high, static_cast<double>(height));
    }
  }
}

}  // namespace tern_host
