// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include <cstdint>

#include "tern_stacks/stacks.h"

namespace {

using tern::Status;

constexpr std::uint8_t kInvalid = static_cast<std::uint8_t>(Status::kInvalidArgument);

static_assert(TERN_MAVLINK_SETPOINT_BYTES == tern::kMavlinkSetpointBytes, "the C header's numbers are the core's");
static_assert(TERN_CRAZYFLIE_COMPRESSED_BYTES(7) == tern::crazyflie_compressed_bytes(7), "likewise");

std::uint8_t code(Status status) {
  return static_cast<std::uint8_t>(status);
}

tern::Vec3 zero_for_null(const tern_vec3* origin) {
  return origin == nullptr ? tern::Vec3{0.0, 0.0, 0.0} : *origin;
}

Status limits_of(const tern_px4_parameters& parameters, tern_limits& limits, tern::Field* field) {
  return tern::limits_from_px4(parameters, limits, field);
}

Status limits_of(const tern_ardupilot_parameters& parameters, tern_limits& limits, tern::Field* field) {
  return tern::limits_from_ardupilot(parameters, limits, field);
}

Status limits_of(const tern_crazyflie_parameters& parameters, tern_limits& limits, tern::Field* field) {
  return tern::limits_from_crazyflie(parameters, limits, field);
}

template <typename Parameters>
std::uint8_t limits_from(const Parameters* parameters, tern_limits* limits, std::uint8_t* field) {
  if (parameters == nullptr || limits == nullptr) return kInvalid;
  tern::Field bad = tern::Field::kNone;
  const Status status = limits_of(*parameters, *limits, &bad);
  if (field != nullptr) *field = static_cast<std::uint8_t>(bad);
  return code(status);
}

}  // namespace

extern "C" {

void tern_setpoint_ned(const tern_sample* sample, const tern_yaw_sample* yaw, const tern_vec3* origin,
                       tern_setpoint* setpoint) {
  if (setpoint == nullptr) return;
  const tern::Sample at = sample == nullptr ? tern::Sample{} : *sample;
  *setpoint = yaw == nullptr ? tern::setpoint_ned(at, zero_for_null(origin))
                             : tern::setpoint_ned(at, *yaw, zero_for_null(origin));
}

std::uint8_t tern_setpoint_error(const tern_trajectory* trajectory, const tern_yaw_plan* yaw, const tern_vec3* origin,
                                 tern_export_error* error) {
  if (trajectory == nullptr || error == nullptr) return kInvalid;
  *error = tern::setpoint_error(*trajectory, yaw, zero_for_null(origin));
  return 0;
}

void tern_attitude_ned(const double enu[4], double ned[4]) {
  if (enu != nullptr && ned != nullptr) tern::attitude_ned(enu, ned);
}

std::int32_t tern_mavlink_setpoint(const tern_setpoint* setpoint, const tern_mavlink_header* header,
                                   std::uint8_t* frame) {
  if (setpoint == nullptr || header == nullptr || frame == nullptr) return 0;
  return tern::mavlink_setpoint(*setpoint, *header, frame);
}

std::uint8_t tern_crazyflie_raw(const tern_trajectory* trajectory, const tern_yaw_plan* yaw, const tern_vec3* origin,
                                tern_crazyflie_piece* pieces, std::int32_t room, std::int32_t* count,
                                tern_export_error* error) {
  if (trajectory == nullptr || count == nullptr || error == nullptr) return kInvalid;
  return code(tern::crazyflie_raw(*trajectory, yaw, zero_for_null(origin), pieces, room, *count, *error));
}

std::uint8_t tern_crazyflie_compressed(const tern_trajectory* trajectory, const tern_yaw_plan* yaw,
                                       const tern_vec3* origin, std::uint8_t* bytes, std::int32_t room,
                                       std::int32_t* used, tern_export_error* error) {
  if (trajectory == nullptr || used == nullptr || error == nullptr) return kInvalid;
  return code(tern::crazyflie_compressed(*trajectory, yaw, zero_for_null(origin), bytes, room, *used, *error));
}

std::uint8_t tern_crazyflie_decompressed(const std::uint8_t* bytes, std::int32_t count, const tern_vec3* origin,
                                         tern_trajectory* trajectory) {
  if (trajectory == nullptr) return kInvalid;
  return code(tern::crazyflie_decompressed(bytes, count, zero_for_null(origin), *trajectory));
}

void tern_px4_defaults(tern_px4_parameters* parameters) {
  if (parameters != nullptr) *parameters = tern::px4_limits();
}

void tern_ardupilot_defaults(tern_ardupilot_parameters* parameters) {
  if (parameters != nullptr) *parameters = tern::ardupilot_limits();
}

void tern_crazyflie_defaults(tern_crazyflie_parameters* parameters) {
  if (parameters != nullptr) *parameters = tern::crazyflie_limits();
}

std::uint8_t tern_limits_from_px4(const tern_px4_parameters* parameters, tern_limits* limits, std::uint8_t* field) {
  return limits_from(parameters, limits, field);
}

std::uint8_t tern_limits_from_ardupilot(const tern_ardupilot_parameters* parameters, tern_limits* limits,
                                        std::uint8_t* field) {
  return limits_from(parameters, limits, field);
}

std::uint8_t tern_limits_from_crazyflie(const tern_crazyflie_parameters* parameters, tern_limits* limits,
                                        std::uint8_t* field) {
  return limits_from(parameters, limits, field);
}

}  // extern "C"
