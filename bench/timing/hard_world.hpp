// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Worlds in which ticks take long, and what sensors see of them. All that stands reaches from the floor to the ceiling,
// or to its own top, so that a column of pixels looks along one line on the floor plan.
#ifndef TERN_BENCH_TIMING_HARD_WORLD_HPP
#define TERN_BENCH_TIMING_HARD_WORLD_HPP

#include <cstdint>

#include "tern/vec3.hpp"

namespace tern_timing {

/// The same numbers on every machine.
class Dice {
 public:
  explicit Dice(std::uint32_t seed) : state_(seed) {}
  std::uint32_t next() {
    state_ = state_ * 1664525u + 1013904223u;
    return state_ >> 8;
  }
  /// In [0, 1).
  double unit() { return next() / 16777216.0; }
  double in(double low, double high) { return low + (high - low) * unit(); }

 private:
  std::uint32_t state_;
};

/// On the floor plan, metres.
struct Ray {
  double x, y;    ///< where it begins
  double dx, dy;  ///< direction, of any length
};

/// A block with sides along x and y, or a round pillar.
struct Thing {
  double x0, y0, x1, y1;
  double radius;  ///< 0: a block; else a pillar about (x0, y0)
  double top;     ///< metres
};

class HardWorld {
 public:
  static constexpr double kCeiling = 3.0;
  static constexpr double kFar = 30.0;
  static constexpr int kMostHits = 4;

  /// What a column of pixels looks at, the nearest first: how far in units of the ray's direction, and up to where.
  struct Column {
    int count = 0;
    double at[kMostHits];
    double top[kMostHits];

    /// Where a ray that rises by `slope` meets something.
    double depth(double eye, double slope) const;
  };

  Column look(const Ray& ray) const;
  int count() const { return count_; }

 protected:
  static constexpr int kMostThings = 96;

  void add_block(double x0, double y0, double x1, double y1, double top) { add({x0, y0, x1, y1, 0.0, top}); }
  void add_pillar(double x, double y, double radius) { add({x, y, x, y, radius, kCeiling}); }
  /// True where nothing is within `reach` of the point.
  bool empty_around(double x, double y, double reach) const;

 private:
  void add(const Thing& thing) {
    if (count_ < kMostThings) things_[count_++] = thing;
  }
  static double meet(const Ray& ray, const Thing& thing);

  Thing things_[kMostThings];
  int count_ = 0;
};

/// Six rooms, doors of 1.2 m, tables and shelves: 18 x 10 m. The flight begins in one corner and ends in another.
class Storey : public HardWorld {
 public:
  Storey();
};

/// One round pillar on 8 m^2, 24 x 14 m.
class Thicket : public HardWorld {
 public:
  Thicket();
};

}  // namespace tern_timing

#endif
