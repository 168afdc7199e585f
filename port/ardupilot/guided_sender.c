/* Copyright (c) 2026, the Tern authors
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * guided_sender PORT EAST NORTH UP: on a companion computer, beside ArduPilot. Listens on a UDP port until the vehicle
 * hovers in guided mode, plans from there past the boxes of kObstacles, and streams the plan back to the sender at
 * 50 Hz as SET_POSITION_TARGET_LOCAL_NED (84): position, velocity, acceleration, yaw and yaw rate. README.md says what
 * it does when. */
#define _POSIX_C_SOURCE 200809L
#include <arpa/inet.h>
#include <errno.h>
#include <math.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <time.h>

#include "telemetry.h"
#include "tern_stacks/stacks.h"

enum { PERIOD = 20, LONGEST = 500, AFTER_END = 1000, STALE_POSITION = 1000, STALE_HEARTBEAT = 3000 }; /* ms */

static const double kStartTolerance = 0.1;   /* m from the plan's start to the vehicle */
static const double kRestSpeed = 0.3;        /* m/s */
static const double kStray = 1.0;            /* m from the last setpoint; farther away, the plan is given up */
static const double kStopDeceleration = 2.0; /* m/s^2 */

/* Yours: from a map, or none. East, north, up from the EKF's origin, metres. */
static const tern_box kObstacles[] = {{{4, -3, 0}, {5, 3, 5}}};
static const tern_grid_spec kSpec = {{-5, -10, -1}, 0.2, {100, 100, 35}, {{-5, -10, 0.5}, {15, 10, 6}}, 0.3, 0.3};

/* How far along the plan the stream is. */
typedef struct {
  double time, rate; /* s on the plan, and how many of them pass in a second */
  double stop_time;  /* s from full speed to rest; 0: it does not stop */
  tern_vec3 shift;
  uint32_t sent;      /* setpoints */
  int64_t watched_at; /* of the last position that was looked at */
} flight;

static tern_grid grid;
static tern_planner planner;
static tern_trajectory plan;
static tern_yaw_planner yaw_planner;
static tern_yaw_plan yaw_plan;
static volatile sig_atomic_t interrupted = 0;

static void interrupt(int number) {
  (void)number;
  interrupted = 1;
}

static double distance(tern_vec3 a, tern_vec3 b) {
  return sqrt((a.x - b.x) * (a.x - b.x) + (a.y - b.y) * (a.y - b.y) + (a.z - b.z) * (a.z - b.z));
}

static int64_t now_ms(void) {
  struct timespec now;
  clock_gettime(CLOCK_MONOTONIC, &now);
  return 1000 * (int64_t)now.tv_sec + now.tv_nsec / 1000000;
}

static void sleep_until(int64_t ms) {
  const struct timespec until = {ms / 1000, ms % 1000 * 1000000};
  while (clock_nanosleep(CLOCK_MONOTONIC, TIMER_ABSTIME, &until, NULL) == EINTR) {
  }
}

static int make_map(void) {
  const size_t words = tern_grid_words(kSpec.dims), bytes = tern_size_of(TERN_SIZE_WORKSPACE);
  if (tern_grid_bind(&grid, &kSpec, calloc(words, sizeof(uint64_t)), words) != 0) return 0;
  for (size_t i = 0; i < sizeof kObstacles / sizeof *kObstacles; ++i) tern_grid_mark_box(&grid, &kObstacles[i]);
  tern_grid_inflate(&grid);
  return tern_planner_init(&planner, malloc(bytes), bytes) == 0;
}

/* Plans from rest at `start`, with that yaw, to rest at `goal`, within ArduPilot's limits, the nose along the motion.
 */
