// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Conflicts of intents: by hand at their edges, and random outlines beside a comparison of all their sides.
#include "host/intent/conflicts.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "host/intent/convex_gap.hpp"
#include "support/random.hpp"

namespace {

using tern_host::Conflict;
using tern_host::EntityKind;
using tern_host::HeightReference;
using tern_host::LocalFrame;
using tern_host::Plan2;
using tern_host::PlanPolygon;
using tern_host::UtmEntity;
using tern_host::Zone;
using tern_test::Random;

const LocalFrame kPlace({{47.0, 8.0}, 400.0});
const tern_host::Instant kNoon = *tern_host::parse_instant("2026-03-01T12:00:00Z");

Zone volume(const std::vector<Plan2>& outline, double low, double high, double from, double until) {
  Zone zone;
  zone.edges = tern_host::EdgeRule::kGeodesic;
  zone.areas.emplace_back();
  for (const Plan2& p : outline) zone.areas[0].ring.push_back(kPlace.point(p));
  zone.lower = {low, HeightReference::kEllipsoid};
  zone.upper = {high, HeightReference::kEllipsoid};
  const auto at = [](double s) { return kNoon + static_cast<tern_host::Instant>(s * 1e9); };
  zone.times.push_back({at(from), at(until), {}});
  return zone;
}

std::vector<Plan2> square(double x, double y, double size) {
  return {{x, y}, {x + size, y}, {x + size, y + size}, {x, y + size}};
}

UtmEntity entity(const std::string& id, const Zone& zone, int priority = 0) {
  UtmEntity e;
  e.id = id;
  e.priority = priority;
  e.volumes.push_back(zone);
  return e;
}

UtmEntity own(int priority = 0) {
  return entity("own", volume(square(0, 0, 100), 450, 500, 0, 60), priority);
}

std::size_t count(const Zone& other) {
  return conflicts_of(own(), {entity("other", other)}, kPlace).size();
}

TEST(Conflicts, NeedTimeHeightAndOutlineInCommon) {
  EXPECT_EQ(count(volume(square(50, 50, 100), 480, 520, 30, 90)), 1u);
  EXPECT_EQ(count(volume(square(50, 50, 100), 480, 520, 60, 90)), 1u) << "touches in time";
  EXPECT_EQ(count(volume(square(50, 50, 100), 480, 520, 60.001, 90)), 0u);
  EXPECT_EQ(count(volume(square(50, 50, 100), 480, 520, -30, -0.001)), 0u);
  EXPECT_EQ(count(volume(square(50, 50, 100), 500, 520, 30, 90)), 1u) << "touches in height";
  EXPECT_EQ(count(volume(square(50, 50, 100), 500.001, 520, 30, 90)), 0u);
  EXPECT_EQ(count(volume(square(50, 50, 100), 430, 449.999, 30, 90)), 0u);
  EXPECT_EQ(count(volume(square(100, 50, 100), 480, 520, 30, 90)), 1u) << "touches in plan";
  EXPECT_EQ(count(volume(square(100.009, 50, 100), 480, 520, 30, 90)), 1u) << "touches to a centimetre";
  EXPECT_EQ(count(volume(square(100.021, 50, 100), 480, 520, 30, 90)), 0u);
  EXPECT_EQ(count(volume(square(20, 20, 10), 480, 520, 30, 90)), 1u) << "within";
  EXPECT_EQ(count(volume(square(-200, -200, 600), 480, 520, 30, 90)), 1u) << "around";
}

TEST(Conflicts, KnowOutlinesThatAreNotConvex) {
  // A U about the square, open to the north, 10 m away from it.
  std::vector<Plan2> u{{-20, -20}, {120, -20}, {120, 150}, {110, 150}, {110, -10}, {-10, -10}, {-10, 150}, {-20, 150}};
  EXPECT_EQ(count(volume(u, 480, 520, 30, 90)), 0u);
  u[5].north = u[4].north = 1.0;
  EXPECT_EQ(count(volume(u, 480, 520, 30, 90)), 1u);
}

TEST(Conflicts, KnowCircles) {
  Zone zone = volume(square(0, 0, 1), 480, 520, 30, 90);
  zone.areas[0].ring.clear();
  zone.areas[0].centre = kPlace.point({150.0, 50.0});
  zone.areas[0].radius = 49.97;
  EXPECT_EQ(count(zone), 0u);
  zone.areas[0].radius = 50.0;
  EXPECT_EQ(count(zone), 1u);
}

TEST(Conflicts, SayWhenAndWhere) {
  const std::vector<UtmEntity> others{entity("other", volume(square(80, 60, 100), 480, 520, 30, 90))};
  const std::vector<Conflict> conflicts = conflicts_of(own(), others, kPlace);
  ASSERT_EQ(conflicts.size(), 1u);
  EXPECT_EQ(conflicts[0].span.from, kNoon + 30 * tern_host::kSecond);
  EXPECT_EQ(conflicts[0].span.until, kNoon + 60 * tern_host::kSecond);
  EXPECT_EQ(conflicts[0].low, 480.0);
  EXPECT_EQ(conflicts[0].high, 500.0);
  const Plan2 at = kPlace.plan(conflicts[0].place);
  EXPECT_NEAR(at.east, 90.0, 0.01);
  EXPECT_NEAR(at.north, 80.0, 0.01);
}

TEST(Conflicts, BindByPriority) {
  const Zone zone = volume(square(50, 50, 100), 480, 520, 30, 90);
  EXPECT_TRUE(conflicts_of(own(5), {entity("other", zone, 5)}, kPlace)[0].binding);
  EXPECT_TRUE(conflicts_of(own(5), {entity("other", zone, 6)}, kPlace)[0].binding);
  EXPECT_FALSE(conflicts_of(own(5), {entity("other", zone, 4)}, kPlace)[0].binding);
  UtmEntity constraint = entity("other", zone);
  constraint.kind = EntityKind::kConstraint;
  EXPECT_TRUE(conflicts_of(own(5), {constraint}, kPlace)[0].binding);
}

TEST(Conflicts, LeaveOutEarlierVersions) {
  const Zone zone = volume(square(50, 50, 100), 480, 520, 30, 90);
  EXPECT_TRUE(conflicts_of(own(), {entity("own", zone)}, kPlace).empty());
}

TEST(Conflicts, HoldAtAllTimesAndHeightsIfNoneAreSaid) {
  Zone zone = volume(square(50, 50, 100), 480, 520, 30, 90);
  zone.times.clear();
  zone.lower.reset();
  zone.upper.reset();
  EXPECT_EQ(count(zone), 1u);
}

TEST(Conflicts, RefuseWhatIsTooFarAway) {
  UtmEntity far = own();
  far.volumes[0] = volume(square(20000, 0, 100), 450, 500, 0, 60);
  EXPECT_THROW(conflicts_of(far, {}, kPlace), std::invalid_argument);
}

// ---- beside a comparison of all sides ----

long double side_of(const Plan2& a, const Plan2& b, const Plan2& p) {
  return (static_cast<long double>(b.east) - a.east) * (static_cast<long double>(p.north) - a.north) -
         (static_cast<long double>(b.north) - a.north) * (static_cast<long double>(p.east) - a.east);
}

long double distance(const Plan2& a, const Plan2& b, const Plan2& p) {
  const long double dx = b.east - a.east, dy = b.north - a.north;
  const long double u = ((p.east - a.east) * dx + (p.north - a.north) * dy) / (dx * dx + dy * dy);
  const long double v = std::clamp(u, 0.0L, 1.0L);
  return std::hypot(p.east - a.east - v * dx, p.north - a.north - v * dy);
}

bool inside(const std::vector<Plan2>& ring, const Plan2& p) {
  int turns = 0;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Plan2& a = ring[i];
    const Plan2& b = ring[(i + 1) % ring.size()];
    if (a.north <= p.north && b.north > p.north && side_of(a, b, p) > 0.0L) ++turns;
    if (a.north > p.north && b.north <= p.north && side_of(a, b, p) < 0.0L) --turns;
  }
  return turns != 0;
}

