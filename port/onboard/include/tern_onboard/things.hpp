// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The things that move around the vehicle: the last sighting of each, until a flight has it, and until it counts as
// gone.
#ifndef TERN_ONBOARD_THINGS_HPP
#define TERN_ONBOARD_THINGS_HPP

#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "tern/flight.hpp"
#include "tern/flight_record.hpp"
#include "tern_onboard/notices.hpp"
#include "tern_onboard/settings.hpp"
#include "tern_onboard/sighting.hpp"

namespace tern_onboard {

/// Not thread-safe. At most kMaxFlightTracks things; of more, the nearest.
class Things {
 public:
  explicit Things(const ThingSettings& settings) : settings_(settings) {}

  /// Takes a sighting at time `now`. `here`: where the vehicle is, in the frame of the sighting; null if that is not
  /// known, and then all things are near. What is refused, `notices` says.
  void add(const Sighting& sighting, const tern::Vec3* here, std::int64_t now, Notices& notices);
  /// Tells the flight, before its tick at `time`, what is new and what is gone. `offset`: Poses::offset().
  void tell(tern::Flight& flight, tern::FlightRecorder& record, const tern::Vec3& offset, std::int64_t time,
            Notices& notices);
  /// A flight begins, and knows nothing.
  void begin_flight();
  /// The clock was set to `now`: what is known was heard of now, and any later sighting is new.
  void set_clock(std::int64_t now);
  std::size_t count() const { return known_.size(); }

 private:
  struct Thing {
    tern::Track track;
    std::int64_t heard;  // the time of its last sighting
    double away;         // m, from the vehicle, when it was sighted
    bool is_new, is_told;
  };

  bool is_good(const Sighting& sighting, std::int64_t now, Notices& notices) const;
  bool make_room(double away);
  void drop(std::map<std::string, Thing>::iterator thing);
  void forget_old(std::int64_t now);

  ThingSettings settings_;
  std::map<std::string, Thing> known_;
  std::vector<std::uint32_t> gone_;  // of which the flight still knows
  std::uint32_t next_id_ = 1;
};

}  // namespace tern_onboard

#endif