static int make_plan(tern_vec3 start, double start_yaw, const tern_vec3* goal) {
  const tern_heading heading = {sin(start_yaw), cos(start_yaw)};
  tern_ardupilot_parameters parameters;
  tern_request request;
  tern_yaw_request yaw;
  tern_report report;
  uint8_t status, field;
  tern_request_init(&request);
  request.start.position = start;
  request.goal.position = *goal;
  tern_ardupilot_defaults(&parameters);
  parameters.wpnav_speed_m_s = 3; /* what your vehicle has */
  status = tern_limits_from_ardupilot(&parameters, &request.limits, &field);
  if (status != 0) {
    fprintf(stderr, "parameters give no limits: %s, %s; they are in metres\n", tern_status_name(status),
            tern_field_name(field));
    return 0;
  }
  if (tern_plan(&planner, &grid, &request, &plan, &report) != 0) {
    fprintf(stderr, "no plan: %s, field %s\n", tern_status_name(report.status), tern_field_name(report.field));
    return 0;
  }
  tern_yaw_request_init(&yaw, &heading, 1, 1);
  if (tern_plan_yaw(&yaw_planner, &plan, &yaw, &yaw_plan) != 0) return 0;
  printf("plan of %.2f s from %.2f %.2f %.2f\n", tern_duration(&plan), start.x, start.y, start.z);
  fflush(stdout);
  return 1;
}

/* Guided, armed, in the air, and at rest. */
static int is_ready(const telemetry* seen, int64_t now) {
  const tern_vec3 zero = {0, 0, 0};
  return seen->is_guided && seen->is_flying && now - seen->heartbeat_at < STALE_HEARTBEAT && seen->attitude_at != 0 &&
         seen->position_at != 0 && now - seen->position_at < STALE_POSITION &&
         distance(seen->velocity, zero) <= kRestSpeed;
}

/* Plans from where the vehicle hovers, again if it is no longer there once the plan is made. 0: no plan. */
static int plan_from_hover(int link, telemetry* seen, const tern_vec3* goal) {
  for (;; sleep_until(now_ms() + PERIOD)) {
    listen_to(link, now_ms(), seen);
    if (interrupted) return 0;
    if (!is_ready(seen, now_ms())) continue;
    const tern_vec3 start = seen->position;
    if (!make_plan(start, seen->yaw, goal)) return 0;
    seen->position_at = 0;
    while (seen->position_at == 0 && !interrupted) {
      listen_to(link, now_ms(), seen);
      sleep_until(now_ms() + PERIOD);
    }
    if (is_ready(seen, now_ms()) && distance(seen->position, start) <= kStartTolerance) return 1;
    printf("the vehicle has moved\n");
  }
}

static tern_sample sample_of(const flight* f) {
  const double brake = f->stop_time > 0 && f->rate > 0 ? 1 / f->stop_time : 0, r = f->rate;
  tern_sample s;
  tern_evaluate(&plan, f->time, &s);
  s.position = (tern_vec3){s.position.x + f->shift.x, s.position.y + f->shift.y, s.position.z + f->shift.z};
  s.acceleration =
      (tern_vec3){r * r * s.acceleration.x - brake * s.velocity.x, r * r * s.acceleration.y - brake * s.velocity.y,
                  r * r * s.acceleration.z - brake * s.velocity.z};
  s.velocity = (tern_vec3){r * s.velocity.x, r * s.velocity.y, r * s.velocity.z};
  return s;
}

/* Sends what to fly now. */
static int send_setpoint(int link, const telemetry* seen, flight* f) {
  const tern_mavlink_header header = {255, 190, seen->system, seen->component, (uint8_t)f->sent, PERIOD * f->sent};
  const tern_sample sample = sample_of(f);
  uint8_t frame[TERN_MAVLINK_SETPOINT_BYTES];
  tern_yaw_sample yaw;
  tern_setpoint setpoint;
  tern_yaw_evaluate(&yaw_plan, f->time, &yaw);
  yaw.yaw.rate *= f->rate;
  tern_setpoint_ned(&sample, &yaw, NULL, &setpoint);
  const int32_t bytes = tern_mavlink_setpoint(&setpoint, &header, frame);
  ++f->sent;
  return sendto(link, frame, (size_t)bytes, 0, (const struct sockaddr*)&seen->from, sizeof seen->from) == bytes;
}

