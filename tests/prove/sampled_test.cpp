// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Proofs against samples in long double, and against the planner: what it makes on a grid is proven on that grid.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "support/grid_storage.hpp"
#include "support/random.hpp"
#include "support/world.hpp"
#include "tern/proof.hpp"

namespace {

using namespace tern;
using tern_test::Random;
using tern_test::World;

using Number = long double;

struct Point {
  Number c[3];
};

Point local_at(const Trajectory& plan, const GridSpec& spec, int index, Number u) {
  Number binomial = 1;
  Point sum{};
  for (int i = 0; i <= kDegree; ++i) {
    const Vec3& p = plan.segments[index].points[i];
    const Number weight = binomial * std::pow(u, static_cast<Number>(i)) * std::pow(1 - u, static_cast<Number>(7 - i));
    sum.c[0] += weight * p.x;
    sum.c[1] += weight * p.y;
    sum.c[2] += weight * p.z;
    binomial = binomial * (kDegree - i) / (i + 1);
  }
  sum.c[0] += static_cast<Number>(plan.origin.x) - spec.origin.x;
  sum.c[1] += static_cast<Number>(plan.origin.y) - spec.origin.y;
  sum.c[2] += static_cast<Number>(plan.origin.z) - spec.origin.z;
  return sum;
}

/// Distance from the nearest obstacle cube, of those within `reach`.
Number distance_at(const Grid& grid, const Point& p, Number reach) {
  const GridSpec& spec = grid.spec();
  const int dims[3] = {spec.dims.x, spec.dims.y, spec.dims.z};
  int lo[3];
  int hi[3];
  for (int a = 0; a < 3; ++a) {
    lo[a] = std::max(0, static_cast<int>(std::floor((p.c[a] - reach) / spec.cell)) - 1);
    hi[a] = std::min(dims[a] - 1, static_cast<int>(std::floor((p.c[a] + reach) / spec.cell)) + 1);
  }
  Number best = reach;
  for (int z = lo[2]; z <= hi[2]; ++z) {
    for (int y = lo[1]; y <= hi[1]; ++y) {
      for (int x = lo[0]; x <= hi[0]; ++x) {
        if (!grid.obstacle({x, y, z})) continue;
        const int index[3] = {x, y, z};
        Number square = 0;
        for (int a = 0; a < 3; ++a) {
          const Number from = index[a] * static_cast<Number>(spec.cell);
          const Number gap = std::max({from - p.c[a], p.c[a] - from - spec.cell, Number{0}});
          square += gap * gap;
        }
        best = std::min(best, std::sqrt(square));
      }
    }
  }
  return best;
}

/// The first sample nearer than the radius, but for 1e-8 m, or outside.
Number first_bad_sample(const Grid& grid, const Trajectory& plan, Number slack, int samples) {
  const GridSpec& spec = grid.spec();
  const Vec3 top{spec.dims.x * spec.cell, spec.dims.y * spec.cell, spec.dims.z * spec.cell};
  const Number upper[3] = {top.x, top.y, top.z};
  Number begin = 0;
  for (int s = 0; s < plan.count; ++s) {
    for (int k = 0; k <= samples; ++k) {
      const Number u = static_cast<Number>(k) / samples;
      const Point p = local_at(plan, spec, s, u);
      bool bad = distance_at(grid, p, spec.radius + spec.cell) < spec.radius - slack;
      for (int a = 0; a < 3; ++a) bad = bad || p.c[a] < -slack || p.c[a] > upper[a] + slack;
      if (bad) return begin + u * plan.segments[s].duration;
    }
    begin += plan.segments[s].duration;
  }
  return begin;
}

void fill_room(Random& random, Grid& grid, double part) {
  const Voxel dims = grid.spec().dims;
  for (int z = 0; z < dims.z; ++z) {
    for (int y = 0; y < dims.y; ++y) {
      for (int x = 0; x < dims.x; ++x) {
        if (random.chance(part)) grid.mark_voxel({x, y, z});
      }
    }
  }
}

/// A random segment: control points of a walk through the room.
Trajectory random_curve(Random& random, const GridSpec& spec) {
  Trajectory plan{};
  plan.count = 1;
  plan.origin = {spec.origin.x + random.real(1.0, 5.0), spec.origin.y + random.real(1.0, 5.0),
                 spec.origin.z + random.real(1.0, 3.0)};
  plan.segments[0].duration = random.real(0.05, 8.0);
  const double step = random.real(0.01, 0.6);
  for (int i = 1; i < kControlPoints; ++i) {
    const Vec3& last = plan.segments[0].points[i - 1];
    plan.segments[0].points[i] = {last.x + random.real(-step, step), last.y + random.real(-step, step),
                                  last.z + random.real(-step, step)};
  }
  return plan;
}

/// Nothing bad is proven; and where the proof ends, something bad is near at hand.
TEST(ProofSampled, EndsWhereTheSamplesSay) {
  Random random(170);
  int ended = 0;
  int proven = 0;
  for (int k = 0; k < tern_test::scaled(150); ++k) {
    const Vec3 origin{random.real(-100.0, 100.0), random.real(-100.0, 100.0), 0.0};
    tern_test::OwnedGrid room(tern_test::whole_grid({60, 60, 40}, 0.1, random.real(0.05, 0.4), origin));
    fill_room(random, room.grid, std::pow(10.0, random.real(-4.5, -2.0)));
    const Trajectory plan = random_curve(random, room.grid.spec());
    ProofReport report;
    const double until = clear_until(room.grid, plan, 0.0, nullptr, Beyond::kEmpty, &report);
    const int samples = 2000;
    const double spacing = plan.segments[0].duration / samples;
    EXPECT_GE(first_bad_sample(room.grid, plan, 1e-8, samples) + 1e-9, until) << k;
    if (report.finding == Finding::kNone) {
      ++proven;
      EXPECT_DOUBLE_EQ(until, plan.segments[0].duration);
    } else {
      ++ended;
      // The curve comes within a hair of the radius there: between two samples it may do so alone.
      EXPECT_LE(first_bad_sample(room.grid, plan, -1e-4, samples), until + spacing + 1e-9) << k;
    }
  }
  EXPECT_GT(ended, tern_test::scaled(150) / 10);
  EXPECT_GT(proven, tern_test::scaled(150) / 10);
}

/// Plans touch obstacles, and the proof must not be more severe than the check.
TEST(ProofSampled, PlansAreProvenOnTheirOwnGrid) {
  Random random(171);
  int plans = 0;
  for (int k = 0; k < tern_test::scaled(400); ++k) {
    const Vec3 origin{random.real(-1000.0, 1000.0), random.real(-1000.0, 1000.0), random.real(-50.0, 50.0)};
    World world({100, 100, 30}, 0.1, random.real(0.1, 0.35), origin);
    for (int b = random.integer(5, 40); b > 0; --b) {
      const double x = random.real(1.5, 8.0), y = random.real(0.5, 9.0), w = random.real(0.1, 0.6);
      world.block({x, y, 0.0}, {x + w, y + w, 3.0});
    }
    world.from({0.7, random.real(1.0, 9.0), 1.5}).to({9.3, random.real(1.0, 9.0), random.real(0.8, 2.2)});
    world.request.time_weight = std::pow(10.0, random.real(0.0, 4.0));
    if (world.plan() != Status::kOk) continue;
    ++plans;
    ProofReport report;
    clear_until(world.grid, world.trajectory, 0.0, &world.request.limits, Beyond::kEmpty, &report);
    EXPECT_EQ(report.finding, Finding::kNone) << k << " at " << report.until;
    // From any instant on, too.
    const double from = random.unit() * duration(world.trajectory);
    clear_until(world.grid, world.trajectory, from, &world.request.limits, Beyond::kEmpty, &report);
    EXPECT_EQ(report.finding, Finding::kNone) << k << " from " << from;
    // An obstacle on the way ends it.
    const Sample middle = evaluate(world.trajectory, 0.5 * duration(world.trajectory));
    world.grid.mark_points(&middle.position, 1);
    EXPECT_LT(clear_until(world.grid, world.trajectory, 0.0), 0.5 * duration(world.trajectory));
  }
  EXPECT_GT(plans, tern_test::scaled(400) / 2);
}

}  // namespace
