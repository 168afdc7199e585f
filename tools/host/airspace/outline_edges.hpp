// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Where outlines meet, and how they are ordered along a level line, in exact numbers. Coordinates are steps of up to
// kMostSteps; no product here needs more than 183 bits.
#ifndef TERN_HOST_AIRSPACE_OUTLINE_EDGES_HPP
#define TERN_HOST_AIRSPACE_OUTLINE_EDGES_HPP

#include <boost/multiprecision/cpp_int.hpp>
#include <vector>

#include "host/airspace/convex_pieces.hpp"

namespace tern_host {

using Wide = boost::multiprecision::int256_t;

/// p / q with q > 0.
struct Level {
  Wide p;
  Wide q;
};
bool operator<(const Level& a, const Level& b);
bool operator==(const Level& a, const Level& b);

/// An edge that is not level.
struct Edge {
  Corner low;
  Corner high;
  int turn;  ///< what it adds to the windings when it is passed towards positive x
  std::size_t layer;

  std::int64_t dx() const { return high.x - low.x; }
  std::int64_t dy() const { return high.y - low.y; }
};

/// A level, and about where it is, in steps.
struct LevelLine {
  const Level* level;
  long double near;
};
LevelLine line_of(const Level& level);

/// Where an edge is on a level: x in steps, off by at most `error`.
struct Abscissa {
  const Edge* edge;
  const Level* level;
  long double near;
  long double error;
};
Abscissa abscissa(const Edge& edge, const LevelLine& line);
/// Negative, zero or positive as x of `a` is less than, equal to or more than that of `b` on the same level: in exact
/// numbers where they are too near to tell.
int compare(const Abscissa& a, const Abscissa& b);

/// The x of the edge on the level, and the level itself, in steps, rounded once.
long double rounded_x(const Edge& edge, const Level& level);
long double rounded(const Level& level);

/// Negative, zero or positive as dx / dy of `a` is less than, equal to or more than that of `b`.
int compare_slopes(const Edge& a, const Edge& b);

/// What happens at a place: the edge begins, ends or meets another there.
struct Event {
  Level level;
  const Edge* edge;
};

/// What the outlines consist of: all edges that are not level, by their lower ends, and what happens where, by levels.
struct Arrangement {
  std::vector<Edge> edges;
  std::vector<Event> events;
};
Arrangement arrange(const std::vector<Outline>& outlines);

}  // namespace tern_host

#endif
