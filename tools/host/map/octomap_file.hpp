// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// OctoMap files: `.bt`, which says of a cube that it is free or occupied, and `.ot`, which says how likely.
#ifndef TERN_HOST_MAP_OCTOMAP_FILE_HPP
#define TERN_HOST_MAP_OCTOMAP_FILE_HPP

#include <cstdint>
#include <string>
#include <vector>

#include "host/text_records.hpp"
#include "tern/vec3.hpp"

namespace tern_host {

/// Levels of a tree below its root.
constexpr int kOctomapDepth = 16;
/// Leaves of a tree at most.
constexpr std::size_t kMaxOctomapLeaves = std::size_t{16} * 1024 * 1024;

/// A cube that is all free or all occupied. Its lower corner lies at (key - 32768) * resolution on each axis.
struct OctomapLeaf {
  std::uint32_t key[3];
  std::uint32_t size;  ///< in cells of the resolution
  bool occupied;
};

struct Octomap {
  double resolution;  ///< edge of the smallest cube, metres
  std::vector<OctomapLeaf> leaves;

  tern::Box box(const OctomapLeaf& leaf) const;
};

/// Reads the whole of a file's content. A leaf of an `.ot` is occupied where it is more likely so than not. Throws
/// RecordError: no OctoMap, a tree of another type, cut off, too many leaves, or another number of nodes than it says.
Octomap parse_octomap(const std::string& bytes, const Place& place);

}  // namespace tern_host

#endif
