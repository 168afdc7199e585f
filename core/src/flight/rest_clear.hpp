// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Until when the place where the committed plan ends is clear of all that things that move may do, and of fences for a
// while. A measurement or a commit makes the answer old: the next tick begins to prove it anew, with a part of its
// work.
#ifndef TERN_FLIGHT_REST_CLEAR_HPP
#define TERN_FLIGHT_REST_CLEAR_HPP

#include <cstdint>

#include "base/work.hpp"
#include "flight/flight_facts.hpp"
#include "tern/track_proof.hpp"

namespace tern {

struct RestClear {
  TrackProof proof;
  bool is_running;
  bool has_news;         ///< a thing was measured or forgotten
  const Trajectory* of;  ///< the plan of the proof, when it begins, and how long it is
  std::int64_t begin;
  double length;
  std::int64_t until = INT64_MAX;  ///< while the proof is running, no later than that of what is proven

  void note_news() noexcept { has_news = true; }
  /// Proves what is left to prove, with a quarter of the work at most.
  void advance(const FlightFacts& flight, Work& work) noexcept;

 private:
  bool is_old(const Commitment& latest) const noexcept;
  void prove(const FlightFacts& flight, Work& work) noexcept;
};

}  // namespace tern

#endif
