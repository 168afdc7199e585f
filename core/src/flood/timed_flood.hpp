// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// A flood in time: which cells can be reached when, among things that move. A layer lasts as long as a cell takes at
// the flood's speed. The next layer holds the cells that are at most a step away, free, and not near a thing then; so
// waiting, backing out and ducking aside are ways like any other. There is no open list: the work is layers times
// words.
//
//   forward    layers from the start, within what its velocity and the acceleration allow
//   backward   once the goal is reached and stays clear: the cells of each layer that a way of that arrival leads
//              through, within what braking at the goal allows
//   trace      a way among these, which cannot get stuck
#ifndef TERN_FLOOD_TIMED_FLOOD_HPP
#define TERN_FLOOD_TIMED_FLOOD_HPP

#include <cstdint>

#include "base/progress.hpp"
#include "base/work.hpp"
#include "flood/flood_lattice.hpp"
#include "flood/flood_layers.hpp"
#include "tern/config.hpp"
#include "tern/grid.hpp"
#include "tern/status.hpp"
#include "tracks/thing.hpp"

namespace tern {

/// The most layers.
constexpr std::int32_t kMaxFloodLayers = 192;
/// The most backward passes.
constexpr int kMostArrivals = 8;

/// What is looked for. Local frame of the grid.
struct FloodQuery {
  Things things;
  Vec3 from;
  Vec3 to;
  Vec3 velocity;          ///< at `from`
  Vec3 fastest;           ///< m/s along each axis, > 0
  Vec3 strongest;         ///< m/s^2 along each axis, > 0
  Vec3 sharpest;          ///< m/s^3 along each axis, > 0; infinite if there is no limit
  double begin;           ///< s of the things' clock: when the way begins
  double rest;            ///< s that `to` is to stay clear
  double longest;         ///< s: the way takes no longer
  double share;           ///< of the speed, at most 1
  double more;            ///< that the way keeps off things, in cells
  std::int32_t edge;      ///< of a cell, voxels; larger if the layers do not fit
  bool begins_in_flight;  ///< at a via, with a velocity that is not known yet: limits on acceleration leave out nothing
  bool ends_in_flight;    ///< as above, at `to`: the way need not brake
};

enum class FloodPhase : std::uint8_t { kFree, kForward, kMark, kArrive, kBackward, kTrace, kEnd };

/// Plain data; needs no initialisation before timed_flood_begin.
struct TimedFlood {
  std::int32_t arrival;            ///< the result: the layer that arrives
  double step;                     ///< s of a layer
  Voxel way[kMaxFloodLayers + 1];  ///< the result: the cell of each layer
  FloodLattice lattice;

  FloodQuery query;
  FloodPhase phase;
  std::int32_t layers;
  std::int32_t layer;    ///< the next one
  std::int32_t row;      ///< of the free cells, the next one
  std::int32_t track;    ///< whose cells are cleared next
  std::int32_t first;    ///< the first layer whose arrival is looked at; 0: not known yet
  std::int32_t instant;  ///< after an arrival, in layers: when the goal is looked at next
  int arrivals;          ///< backward passes
  double covered;        ///< until then, the goal is not clear
  Vec3 ratio;            ///< steps along each axis for each layer
  Voxel start;
  Voxel goal;
  Vec3 pace;  ///< of the trace: recent steps
  std::uint64_t words[kMaxFloodWords];
};

/// kRunning, or kFloodFull if even layers of cells four times as large do not fit.
Status timed_flood_begin(TimedFlood& flood, const Grid& grid, const FloodQuery& query) noexcept;

/// What it takes of kMaxFloodWords.
std::int64_t words_of(const TimedFlood& flood) noexcept;

/// A piece of work is a row of free cells, a layer, a thing in a layer, the goal at an instant, or a step of the trace.
/// kFailed: there is no way.
Progress timed_flood_advance(TimedFlood& flood, const Grid& grid, Work& work) noexcept;

/// Pieces of one flood.
constexpr std::uint64_t kFloodPieces =
    std::uint64_t{kMaxFloodWords} +
    (kMostArrivals + 3 + kMaxThings + kMaxFloodLayers + 2) * std::uint64_t{kMaxFloodLayers + 1};
/// The most operations of a piece: a layer, or a look at the goal.
constexpr Operations kFloodOperations = kLayerWordOperations * Operations{kMaxFloodWords} +
                                        2 * (ops::kRow + ops::kDot) * Operations{kMaxFloodWords} +
                                        Operations{kMaxThings} * ops::kPiece + Operations{kMaxTrackPieces} * ops::kTurn;

}  // namespace tern

#endif
