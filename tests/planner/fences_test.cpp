// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Plans among random blocks and geofences: every point of every flight keeps to the fences as the caller gave them.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "support/random.hpp"
#include "support/world.hpp"

namespace tern_test {
namespace {

using tern::Fence;
using tern::FenceKind;
using tern::Halfspace;
using tern::Status;
using tern::Vec3;

double dot_of(const Vec3& a, const Vec3& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}

/// Distance from p to a polyhedron by projecting on its half-spaces in turn (Dykstra's corrections make the limit the
/// nearest point). Slow, and nothing of the core's own.
double distance_to(const Vec3& p, const std::vector<Halfspace>& planes) {
  Vec3 x = p;
  std::vector<Vec3> correction(planes.size(), Vec3{0.0, 0.0, 0.0});
  for (int round = 0; round < 300; ++round) {
    for (std::size_t k = 0; k < planes.size(); ++k) {
      const Vec3 y{x.x + correction[k].x, x.y + correction[k].y, x.z + correction[k].z};
      const double s = dot_of(planes[k].normal, planes[k].normal);
      const double excess = std::max(0.0, dot_of(planes[k].normal, y) - planes[k].offset) / s;
      const Vec3& n = planes[k].normal;
      x = {y.x - excess * n.x, y.y - excess * n.y, y.z - excess * n.z};
      correction[k] = {y.x - x.x, y.y - x.y, y.z - x.z};
    }
  }
  return std::sqrt((x.x - p.x) * (x.x - p.x) + (x.y - p.y) * (x.y - p.y) + (x.z - p.z) * (x.z - p.z));
}

struct Fenced {
  std::vector<std::vector<Halfspace>> planes;
  std::vector<FenceKind> kinds;

  std::vector<Fence> list() const {
    std::vector<Fence> fences;
    for (std::size_t i = 0; i < planes.size(); ++i) {
      fences.push_back({planes[i].data(), static_cast<std::int32_t>(planes[i].size()), kinds[i]});
    }
    return fences;
  }
};

/// A prism or a skewed box about a point.
std::vector<Halfspace> random_polyhedron(Random& random, const Vec3& center, double size) {
  std::vector<Halfspace> planes;
  for (int k = random.integer(4, 8); k > 0; --k) {
    const Vec3 n{random.real(-1.0, 1.0), random.real(-1.0, 1.0), random.real(-0.6, 0.6)};
    if (dot_of(n, n) < 0.05) continue;
    planes.push_back({n, dot_of(n, center) + random.real(0.2, 1.0) * size * std::sqrt(dot_of(n, n))});
  }
  planes.push_back({{0.0, 0.0, 1.0}, center.z + random.real(0.2, 2.0)});
  return planes;
}

void expect_kept(const World& world, const Fenced& fenced, double radius) {
  const double end = tern::duration(world.trajectory);
  for (int k = 0; k <= 120; ++k) {
    const Vec3 p = tern::evaluate(world.trajectory, end * k / 120.0).position;
    for (std::size_t i = 0; i < fenced.planes.size(); ++i) {
      if (fenced.kinds[i] == FenceKind::kKeepOut) {
        ASSERT_GE(distance_to(p, fenced.planes[i]), radius - 1e-4);
        continue;
      }
      for (const Halfspace& h : fenced.planes[i]) ASSERT_LE(dot_of(h.normal, p), h.offset + 1e-6);
    }
  }
}

TEST(FencesPlan, EveryPointOfEveryFlightKeepsToThem) {
  Random random(17);
  int flown = 0;
  int around = 0;
  int refused = 0;
  for (int i = 0; i < scaled(120); ++i) {
    const double radius = random.chance(0.3) ? 0.0 : 0.2;
    const Vec3 origin{random.real(-50.0, 50.0), 3.0, -1.0};
    World world({60, 60, 20}, 0.1, radius, origin);
    for (int k = random.integer(0, 6); k > 0; --k) {
      const Vec3 low{random.real(1.0, 5.0), random.real(0.0, 5.0), random.real(0.0, 1.5)};
      world.block(low, {low.x + random.real(0.1, 0.8), low.y + random.real(0.1, 1.0), low.z + 0.8});
    }
    Fenced fenced;
    for (int k = random.integer(1, 3); k > 0; --k) {
      const Vec3 at{origin.x + random.real(1.5, 4.5), origin.y + random.real(1.0, 5.0),
                    origin.z + random.real(0.0, 2.0)};
      fenced.planes.push_back(random_polyhedron(random, at, 1.0));
      fenced.kinds.push_back(FenceKind::kKeepOut);
    }
    const Vec3 up{random.real(-0.2, 0.2), random.real(-0.2, 0.2), 1.0};
    fenced.planes.push_back({{up, dot_of(up, origin) + 1.9}});
    fenced.kinds.push_back(FenceKind::kKeepIn);
    const std::vector<Fence> list = fenced.list();
    world.request.fences = list.data();
    world.request.fence_count = static_cast<std::int32_t>(list.size());
    world.from({0.5, random.real(0.5, 5.5), 0.5}).to({5.5, random.real(0.5, 5.5), 1.0});
    const Status status = world.plan();
    SCOPED_TRACE(i);
    const bool possible = status == Status::kOk || status == Status::kNoPath || status == Status::kStartFenced ||
                          status == Status::kGoalFenced || status == Status::kStartOccupied ||
                          status == Status::kGoalOccupied || status == Status::kStartTooNarrow ||
                          status == Status::kGoalTooNarrow;
    ASSERT_TRUE(possible) << tern::status_name(status);
    if (status != Status::kOk) {
      ++refused;
      ASSERT_TRUE(world.trajectory_untouched());
      continue;
    }
    ++flown;
    around += world.trajectory.count > 1 ? 1 : 0;
    ASSERT_NO_FATAL_FAILURE(expect_kept(world, fenced, radius));
  }
  EXPECT_GT(flown, scaled(120) / 3);
  EXPECT_GT(around, 0);
  EXPECT_LT(refused, scaled(120) + 1);
}

}  // namespace
}  // namespace tern_test
