// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// One case: a world, requests on it, and every promise held against the answers. A seed and a number determine it.
#ifndef TERN_TESTS_ATTACK_ATTACK_CASE_HPP
#define TERN_TESTS_ATTACK_ATTACK_CASE_HPP

#include "attack/asking.hpp"

namespace tern_attack {

/// What plans came to, by family. Plain data: it lies in memory that processes share.
struct Tally {
  std::uint64_t cases;
  std::uint64_t plans;     ///< calls that are judged: first plans and replans
  std::uint64_t replans;   ///< of these, from a state along an ok plan
  std::uint64_t needed;    ///< of these, refused until the plan that was flown was given, too
  std::uint64_t followed;  ///< plans that are the rest of that one
  std::uint64_t compared;  ///< sliced or kept against whole or fresh
  std::uint64_t status[256];
  std::uint64_t hover;
  std::uint64_t stop_and_go;
  std::uint64_t optimised;
  std::uint64_t work;  ///< units of all stages of all plans
};

/// Planners and outputs, made once for many cases.
struct Bench {
  tern::Workspace kept_memory;
  tern::Workspace fresh_memory;
  tern::Trajectory trajectory;
  double entered = 0.0;  ///< when the plan enters it, seconds since its beginning
  tern::Trajectory second;
  tern::Trajectory untouched;
  /// Where not null: obstacles that are not among these runs are left out of a case's first world.
  const std::vector<SolidRun>* only = nullptr;
  std::vector<SolidRun>* write = nullptr;  ///< where not null: gets that world's obstacles
  bool things = false;                     ///< every request is asked among things that move, four times, and no more
};

struct Context {
  Bench& bench;
  Rng& rng;
  Family family;
  Tally& tally;
  Findings& findings;
  bool verbose;
};

/// Every tenth case is of the same family.
inline Family family_of(std::uint64_t number) {
  return static_cast<Family>(number % kFamilies);
}

/// Runs case `number` of `seed`; tallies has one entry a family.
void run_case(Bench& bench, std::uint64_t seed, std::uint64_t number, bool verbose, Tally* tallies, Findings& findings);

/// Leaves obstacles out of a world and writes down the others, as the bench says.
void thin_out(const Bench& bench, World& world);
/// The grid's two layers against the record and the reference (contract C5).
void check_layers(const World& world, const Map& map, Findings& findings);
/// Asks in one call and judges the answer; the plan, where there is one, is in bench.trajectory from bench.entered on.
tern::Status ask_once(Context& context, tern::Planner& planner, const World& world, const Map& map, const Ask& ask,
                      const char* what);
/// Judges a status and its report by what the request and the map promise.
void judge(Context& context, const World& world, const Map& map, const Ask& ask, const tern::Report& report,
           tern::Status status, const char* what);
/// The same request in slices, on a planner that finds the map new, or on one that planned something else in between
/// has to give the same status and, as bench.trajectory has them, the same bits.
void compare_slices(Context& context, const World& world, const Ask& ask, tern::Status status);
void compare_fresh(Context& context, const World& world, const Ask& ask, tern::Status status);
void compare_kept(Context& context, tern::Planner& planner, const World& world, const Map& map, const Ask& ask,
                  tern::Status status);
/// Plans from states along the plan in bench.trajectory.
void replan(Context& context, tern::Planner& planner, const World& world, const Map& map, const Ask& ask);
/// A goal that cannot be planned to, as near as possible: there is a plan to the nearest point, if the start rests.
void go_near(Context& context, tern::Planner& planner, const World& world, const Map& map, Ask& ask);
/// A world of its own whose boundary holds no whole voxel on an axis, and the same with a keep-in in its place. `own`:
/// what is left of the case draws nothing from it.
void attack_flat(Context& context, Rng& own);
/// The same request among things that move. `without`: the answer to it alone, whose plan is in bench.trajectory where
/// there is one.
void attack_tracks(Context& context, Rng& own, tern::Planner& planner, const World& world, const Ask& ask,
                   tern::Status without);
/// Grids copied, rebound and changed between calls and between slices.
void run_changes(Context& context);

/// Fills an output with a pattern, and tells whether it still holds it.
void spoil(tern::Trajectory& trajectory);
bool spoiled(const tern::Trajectory& trajectory);
bool same_bits(const tern::Trajectory& a, const tern::Trajectory& b);
bool is_capacity(tern::Status status);
void print_ask(const World& world, const Ask& ask);

}  // namespace tern_attack

#endif
