// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "path/shortcut.hpp"

#include "base/capacity.hpp"
#include "base/math.hpp"
#include "path/polyline.hpp"
#include "path/sight.hpp"

namespace tern {
namespace {

double leg_cost(const Grid& grid, const Path& path, std::int32_t i, std::int32_t j) {
  return distance(path.raw[i], path.raw[j]) + kLegPrice * grid.spec().cell;
}

/// The first candidate for the head's predecessor.
std::int32_t window_begin(const Shortcut& shortcut) {
  return shortcut.head > kSightWindow ? shortcut.head - kSightWindow : 0;
}

/// The least of `count` values and `least`. Compares four at a time, so that no comparison waits for the one before.
double least_of(const double* values, std::int32_t count, double least) {
  double lanes[4] = {least, least, least, least};
  std::int32_t i = 0;
  for (; i + 4 <= count; i += 4) {
    for (int k = 0; k < 4; ++k) lanes[k] = smaller(values[i + k], lanes[k]);
  }
  for (; i < count; ++i) lanes[0] = smaller(values[i], lanes[0]);
  return smaller(smaller(lanes[0], lanes[1]), smaller(lanes[2], lanes[3]));
}

/// The candidate whose chain to the head is the cheapest, if it beats the best known one; of equals, the one with the
/// lowest index. -1 if nothing beats the best known.
std::int32_t best_probe(const Shortcut& shortcut) {
  const double known = shortcut.ends[shortcut.head].cost;
  const std::int32_t begin = window_begin(shortcut);
  const double least = least_of(shortcut.onward + begin, shortcut.head - 1 - begin, known);
  if (!(least < known)) return -1;
  std::int32_t best = begin;
  while (shortcut.onward[best] > least) ++best;
  return best;
}

/// Makes the next point the head. At first, its best chain ends with the leg from the point before it.
void chain_advance(Shortcut& shortcut, const Grid& grid, const Path& path) {
  const std::int32_t j = ++shortcut.head;
  if (j >= path.raw_count) return;
  for (std::int32_t i = window_begin(shortcut); i < j; ++i) {
    shortcut.onward[i] = shortcut.ends[i].cost + leg_cost(grid, path, i, j);
  }
  shortcut.ends[j] = {shortcut.onward[j - 1], j - 1};
  shortcut.probe = best_probe(shortcut);
}

}  // namespace

void shortcut_begin(Shortcut& shortcut, const Grid& grid, Path& path) noexcept {
  shortcut.head = 0;
  shortcut.probe = path.raw_count - 1;
  shortcut.ends[0] = {0.0, 0};
  path.raw_length = polyline_length(path.raw, path.raw_count);
  chain_advance(shortcut, grid, path);
}

bool shortcut_needs_step(const Shortcut& shortcut, const Path& path) noexcept {
  return shortcut.head < path.raw_count;
}

void shortcut_step(Shortcut& shortcut, const Grid& grid, Path& path) noexcept {
  if (shortcut.probe < 0) return chain_advance(shortcut, grid, path);
  ChainEnd& end = shortcut.ends[shortcut.head];
  double& onward = shortcut.onward[shortcut.probe];
  // Probes are tried cheapest first, so the first one in sight is the best.
  if (line_of_sight(grid, path.raw[shortcut.probe], path.raw[shortcut.head])) {
    end.cost = onward;
    end.from = shortcut.probe;
    return chain_advance(shortcut, grid, path);
  }
  // This makes the candidate as expensive as the best known, so it is never chosen again.
  onward = end.cost;
  shortcut.probe = best_probe(shortcut);
}

Status shortcut_finish(Shortcut& shortcut, Path& path) noexcept {
  const std::int32_t last = path.raw_count - 1;
  int count = 1;
  for (std::int32_t i = last; i > 0; i = shortcut.ends[i].from) ++count;
  path.count = count;
  if (is_full(count > kMaxWaypoints)) return Status::kSegmentsFull;
  std::int32_t at = last;
  for (int k = count - 1; k >= 0; --k) {
    path.points[k] = path.raw[at];
    at = shortcut.ends[at].from;
  }
  path.length = polyline_length(path.points, count);
  return Status::kOk;
}

}  // namespace tern
