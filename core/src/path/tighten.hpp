// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Pulls the shortcut path tight. Its waypoints move from voxel centres to the corners and edges where a taut string
// would bend.
#ifndef TERN_PATH_TIGHTEN_HPP
#define TERN_PATH_TIGHTEN_HPP

#include <cstdint>

#include "tern/grid.hpp"
#include "tern/path.hpp"

namespace tern {

/// Passes, at most; each visits every waypoint. Most paths stop changing after two or three.
constexpr int kTightenPasses = 4;
/// Trials of one move: steps that grow across the largest grid, then halve from its diagonal down to the finest step.
constexpr int kTightenTrials = 26;
/// A move, or its remainder, is skipped if it shortens the path by at most this share of a voxel. The path gets shorter
/// all along a move, so the end of the move has the greatest gain.
constexpr double kTightenLeast = 0.01;
/// A move is finished when the farthest position in sight and the nearest one out of sight are this share of a voxel
/// apart.
constexpr double kTightenFinest = 0.2;
/// The first step of a move is one voxel. Each further step is this many times the one before, until a step is refused.
constexpr double kTightenGrowth = 4.0;
/// A pass that shortens the path by less than this share of a voxel is the last.
constexpr double kTightenGain = 0.1;

/// Segments to a moved waypoint keep this share of a voxel (max norm) from everything that is not free. That is more
/// than a line of sight must keep, and it makes the corridor wider. A smaller share gives shorter paths but, in narrow
/// places, slower plans.
constexpr double kTightenMargin = 0.15;

/// The moves that are tried with a waypoint, in this order. Each but kDrop follows a straight line along which the path
/// gets shorter.
enum class TightenMove : std::uint8_t {
  kDrop,    ///< leave the waypoint out
  kBack,    ///< towards the waypoint before it
  kOn,      ///< towards the waypoint after it
  kAlongX,  ///< along an axis, like an edge of a voxel, to the point at which the path is shortest
  kAlongY,
  kAlongZ,
  kMoves,
};

/// Bound on trials, each of at most two lines of sight.
constexpr std::uint32_t kTightenBound = static_cast<std::uint32_t>(kMaxWaypoints) * kTightenPasses *
                                        ((static_cast<std::uint32_t>(TightenMove::kMoves) - 1u) * kTightenTrials + 1u);

/// Plain data; needs no initialisation before tighten_begin.
struct Tighten {
  int pass;
  int waypoint;  ///< the waypoint being moved; path.count - 1 or more once the path is tight
  TightenMove move;
  int trials;         ///< trials left for the current move
  double pass_start;  ///< the path's length when the pass began, metres
  Vec3 from;          ///< beginning of the move
  Vec3 to;            ///< the farthest point that it may reach
  double reach;       ///< metres from `from` to `to`
  double seen;        ///< farthest distance found in sight, metres
  double refused;     ///< nearest distance that was refused; more than reach if none was
  double next;        ///< distance to be tried next
  double length;      ///< length of the two legs at the waypoint, metres
  double least;       ///< length of the two legs at `refused` or, before anything is refused, at `to`
};

/// `path` holds waypoints and length. Each inner waypoint may move.
void tighten_begin(Tighten& tighten, const Grid& grid, const Path& path) noexcept;

/// True while there is a trial to make.
bool tighten_needs_trial(const Tighten& tighten, const Path& path) noexcept;

/// Makes one trial, which tests at most two lines of sight. The path never gets longer and never gains a waypoint.
/// Every leg that changes passes line_of_sight: with kTightenMargin if a waypoint moved, with kSightMargin if one was
/// dropped. Keeps path.count up to date, and path.length after each pass.
void tighten_try(Tighten& tighten, const Grid& grid, Path& path) noexcept;

}  // namespace tern

#endif
