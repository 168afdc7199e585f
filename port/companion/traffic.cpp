// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "companion/traffic.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <iterator>
#include <utility>

#include "companion/clock_sync.hpp"
#include "tern_onboard/pose.hpp"

namespace tern_companion {
namespace {

using tern_onboard::Sighting;

// Of 95 % bounds: of the length of two numbers, as of horizontal errors, and of one number.
constexpr double kOfTwo = 1.0 / 2.448, kOfOne = 1.0 / 1.960;
// Errors of the height count as bounds, at so many deviations.
constexpr double kHeightSigmas = 4.0;
// m. A pressure altitude, with weather of 980 to 1040 hPa and 15 % of cold at 500 m; the sea's surface off the
// ellipsoid; of an unknown height: it is anywhere.
constexpr double kPressureError = 300.0, kGeoidError = 110.0, kAnyHeight = 20000.0;
// m and m/s, for 95 %: what airspace asks of transponders (14 CFR 91.227).
constexpr double kAdsbPlaceError = 92.6, kAdsbSpeedError = 10.0;
// s: of an age in whole seconds, half of one, and what a transponder may be late by.
constexpr double kAdsbTimeError = 0.5 + 0.6;
// s: of a report whose time is not known. Drones report once a second at least.
constexpr double kUnknownAge = 2.0;
// s: the clocks of two satellite receivers, and of what passes their time on.
constexpr double kUtmTimeError = 0.1;
// Of MAV_ODID_TIME_ACC, tenths of a second.
constexpr std::uint8_t kWorstTime = 15;
// m/s: a climb that is not known.
constexpr double kAnyClimb = 15.0;
constexpr std::int64_t kHour = 3600 * kSecond;
constexpr double kRadian = 3.14159265358979323846 / 180.0;

template <class Bytes>
std::string hex_of(const Bytes& bytes) {
  static const char kDigits[] = "0123456789abcdef";
  std::string text;
  for (const std::uint8_t byte : bytes) {
    text += kDigits[byte >> 4];
    text += kDigits[byte & 15];
  }
  return text;
}

std::string hex_of(std::uint32_t icao) {
  return hex_of(std::array<std::uint8_t, 3>{static_cast<std::uint8_t>(icao >> 16), static_cast<std::uint8_t>(icao >> 8),
                                            static_cast<std::uint8_t>(icao)});
}

std::string small(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(), [](unsigned char c) { return std::tolower(c); });
  return text;
}

bool is_zero(const std::array<std::uint8_t, 20>& address) {
  return std::all_of(address.begin(), address.end(), [](std::uint8_t byte) { return byte == 0; });
}

/// Towards a course in hundredths of a degree, clockwise from north; speeds in cm/s.
tern::Vec3 velocity_of(std::uint16_t course, std::uint16_t speed, std::int16_t climb) {
  const double angle = 0.01 * kRadian * course;
  return {0.01 * speed * std::sin(angle), 0.01 * speed * std::cos(angle), 0.01 * climb};
}

/// A velocity whose climb may be unknown.
void move(const tern::Vec3& velocity, bool climb_is_known, Sighting& sighting) {
  sighting.has_velocity = true;
  sighting.velocity = velocity;
  if (climb_is_known) return;
  sighting.velocity.z = 0.0;
  sighting.speed_error += kAnyClimb;
}

void place_by_pressure(double altitude, const TrafficView& view, Sighting& sighting) {
  sighting.position.z = altitude - 1e-3 * view.local->origin.altitude;
  sighting.height_error += kPressureError;
}

/// A stamp that is `ahead` ns of the clock. What its error explains is not from the future.
void stamp(const TrafficView& view, std::int64_t ahead, double error, Sighting& sighting) {
  const bool is_now = ahead > 0 && 1e-9 * static_cast<double>(ahead) <= error;
  sighting.stamp = view.now + (is_now ? 0 : ahead);
  sighting.time_error = error;
}

tern::TrackClass class_of(std::uint8_t emitter) {
  if (emitter == kAdsbUav) return tern::TrackClass::kDrone;
  const bool drives = emitter == kAdsbEmergencyVehicle || emitter == kAdsbServiceVehicle;
  return drives ? tern::TrackClass::kTruck : tern::TrackClass::kAircraft;
}

/// m and m/s, for 95 %, by the numbers of MAV_ODID_HOR_ACC, MAV_ODID_VER_ACC and MAV_ODID_SPEED_ACC. 0 is unknown: as
/// bad as anything that may fly.
constexpr double kMile = 1852.0;
constexpr double kAcross[] = {0.1 * kMile, 10 * kMile,   4 * kMile, 2 * kMile, kMile, 0.5 * kMile, 0.3 * kMile,
                              0.1 * kMile, 0.05 * kMile, 30.0,      10.0,      3.0,   1.0};
constexpr double kUp[] = {150.0, 150.0, 45.0, 25.0, 10.0, 3.0, 1.0};
constexpr double kSpeeds[] = {10.0, 10.0, 3.0, 1.0, 0.3};

template <std::size_t N>
double accuracy(const double (&table)[N], std::uint8_t number) {
  return table[number < N ? number : 0];
}

}  // namespace

