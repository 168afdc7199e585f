// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TERN_HOST_PAGE_FLIGHT_FILM_HPP
#define TERN_HOST_PAGE_FLIGHT_FILM_HPP

#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "host/flight/simulated_flight.hpp"
#include "host/page/known_growth.hpp"
#include "host/page/run_json.hpp"
#include "tern/track.hpp"

namespace tern_host {

/// Films a flight, tick by tick, for the page.
class FlightFilm {
 public:
  /// `world` must outlive it.
  explicit FlightFilm(const FlightWorld& world);

  void note(const FlightMoment& moment);
  /// The flight as a run (page.hpp), once it is over.
  std::string run(const FlightResult& result) const;

 private:
  void note_motion(const FlightMoment& moment);
  void note_commit(const FlightMoment& moment);
  void note_lost(const FlightMoment& moment);
  void note_tubes(const FlightMoment& moment);
  RunJson tubes_json() const;
  RunJson facts(const FlightResult& result) const;

  /// A tube that committed plans were proven with: its last track, and a row for each instant.
  struct ShownTube {
    tern::Track of;
    std::vector<RunJson> rows;
  };

  const FlightWorld& world_;
  KnownGrowth growth_;
  double tube_step_;
  std::size_t tube_rows_ = 0;
  std::map<std::uint32_t, ShownTube> tubes_;  ///< by the tracks' numbers
  MotionColumns motion_;
  RunJson commits_ = RunJson::array();
  RunJson dropped_ = RunJson::array();
  std::int64_t ticks_ = 0;
  std::int64_t stride_;          ///< ticks from one row of the motion to the next
  tern::FlightReport before_{};  ///< of the tick before
  std::int64_t shown_ = -1;      ///< beginning of the draft that was noted last
};

}  // namespace tern_host

#endif
