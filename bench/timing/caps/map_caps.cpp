// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Jobs of a rolling map at their bounds: the largest image, a scan in which no cube of voxels can be decided as a
// whole, and the most boxes of a prior in a slide.
#include "caps/cap.hpp"
#include "map/map_state.hpp"
#include "support/random.hpp"

namespace tern_caps {
namespace {

using tern::MapSpec;
using tern::RollingMap;
using tern::Vec3;

constexpr double kCell = 0.2;
constexpr std::size_t kMapBytes = std::size_t{24} << 20;
constexpr std::size_t kBeams = 6 * 125 * 125;

struct Storage {
  std::uint64_t words[kMapBytes / sizeof(std::uint64_t)];
  float depths[tern::kMaxPixels];
  Vec3 points[kBeams];
  tern::Box boxes[tern::kMaxPriorBoxes];
};
static_assert(sizeof(Storage) <= kMemoryBytes, "the planner's memory serves the maps, too");

Storage& storage() {
  return state_at<Storage>(0);
}

MapSpec spec_of(const tern::Voxel& dims) {
  const Vec3 origin{-0.5 * dims.x * kCell, -0.5 * dims.y * kCell, -0.5 * dims.z * kCell};
  MapSpec spec = tern::map_spec(origin, kCell, dims, 0.3);
  spec.slack = 0;
  return spec;
}

/// Units of the job, done one by one.
std::uint64_t units_of(RollingMap& map, tern::Status begun) {
  std::uint64_t units = 0;
  for (tern::Status status = begun; status == tern::Status::kRunning; status = map.step(1)) ++units;
  return units;
}

/// The largest image, all noise. Once counted, once unit by unit.
void largest_image() {
  Storage& s = storage();
  MapSpec spec = spec_of({256, 128, 40});
  spec.pixels = tern::kMaxPixels;
  RollingMap map;
  map.bind(spec, s.words, sizeof s.words / sizeof s.words[0]);
  tern_test::Random random(1);
  for (float& depth : s.depths) depth = static_cast<float>(random.real(0.5, 12.0));
  constexpr std::int32_t kWidth = 2048;
  constexpr std::int32_t kHeight = tern::kMaxPixels / kWidth;
  const tern::DepthView view{nullptr,      s.depths,      kWidth, kHeight, kWidth, 0.5 * kWidth, 0.5 * kWidth,
                             0.5 * kWidth, 0.5 * kHeight, 1.0,    0.1,     50.0,   0.0};
  const tern::Pose pose{{0.0, 0.0, 0.0}, {0.5, -0.5, 0.5, -0.5}};
  const std::uint64_t entered = count([&] {
    map.begin_frame(view, pose, 0);
    map.step(~std::uint32_t{0});
  });
  const std::uint64_t units = units_of(map, map.begin_frame(view, pose, 0));
  report({"map_pixels", "frame", entered, static_cast<std::uint64_t>(kWidth) * kHeight, tern::kMaxPixels, units, 1});
}

/// A beam through the middle of each pixel of the six faces, with a length of its own.
void strew_beams(Vec3 (&points)[kBeams], std::int32_t face) {
  tern_test::Random random(2);
  std::size_t k = 0;
  for (int a = 0; a < 6; ++a) {
    for (std::int32_t v = 0; v < face; ++v) {
      for (std::int32_t u = 0; u < face; ++u) {
        const double far = random.real(0.5, 24.0) * (a % 2 == 0 ? 1.0 : -1.0);
        const double ray[] = {((u + 0.5) / face - 0.5) * 2.5, ((v + 0.5) / face - 0.5) * 2.5};
        double p[3];
        p[a / 2] = far;
        p[(a / 2 + 1) % 3] = far * ray[0];
        p[(a / 2 + 2) % 3] = far * ray[1];
        points[k++] = {p[0], p[1], p[2]};
      }
    }
  }
}

/// A scan that may change every block of the window.
void all_blocks() {
  Storage& s = storage();
  MapSpec spec = spec_of({200, 200, 40});
  spec.range = 40.0;
  spec.scan_pixel = 0.02;
  spec.pixels = static_cast<std::int32_t>(kBeams);
  spec.hits = tern::kMaxEvidence;  // nothing blocks at once: all voxels stay of interest
  RollingMap map;
  map.bind(spec, s.words, sizeof s.words / sizeof s.words[0]);
  const tern::MapState& state = *reinterpret_cast<const tern::MapState*>(s.words);
  strew_beams(s.points, state.face);
  const Vec3 eye{0.0, 0.0, 0.0};
  const std::uint64_t entered = count([&] {
    map.begin_scan(s.points, kBeams, eye, 0);
    map.step(~std::uint32_t{0});
  });
  const std::uint64_t units = units_of(map, map.begin_scan(s.points, kBeams, eye, 0));
  const std::int32_t blocks = state.row_words() * ((spec.dims.y + 7) / 8) * state.layers();
  std::uint64_t met = 0;
  for (std::int32_t k = 0; k < blocks; ++k) {
    const tern::VoxelBox block = state.brick_at(k);
    met += block.x.begin < block.x.end ? 1 : 0;
  }
  report({"map_blocks", "scan", entered, met, static_cast<std::uint64_t>(blocks), units, 1});
}

/// Every box of the prior lies in the window.
void largest_prior() {
  Storage& s = storage();
  MapSpec spec = spec_of({200, 200, 40});
  tern_test::Random random(3);
  for (tern::Box& box : s.boxes) {
    const Vec3 at{random.real(-18.0, 18.0), random.real(-18.0, 18.0), random.real(-3.0, 3.0)};
    box = {at, {at.x + 1.5, at.y + 1.5, at.z + 1.5}};
  }
  spec.prior = s.boxes;
  spec.prior_count = tern::kMaxPriorBoxes;
  RollingMap map;
  map.bind(spec, s.words, sizeof s.words / sizeof s.words[0]);
  const std::uint64_t slid = count([&] {
    map.follow({0.0, 0.0, 1.5 * kCell});
    map.step(~std::uint32_t{0});
  });
  const std::uint64_t units = units_of(map, map.follow({0.0, 0.0, 0.5 * kCell}));
  report({"map_prior", "slide", slid, static_cast<std::uint64_t>(spec.prior_count), tern::kMaxPriorBoxes, units, 1});
}

}  // namespace

void map_caps() {
  largest_image();
  all_blocks();
  largest_prior();
}

}  // namespace tern_caps
