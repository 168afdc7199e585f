// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Octets and waves over them: worked out by hand, and against a wave that takes one octet at a time.
#include "lookout/wave.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "lookout/places.hpp"
#include "support/lookout_map.hpp"
#include "support/random.hpp"

namespace {

using namespace tern;
using tern_test::LookoutMap;
using tern_test::Random;
using tern_test::scaled;

/// Octets without a map, and a wave over them.
struct Pool {
  explicit Pool(const Voxel& count) {
    const Voxel dims{2 * count.x, 2 * count.y, 2 * count.z};
    layer = octet_layer_words(dims);
    words.assign((2 + kWaveLayers) * layer, 0xA5A5A5A5A5A5A5A5u);
    octets.origin = {0, 0, 0};
    octets.count = count;
    octets.known = words.data();
    octets.open = words.data() + layer;
    octets.edge = 0.5;
    for (std::size_t k = 0; k < 2 * layer; ++k) words[k] = 0;
  }
  void set(std::uint64_t* rows, const Voxel& at) { rows[octets.row(at)] |= std::uint64_t{1} << at.x; }
  void begin(const Voxel& at) {
    Work work;
    wave.begin(octets, words.data() + 2 * layer, layer, work);
    wave.seed(octets, at);
  }
  void run(bool everywhere) {
    Work work;
    while (!wave.is_over) wave.advance(octets, everywhere, work);
  }
  std::vector<Voxel> way_to(const Voxel& at) {
    Work work;
    std::int32_t way[kMaxWave];
    std::vector<Voxel> found;
    const std::int32_t count = wave.way_to(octets, at, way, work);
    for (std::int32_t k = 0; k < count; ++k) found.push_back(octets.octet(way[k]));
    return found;
  }

