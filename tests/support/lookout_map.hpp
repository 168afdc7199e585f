// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TERN_TESTS_SUPPORT_LOOKOUT_MAP_HPP
#define TERN_TESTS_SUPPORT_LOOKOUT_MAP_HPP

#include <gtest/gtest.h>

#include <cstdint>
#include <vector>

#include "lookout/octets.hpp"
#include "support/owned_map.hpp"
#include "tern/map.hpp"

namespace tern_test {

/// 32 x 16 x 8 m from the origin on, cells of 0.25 m and a radius of 0.5 m, of which nothing is seen at first. A sensor
/// without errors.
struct LookoutMap {
  static constexpr double kCell = 0.25;

  static tern::MapSpec spec_of_map() {
    tern::MapSpec spec = tern::map_spec({0.0, 0.0, 0.0}, kCell, {128, 64, 32}, 0.5);
    spec.depth_margin = spec.pose_margin = 0.0;
    return spec;
  }
  LookoutMap() : owned(spec_of_map()) {}

  tern::RollingMap& map() { return owned.map; }
  void mark(const tern::Box& box) { EXPECT_EQ(map().mark_box(box), tern::Status::kOk); }
  /// All voxels whose centre is in the box count as seen, without a sensor.
  void see_free(const tern::Vec3& low, const tern::Vec3& high) {
    tern::Grid safe = map().safe();
    auto* const seen = const_cast<std::uint64_t*>(map().seen_rows());  // in `owned.words`
    for (std::int32_t k = 0; k < 128 * 64 * 32; ++k) {
      const tern::Voxel at{k % 128, k / 128 % 64, k / (128 * 64)};
      const tern::Vec3 c = safe.center(at);
      if (c.x < low.x || c.y < low.y || c.z < low.z || c.x > high.x || c.y > high.y || c.z > high.z) continue;
      seen[(at.z * 64 + at.y) * 2 + at.x / 64] |= std::uint64_t{1} << at.x % 64;
      if (map().route().obstacle(at)) continue;
      EXPECT_EQ(safe.clear_voxel(at), tern::Status::kOk);
    }
    safe.inflate();
  }
  /// The octets around a place. They live in the words of this room.
  tern::Octets octets(const tern::Vec3& around) {
    const tern::Grid& safe = map().safe();
    words.resize(2 * tern::octet_layer_words(safe.spec().dims));
    tern::Octets found{};
    found.place(safe, safe.voxel_of(safe.to_local(around)), words.data());
    tern::Work work;
    for (std::int32_t z = 0; z < found.count.z; ++z) found.read_plane(map(), z, work);
    return found;
  }

  OwnedMap owned;
  std::vector<std::uint64_t> words;
};

}  // namespace tern_test

#endif
