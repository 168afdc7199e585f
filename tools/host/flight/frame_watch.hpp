// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TERN_HOST_FLIGHT_FRAME_WATCH_HPP
#define TERN_HOST_FLIGHT_FRAME_WATCH_HPP

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "host/flight/depth_camera.hpp"
#include "host/flight/lidar.hpp"
#include "tern/map.hpp"

namespace tern_host {

/// True if what a frame of time t, ns, hits at `point` may be a thing that moves, grown by `room` m on all sides. Such
/// hits mark no voxel.
using Explains = std::function<bool(const tern::Vec3& point, std::int64_t t, double room)>;

/// Holds a map to the sixth invariant, with code of its own and at random voxels of every frame: a voxel becomes free
/// only where its whole cube is in front of every pixel that covers it, and is not free once it was hit in as many
/// frames, one after the other, as MapSpec::hits says, by what does not move. After a scan, a voxel becomes free only
/// where its whole cube is free in the true world.
class FrameWatch {
 public:
  /// World and map must outlive the watch. `explains` may be empty: nothing moves.
  FrameWatch(const FlightWorld& world, const tern::MapSpec& spec, const tern::RollingMap& map, Explains explains = {});

  /// Before a frame or a scan is entered, and after that, but before the next one, with the same one.
  void before(const DepthFrame& frame);
  void after(const DepthFrame& frame);
  void before(const LidarScan& scan);
  void after(const LidarScan& scan);
  /// From now on, poses are off by more than their margin, and what scans show is not compared with the true world.
  void forget_world() { knows_world_ = false; }
  const std::string& broken() const { return broken_; }
  /// Voxels that became free while they were watched, and hits that were looked at.
  std::uint64_t seen() const { return seen_; }
  std::uint64_t hits() const { return hits_; }

 private:
  bool voxel_at(const tern::Vec3& point, tern::Voxel& voxel) const;
  bool wholly_in_front(const DepthFrame& frame, const tern::Vec3& center) const;
  bool begin();
  bool end();
  tern::Vec3 center_of(const tern::Voxel& voxel) const;
  void note_unseen(const tern::Vec3& point);
  template <typename IsWhole>
  void check_seen(IsWhole is_whole);
  bool is_hit(const tern::Vec3& point, tern::Voxel& voxel) const;
  bool is_supported(const DepthFrame& frame, int u, int v) const;
  std::vector<tern::Vec3> hits_of(const DepthFrame& frame);
  std::vector<tern::Vec3> hits_of(const LidarScan& scan) const;
  void check_hits(const std::vector<tern::Vec3>& points, std::int64_t taken);

  const FlightWorld& world_;
  bool knows_world_ = true;
  tern::MapSpec spec_;
  const tern::RollingMap& map_;
  Explains explains_;
  Noise noise_;
  bool watches_ = false;
  /// A voxel that was hit in all of the last frames.
  struct HitVoxel {
    tern::Vec3 center;
    int frames;
    bool may_move;  ///< a thing that moves may explain what was hit
  };
  std::vector<tern::Vec3> unseen_;  ///< centres of voxels
  std::vector<HitVoxel> hit_;
  std::uint64_t seen_ = 0, hits_ = 0;
  std::string broken_;
};

}  // namespace tern_host

#endif
