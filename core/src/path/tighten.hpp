// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Pulling the shortcut path tight: its waypoints leave the voxel centres for the corners and edges that the shortest
// path of its kind bends at.
#ifndef TERN_PATH_TIGHTEN_HPP
#define TERN_PATH_TIGHTEN_HPP

#include <cstdint>

#include "tern/grid.hpp"
#include "tern/path.hpp"

namespace tern {

/// Times that each waypoint is visited. Most paths stop changing after two or three.
constexpr int kTightenPasses = 4;
/// Trials of one move: steps that grow across the largest grid, then halve from its diagonal down to the finest step.
constexpr int kTightenTrials = 26;
/// A move, or what is left of one, is not tried where it can shorten the path by no more than this part of a voxel:
/// along a move the length falls, so that its end tells.
constexpr double kTightenLeast = 0.01;
/// A move is known well enough when this part of a voxel is left between the farthest position in sight and the nearest
/// out of sight.
constexpr double kTightenFinest = 0.2;
/// Each step of a move is so many times the one before, from one voxel on, until one is refused.
constexpr double kTightenGrowth = 4.0;
/// A pass that shortens the path by less than this part of a voxel is the last.
constexpr double kTightenGain = 0.1;

/// Segments to a moved waypoint keep this part of a voxel (max norm) from what is not free, more than a line of sight
/// must: the corridor around them is wider for it. Less gives shorter paths and, in narrow places, slower plans.
constexpr double kTightenMargin = 0.15;

/// What is tried with a waypoint, in this order. Each leads along a straight line on which the path grows shorter.
enum class TightenMove : std::uint8_t {
  kDrop,    ///< leave it out
  kBack,    ///< towards the waypoint before it
  kOn,      ///< towards the waypoint after it
  kAlongX,  ///< along an axis, as an edge of a voxel runs, to where the path is shortest
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
  int waypoint;  ///< being moved; path.count - 1 or more when the path is tight
  TightenMove move;
  int trials;         ///< left of the move
  double pass_start;  ///< the path's length when the pass began, metres
  Vec3 from;          ///< where the move began
  Vec3 to;            ///< where it leads at most
  double reach;       ///< metres from one to the other
  double seen;        ///< farthest that it went, metres
  double refused;     ///< nearest that was refused, or more than reach
  double next;        ///< to be tried next
  double length;      ///< of the two hops over the waypoint, metres
  double least;       ///< what it would be at `refused` or, before anything is refused, at `to`
};

/// `path` holds waypoints and length. Each inner waypoint may move.
void tighten_begin(Tighten& tighten, const Grid& grid, const Path& path) noexcept;

/// True while a trial is to be made.
bool tighten_needs_trial(const Tighten& tighten, const Path& path) noexcept;

/// Makes one trial: two lines of sight at most. The path never grows longer, nor has it more waypoints; every segment
/// that changes passes line_of_sight, with kTightenMargin where a waypoint moved, with kSightMargin where one was left
/// out. Keeps path.count and, from pass to pass, length up to date.
void tighten_try(Tighten& tighten, const Grid& grid, Path& path) noexcept;

}  // namespace tern

#endif