bool Traffic::is_own(const std::string& id) const {
  return std::any_of(settings_.own_ids.begin(), settings_.own_ids.end(),
                     [&id](const std::string& own) { return small(own) == small(id); });
}

/// East and north, with the errors of the frame.
bool Traffic::place(std::int32_t latitude, std::int32_t longitude, const TrafficView& view, Sighting& sighting,
                    std::string& why) const {
  if (view.local == nullptr) {
    why = "other aircraft are left out: the autopilot has not sent GPS_GLOBAL_ORIGIN";
    return false;
  }
  const std::optional<tern::Vec3> place = place_in(*view.local, 1e-7 * latitude, 1e-7 * longitude);
  if (!place) {
    why = "other aircraft are left out that are more than 10 km from the local origin, or while that is near a pole";
    return false;
  }
  sighting.position = *place;
  const tern::Vec3 from = view.here == nullptr ? *place : tern_onboard::minus(*place, *view.here);
  sighting.error = settings_.own_error + kScaleError * std::hypot(from.x, from.y);
  return true;
}

/// A height above the ellipsoid. Local heights are above the sea, as the autopilot's satellite receiver has it.
void Traffic::place_by_gps(double altitude, const TrafficView& view, Sighting& sighting) const {
  sighting.position.z = altitude - settings_.geoid.value_or(0.0) - 1e-3 * view.local->origin.altitude;
  if (!settings_.geoid) sighting.height_error += kGeoidError;
}

std::optional<Sighting> Traffic::read(const Frame& frame, const TrafficView& view, std::string& why) {
  why.clear();
  switch (frame.id) {
    case AdsbVehicle::kId:
      return read(parse<AdsbVehicle>(frame), view, why);
    case UtmGlobalPosition::kId:
      return read(parse<UtmGlobalPosition>(frame), frame.system, view, why);
    case OpenDroneIdLocation::kId:
      return read(parse<OpenDroneIdLocation>(frame), view, why);
    case OpenDroneIdBasicId::kId:
      note(parse<OpenDroneIdBasicId>(frame));
      return {};
    default:
      return {};
  }
}

Traffic::Found Traffic::read(const AdsbVehicle& report, const TrafficView& view, std::string& why) const {
  Sighting sighting;
  const std::string icao = hex_of(report.icao);
  if (is_own(icao)) return {};
  if ((report.flags & kAdsbPlace) == 0) {
    why = "ADSB_VEHICLE is left out where its flags say that its coordinates are not valid";
    return {};
  }
  if (!place(report.latitude, report.longitude, view, sighting, why)) return {};
  sighting.name = "adsb " + icao;
  sighting.kind = class_of(report.emitter_type);
  sighting.deviation = kOfTwo * kAdsbPlaceError;
  if ((report.flags & kAdsbAltitude) == 0) {
    sighting.height_error = kAnyHeight;
  } else if (report.altitude_type == kAdsbGeometric) {
    place_by_gps(1e-3 * report.altitude, view, sighting);
    // Transponders give it above the ellipsoid, and the message calls it above the sea: it may be either.
    const double between = settings_.geoid.value_or(0.0);
    sighting.position.z += 0.5 * between;
    sighting.height_error += 0.5 * std::abs(between) + kHeightSigmas * kOfOne * kAdsbPlaceError;
  } else {
    place_by_pressure(1e-3 * report.altitude, view, sighting);
  }
  sighting.speed_deviation = kOfTwo * kAdsbSpeedError;
  constexpr std::uint16_t kMoves = kAdsbHeading | kAdsbSpeed;
  if ((report.flags & kMoves) == kMoves) {
    move(velocity_of(report.heading, report.speed, report.climb), (report.flags & kAdsbClimb) != 0, sighting);
  }
  stamp(view, -kSecond * report.age - kSecond / 2, kAdsbTimeError, sighting);
  return sighting;
}