/* Comes to rest along the plan. */
static void slow_down(flight* f, const char* reason) {
  const tern_vec3 zero = {0, 0, 0};
  tern_sample s;
  if (f->stop_time > 0) return;
  fprintf(stderr, "%s: coming to rest\n", reason);
  tern_evaluate(&plan, f->time, &s);
  f->stop_time = fmax(0.1, distance(s.velocity, zero) / kStopDeceleration);
}

/* Comes to rest from where the vehicle is, if it is far from what it was told. */
static void watch_position(const telemetry* seen, flight* f) {
  const tern_vec3 at = sample_of(f).position, is = seen->position;
  if (seen->position_at == f->watched_at || distance(is, at) <= kStray) return;
  f->shift = (tern_vec3){f->shift.x + is.x - at.x, f->shift.y + is.y - at.y, f->shift.z + is.z - at.z};
  slow_down(f, "far from the setpoint");
}

static void advance(flight* f) {
  if (f->stop_time > 0) {
    const double rate = fmax(0, f->rate - 1e-3 * PERIOD / f->stop_time);
    f->time += 0.5e-3 * PERIOD * (f->rate + rate);
    f->rate = rate;
  } else {
    f->time = 1e-3 * (PERIOD * f->sent);
  }
}

/* Streams the plan and a second of the hover at its end. 0 if it ended elsewhere. */
static int stream(int link, telemetry* seen) {
  flight f = {0, 1, 0, {0, 0, 0}, 0, seen->position_at};
  int64_t next = now_ms();
  for (int rested = 0; rested <= AFTER_END; next += PERIOD, sleep_until(next)) {
    const int64_t now = now_ms();
    listen_to(link, now, seen);
    if (!seen->is_guided || !seen->is_flying) {
      fprintf(stderr, "not in guided mode, or not flying\n");
      return 0;
    }
    if (interrupted) slow_down(&f, "interrupted");
    if (now - seen->heartbeat_at > STALE_HEARTBEAT) slow_down(&f, "no heartbeat");
    if (now - seen->position_at > STALE_POSITION) slow_down(&f, "no position");
    watch_position(seen, &f);
    f.watched_at = seen->position_at;
    if (now - next > LONGEST) {
      slow_down(&f, "the stream stood still");
      next = now;
    }
    if (!send_setpoint(link, seen, &f)) return 0;
    rested += f.rate <= 0 || f.time >= tern_duration(&plan) ? PERIOD : 0;
    advance(&f);
  }
  return f.stop_time <= 0;
}

int main(int argc, char** argv) {
  struct sockaddr_in own = {0};
  telemetry seen = {0};
  tern_vec3 goal;
  const int link = socket(AF_INET, SOCK_DGRAM, 0);
  char* end[4] = {0};
  if (argc == 5) {
    own.sin_port = htons((uint16_t)strtoul(argv[1], &end[0], 10));
    goal = (tern_vec3){strtod(argv[2], &end[1]), strtod(argv[3], &end[2]), strtod(argv[4], &end[3])};
  }
  for (int i = 0; i < 4; ++i) {
    if (end[i] == NULL || end[i] == argv[i + 1] || *end[i] != '\0') {
      fprintf(stderr, "usage: guided_sender PORT EAST NORTH UP\n");
      return 2;
    }
  }
  if (tern_abi() != TERN_ABI || tern_self_test(tern_header_hash(), NULL) != 0 || !make_map()) return 1;
  own.sin_family = AF_INET;
  if (bind(link, (struct sockaddr*)&own, sizeof own) != 0) return 1;
  signal(SIGINT, interrupt);
  signal(SIGTERM, interrupt);
  printf("listening\n");
  fflush(stdout);
  return plan_from_hover(link, &seen, &goal) && stream(link, &seen) ? 0 : 1;
}
