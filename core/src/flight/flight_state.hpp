// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// A flight's state, in the first of the caller's words; the copy of the route grid follows it. Each part has fields of
// its own, which no other part writes: a part reads the others, and its functions say in their results what happened.
// The functions here join them.
#ifndef TERN_FLIGHT_FLIGHT_STATE_HPP
#define TERN_FLIGHT_FLIGHT_STATE_HPP

#include <cstdint>

#include "base/progress.hpp"
#include "base/work.hpp"
#include "flight/blocked.hpp"
#include "flight/cycle.hpp"
#include "flight/draft.hpp"
#include "flight/evasion.hpp"
#include "flight/flight_facts.hpp"
#include "flight/lookouts.hpp"
#include "flight/nose.hpp"
#include "flight/rest_clear.hpp"
#include "flight/rest_search.hpp"
#include "flight/track_pieces.hpp"
#include "flight/watch.hpp"
#include "tern/flight.hpp"

namespace tern {

class FlightState {
 public:
  FlightFacts facts;
  Work tick_work;  ///< what is left of the tick's units; a debt goes on to the next tick
  Cycle cycle;
  Evasion evasion;
  Draft draft;  ///< of the cycle or of the evasion: at most one of them is at work
  Watch watch;
  RestSearch search;
  Lookouts lookouts;
  RestClear rest;
  Blockage block;  ///< what ended the last proof or plan to the goal
  Nose nose;
  TrackPieces pieces;  ///< of the curves in all tables of things that move
  bool is_leaving;     ///< a fence is about to begin where the vehicle rests
  FlightReport report;

  // tick.cpp: one tick
  void tick(std::int64_t t) noexcept;
  void step_map() noexcept;
  void run_watch() noexcept;
  void end_watched_part() noexcept;
  Status update_track(const Track& measured) noexcept;
  bool keep_pieces(Track& track) noexcept;
  bool leaves_place() noexcept;
  bool may_shift_plan() const noexcept;
  bool waits_for_plan() noexcept;
  void advance() noexcept;
  void begin_evasion() noexcept;
  void prove_anew() noexcept;
  Progress run_evasion() noexcept;
  void go_on_evading(EvasionResult result) noexcept;
  void end_evasion() noexcept;
  bool is_busy() const noexcept { return cycle.job != Job::kIdle || evasion.is_running; }

  /// The place that the sensor should see at time `t`.
  Vec3 looking_at(std::int64_t t) const noexcept;

  // report.cpp: the vehicle's surroundings, and the report of a tick
  double note_block_near_vehicle() noexcept;
  void finish_report(std::uint32_t spent) noexcept;

  // lift.cpp: straight up from the ground, and down to it
  bool begin_lift() noexcept;
  void end_lift() noexcept;
  void end_lift_unproven() noexcept;

  // clearance.cpp: plans that wait until others agree to them
  Status answer(std::uint32_t number, bool may_fly) noexcept;
  Status take_back() noexcept;
  Status set_clearance(std::int64_t clearance) noexcept;
  void leave_question() noexcept;
  Progress run_renewal() noexcept;

  // results.cpp: what the results of a cycle mean to the other parts
  void begin_cycle() noexcept;
  bool look_out() noexcept;
  Progress run_job() noexcept;
  Progress choose_aim() noexcept;
  Progress ask_plan() noexcept;
  Progress end_planner() noexcept;
  void end_without_plan(const Report& found) noexcept;
  bool note_fault(const Report& found) noexcept;
  void choose_draft(bool planned) noexcept;
  Progress run_proof() noexcept;
  Progress run_confirm() noexcept;
  Progress run_sidestep() noexcept;
  Progress or_fail(Progress progress) noexcept;
  bool commit() noexcept;
  void enter_draft() noexcept;
  void fail() noexcept;
  void give_up() noexcept;
  void next_attempt() noexcept;
  FlightReason reason_of_landing(FlightReason why) const noexcept;
  void park(FlightReason why) noexcept;
  bool leave_out(std::int32_t point, FlightReason why) noexcept;
  void try_anew() noexcept;
};

}  // namespace tern

#endif