Traffic::Found Traffic::read(const UtmGlobalPosition& report, std::uint8_t system, const TrafficView& view,
                             std::string& why) const {
  Sighting sighting;
  const bool has_id = (report.flags & kUtmId) != 0;
  if (system == view.system || (has_id && is_own(hex_of(report.uas_id)))) return {};
  if ((report.flags & kUtmPlace) == 0) {
    why = "UTM_GLOBAL_POSITION is left out where its flags say that it has no position";
    return {};
  }
  if (!place(report.latitude, report.longitude, view, sighting, why)) return {};
  sighting.name = "utm " + (has_id ? hex_of(report.uas_id) : "system " + std::to_string(system));
  sighting.kind = tern::TrackClass::kDrone;
  // Of a deviation that is not given, what receivers seldom exceed.
  const auto given = [](std::uint16_t deviation, double otherwise, double unit) {
    return deviation == 0 || deviation == UINT16_MAX ? otherwise : unit * deviation;
  };
  sighting.deviation = given(report.horizontal_deviation, 10.0, 1e-3);
  if ((report.flags & kUtmAltitude) != 0) {
    place_by_gps(1e-3 * report.altitude, view, sighting);
    sighting.height_error += kHeightSigmas * given(report.vertical_deviation, 20.0, 1e-3);
  } else {
    sighting.height_error = kAnyHeight;
  }
  sighting.speed_deviation = given(report.speed_deviation, 1.0, 1e-2);
  if ((report.flags & kUtmSpeed) != 0) {
    const auto& v = report.velocity;
    move({0.01 * v[1], 0.01 * v[0], -0.01 * v[2]}, (report.flags & kUtmClimb) != 0, sighting);
  }
  if ((report.flags & kUtmTime) != 0 && view.unix_time) {
    stamp(view, 1000 * static_cast<std::int64_t>(report.time) - *view.unix_time, kUtmTimeError, sighting);
  } else {
    stamp(view, 0, kUnknownAge, sighting);
  }
  return sighting;
}

void Traffic::note(const OpenDroneIdBasicId& report) {
  const std::string id(report.uas_id.begin(), std::find(report.uas_id.begin(), report.uas_id.end(), '\0'));
  if (is_own(id)) own_addresses_.insert(report.address);
}

Traffic::Found Traffic::read(const OpenDroneIdLocation& report, const TrafficView& view, std::string& why) const {
  Sighting sighting;
  // Without an address, it is what this vehicle's own transmitter is told.
  if (is_zero(report.address) || own_addresses_.count(report.address) > 0) return {};
  if (report.latitude == 0 && report.longitude == 0) {
    why = "OPEN_DRONE_ID_LOCATION is left out where it has no position";
    return {};
  }
  if (!place(report.latitude, report.longitude, view, sighting, why)) return {};
  sighting.name = "remote id " + hex_of(report.address);
  sighting.kind = tern::TrackClass::kDrone;
  sighting.deviation = kOfTwo * accuracy(kAcross, report.horizontal_accuracy);
  constexpr float kNoHeight = -1000.0f;
  if (report.geodetic > kNoHeight) {
    place_by_gps(static_cast<double>(report.geodetic), view, sighting);
    sighting.height_error += kHeightSigmas * kOfOne * accuracy(kUp, report.vertical_accuracy);
  } else if (report.barometric > kNoHeight) {
    place_by_pressure(static_cast<double>(report.barometric), view, sighting);
  } else {
    sighting.height_error = kAnyHeight;
  }
  sighting.speed_deviation = kOfTwo * accuracy(kSpeeds, report.speed_accuracy);
  // From these numbers on they are unknown, or larger than can be said.
  if (report.direction < 36000 && report.speed < 25425) {
    move(velocity_of(report.direction, report.speed, report.climb), std::abs(report.climb) < 6200, sighting);
  }
  if (report.time >= 0.0f && report.time <= 3600.0f && view.unix_time) {
    const auto past_hour = static_cast<std::int64_t>(1e9 * static_cast<double>(report.time));
    const std::int64_t ahead = (past_hour - *view.unix_time % kHour + kHour + kHour / 2) % kHour - kHour / 2;
    const bool is_given = report.time_accuracy > 0 && report.time_accuracy <= kWorstTime;
    stamp(view, ahead, 0.1 * (is_given ? report.time_accuracy : kWorstTime), sighting);
  } else {
    stamp(view, 0, kUnknownAge, sighting);
  }
  return sighting;
}

}  // namespace tern_companion
