// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include <vector>

#include "fuzz/byte_source.hpp"
#include "fuzz/fuzz_checks.hpp"
#include "tern/map.hpp"

namespace tern_fuzz {
namespace {

constexpr int kFrames = 4;
constexpr int kMostSteps = 100000;

tern::MapSpec spec_of(ByteSource& source) {
  const tern::Voxel dims{64, 8 + source.below(9), 8 + source.below(9)};
  tern::MapSpec spec =
      tern::map_spec(source.vector(-4.0, 4.0), source.number(0.05, 0.5), dims, source.number(0.0, 0.6));
  spec.range = source.number(0.5, 10.0);
  spec.depth_margin = source.number(0.0, 0.2);
  spec.pose_margin = source.number(0.0, 0.2);
  spec.angle_margin = source.number(0.0, 0.05);
  spec.hits = source.below(6);
  spec.misses = source.below(6);
  spec.support = source.below(10);
  spec.slack = source.below(24);
  spec.pixels = 4096;
  spec.scan_pixel = 0.2;
  return spec;
}

tern::DepthView view_of(ByteSource& source, const std::vector<std::uint16_t>& pixels) {
  const int width = source.below(34);
  tern::DepthView view{pixels.data(), nullptr, width, source.below(18), width + source.below(2), 0.0, 0.0, 0.0, 0.0,
                       0.001,         0.0,     0.0};
  view.fx = source.number(5.0, 40.0);
  view.fy = source.number(5.0, 40.0);
  view.cx = source.number(0.0, 32.0);
  view.cy = source.number(0.0, 16.0);
  view.scale = source.number(0.001, 0.04);
  view.min = source.number(0.05, 0.5);
  view.max = source.number(1.0, 20.0);
  return view;
}

tern::Pose pose_of(ByteSource& source) {
  tern::Pose pose{source.vector(-6.0, 6.0), {1.0, 0.0, 0.0, 0.0}};
  const int turn = source.below(4);
  if (turn == 3) {
    for (double& q : pose.quaternion) q = source.number(-1.0, 1.0);
  } else if (turn > 0) {
    pose.quaternion[turn - 1] = 0.7071067811865476;
    pose.quaternion[3] = turn == 1 ? -0.7071067811865476 : 0.7071067811865476;
  }
  return pose;
}

/// The safe grid is free only where the map has seen, and never freer than the route grid.
std::string wrong_with(const tern::RollingMap& map) {
  const tern::Grid& safe = map.safe();
  const tern::Grid& route = map.route();
  const tern::Voxel dims = safe.spec().dims;
  for (int z = 0; z < dims.z; ++z) {
    for (int y = 0; y < dims.y; ++y) {
      for (int x = 0; x < dims.x; ++x) {
        const tern::Voxel v{x, y, z};
        if (!safe.obstacle(v) && !map.seen(v)) return "unseen space counts as free";
        if (route.obstacle(v) && !safe.obstacle(v)) return "an obstacle is free in the safe grid";
        if (safe.free(v) && !route.free(v)) return "the safe grid is freer than the route grid";
      }
    }
  }
  return "";
}

}  // namespace

std::string check_depth(const std::uint8_t* data, std::size_t size) {
  ByteSource source(data, size);
  const tern::MapSpec spec = spec_of(source);
  std::vector<std::uint64_t> words(tern::map_words(spec), 0x5A5A5A5A5A5A5A5Au);
  tern::RollingMap map;
  if (map.bind(spec, words.data(), words.size()) != tern::Status::kOk) {
    return map.bound() ? "bound though it was refused" : "";
  }
  for (int frame = 0; frame < kFrames && source.left() > 0; ++frame) {
    std::vector<std::uint16_t> pixels(34 * 36, static_cast<std::uint16_t>(source.byte() * 40));
    const tern::DepthView view = view_of(source, pixels);
    const tern::Pose pose = pose_of(source);
    for (int k = source.below(64); k > 0; --k) {
      const std::size_t at = static_cast<std::size_t>(source.byte() * 256 + source.byte()) % pixels.size();
      pixels[at] = static_cast<std::uint16_t>(source.byte() * 257);
    }
    tern::Status status = source.below(8) == 0 ? map.follow(pose.position) : map.begin_frame(view, pose, 1000 * frame);
    if (status != tern::Status::kOk && status != tern::Status::kRunning && map.busy())
      return "busy with a job that was refused";
    const auto slice = static_cast<std::uint32_t>(1 + 16 * source.byte());
    for (int k = 0; map.busy() && k < kMostSteps; ++k) status = map.step(slice);
    if (map.busy()) return "a job does not end";
    const std::string wrong = wrong_with(map);
    if (!wrong.empty()) return wrong;
  }
  return "";
}

}  // namespace tern_fuzz
