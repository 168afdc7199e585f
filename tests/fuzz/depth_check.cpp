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
  tern::DepthView view{
      pixels.data(), nullptr, width, source.below(18), width + source.below(2), 0.0, 0.0, 0.0, 0.0, 0.001,
      0.0,           0.0,     0.0};
  view.fx = source.number(5.0, 40.0);
  view.fy = source.number(5.0, 40.0);
  view.cx = source.number(0.0, 32.0);
  view.cy = source.number(0.0, 16.0);
  view.scale = source.number(0.001, 0.04);
  view.min = source.number(0.05, 0.5);
  view.max = source.number(1.0, 20.0);
  view.no_return = source.below(2) == 1 ? source.number(-1.0, 12.0) : 0.0;
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

/// Rows of the map's layers, a word of them at a time.
struct Words {
  std::uint64_t safe, route;                  ///< obstacles
  std::uint64_t safe_blocked, route_blocked;  ///< not free
  std::uint64_t seen;
  std::uint64_t inside;  ///< voxels of the grid
};

/// What is wrong, null where nothing is: the safe grid is free only where the map has seen, and never freer than the
/// route grid.
const char* wrong_with(const Words& w) {
  if ((w.inside & ~w.safe & ~w.seen) != 0) return "unseen space counts as free";
  if ((w.route & ~w.safe) != 0) return "an obstacle is free in the safe grid";
  if ((w.inside & ~w.safe_blocked & w.route_blocked) != 0) return "the safe grid is freer than the route grid";
  return nullptr;
}

bool bit(std::uint64_t word, int x) {
  return (word >> (x % 64) & 1u) != 0;
}

/// What is said of a single voxel is what its rows say.
const char* wrong_with(const tern::RollingMap& map, const tern::Voxel& v, const Words& w) {
  const bool same = map.safe().obstacle(v) == bit(w.safe, v.x) && map.route().obstacle(v) == bit(w.route, v.x) &&
                    map.safe().free(v) != bit(w.safe_blocked, v.x) &&
                    map.route().free(v) != bit(w.route_blocked, v.x) && map.seen(v) == bit(w.seen, v.x);
  return same ? nullptr : "a voxel differs from its row";
}

std::string wrong_with(const tern::RollingMap& map) {
  const tern::Grid& safe = map.safe();
  const tern::Grid& route = map.route();
  const tern::Voxel dims = safe.spec().dims;
  const std::uint64_t* seen = map.seen_rows();
  for (int z = 0; z < dims.z; ++z) {
    for (int y = 0; y < dims.y; ++y) {
      for (int k = 0; k < safe.row_words(); ++k) {
        const int left = dims.x - 64 * k;
        const Words words{safe.obstacle_row(y, z)[k],
                          route.obstacle_row(y, z)[k],
                          safe.blocked_row(y, z)[k],
                          route.blocked_row(y, z)[k],
                          *seen++,
                          left < 64 ? (std::uint64_t{1} << left) - 1 : ~std::uint64_t{0}};
        if (const char* wrong = wrong_with(words)) return wrong;
        const int x = 64 * k + (7 * y + 13 * z) % (left < 64 ? left : 64);
        if (const char* wrong = wrong_with(map, {x, y, z}, words)) return wrong;
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