/// 0 where they have a point in common.
long double gap(const std::vector<Plan2>& a, const std::vector<Plan2>& b) {
  if (inside(a, b[0]) || inside(b, a[0])) return 0.0L;
  long double least = HUGE_VALL;
  for (std::size_t i = 0; i < a.size(); ++i) {
    const Plan2 &p = a[i], &q = a[(i + 1) % a.size()];
    for (std::size_t j = 0; j < b.size(); ++j) {
      const Plan2 &r = b[j], &s = b[(j + 1) % b.size()];
      if (side_of(p, q, r) * side_of(p, q, s) <= 0.0L && side_of(r, s, p) * side_of(r, s, q) <= 0.0L) return 0.0L;
      least = std::min({least, distance(p, q, r), distance(p, q, s), distance(r, s, p), distance(r, s, q)});
    }
  }
  return least;
}

std::vector<Plan2> star(Random& random, double x, double y) {
  std::vector<Plan2> ring;
  const int corners = random.integer(3, 9);
  for (int i = 0; i < corners; ++i) {
    const double angle = 6.283185307179586 * (i + random.real(0.0, 0.6)) / corners, r = random.real(10.0, 60.0);
    ring.push_back({x + r * std::cos(angle), y + r * std::sin(angle)});
  }
  return ring;
}

TEST(Conflicts, AgreeWithAComparisonOfAllSides) {
  Random random(105);
  const int cases = tern_test::scaled(2000);
  int met = 0, apart = 0;
  for (int c = 0; c < cases; ++c) {
    const std::vector<Plan2> a = star(random, 0.0, 0.0);
    const std::vector<Plan2> b = star(random, random.real(-120.0, 120.0), random.real(-120.0, 120.0));
    const UtmEntity mine = entity("own", volume(a, 450, 500, 0, 60));
    const bool found = !conflicts_of(mine, {entity("other", volume(b, 450, 500, 0, 60))}, kPlace).empty();
    const long double between = gap(a, b);
    ASSERT_TRUE(found || between > 0.0L) << "case " << c;
    ASSERT_FALSE(found && between > 0.02L) << "case " << c << ", " << static_cast<double>(between) << " m apart";
    (found ? met : apart) += 1;
  }
  EXPECT_TRUE(met > cases / 10 && apart > cases / 10) << met << ", " << apart;
}

TEST(ConvexGap, IsTheDistanceOfPolygons) {
  const PlanPolygon a{{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  EXPECT_EQ(tern_host::gap_between(a, {{3, 0}, {4, 0}, {4, 1}}), 2.0);
  EXPECT_DOUBLE_EQ(tern_host::gap_between(a, {{4, 5}, {6, 5}, {6, 7}}), 5.0);
  EXPECT_EQ(tern_host::gap_between(a, {{0.5, 0.5}, {6, 5}, {5, 7}}), 0.0);
  EXPECT_EQ(tern_host::gap_between(a, {{1, 0}, {2, 0}, {2, 1}}), 0.0);
  const auto at = tern_host::common_place(a, {{0.5, -1}, {2, -1}, {2, 2}, {0.5, 2}});
  EXPECT_DOUBLE_EQ(at.x, 0.75);
  EXPECT_DOUBLE_EQ(at.y, 0.5);
}

}  // namespace
