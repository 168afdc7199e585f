// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// What is flown is proven anew whenever the map changed.
#include "base/math.hpp"
#include "flight/flight_state.hpp"

namespace tern {

/// The course that will be flown to its end. What comes before a takeover lasts a few ticks.
void FlightState::begin_watch() noexcept {
  const Course& course = has_next ? next : now;
  const double from = larger(0.0, seconds_between(course.begin, time));
  watching = watch.begin(map.safe(), course.flown, from, nullptr, Beyond::kSolid) == Status::kRunning;
  watched = map.revision();
}

void FlightState::run_watch(Work& work) noexcept {
  if (!watching && !map.busy() && watched != map.revision()) begin_watch();
  if (!watching) return;
  const std::uint32_t before = watch.report().work;
  const Status status = watch.step(work.left);
  work.left -= watch.report().work - before;
  if (status == Status::kRunning) return;
  watching = false;
  threat = watch.report().end != ProofEnd::kProven;
  evaded = false;
  if (!threat) return;
  alarmed = true;
  const Course& course = has_next ? next : now;
  contact = course.begin + nanoseconds(watch.report().until);
  contact_speed = length(evaluate(course.flown, watch.report().until).velocity);
  if (!has_next) return;
  has_next = false;  // what is flown until then may still be proven
  watched = 0;
}

}  // namespace tern
