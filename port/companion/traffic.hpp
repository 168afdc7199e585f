// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Other aircraft that a MAVLink link tells of: ADSB_VEHICLE of transponders, UTM_GLOBAL_POSITION and Remote ID of
// drones.
#ifndef TERN_COMPANION_TRAFFIC_HPP
#define TERN_COMPANION_TRAFFIC_HPP

#include <array>
#include <cstdint>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "companion/frame.hpp"
#include "companion/globe.hpp"
#include "tern_onboard/sighting.hpp"

namespace tern_companion {

struct TrafficSettings {
  /// Reports that are the vehicle's own: an ICAO address ("4ca123"), a serial number or registration of Remote ID, a
  /// UTM id (36 hexadecimal digits).
  std::vector<std::string> own_ids;
  /// m: the sea's surface above the ellipsoid at this place; nothing if nobody said. Local heights are above the sea.
  std::optional<double> geoid;
  /// m: bound of the vehicle's own position on the globe.
  double own_error = 5.0;
};

/// What the vehicle knows at a report.
struct TrafficView {
  std::int64_t now = 0;                   ///< ns, of the companion's clock
  std::optional<std::int64_t> unix_time;  ///< ns, now, by the autopilot's satellite receiver
  const LocalFrame* local = nullptr;      ///< null if its origin is not known
  const tern::Vec3* here = nullptr;       ///< of the vehicle in it, m; null if that is not known
  std::uint8_t system = 0;                ///< of the autopilot
};

class Traffic {
 public:
  explicit Traffic(TrafficSettings settings) : settings_(std::move(settings)) {}

  /// What the frame says of an aircraft. Nothing if it is no such report, or one of the vehicle itself; also if it
  /// cannot be used: then `why` has the reason.
  std::optional<tern_onboard::Sighting> read(const Frame& frame, const TrafficView& view, std::string& why);

 private:
  using Address = std::array<std::uint8_t, 20>;
  using Found = std::optional<tern_onboard::Sighting>;

  Found read(const AdsbVehicle& report, const TrafficView& view, std::string& why) const;
  Found read(const UtmGlobalPosition& report, std::uint8_t system, const TrafficView& view, std::string& why) const;
  Found read(const OpenDroneIdLocation& report, const TrafficView& view, std::string& why) const;
  void note(const OpenDroneIdBasicId& report);
  bool is_own(const std::string& id) const;
  bool place(std::int32_t latitude, std::int32_t longitude, const TrafficView& view, tern_onboard::Sighting& sighting,
             std::string& why) const;
  void place_by_gps(double altitude, const TrafficView& view, tern_onboard::Sighting& sighting) const;

  TrafficSettings settings_;
  std::set<Address> own_addresses_;
};

}  // namespace tern_companion

#endif
