// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The messages of MAVLink that the companion sends or reads, from the public specification (common.xml). Each has its
// number, the byte that its definition adds to the checksum, and one list of fields in the order of the wire, which
// both packs and parses it. Fields after the basic ones are extensions of MAVLink 2.
#ifndef TERN_COMPANION_MESSAGES_HPP
#define TERN_COMPANION_MESSAGES_HPP

#include <array>
#include <cstdint>
#include <tuple>

namespace tern_companion {

/// MAV_AUTOPILOT, MAV_TYPE, MAV_STATE, MAV_MODE_FLAG, MAV_LANDED_STATE, MAV_FRAME, MAV_CMD and MAV_RESULT, as far as
/// they are used.
constexpr std::uint8_t kArdupilot = 3, kPx4 = 12, kInvalidAutopilot = 8;
constexpr std::uint8_t kGroundStation = 6, kOnboardController = 18;
constexpr std::uint8_t kStateStandby = 3, kStateActive = 4;
constexpr std::uint8_t kArmedFlag = 128, kCustomModeFlag = 1;
constexpr std::uint8_t kLandedOnGround = 1, kLandedInAir = 2, kLandedTakingOff = 3, kLandedLanding = 4;
constexpr std::uint8_t kGlobal = 0, kLocalNed = 1, kGlobalRelative = 3, kGlobalInt = 5, kGlobalRelativeInt = 6;
constexpr std::uint8_t kBodyFrd = 12;
constexpr std::uint16_t kDoSetMode = 176, kDoReposition = 192, kSetMessageInterval = 511, kRequestMessage = 512;
constexpr std::uint8_t kAccepted = 0, kTemporarilyRejected = 1, kDenied = 2, kUnsupported = 3;

/// Components: the autopilot, and an onboard computer.
constexpr std::uint8_t kAutopilotComponent = 1, kCompanionComponent = 191;

struct Heartbeat {
  static constexpr std::uint32_t kId = 0;
  static constexpr std::uint8_t kCrcExtra = 50;
  std::uint32_t custom_mode = 0;
  std::uint8_t type = 0, autopilot = 0, base_mode = 0, system_status = 0, mavlink_version = 3;
  template <class M, class Visit>
  static void fields(M& m, Visit& visit) {
    visit(m.custom_mode, m.type, m.autopilot, m.base_mode, m.system_status, m.mavlink_version);
  }
};

struct SystemTime {
  static constexpr std::uint32_t kId = 2;
  static constexpr std::uint8_t kCrcExtra = 137;
  std::uint64_t time_unix_usec = 0;
  std::uint32_t time_boot_ms = 0;
  template <class M, class Visit>
  static void fields(M& m, Visit& visit) {
    visit(m.time_unix_usec, m.time_boot_ms);
  }
};

/// From forward-right-down to north-east-down, (w, x, y, z).
struct AttitudeQuaternion {
  static constexpr std::uint32_t kId = 31;
  static constexpr std::uint8_t kCrcExtra = 246;
  std::uint32_t time_boot_ms = 0;
  std::array<float, 4> q{};
  std::array<float, 3> rates{};
  std::array<float, 4> offset{};
  template <class M, class Visit>
  static void fields(M& m, Visit& visit) {
    visit(m.time_boot_ms, m.q, m.rates, m.offset);
  }
};

struct LocalPositionNed {
  static constexpr std::uint32_t kId = 32;
  static constexpr std::uint8_t kCrcExtra = 185;
  std::uint32_t time_boot_ms = 0;
  std::array<float, 3> position{}, velocity{};
  template <class M, class Visit>
  static void fields(M& m, Visit& visit) {
    visit(m.time_boot_ms, m.position, m.velocity);
  }
};

/// Where the local frame's origin is: degrees times 1e7, and millimetres above the sea.
struct GpsGlobalOrigin {
  static constexpr std::uint32_t kId = 49;
  static constexpr std::uint8_t kCrcExtra = 39;
  std::int32_t latitude = 0, longitude = 0, altitude = 0;
  std::uint64_t time_usec = 0;
  template <class M, class Visit>
  static void fields(M& m, Visit& visit) {
    visit(m.latitude, m.longitude, m.altitude, m.time_usec);
  }
};

/// In both directions: setpoints to the autopilot, goals from a ground station.
struct SetPositionTarget {
  static constexpr std::uint32_t kId = 84;
  static constexpr std::uint8_t kCrcExtra = 143;
  std::uint32_t time_boot_ms = 0;
  std::array<float, 3> position{}, velocity{}, acceleration{};
  float yaw = 0.0f, yaw_rate = 0.0f;
  std::uint16_t type_mask = 0;
  std::uint8_t target_system = 0, target_component = 0, coordinate_frame = kLocalNed;
  template <class M, class Visit>
  static void fields(M& m, Visit& visit) {
    visit(m.time_boot_ms, m.position, m.velocity, m.acceleration, m.yaw, m.yaw_rate, m.type_mask, m.target_system,
          m.target_component, m.coordinate_frame);
  }
};

struct CommandInt {
  static constexpr std::uint32_t kId = 75;
  static constexpr std::uint8_t kCrcExtra = 158;
  std::array<float, 4> params{};
  std::int32_t x = 0, y = 0;
  float z = 0.0f;
  std::uint16_t command = 0;
  std::uint8_t target_system = 0, target_component = 0, frame = 0, current = 0, autocontinue = 0;
  template <class M, class Visit>
  static void fields(M& m, Visit& visit) {
    visit(m.params, m.x, m.y, m.z, m.command, m.target_system, m.target_component, m.frame, m.current, m.autocontinue);
  }
};

struct CommandLong {
  static constexpr std::uint32_t kId = 76;
  static constexpr std::uint8_t kCrcExtra = 152;
  std::array<float, 7> params{};
  std::uint16_t command = 0;
  std::uint8_t target_system = 0, target_component = 0, confirmation = 0;
  template <class M, class Visit>
  static void fields(M& m, Visit& visit) {
    visit(m.params, m.command, m.target_system, m.target_component, m.confirmation);
  }
};

struct CommandAck {
  static constexpr std::uint32_t kId = 77;
  static constexpr std::uint8_t kCrcExtra = 143;
  std::uint16_t command = 0;
  std::uint8_t result = 0, progress = 0;
  std::int32_t result_param2 = 0;
  std::uint8_t target_system = 0, target_component = 0;
  template <class M, class Visit>
  static void fields(M& m, Visit& visit) {
    visit(m.command, m.result, m.progress, m.result_param2, m.target_system, m.target_component);
  }
};

/// Nanoseconds. A request has tc1 = 0; the answer repeats ts1, and tc1 is the answerer's time.
struct TimeSync {
  static constexpr std::uint32_t kId = 111;
  static constexpr std::uint8_t kCrcExtra = 34;
  std::int64_t tc1 = 0, ts1 = 0;
  std::uint8_t target_system = 0, target_component = 0;
  template <class M, class Visit>
  static void fields(M& m, Visit& visit) {
    visit(m.tc1, m.ts1, m.target_system, m.target_component);
  }
};

struct ExtendedSysState {
  static constexpr std::uint32_t kId = 245;
  static constexpr std::uint8_t kCrcExtra = 130;
  std::uint8_t vtol_state = 0, landed_state = 0;
  template <class M, class Visit>
  static void fields(M& m, Visit& visit) {
    visit(m.vtol_state, m.landed_state);
  }
};

struct StatusText {
  static constexpr std::uint32_t kId = 253;
  static constexpr std::uint8_t kCrcExtra = 83;
  std::uint8_t severity = 0;
  std::array<char, 50> text{};
  std::uint16_t id = 0;
  std::uint8_t chunk = 0;
  template <class M, class Visit>
  static void fields(M& m, Visit& visit) {
    visit(m.severity, m.text, m.id, m.chunk);
  }
};

/// The pose in `frame_id`, the velocity in `child_frame_id`.
struct Odometry {
  static constexpr std::uint32_t kId = 331;
  static constexpr std::uint8_t kCrcExtra = 91;
  std::uint64_t time_usec = 0;
  std::array<float, 3> position{};
  std::array<float, 4> q{};
  std::array<float, 3> velocity{}, rates{};
  std::array<float, 21> pose_covariance{}, velocity_covariance{};
  std::uint8_t frame_id = 0, child_frame_id = 0, reset_counter = 0, estimator_type = 0;
  std::int8_t quality = 0;
  template <class M, class Visit>
  static void fields(M& m, Visit& visit) {
    visit(m.time_usec, m.position, m.q, m.velocity, m.rates, m.pose_covariance, m.velocity_covariance, m.frame_id,
          m.child_frame_id, m.reset_counter, m.estimator_type, m.quality);
  }
};

/// ADSB_FLAGS, ADSB_ALTITUDE_TYPE and ADSB_EMITTER_TYPE, as far as they are used.
constexpr std::uint16_t kAdsbPlace = 1, kAdsbAltitude = 2, kAdsbHeading = 4, kAdsbSpeed = 8, kAdsbClimb = 128;
constexpr std::uint8_t kAdsbGeometric = 1;
constexpr std::uint8_t kAdsbUav = 14, kAdsbEmergencyVehicle = 17, kAdsbServiceVehicle = 18;

/// A transponder's report of itself, as a receiver had it. Degrees times 1e7, mm, hundredths of a degree, cm/s,
/// upwards.
struct AdsbVehicle {
  static constexpr std::uint32_t kId = 246;
  static constexpr std::uint8_t kCrcExtra = 184;
  std::uint32_t icao = 0;
  std::int32_t latitude = 0, longitude = 0, altitude = 0;
  std::uint16_t heading = 0, speed = 0;
  std::int16_t climb = 0;
  std::uint16_t flags = 0, squawk = 0;
  std::uint8_t altitude_type = 0;
  std::array<char, 9> callsign{};
  std::uint8_t emitter_type = 0, age = 0;
  template <class M, class Visit>
  static void fields(M& m, Visit& visit) {
    visit(m.icao, m.latitude, m.longitude, m.altitude, m.heading, m.speed, m.climb, m.flags, m.squawk, m.altitude_type,
          m.callsign, m.emitter_type, m.age);
  }
};

/// UTM_DATA_AVAIL_FLAGS.
constexpr std::uint8_t kUtmTime = 1, kUtmId = 2, kUtmPlace = 4, kUtmAltitude = 8, kUtmSpeed = 32, kUtmClimb = 64;

/// A drone's report of itself. Microseconds of the Unix epoch, degrees times 1e7, mm above the ellipsoid, cm/s
/// north-east-down, standard deviations in mm and cm/s.
struct UtmGlobalPosition {
  static constexpr std::uint32_t kId = 340;
  static constexpr std::uint8_t kCrcExtra = 99;
  std::uint64_t time = 0;
  std::int32_t latitude = 0, longitude = 0, altitude = 0, relative_altitude = 0;
  std::int32_t next_latitude = 0, next_longitude = 0, next_altitude = 0;
  std::array<std::int16_t, 3> velocity{};
  std::uint16_t horizontal_deviation = 0, vertical_deviation = 0, speed_deviation = 0, update_rate = 0;
  std::array<std::uint8_t, 18> uas_id{};
  std::uint8_t flight_state = 0, flags = 0;
  template <class M, class Visit>
  static void fields(M& m, Visit& visit) {
    visit(m.time, m.latitude, m.longitude, m.altitude, m.relative_altitude, m.next_latitude, m.next_longitude,
          m.next_altitude, m.velocity, m.horizontal_deviation, m.vertical_deviation, m.speed_deviation, m.update_rate,
          m.uas_id, m.flight_state, m.flags);
  }
};

/// Remote ID: who the sender with this address is.
struct OpenDroneIdBasicId {
  static constexpr std::uint32_t kId = 12900;
  static constexpr std::uint8_t kCrcExtra = 114;
  std::uint8_t target_system = 0, target_component = 0;
  std::array<std::uint8_t, 20> address{};
  std::uint8_t id_type = 0, ua_type = 0;
  std::array<char, 20> uas_id{};
  template <class M, class Visit>
  static void fields(M& m, Visit& visit) {
    visit(m.target_system, m.target_component, m.address, m.id_type, m.ua_type, m.uas_id);
  }
};

/// Remote ID: where it is. Degrees times 1e7, m, seconds after the full hour, hundredths of a degree, cm/s, and numbers
/// of accuracies, which hold for 95 %.
struct OpenDroneIdLocation {
  static constexpr std::uint32_t kId = 12901;
  static constexpr std::uint8_t kCrcExtra = 254;
  std::int32_t latitude = 0, longitude = 0;
  float barometric = 0.0f, geodetic = 0.0f, height = 0.0f, time = 0.0f;
  std::uint16_t direction = 0, speed = 0;
  std::int16_t climb = 0;
  std::uint8_t target_system = 0, target_component = 0;
  std::array<std::uint8_t, 20> address{};
  std::uint8_t status = 0, height_reference = 0, horizontal_accuracy = 0, vertical_accuracy = 0, barometer_accuracy = 0,
               speed_accuracy = 0, time_accuracy = 0;
  template <class M, class Visit>
  static void fields(M& m, Visit& visit) {
    visit(m.latitude, m.longitude, m.barometric, m.geodetic, m.height, m.time, m.direction, m.speed, m.climb,
          m.target_system, m.target_component, m.address, m.status, m.height_reference, m.horizontal_accuracy,
          m.vertical_accuracy, m.barometer_accuracy, m.speed_accuracy, m.time_accuracy);
  }
};

/// All of them; frames of others cannot be checked, and are passed over.
using Messages =
    std::tuple<Heartbeat, SystemTime, AttitudeQuaternion, LocalPositionNed, GpsGlobalOrigin, SetPositionTarget,
               CommandInt, CommandLong, CommandAck, TimeSync, ExtendedSysState, StatusText, Odometry, AdsbVehicle,
               UtmGlobalPosition, OpenDroneIdBasicId, OpenDroneIdLocation>;

}  // namespace tern_companion

#endif
