// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TERN_HOST_PICTURE_OBLIQUE_SCENE_HPP
#define TERN_HOST_PICTURE_OBLIQUE_SCENE_HPP

#include <string>
#include <vector>

#include "host/picture/oblique_camera.hpp"

namespace tern_host {

/// More boxes than this make a file that is slow to show: of more, the large ones are drawn.
constexpr std::size_t kMaxObliqueBlocks = 1000;

/// What stands in a map, seen by a camera: drawing it, and what of a line it hides.
class ObliqueScene {
 public:
  ObliqueScene(const Scenario& scenario, const ObliqueCamera& camera);

  void draw_ground(Canvas& canvas) const;
  void draw_blocks(Canvas& canvas) const;
  void draw_fences(Canvas& canvas, tern::FenceKind kind) const;
  /// Whether an obstacle stands before a point of the world.
  bool hidden(const tern::Vec3& world) const;

 private:
  const Scenario& scenario_;
  const ObliqueCamera& camera_;
  std::vector<tern::Box> boxes_;  ///< turned, within the boundary
  std::vector<bool> keepout_;     ///< of each box
};

}  // namespace tern_host

#endif
