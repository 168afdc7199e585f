// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "flood/timed_way.hpp"

#include "base/capacity.hpp"
#include "base/direction.hpp"
#include "base/math.hpp"
#include "grid/lattice.hpp"
#include "path/sight.hpp"

namespace tern {
namespace {

/// Legs that rest may be longer by this factor.
constexpr std::int32_t kLongestRest = 3;

Vec3 point_of(const TimedFlood& flood, const Grid& grid, std::int32_t layer) {
  if (layer == 0) return flood.query.from;
  if (layer == flood.arrival) return flood.query.to;
  return middle_of(flood.lattice, grid, flood.way[layer]);
}

/// The most layers of a leg, so that there are hardly more than `most`.
std::int32_t longest_leg(const TimedFlood& flood, std::int32_t most) {
  const std::int32_t wanted = floor_index(kLongestLeg / flood.step, 1, kMaxFloodLayers);
  const std::int32_t needed = flood.arrival / (1 + most) + 1;
  return wanted < needed ? needed : wanted;
}

/// The layer that a leg reaches at most. A leg that stays in its cell may be longer.
std::int32_t first_trial(const TimedFlood& flood, std::int32_t longest, std::int32_t knot) {
  std::int32_t end = knot + longest;
  if (end > flood.arrival) return flood.arrival;
  std::int32_t stays = knot;
  while (stays < flood.arrival && same(flood.way[stays + 1], flood.way[knot])) ++stays;
  const std::int32_t most = knot + kLongestRest * longest;
  if (stays > end) end = stays < most ? stays : most;
  return end;
}

/// True if a point keeps off all things at a time.
bool is_clear(const Things& things, const Vec3& point, double time) {
  for (std::int32_t j = 0; j < things.count; ++j) {
    if (is_too_near(things, things.tracks[j], point, time)) return false;
  }
  return true;
}

/// True if a straight line from one layer's cell to another's is free and clear.
bool is_leg(const TimedFlood& flood, const Grid& grid, std::int32_t begin, std::int32_t end, Work& work) {
  const Vec3 from = point_of(flood, grid, begin);
  const Vec3 to = point_of(flood, grid, end);
  const bool is_outer = begin == 0 || end == flood.arrival;
  work.spend(sight_operations(grid, from, to));
  if (!line_of_sight(grid, from, to, is_outer ? 0.0 : kSightMargin)) return false;
  const Things& things = flood.query.things;
  for (std::int32_t k = begin + 1; k < end; ++k) {
    const double share = static_cast<double>(k - begin) / (end - begin);
    work.spend((ops::kPiece + ops::kDot) * things.count);
    if (!is_clear(things, from + share * (to - from), flood.query.begin + k * flood.step)) return false;
  }
  return true;
}

}  // namespace

void timed_way_begin(const TimedFlood& flood, std::int32_t most, TimedWay& way) noexcept {
  way.points[way.count] = flood.query.from;
  way.longest = longest_leg(flood, most);
  way.knot = 0;
  way.trial = first_trial(flood, way.longest, 0);
}

Progress timed_way_advance(const TimedFlood& flood, const Grid& grid, TimedWay& way, Work& work) noexcept {
  // Each trial is a layer nearer than the one before.
  for (std::int32_t i = 0; i < kMaxFloodLayers * kMaxFloodLayers; ++i) {
    if (way.knot == flood.arrival) return Progress::kDone;
    if (!work.left()) return Progress::kMore;
    work.spend(ops::kPiece);
    if (way.trial > way.knot + 1 && !is_leg(flood, grid, way.knot, way.trial, work)) {
      --way.trial;
      continue;
    }
    if (is_full(way.count == kMaxSegments)) return Progress::kFailed;
    way.duration[way.count] = (way.trial - way.knot) * flood.step;
    ++way.count;
    way.points[way.count] = point_of(flood, grid, way.trial);
    way.knot = way.trial;
    way.trial = first_trial(flood, way.longest, way.knot);
  }
  return Progress::kFailed;
}

}  // namespace tern
