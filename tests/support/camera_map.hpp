// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TERN_TESTS_SUPPORT_CAMERA_MAP_HPP
#define TERN_TESTS_SUPPORT_CAMERA_MAP_HPP

#include "tern/map.hpp"

namespace tern_test {

/// A small map without errors, for images of up to 64 x 64 pixels.
inline tern::MapSpec camera_spec() {
  tern::MapSpec spec = tern::map_spec({0.0, 0.0, 0.0}, 0.1, {64, 20, 20}, 0.0);
  spec.depth_margin = 0.0;
  spec.pose_margin = 0.0;
  spec.range = 6.0;
  spec.pixels = 4096;
  return spec;
}

}  // namespace tern_test

#endif
