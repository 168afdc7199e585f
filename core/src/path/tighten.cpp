// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "path/tighten.hpp"

#include "base/math.hpp"
#include "path/sight.hpp"

namespace tern {
namespace {

/// Where along one axis through p the way from a over p to b is shortest: the two triangles that p makes with the axis,
/// unfolded into one plane, make a straight line.
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

/// Where the move leads at most.
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

double chain_length(const Path& path) {
  double sum = 0.0;
  for (int k = 1; k < path.count; ++k) sum += distance(path.points[k - 1], path.points[k]);
  return sum;
}

/// True where the move has something to try.
bool set_up(Tighten& tighten, const Grid& grid, const Path& path) {
  const double cell = grid.spec().cell;
  tighten.from = path.points[tighten.waypoint];
  tighten.to = target(path, tighten.waypoint, tighten.move);
  tighten.reach = distance(tighten.from, tighten.to);
  tighten.seen = 0.0;
  tighten.refused = 2.0 * tighten.reach;
  tighten.trials = kTightenTrials;
  tighten.next = smaller(cell, tighten.reach);
  return tighten.move == TightenMove::kDrop || tighten.reach > kTightenFinest * cell;
}

/// The next move that has something to try: of this waypoint, of the next, of the next pass while passes pay.
void advance(Tighten& tighten, const Grid& grid, Path& path) {
  // Each turn takes a move; a pass takes all moves of all waypoints.
  while (tighten.waypoint + 1 < path.count) {
    tighten.move = static_cast<TightenMove>(static_cast<int>(tighten.move) + 1);
    if (tighten.move == TightenMove::kMoves) {
      tighten.move = TightenMove::kDrop;
      ++tighten.waypoint;
    }
    if (tighten.waypoint + 1 >= path.count) {
      path.length = chain_length(path);
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
  // The waypoint that took its place is next.
  tighten.move = TightenMove::kMoves;
  --tighten.waypoint;
}

/// The path over `at` instead of the waypoint is shorter, and in sight.
bool takes(const Tighten& tighten, const Grid& grid, const Path& path, const Vec3& at) {
  const Vec3& before = path.points[tighten.waypoint - 1];
  const Vec3& after = path.points[tighten.waypoint + 1];
  const Vec3& now = path.points[tighten.waypoint];
  if (!(distance(before, at) + distance(at, after) < distance(before, now) + distance(now, after))) return false;
  return line_of_sight(grid, at, after, kTightenMargin) && line_of_sight(grid, before, at, kTightenMargin);
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
  const double part = tighten.next / tighten.reach;
  const Vec3 at = tighten.from + part * (tighten.to - tighten.from);
  if (takes(tighten, grid, path, at)) {
    path.points[tighten.waypoint] = at;
    tighten.seen = tighten.next;
  } else {
    tighten.refused = tighten.next;
  }
  // Steps double until one is refused, then halve what is left between.
  const bool refused = tighten.refused <= tighten.reach;
  tighten.next = refused ? 0.5 * (tighten.seen + tighten.refused) : smaller(2.0 * tighten.seen, tighten.reach);
  const double left = (refused ? tighten.refused : tighten.reach) - tighten.seen;
  if (--tighten.trials == 0 || left <= kTightenFinest * grid.spec().cell) advance(tighten, grid, path);
}

}  // namespace tern
