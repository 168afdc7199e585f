// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Point clouds and OctoMaps, read by the verifier's own means: what is occupied, and what is known to be free.
#ifndef TERN_VERIFY_MAP_FILES_HPP
#define TERN_VERIFY_MAP_FILES_HPP

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace tern_verify {

/// World frame, metres; all coordinates are finite.
using CloudPoint = std::array<double, 3>;

/// A cube of the tree: from (key - 32768) * resolution on, `size` times the resolution wide.
struct Leaf {
  std::array<std::int64_t, 3> key;
  std::int64_t size;
  bool occupied;
};

struct Octree {
  double resolution;
  std::vector<Leaf> leaves;
};

/// Reads all of a file's content; `name` is for messages. Throws InputError where it is no such file, or broken.
std::vector<CloudPoint> read_cloud(const std::string& bytes, const std::string& name);
Octree read_octree(const std::string& bytes, const std::string& name);

}  // namespace tern_verify

#endif
