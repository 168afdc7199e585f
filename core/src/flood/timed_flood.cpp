// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "flood/timed_flood.hpp"

#include "base/capacity.hpp"
#include "base/math.hpp"
#include "flood/flood_layers.hpp"
#include "flood/flood_marks.hpp"
#include "grid/lattice.hpp"

namespace tern {
namespace {

/// Layers of words besides those of the two passes: free cells, free and clear cells, scratch.
constexpr std::int32_t kOtherLayers = 4;
/// Cells may become larger by this factor so that the layers fit.
constexpr std::int32_t kLargest = 4;

// Weights of the trace: steps as the last ones, steps that lead evenly to the goal, and the goal's height.
constexpr double kLikeLast = 0.3;
constexpr double kOffHeight = 0.02;
constexpr double kOldPace = 0.7;

std::uint64_t* free_cells(TimedFlood& flood) {
  return flood.words;
}
std::uint64_t* clear_cells(TimedFlood& flood) {
  return flood.words + flood.lattice.words;
}
std::uint64_t* scratch_of(TimedFlood& flood) {
  return flood.words + 2 * flood.lattice.words;
}
std::uint64_t* reached(TimedFlood& flood, std::int32_t layer) {
  return flood.words + (kOtherLayers + layer) * flood.lattice.words;
}
std::uint64_t* leading(TimedFlood& flood, std::int32_t layer) {
  return reached(flood, flood.layers + 1 + layer);
}

/// How many steps up to a layer may go along an axis.
std::int32_t steps_until(const TimedFlood& flood, std::int32_t layer, int a) {
  return floor_index(layer * axis(flood.ratio, a), 0, layer);
}

/// Whether the step to a layer may go along an axis that is slower than the fastest one.
bool steps_along(const TimedFlood& flood, std::int32_t layer, int a) {
  return steps_until(flood, layer, a) > steps_until(flood, layer - 1, a);
}

void spread(TimedFlood& flood, std::int32_t layer, const std::uint64_t* in, std::uint64_t* out) {
  const FloodSteps steps{steps_along(flood, layer, 0), steps_along(flood, layer, 1), steps_along(flood, layer, 2)};
  spread_layer(flood.lattice, steps, free_cells(flood), in, out, scratch_of(flood));
}

/// Clears what cannot be reached from a point with a velocity within `time`. In flight, all can.
void keep_reachable(const TimedFlood& flood, const Grid& grid, const Vec3& point, const Vec3& velocity, double time,
                    bool in_flight, std::uint64_t* layer) {
  if (in_flight) return;
  const FloodQuery& query = flood.query;
  clear_out_of_reach(flood.lattice, grid, {point, velocity, query.fastest, query.strongest, query.sharpest}, time,
                     layer);
}

/// Begins to look whether the goal stays clear from the layer on, latest instant first.
void begin_arrival(TimedFlood& flood) {
  flood.instant = floor_index(flood.query.rest / flood.step, 0, kMaxFloodLayers) + 1;
  flood.phase = FloodPhase::kArrive;
}

/// True if the goal is clear at the next instant. Else `covered` says until when at least it is not.
bool goal_is_clear(TimedFlood& flood, std::int32_t layer, Operations& spent) {
  const FloodQuery& query = flood.query;
  const double time = query.begin + (layer + flood.instant) * flood.step;
  for (std::int32_t j = 0; j < query.things.count; ++j) {
    const Track& track = query.things.tracks[j];
    spent += ops::kPiece + ops::kTurn * track.piece_count;
    if (!is_too_near(query.things, track, query.to, time)) continue;
    flood.covered = time;
    return false;
  }
  --flood.instant;
  return true;
}

/// Makes the layer as if there were no things.
void step_forward(TimedFlood& flood, const Grid& grid) {
  const std::int32_t k = flood.layer;
  const double since = k * flood.step;
  std::uint64_t* const layer = reached(flood, k);
  spread(flood, k, reached(flood, k - 1), layer);
  keep_reachable(flood, grid, flood.query.from, flood.query.velocity, since, flood.query.begins_in_flight, layer);
  std::uint64_t* const clear = clear_cells(flood);
  for (std::int32_t r = 0; r < flood.lattice.words; ++r) clear[r] = free_cells(flood)[r];
  flood.track = 0;
  flood.phase = FloodPhase::kMark;
}

/// Clears the cells that are near the next thing.
void mark(TimedFlood& flood, const Grid& grid, Operations& spent) {
  const double time = flood.query.begin + flood.layer * flood.step;
  const Track& track = flood.query.things.tracks[flood.track];
  spent += clear_near_thing(flood.lattice, grid, flood.query.things, track, time, flood.query.more * flood.lattice.size,
                            clear_cells(flood));
  ++flood.track;
}

/// The layers that braking takes longer than going on.
std::int32_t braking_layers(const TimedFlood& flood) {
  if (flood.query.ends_in_flight) return 0;
  double longest = 0.0;
  for (int a = 0; a < 3; ++a) {
    if (axis(flood.start, a) == axis(flood.goal, a)) continue;
    const FloodQuery& query = flood.query;
    const double speed = query.share * axis(query.fastest, a);
    const SpeedUp up = speed_up(speed, {speed, axis(query.strongest, a), axis(query.sharpest, a)});
    longest = larger(longest, 0.5 * (up.ramp + up.delay));
  }
  return floor_index(longest / flood.step, 0, kMaxFloodLayers);
}

/// Ends a layer. False if the flood leads nowhere.
bool end_layer(TimedFlood& flood) {
  const std::int32_t k = flood.layer;
  if (!keep_common(flood.lattice, clear_cells(flood), reached(flood, k))) return false;
  ++flood.layer;
  flood.phase = FloodPhase::kForward;
  if (!has_cell(flood.lattice, reached(flood, k), flood.goal)) return true;
  if (flood.first == 0) flood.first = k + braking_layers(flood);
  if (k >= flood.first && flood.query.begin + k * flood.step > flood.covered) begin_arrival(flood);
  return true;
}

/// Looks at the goal once more. Begins the backward pass if it stays clear, and goes on forward if not. False if there
/// were too many arrivals.
bool look_at_goal(TimedFlood& flood, Operations& spent) {
  const std::int32_t k = flood.layer - 1;
  if (!goal_is_clear(flood, k, spent)) {
    flood.phase = FloodPhase::kForward;
    return true;
  }
  if (flood.instant >= 0) return true;
  if (is_full(flood.arrivals == kMostArrivals)) return false;
  ++flood.arrivals;
  flood.arrival = k;
  std::uint64_t* const last = leading(flood, k);
  for (std::int32_t r = 0; r < flood.lattice.words; ++r) last[r] = 0;
  set_cell(flood.lattice, flood.goal, last);
  flood.layer = k - 1;
  flood.phase = FloodPhase::kBackward;
  return true;
}

void flood_backward(TimedFlood& flood, const Grid& grid) {
  const std::int32_t k = flood.layer;
  std::uint64_t* const layer = leading(flood, k);
  spread(flood, k + 1, leading(flood, k + 1), layer);
  keep_reachable(flood, grid, flood.query.to, kZero, (flood.arrival - k) * flood.step, flood.query.ends_in_flight,
                 layer);
  --flood.layer;
  if (!keep_common(flood.lattice, reached(flood, k), layer)) {
    flood.layer = flood.arrival + 1;
    flood.phase = FloodPhase::kForward;
  } else if (k == 0) {
    flood.way[0] = flood.start;
    flood.layer = 1;
    flood.phase = FloodPhase::kTrace;
  }
}

/// What a step to a cell costs the trace.
double step_cost(const TimedFlood& flood, const Voxel& cell, const Vec3& step) {
  const double left = larger(1.0, flood.arrival - flood.layer);
  const Vec3 to{static_cast<double>(flood.goal.x - cell.x), static_cast<double>(flood.goal.y - cell.y),
                static_cast<double>(flood.goal.z - cell.z)};
  const Vec3 turn = step - flood.pace;
  const Vec3 off = step - (1.0 / left) * to;
  return kLikeLast * dot(turn, turn) + dot(off, off) + kOffHeight * absolute(to.z);
}

/// One step of the way. False if there is none, which cannot be.
bool trace(TimedFlood& flood) {
  const Voxel& from = flood.way[flood.layer - 1];
  const std::uint64_t* const layer = leading(flood, flood.layer);
  double least = 1e300;
  Vec3 best = kZero;
  for (int n = 0; n < 27; ++n) {
    const Voxel move{n % 3 - 1, n / 3 % 3 - 1, n / 9 - 1};
    const Voxel cell{from.x + move.x, from.y + move.y, from.z + move.z};
    if (!is_cell(flood.lattice, cell) || !has_cell(flood.lattice, layer, cell)) continue;
    const Vec3 step{static_cast<double>(move.x), static_cast<double>(move.y), static_cast<double>(move.z)};
    const double cost = step_cost(flood, cell, step);
    if (!(cost < least)) continue;
    least = cost;
    best = step;
    flood.way[flood.layer] = cell;
  }
  if (!(least < 1e300)) return false;
  flood.pace = kOldPace * flood.pace + (1.0 - kOldPace) * best;
  ++flood.layer;
  return true;
}

/// Begins the forward pass.
void begin_forward(TimedFlood& flood) {
  set_cell(flood.lattice, flood.start, free_cells(flood));
  set_cell(flood.lattice, flood.goal, free_cells(flood));
  std::uint64_t* const first = reached(flood, 0);
  for (std::int32_t r = 0; r < flood.lattice.words; ++r) first[r] = 0;
  set_cell(flood.lattice, flood.start, first);
  flood.layer = 1;
  flood.phase = FloodPhase::kForward;
}

void fill_next_row(TimedFlood& flood, const Grid& grid, Operations& spent) {
  const Voxel& cells = flood.lattice.cells;
  spent += fill_free_row(flood.lattice, grid, flood.row % cells.y, flood.row / cells.y, free_cells(flood));
  ++flood.row;
  if (flood.row == cells.y * cells.z) begin_forward(flood);
}

/// A piece of work. False if there is no way.
bool run_piece(TimedFlood& flood, const Grid& grid, Operations& spent) {
  switch (flood.phase) {
    case FloodPhase::kFree:
      fill_next_row(flood, grid, spent);
      return true;
    case FloodPhase::kForward:
      spent += kLayerWordOperations * flood.lattice.words;
      if (flood.layer > flood.layers) return false;
      step_forward(flood, grid);
      return true;
    case FloodPhase::kMark:
      if (flood.track == flood.query.things.count) return end_layer(flood);
      mark(flood, grid, spent);
      return true;
    case FloodPhase::kArrive:
      return look_at_goal(flood, spent);
    case FloodPhase::kBackward:
      spent += kLayerWordOperations * flood.lattice.words;
      flood_backward(flood, grid);
      return true;
    case FloodPhase::kTrace:
      spent += 27 * ops::kNode;
      if (!trace(flood)) return false;
      if (flood.layer > flood.arrival) flood.phase = FloodPhase::kEnd;
      return true;
    case FloodPhase::kEnd:
      break;
  }
  return true;
}

}  // namespace

Status timed_flood_begin(TimedFlood& flood, const Grid& grid, const FloodQuery& query) noexcept {
  flood.query = query;
  const Vec3& fastest = query.fastest;
  const double speed = larger(larger(fastest.x, fastest.y), fastest.z);
  for (int a = 0; a < 3; ++a) axis(flood.ratio, a) = axis(fastest, a) / speed;
  bool fits = false;
  for (std::int32_t edge = query.edge; edge <= kLargest * query.edge && !fits; ++edge) {
    flood.lattice = lay_out(grid, query.from, edge);
    flood.step = flood.lattice.size / (query.share * speed);
    flood.layers = floor_index(query.longest / flood.step, 0, kMaxFloodLayers) + 1;
    if (flood.layers > kMaxFloodLayers) flood.layers = kMaxFloodLayers;
    // No way of so many layers leads further.
    const std::int32_t last = flood.layers;
    const Voxel steps{steps_until(flood, last, 0), steps_until(flood, last, 1), steps_until(flood, last, 2)};
    keep_cells_between(grid, query.from, query.to, steps, flood.lattice);
    fits = words_of(flood) <= kMaxFloodWords;
  }
  if (is_full(!fits)) return Status::kFloodFull;
  flood.start = cell_at(flood.lattice, grid, query.from);
  flood.goal = cell_at(flood.lattice, grid, query.to);
  flood.phase = FloodPhase::kFree;
  flood.row = flood.first = 0;
  flood.arrivals = 0;
  flood.covered = -1e300;
  flood.pace = (flood.step / flood.lattice.size) * query.velocity;
  return Status::kRunning;
}

std::int64_t words_of(const TimedFlood& flood) noexcept {
  return std::int64_t{flood.lattice.words} * (kOtherLayers + 2 * (flood.layers + 1));
}

Progress timed_flood_advance(TimedFlood& flood, const Grid& grid, Work& work) noexcept {
  for (std::uint64_t piece = 0; piece < kFloodPieces; ++piece) {
    if (flood.phase == FloodPhase::kEnd) return Progress::kDone;
    if (!work.left()) return Progress::kMore;
    Operations spent = ops::kPiece;
    const bool leads_on = run_piece(flood, grid, spent);
    work.spend(spent);
    if (!leads_on) return Progress::kFailed;
  }
  return Progress::kFailed;
}

}  // namespace tern