  std::size_t layer;
  std::vector<std::uint64_t> words;
  Octets octets{};
  Wave wave{};
};

/// Steps over faces and over all sides take turns, the first one over faces.
TEST(LookoutWave, StepsTakeTurns) {
  Pool pool({9, 9, 9});
  for (int z = 0; z < 9; ++z) {
    for (int y = 0; y < 9; ++y) {
      for (int x = 0; x < 9; ++x) pool.set(pool.octets.known, {x, y, z});
    }
  }
  pool.begin({4, 4, 4});
  Work work;
  pool.wave.advance(pool.octets, false, work);
  EXPECT_TRUE(pool.wave.has(pool.octets, {5, 4, 4}));
  EXPECT_FALSE(pool.wave.has(pool.octets, {5, 5, 4}));
  pool.wave.advance(pool.octets, false, work);
  EXPECT_TRUE(pool.wave.has(pool.octets, {6, 5, 5}));
  EXPECT_FALSE(pool.wave.has(pool.octets, {6, 6, 4}));
  EXPECT_FALSE(pool.wave.has(pool.octets, {7, 4, 4}));
  EXPECT_LT(work.operations(), 0);
}

/// A known way round of eight octets is taken before an open one through six.
TEST(LookoutWave, OpenOctetsTakeTwoSteps) {
  Pool pool({8, 3, 1});
  for (int x = 0; x < 8; ++x) pool.set(pool.octets.known, {x, 0, 0});
  for (int x = 1; x < 7; ++x) pool.set(pool.octets.open, {x, 1, 0});
  pool.set(pool.octets.known, {0, 1, 0});
  pool.set(pool.octets.known, {7, 1, 0});
  pool.begin({0, 1, 0});
  pool.run(true);
  const std::vector<Voxel> way = pool.way_to({7, 1, 0});
  EXPECT_GE(way.size(), 8u);
  for (const Voxel& at : way) EXPECT_TRUE(pool.octets.bit(pool.octets.known, at)) << at.x << ' ' << at.y;
  pool.begin({0, 1, 0});
  pool.run(false);
  EXPECT_FALSE(pool.wave.has(pool.octets, {2, 1, 0}));
}

/// The same wave, one octet at a time: the number of steps to each octet, or -1.
std::vector<int> steps_of(const Pool& pool, const Voxel& from, bool everywhere, int most) {
  const Octets& octets = pool.octets;
  const Voxel& n = octets.count;
  const auto number = [&](const Voxel& v) { return static_cast<std::size_t>((v.z * n.y + v.y) * n.x + v.x); };
  std::vector<int> steps(static_cast<std::size_t>(n.x * n.y * n.z), -1);
  std::vector<int> due(steps.size(), -1);
  steps[number(from)] = 0;
  for (int s = 1; s <= most; ++s) {
    for (int z = 0; z < n.z; ++z) {
      for (int y = 0; y < n.y; ++y) {
        for (int x = 0; x < n.x; ++x) {
          const std::size_t at = number({x, y, z});
          if (steps[at] >= 0) continue;
          if (due[at] == s) {
            steps[at] = s;
            continue;
          }
          const bool known = octets.bit(octets.known, {x, y, z});
          if (due[at] >= 0 || (!known && !(everywhere && octets.bit(octets.open, {x, y, z})))) continue;
          bool touched = false;
          for (int k = 0; k < 27; ++k) {
            const Voxel beside{x + k % 3 - 1, y + k / 3 % 3 - 1, z + k / 9 - 1};
            const int apart = (beside.x != x) + (beside.y != y) + (beside.z != z);
            if (!octets.has(beside) || apart == 0 || (s % 2 == 1 && apart > 1)) continue;
            touched = touched || (steps[number(beside)] >= 0 && steps[number(beside)] < s);
          }
          if (!touched) continue;
          known ? steps[at] = s : due[at] = s + 1;
        }
      }
    }
  }
  return steps;
}

TEST(LookoutWave, IsTheWaveOfSingleOctets) {
  Random random(7);
  for (int n = 0; n < scaled(60); ++n) {
    Pool pool({random.integer(1, 64), random.integer(1, 12), random.integer(1, 8)});
    const Voxel& count = pool.octets.count;
    for (int z = 0; z < count.z; ++z) {
      for (int y = 0; y < count.y; ++y) {
        for (int x = 0; x < count.x; ++x) {
          const double kind = random.unit();
          if (kind < 0.5) pool.set(pool.octets.known, {x, y, z});
          if (kind > 0.7) pool.set(pool.octets.open, {x, y, z});
        }
      }
    }
    const Voxel from{random.integer(0, count.x - 1), random.integer(0, count.y - 1), random.integer(0, count.z - 1)};
    const bool everywhere = n % 3 != 0;
    pool.begin(from);
    pool.run(everywhere);
    const std::vector<int> steps = steps_of(pool, from, everywhere, pool.wave.step + 2);
    std::size_t k = 0;
    for (int z = 0; z < count.z; ++z) {
      for (int y = 0; y < count.y; ++y) {
        for (int x = 0; x < count.x; ++x, ++k) {
          const bool reached = pool.wave.has(pool.octets, {x, y, z});
          ASSERT_EQ(reached, steps[k] >= 0) << n << ": " << x << ' ' << y << ' ' << z;
          if (!reached || !random.chance(0.05)) continue;
          const std::vector<Voxel> way = pool.way_to({x, y, z});
          EXPECT_EQ(way.front().x, from.x);
          EXPECT_EQ(way.front().y, from.y);
          EXPECT_EQ(way.front().z, from.z);
          int sum = 0;
          for (std::size_t w = 1; w < way.size(); ++w) {
            sum += pool.octets.bit(pool.octets.known, way[w]) ? 1 : kOpenSteps;
          }
          EXPECT_LE(sum, steps[k]) << n;
          EXPECT_GE(sum + static_cast<int>(way.size()) - 1, steps[k]) << n;
        }
      }
    }
  }
}

/// A long corridor: the wave ends before a way would be longer than there is room for.
TEST(LookoutWave, EndsInTime) {
  Pool pool({64, 16, 8});
  for (int z = 0; z < 8; z += 2) {  // a winding way of more than 256 octets
    for (int y = 0; y < 16; y += 2) {
      for (int x = 0; x < 64; ++x) pool.set(pool.octets.known, {x, y, z});
      pool.set(pool.octets.known, {y % 4 == 0 ? 63 : 0, y + 1, z});
    }
  }
  pool.begin({0, 0, 0});
  pool.run(true);
  EXPECT_EQ(pool.wave.step, kMaxWave - kOpenSteps);
  int reached = 0;
  for (int y = 0; y < 16; ++y) {
    for (int x = 0; x < 64; ++x) {
      if (!pool.wave.has(pool.octets, {x, y, 0})) continue;
      ++reached;
      EXPECT_LE(pool.way_to({x, y, 0}).size(), static_cast<std::size_t>(kMaxWave));
    }
  }
  EXPECT_GE(reached, kMaxWave - kOpenSteps);
}

/// If there are more places than room, every second octet is taken, and near the vehicle more.
TEST(LookoutPlaces, AreThinned) {
  Pool pool({64, 16, 8});
  for (int z = 0; z < 8; ++z) {
    for (int y = 0; y < 16; ++y) {
      for (int x = 0; x < 64; ++x) pool.set(pool.octets.known, {x, y, z});
    }
  }
  pool.begin({31, 7, 3});
  Places places{};
  places.begin(pool.octets.index({31, 7, 3}));
  Work work;
  for (int k = 0; k < 20; ++k) {
    pool.wave.advance(pool.octets, false, work);
    places.take_front(pool.octets, pool.wave, false, work);
  }
  EXPECT_GT(places.count, kMaxPlaces / 5);
  EXPECT_LE(places.count, kMaxPlaces);
  EXPECT_GE(places.level, 3);
  const Lattice far = places.lattice(6), near = places.lattice(5);
  EXPECT_EQ(far.stride, places.level % 2 == 0 ? far.stride_up : 2 * far.stride_up);
  EXPECT_EQ(near.stride, far.stride >= 4 ? far.stride / 4 : 1);
  EXPECT_EQ(near.stride_up, far.stride_up >= 4 ? far.stride_up / 4 : 1);
  EXPECT_EQ(places.place[0].octet, pool.octets.index({31, 7, 3}));
  for (std::int32_t k = 1; k < places.count; ++k) {
    const Voxel at = pool.octets.octet(places.place[k].octet);
    const Lattice& lattice = places.place[k].steps > 5 ? far : near;
    EXPECT_EQ((at.x | at.y) % lattice.stride, 0);
    EXPECT_EQ(at.z % lattice.stride_up, 0);
    EXPECT_GT(places.place[k].steps, 0);
  }
}

/// From rest to rest: 2 m at 2 m/s^2 take 2 s, and 6 m at 3 m/s at most as long as 2 m at that speed and 1.5 s.
TEST(LookoutPlaces, TakeTime) {
  const Agility agility{3.0, 2.0, 1.0, 4.0};
  EXPECT_DOUBLE_EQ(agility.seconds(0.0), 0.0);
  EXPECT_DOUBLE_EQ(agility.seconds(2.0), 2.0);
  EXPECT_DOUBLE_EQ(agility.seconds(6.0), 3.5);
  EXPECT_DOUBLE_EQ(agility.seconds_to_turn(1.0), 1.25);
}

/// A voxel of eight that is free for all that is known makes an octet known; one that is free but for what was not seen
/// makes it open.
TEST(LookoutOctets, AreKnownOpenOrNeither) {
  LookoutMap room;
  room.see_free({1.0, 1.0, 1.0}, {3.0, 3.0, 3.0});
  room.mark({{4.0, 0.0, 0.0}, {4.25, 8.0, 4.0}});
  const Octets octets = room.octets({2.0, 2.0, 2.0});
  const auto at = [&](const Vec3& place) { return octets.of(room.map().safe().voxel_of(place)); };
  EXPECT_TRUE(octets.bit(octets.known, at({2.0, 2.0, 2.0})));
  EXPECT_FALSE(octets.bit(octets.open, at({2.0, 2.0, 2.0})));
  EXPECT_FALSE(octets.bit(octets.known, at({1.1, 2.0, 2.0}))) << "nearer than the radius to what was not seen";
  EXPECT_TRUE(octets.bit(octets.open, at({1.1, 2.0, 2.0})));
  EXPECT_FALSE(octets.bit(octets.open, at({4.1, 2.0, 2.0}))) << "in the wall";
  EXPECT_FALSE(octets.bit(octets.open, at({3.6, 2.0, 2.0}))) << "nearer than the radius to the wall";
}

TEST(LookoutOctets, OfVoxels) {
  Octets octets{};
  octets.origin = {4, 2, 0};
  octets.count = {3, 3, 3};
  EXPECT_EQ(octets.of({4, 3, 1}).x, 0);
  EXPECT_EQ(octets.of({3, 3, 1}).x, -1);
  EXPECT_FALSE(octets.has(octets.of({3, 3, 1})));
  EXPECT_EQ(octets.of({9, 7, 5}).y, 2);
  EXPECT_TRUE(octets.has(octets.of({9, 7, 5})));
  EXPECT_FALSE(octets.has(octets.of({10, 7, 5})));
  const Voxel back = octets.octet(octets.index({1, 2, 0}));
  EXPECT_EQ(back.x, 1);
  EXPECT_EQ(back.y, 2);
  EXPECT_EQ(back.z, 0);
}

/// Random maps: each octet's bits are those of its eight voxels.
TEST(LookoutOctets, AreThoseOfTheirVoxels) {
  Random random(11);
  for (int n = 0; n < scaled(20); ++n) {
    LookoutMap room;
    for (int k = 0; k < 6; ++k) {
      const Vec3 low{random.real(0.0, 30.0), random.real(0.0, 14.0), random.real(0.0, 6.0)};
      const Vec3 high{low.x + random.real(1.0, 8.0), low.y + random.real(1.0, 8.0), low.z + random.real(1.0, 4.0)};
      random.chance(0.3) ? room.mark({low, high}) : room.see_free(low, high);
    }
    const Octets octets = room.octets({random.real(0.0, 32.0), random.real(0.0, 16.0), random.real(0.0, 8.0)});
    const Grid& safe = room.map().safe();
    for (int z = 0; z < octets.count.z; ++z) {
      for (int y = 0; y < octets.count.y; ++y) {
        for (int x = 0; x < octets.count.x; ++x) {
          bool known = false;
          bool free = false;
          for (int k = 0; k < 8; ++k) {
            const Voxel voxel{octets.origin.x + 2 * x + k % 2, octets.origin.y + 2 * y + k / 2 % 2,
                              octets.origin.z + 2 * z + k / 4};
            known = known || safe.free(voxel);
            free = free || room.map().route().free(voxel);
          }
          ASSERT_EQ(octets.bit(octets.known, {x, y, z}), known);
          ASSERT_EQ(octets.bit(octets.open, {x, y, z}), free && !known);
          ASSERT_EQ(safe.free(octets.free_voxel(safe, {x, y, z})), known);
        }
      }
    }
  }
}

}  // namespace
