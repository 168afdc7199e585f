/* Copyright (c) 2026, the Tern authors
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * guided_sender PORT EAST NORTH UP: on a companion computer, beside ArduPilot in guided mode. Listens on a UDP port for
 * the vehicle's LOCAL_POSITION_NED, plans from there past the boxes of kObstacles, and streams the plan back to the
 * sender at 50 Hz as SET_POSITION_TARGET_LOCAL_NED (84): position, velocity, acceleration, yaw and yaw rate. */
#define _POSIX_C_SOURCE 200809L
#include <arpa/inet.h>
#include <errno.h>
#include <netinet/in.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/socket.h>
#include <time.h>

#include "tern/tern_export.h"

enum { PERIOD_MS = 20, LOCAL_POSITION_NED = 32, LOCAL_POSITION_EXTRA = 185, HEADER = 10, POSITION_AT = 4 };

/* Yours: from a map, or none. East, north, up from the EKF's origin, metres. */
static const tern_box kObstacles[] = {{{4, -3, 0}, {5, 3, 5}}};
static const tern_grid_spec kSpec = {{-5, -10, -1}, 0.2, {100, 100, 35}, {{-5, -10, 0.5}, {15, 10, 6}}, 0.3, 0.3};

static tern_grid grid;
static tern_planner planner;
static tern_trajectory plan;
static tern_yaw_planner yaw_planner;
static tern_yaw_plan yaw_plan;

/* MAVLink's checksum of a byte. */
static uint16_t accumulate(uint16_t crc, uint8_t byte) {
  uint8_t t = (uint8_t)(byte ^ (crc & 0xFF));
  t = (uint8_t)(t ^ (t << 4));
  return (uint16_t)((crc >> 8) ^ (t << 8) ^ (t << 3) ^ (t >> 4));
}

/* Reads the position of a LOCAL_POSITION_NED frame of MAVLink 2. 0 for anything else. */
static int read_position(const uint8_t* frame, ssize_t bytes, tern_vec3* position) {
  uint16_t crc = 0xFFFF;
  float ned[3] = {0, 0, 0};
  uint8_t payload[28] = {0}; /* zeros at the end are left out */
  if (bytes < HEADER + 2 || frame[0] != 0xFD || bytes < HEADER + frame[1] + 2) return 0;
  if ((frame[7] | frame[8] << 8 | frame[9] << 16) != LOCAL_POSITION_NED || frame[1] > sizeof payload) return 0;
  for (int i = 1; i < HEADER + frame[1]; ++i) crc = accumulate(crc, frame[i]);
  crc = accumulate(crc, LOCAL_POSITION_EXTRA);
  if (frame[HEADER + frame[1]] != (crc & 0xFF) || frame[HEADER + frame[1] + 1] != crc >> 8) return 0;
  memcpy(payload, frame + HEADER, frame[1]);
  memcpy(ned, payload + POSITION_AT, sizeof ned);
  *position = (tern_vec3){ned[1], ned[0], -ned[2]};
  return 1;
}

/* Waits for the vehicle's position. `vehicle` gets its address. */
static int wait_for_position(int link, struct sockaddr_in* vehicle, tern_vec3* position) {
  uint8_t frame[512];
  for (;;) {
    socklen_t length = sizeof *vehicle;
    const ssize_t bytes = recvfrom(link, frame, sizeof frame, 0, (struct sockaddr*)vehicle, &length);
    if (bytes < 0) return 0;
    if (read_position(frame, bytes, position)) return 1;
  }
}

