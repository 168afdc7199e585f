// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TERN_HOST_FLIGHT_FRAME_WATCH_HPP
#define TERN_HOST_FLIGHT_FRAME_WATCH_HPP

#include <string>
#include <vector>

#include "host/flight/depth_camera.hpp"
#include "tern/map.hpp"

namespace tern_host {

/// Holds a map to the sixth invariant, with code of its own and at random voxels of every frame: a voxel becomes free
/// only where its whole cube is in front of every pixel that covers it, and is not free once it was hit.
class FrameWatch {
 public:
  /// The map must outlive the watch.
  FrameWatch(const tern::MapSpec& spec, const tern::RollingMap& map, std::uint64_t seed);

  /// Before a frame is entered, and after that, but before the next one, with the same frame.
  void before(const DepthFrame& frame);
  void after(const DepthFrame& frame);
  const std::string& broken() const { return broken_; }
  /// Voxels that became free while they were watched, and hits that were looked at.
  std::uint64_t seen() const { return seen_; }
  std::uint64_t hits() const { return hits_; }

 private:
  bool voxel_at(const tern::Vec3& point, tern::Voxel& voxel) const;
  bool wholly_in_front(const DepthFrame& frame, const tern::Vec3& center) const;
  void check_hit(const DepthFrame& frame);

  tern::MapSpec spec_;
  const tern::RollingMap& map_;
  Noise noise_;
  bool watches_ = false;
  std::vector<tern::Vec3> unseen_;  ///< centres of voxels
  std::uint64_t seen_ = 0, hits_ = 0;
  std::string broken_;
};

}  // namespace tern_host

#endif
