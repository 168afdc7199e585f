// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "path/tighten.hpp"

#include "base/math.hpp"
#include "path/polyline.hpp"
#include "path/sight.hpp"

namespace tern {
namespace {

/// The coordinate at which a path from a to b is shortest if it touches the line through p along the axis. If the
/// half-planes from this line to a and to b are unfolded into one plane, the shortest path is a straight line.
double shortest_along(const Vec3& a, const Vec3& p, const Vec3& b, int along) {
  Vec3 to_a = a - p;
  Vec3 to_b = b - p;
  axis(to_a, along) = 0.0;
  axis(to_b, along) = 0.0;
  const double off_a = length(to_a);
  const double off_b = length(to_b);
  if (!(off_a + off_b > 0.0)) return axis(p, along);
  return axis(a, along) + (axis(b, along) - axis(a, along)) * (off_a / (off_a + off_b));
}

/// The farthest point that the move may reach.
Vec3 target(const Path& path, int waypoint, TightenMove move) {
  const Vec3& before = path.points[waypoint - 1];
  const Vec3& after = path.points[waypoint + 1];
  Vec3 to = path.points[waypoint];
  switch (move) {
    case TightenMove::kDrop:
    case TightenMove::kBack:
      return before;
    case TightenMove::kOn:
      return after;
    case TightenMove::kAlongX:
    case TightenMove::kAlongY:
    case TightenMove::kAlongZ: {
      const int along = static_cast<int>(move) - static_cast<int>(TightenMove::kAlongX);
      axis(to, along) = shortest_along(before, to, after, along);
      return to;
    }
    case TightenMove::kMoves:
      break;
  }
  return to;
}

/// Length of the two legs at the waypoint if the waypoint were at `at`.
double bend(const Tighten& tighten, const Path& path, const Vec3& at) {
  return distance(path.points[tighten.waypoint - 1], at) + distance(at, path.points[tighten.waypoint + 1]);
}

/// The point that is `far` metres along the move.
Vec3 position(const Tighten& tighten, double far) {
  return tighten.from + (far / tighten.reach) * (tighten.to - tighten.from);
}

/// True if the move is worth trying.
bool set_up(Tighten& tighten, const Grid& grid, const Path& path) {
  const double cell = grid.spec().cell;
  tighten.from = path.points[tighten.waypoint];
  tighten.to = target(path, tighten.waypoint, tighten.move);
  tighten.reach = distance(tighten.from, tighten.to);
  tighten.seen = 0.0;
  tighten.refused = 2.0 * tighten.reach;
  tighten.length = bend(tighten, path, tighten.from);
  tighten.least = bend(tighten, path, tighten.to);
  tighten.trials = kTightenTrials;
  tighten.next = smaller(cell, tighten.reach);
  return tighten.move == TightenMove::kDrop || tighten.length - tighten.least > kTightenLeast * cell;
}

/// Finds the next move that is worth trying: of this waypoint, then of the next ones, then in another pass, as long as
/// each pass gains enough.
void advance(Tighten& tighten, const Grid& grid, Path& path) {
  // Each iteration takes one move. A pass takes all moves of all waypoints.
  while (tighten.waypoint + 1 < path.count) {
    tighten.move = static_cast<TightenMove>(static_cast<int>(tighten.move) + 1);
    if (tighten.move == TightenMove::kMoves) {
      tighten.move = TightenMove::kDrop;
      ++tighten.waypoint;
    }
    if (tighten.waypoint + 1 >= path.count) {
      path.length = polyline_length(path.points, path.count);
      if (++tighten.pass == kTightenPasses) return;
      if (!(path.length < tighten.pass_start - kTightenGain * grid.spec().cell)) return;
      tighten.pass_start = path.length;
      tighten.waypoint = 1;
    }
    if (tighten.waypoint + 1 < path.count && set_up(tighten, grid, path)) return;
  }
}

void drop(Tighten& tighten, Path& path) {
  for (int k = tighten.waypoint; k + 1 < path.count; ++k) path.points[k] = path.points[k + 1];
  --path.count;
  // Continues with the waypoint that took the place of the dropped one. All moves of the waypoint before are done.
  tighten.move = TightenMove::kAlongZ;
  --tighten.waypoint;
}

/// True if both legs over `at` are in sight. First tests the leg that is not part of a line known to be clear.
bool clear(const Tighten& tighten, const Grid& grid, const Path& path, const Vec3& at) {
  const Vec3& before = path.points[tighten.waypoint - 1];
  const Vec3& after = path.points[tighten.waypoint + 1];
  const Vec3& first = tighten.move == TightenMove::kOn ? before : after;
  const Vec3& second = tighten.move == TightenMove::kOn ? after : before;
  return line_of_sight(grid, at, first, kTightenMargin) && line_of_sight(grid, at, second, kTightenMargin);
}

/// Chooses the next step. Steps grow until one is refused, and then halve the remaining distance. If the first step is
/// refused, the finest step decides whether the waypoint can move at all. False if no step is worth trying.
bool set_next(Tighten& tighten, const Grid& grid) {
  const double cell = grid.spec().cell;
  const bool refused = tighten.refused <= tighten.reach;
  const double left = (refused ? tighten.refused : tighten.reach) - tighten.seen;
  if (!refused) {
    tighten.next = smaller(kTightenGrowth * tighten.seen, tighten.reach);
  } else if (tighten.seen > 0.0) {
    tighten.next = 0.5 * (tighten.seen + tighten.refused);
  } else {
    tighten.next = kTightenFinest * cell;
  }
  return left > kTightenFinest * cell && tighten.length - tighten.least > kTightenLeast * cell;
}

}  // namespace

void tighten_begin(Tighten& tighten, const Grid& grid, const Path& path) noexcept {
  tighten.pass = 0;
  tighten.waypoint = 1;
  tighten.move = TightenMove::kDrop;
  tighten.pass_start = path.length;
  if (path.count > 2) set_up(tighten, grid, path);
}

bool tighten_needs_trial(const Tighten& tighten, const Path& path) noexcept {
  return tighten.waypoint + 1 < path.count;
}

void tighten_try(Tighten& tighten, const Grid& grid, Path& path) noexcept {
  if (tighten.move == TightenMove::kDrop) {
    if (line_of_sight(grid, path.points[tighten.waypoint - 1], path.points[tighten.waypoint + 1])) drop(tighten, path);
    return advance(tighten, grid, path);
  }
  const Vec3 at = position(tighten, tighten.next);
  const double length = bend(tighten, path, at);
  if (length < tighten.length && clear(tighten, grid, path, at)) {
    path.points[tighten.waypoint] = at;
    tighten.length = length;
    tighten.seen = tighten.next;
  } else {
    tighten.least = length;
    tighten.refused = tighten.next;
  }
  if (--tighten.trials == 0 || !set_next(tighten, grid)) advance(tighten, grid, path);
}

}  // namespace tern