/* Plans from rest at `start` to rest at `goal`, within ArduPilot's limits, with the nose along the motion. */
static int make_plan(const tern_vec3* start, const tern_vec3* goal) {
  const size_t words = tern_grid_words(kSpec.dims), bytes = tern_size_of(TERN_SIZE_WORKSPACE);
  const tern_heading east = {1, 0};
  tern_ardupilot_parameters parameters;
  tern_request request;
  tern_yaw_request yaw;
  tern_report report;
  if (tern_grid_bind(&grid, &kSpec, calloc(words, sizeof(uint64_t)), words) != 0) return 0;
  for (size_t i = 0; i < sizeof kObstacles / sizeof *kObstacles; ++i) tern_grid_mark_box(&grid, &kObstacles[i]);
  tern_grid_inflate(&grid);
  if (tern_planner_init(&planner, malloc(bytes), bytes) != 0) return 0;
  tern_request_init(&request);
  request.start.position = *start;
  request.goal.position = *goal;
  tern_ardupilot_defaults(&parameters);
  parameters.wpnav_speed_m_s = 3; /* what your vehicle has */
  if (tern_limits_from_ardupilot(&parameters, &request.limits, NULL) != 0) return 0;
  if (tern_plan(&planner, &grid, &request, &plan, &report) != 0) {
    fprintf(stderr, "no plan: %s, field %s\n", tern_status_name(report.status), tern_field_name(report.field));
    return 0;
  }
  tern_yaw_request_init(&yaw, &east, 1, 1);
  return tern_plan_yaw(&yaw_planner, &plan, &yaw, &yaw_plan) == 0;
}

/* Sends what to fly `ms` milliseconds after the plan's beginning. */
static int send_setpoint(int link, const struct sockaddr_in* vehicle, uint32_t ms) {
  static uint8_t sequence = 0;
  const tern_mavlink_header header = {255, 190, 1, 1, sequence++, ms};
  uint8_t frame[TERN_MAVLINK_SETPOINT_BYTES];
  tern_sample sample;
  tern_yaw_sample yaw;
  tern_setpoint setpoint;
  tern_evaluate(&plan, ms / 1000.0, &sample);
  tern_yaw_evaluate(&yaw_plan, ms / 1000.0, &yaw);
  tern_setpoint_ned(&sample, &yaw, NULL, &setpoint);
  const int32_t bytes = tern_mavlink_setpoint(&setpoint, &header, frame);
  return sendto(link, frame, (size_t)bytes, 0, (const struct sockaddr*)vehicle, sizeof *vehicle) == bytes;
}

/* Streams the plan and a second of the hover at its end. */
static int stream(int link, const struct sockaddr_in* vehicle) {
  const uint32_t end = (uint32_t)(1000.0 * tern_duration(&plan)) + 1000;
  struct timespec next;
  clock_gettime(CLOCK_MONOTONIC, &next);
  for (uint32_t ms = 0; ms <= end; ms += PERIOD_MS) {
    if (!send_setpoint(link, vehicle, ms)) return 0;
    next.tv_nsec += PERIOD_MS * 1000000;
    if (next.tv_nsec >= 1000000000) {
      next.tv_nsec -= 1000000000;
      ++next.tv_sec;
    }
    while (clock_nanosleep(CLOCK_MONOTONIC, TIMER_ABSTIME, &next, NULL) == EINTR) {
    }
  }
  return 1;
}

int main(int argc, char** argv) {
  struct sockaddr_in own = {0}, vehicle;
  tern_vec3 start, goal;
  const int link = socket(AF_INET, SOCK_DGRAM, 0);
  if (argc != 5) {
    fprintf(stderr, "usage: guided_sender PORT EAST NORTH UP\n");
    return 2;
  }
  if (tern_abi() != TERN_ABI || tern_self_test(tern_header_hash(), NULL) != 0) return 1;
  own.sin_family = AF_INET;
  own.sin_port = htons((uint16_t)atoi(argv[1]));
  goal = (tern_vec3){atof(argv[2]), atof(argv[3]), atof(argv[4])};
  if (bind(link, (struct sockaddr*)&own, sizeof own) != 0) return 1;
  printf("listening\n");
  fflush(stdout);
  if (!wait_for_position(link, &vehicle, &start) || !make_plan(&start, &goal)) return 1;
  printf("plan of %.2f s from %.2f %.2f %.2f\n", tern_duration(&plan), start.x, start.y, start.z);
  return stream(link, &vehicle) ? 0 : 1;
}
