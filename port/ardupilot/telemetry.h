/* Copyright (c) 2026, the Tern authors
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * What guided_sender hears from ArduPilot: HEARTBEAT (0), ATTITUDE (30) and LOCAL_POSITION_NED (32) of MAVLink 2. */
#ifndef TERN_TELEMETRY_H
#define TERN_TELEMETRY_H

#include <netinet/in.h>
#include <stdint.h>
#include <string.h>
#include <sys/socket.h>

#include "tern/tern.h"

enum { HEADER = 10, PAYLOAD_MAX = 255, HEARTBEAT = 0, ATTITUDE = 30, LOCAL_POSITION_NED = 32 };
enum { ARDUPILOT = 3, ARMED = 128, ACTIVE = 4, GUIDED = 4 }; /* autopilot, base_mode, system_status, custom_mode */

/* Times are in milliseconds; 0 is never. */
typedef struct {
  struct sockaddr_in from;
  uint8_t system, component;
  int is_guided, is_flying;     /* flying: armed and off the ground */
  tern_vec3 position, velocity; /* east, north, up from the EKF's origin */
  double yaw;                   /* clockwise from north */
  int64_t heartbeat_at, attitude_at, position_at;
} telemetry;

/* MAVLink's checksum of a byte. */
static uint16_t accumulate(uint16_t crc, uint8_t byte) {
  uint8_t t = (uint8_t)(byte ^ (crc & 0xFF));
  t = (uint8_t)(t ^ (t << 4));
  return (uint16_t)((crc >> 8) ^ (t << 8) ^ (t << 3) ^ (t >> 4));
}

/* The payload of a frame of MAVLink 2, with the zeros that its end leaves out. The message's number, or -1. */
static int32_t read_payload(const uint8_t* frame, ssize_t bytes, uint8_t* payload) {
  uint16_t crc = 0xFFFF;
  int32_t id;
  if (bytes < HEADER + 2 || frame[0] != 0xFD || bytes < HEADER + frame[1] + 2) return -1;
  id = frame[7] | frame[8] << 8 | frame[9] << 16;
  if (id != HEARTBEAT && id != ATTITUDE && id != LOCAL_POSITION_NED) return -1;
  for (int i = 1; i < HEADER + frame[1]; ++i) crc = accumulate(crc, frame[i]);
  crc = accumulate(crc, id == HEARTBEAT ? 50 : id == ATTITUDE ? 39 : 185);
  if (frame[HEADER + frame[1]] != (crc & 0xFF) || frame[HEADER + frame[1] + 1] != crc >> 8) return -1;
  memset(payload, 0, PAYLOAD_MAX);
  memcpy(payload, frame + HEADER, frame[1]);
  return id;
}

static int read_heartbeat(const uint8_t* frame, const uint8_t* payload, int64_t now, telemetry* seen) {
  uint32_t mode = 0;
  if (payload[5] != ARDUPILOT) return 0; /* a ground station's, or another component's */
  memcpy(&mode, payload, sizeof mode);
  seen->system = frame[5];
  seen->component = frame[6];
  seen->is_guided = mode == GUIDED;
  seen->is_flying = (payload[6] & ARMED) != 0 && payload[7] == ACTIVE;
  seen->heartbeat_at = now;
  return 1;
}

/* True for a frame of the autopilot that says something. */
static int read_frame(const uint8_t* frame, ssize_t bytes, int64_t now, telemetry* seen) {
  uint8_t payload[PAYLOAD_MAX];
  float ned[6];
  const int32_t id = read_payload(frame, bytes, payload);
  if (id < 0) return 0;
  if (id == HEARTBEAT) return read_heartbeat(frame, payload, now, seen);
  if (seen->heartbeat_at == 0 || frame[5] != seen->system || frame[6] != seen->component) return 0;
  memcpy(ned, payload + 4, sizeof ned); /* after the time */
  if (id == ATTITUDE) {
    seen->yaw = ned[2];
    seen->attitude_at = now;
  } else {
    seen->position = (tern_vec3){ned[1], ned[0], -ned[2]};
    seen->velocity = (tern_vec3){ned[4], ned[3], -ned[5]};
    seen->position_at = now;
  }
  return 1;
}

/* Reads what has come. */
static void listen_to(int link, int64_t now, telemetry* seen) {
  uint8_t frame[512];
  for (;;) {
    struct sockaddr_in from;
    socklen_t length = sizeof from;
    const ssize_t bytes = recvfrom(link, frame, sizeof frame, MSG_DONTWAIT, (struct sockaddr*)&from, &length);
    if (bytes < 0) return;
    if (read_frame(frame, bytes, now, seen)) seen->from = from;
  }
}

#endif
