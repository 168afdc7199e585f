// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Things that move: a chain with as many planes as there may be, and a flood whose layers fill all words there are,
// among as many things as there may be, to a goal that is never clear.
#include <cstddef>

#include "base/math.hpp"
#include "caps/cap.hpp"
#include "flood/timed_flood.hpp"
#include "planner/timed_seed.hpp"
#include "trajectory/separations.hpp"

namespace tern_caps {
namespace {

using tern::Vec3;

struct Setting {
  tern::Track things[tern::kMaxTracks];
  tern::Chain chain;
  tern::Trajectory reference;
  tern::Scene scene;
  tern::Separations separations;
  tern::ProgrammeScale scale;
  Vec3 points[tern::kMaxSegments][tern::kControlPoints];
};
constexpr std::size_t kProblemOffset = std::size_t{8} << 20;

/// Balls in two rows beside the way along x, so far away, which come slowly towards it.
void place_things(double length, double aside, tern::Track* things) {
  for (int j = 0; j < tern::kMaxTracks; ++j) {
    const double side = j % 2 == 0 ? 1.0 : -1.0;
    tern::Track& thing = things[j] = tern::Track{};
    thing.position = {length * (j + 0.5) / tern::kMaxTracks, 3.2 + aside * side, 3.2};
    thing.velocity = {0.0, -0.01 * side, 0.0};
    thing.radius = 0.2;
    thing.error_speed = 1e-3;
  }
}

/// A metre a segment, a second each.
void lay_chain(Setting& s) {
  s.chain.count = s.reference.count = tern::kMaxSegments;
  for (int i = 0; i < tern::kMaxSegments; ++i) {
    s.chain.duration[i] = s.chain.length[i] = 1.0;
    for (int k = 0; k < tern::kControlPoints; ++k) s.points[i][k] = {i + k / 7.0, 3.2, 3.2};
    for (int k = 0; k < tern::kControlPoints; ++k) s.reference.segments[i].points[k] = s.points[i][k];
    s.reference.segments[i].duration = 1.0;
  }
  s.chain.start = s.chain.goal = {};
  s.chain.via_joint_count = 0;
  s.chain.center = {0.0, 0.0, 0.0};
  s.scene.reference = &s.reference;
  s.scene.rest = 0.0;
  for (double& pause : s.scene.pause) pause = 0.0;
}

void separation_caps() {
  auto& s = state_at<Setting>(0);
  auto& problem = state_at<tern::QpProblem>(kProblemOffset);
  place_things(tern::kMaxSegments, 0.3, s.things);
  lay_chain(s);
  s.scene.things = {s.things, tern::kMaxTracks, 0.3, {}, 0};
  problem.point_count = problem.plane_count = problem.group_count = 0;
  s.scale.tau = 1.0;
  for (auto& joint : s.scale.joint) {
    for (double& factor : joint) factor = 1.0;
  }
  for (double& unit : s.scale.unit) unit = 1.0;
  tern::Work work{kUnlimited};
  const std::uint64_t instructions = count([&] {
    tern::separations_begin(s.scene, s.points[0][0], s.separations);
    tern::meet_begin(true, s.separations);
    tern::meet_advance(s.chain, s.scene, s.points, s.separations, work);
    tern::add_separations(s.chain, s.scene, s.separations, s.scale, problem, work);
  });
  const auto reached = static_cast<std::uint64_t>(s.separations.rows_count);
  report({"separations", "trajectory", instructions, s.separations.is_full ? reached : 0, tern::kMaxSeparations,
          units_of(work), tern::kMaxQpSolves});
}

void flood_caps() {
  auto& things = state_at<Setting>(0).things;
  auto& flood = state_at<tern::TimedFlood>(kProblemOffset);
  constexpr double kCell = 0.1;
  tern::Grid grid = make_grid({64, 64, 64}, kCell, 0.0);
  grid.inflate();
  place_things(6.4, 1.0, things);
  tern::FloodQuery query{};
  query.from = {0.05, 3.25, 3.25};
  query.to = {6.35, 3.25, 3.25};
  query.fastest = query.strongest = query.sharpest = {1.0, 1.0, 1.0};
  query.share = 1.0;
  query.edge = 1;
  // A layer is 4096 words, and there are 4 more than two for each layer and the start.
  constexpr int kLayers = tern::kMaxFloodWords / 4096 / 2 - 3;
  query.longest = (kLayers - 0.5) * kCell;
  things[0] = tern::Track{};
  things[0].position = query.to;
  things[0].radius = 0.2;
  query.things = {things, tern::kMaxTracks, 0.1, {}, 0};
  tern::Work work{kUnlimited};
  tern::Progress progress = tern::Progress::kMore;
  tern::timed_flood_begin(flood, grid, query);
  const std::uint64_t instructions = count([&] { progress = tern::timed_flood_advance(flood, grid, work); });
  const auto words = static_cast<std::uint64_t>(tern::words_of(flood));
  const bool is_whole = progress == tern::Progress::kFailed && flood.layer > flood.layers;
  report({"flood_words", "tracks", instructions, is_whole ? words : 0, tern::kMaxFloodWords, units_of(work),
          tern::kTimedSeeds});
}

}  // namespace

void track_caps() {
  separation_caps();
  flood_caps();
}

}  // namespace tern_caps
