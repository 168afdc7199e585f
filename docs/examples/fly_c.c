/* Copyright (c) 2026, the Tern authors
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * docs/flight.md: a flight in C through a room that it does not know. A wall with a doorway parts the room. */
#include <math.h>
#include <stdlib.h>

#include "tern/tern_flight.h"

#define WIDTH 160
#define HEIGHT 120
#define FOCAL 80.0f

static const tern_box room = {{-2, -4, 0}, {10, 4, 3}};
static const tern_box walls[2] = {{{4, -4, 0}, {4.4, 1, 3}}, {{4, 3, 0}, {4.4, 4, 3}}};

/* The rays of a pixel of the level camera that looks along `yaw`: along each axis, the least and the largest way at a
 * depth of 1. */
static void rays_of(int u, int v, double yaw, double rays[3][2]) {
  for (int corner = 0; corner < 4; ++corner) {
    const double right = (u + (corner % 2) - 0.5 * WIDTH) / FOCAL;
    const double down = (v + (corner / 2) - 0.5 * HEIGHT) / FOCAL;
    const double ray[3] = {cos(yaw) + right * sin(yaw), sin(yaw) - right * cos(yaw), -down};
    for (int a = 0; a < 3; ++a) {
      rays[a][0] = corner == 0 ? ray[a] : fmin(rays[a][0], ray[a]);
      rays[a][1] = corner == 0 ? ray[a] : fmax(rays[a][1], ray[a]);
    }
  }
}

/* 1 / depth of what a pixel shows of a box from p, at least that of the nearest point; 0 if the pixel shows nothing of
 * it. At a depth of 1 / w, rays are between the box's faces along an axis if low w <= largest and high w >= least. */
static double box_in(const double p[3], double rays[3][2], const tern_box* box) {
  const double low[3] = {box->lower.x - p[0], box->lower.y - p[1], box->lower.z - p[2]};
  const double high[3] = {box->upper.x - p[0], box->upper.y - p[1], box->upper.z - p[2]};
  double least = 0, most = 1e9;
  for (int a = 0; a < 3; ++a) {
    if (low[a] > 0) most = fmin(most, rays[a][1] / low[a]);
    if (low[a] < 0) least = fmax(least, rays[a][1] / low[a]);
    if (high[a] > 0) least = fmax(least, rays[a][0] / high[a]);
    if (high[a] < 0) most = fmin(most, rays[a][0] / high[a]);
  }
  return least <= most ? most : 0;
}

/* The same of the room's faces, from inside. */
static double room_in(const double p[3], double rays[3][2]) {
  const double low[3] = {room.lower.x - p[0], room.lower.y - p[1], room.lower.z - p[2]};
  const double high[3] = {room.upper.x - p[0], room.upper.y - p[1], room.upper.z - p[2]};
  double most = 0;
  for (int a = 0; a < 3; ++a) most = fmax(most, fmax(rays[a][1] / high[a], rays[a][0] / low[a]));
  return most;
}

/* In place of your camera. A pixel shows the nearest thing in the whole of it, not only along one ray. */
static void take_image(const double p[3], double yaw, float* image) {
  for (int v = 0; v < HEIGHT; ++v) {
    for (int u = 0; u < WIDTH; ++u) {
      double rays[3][2];
      rays_of(u, v, yaw, rays);
      double nearest = room_in(p, rays);
      for (int k = 0; k < 2; ++k) nearest = fmax(nearest, box_in(p, rays, &walls[k]));
      image[v * WIDTH + u] = (float)(1 / nearest);
    }
  }
}

/* Begins to enter an image into the map. Both image and map must stay until the map is no longer busy. */
static int enter_frame(tern_map* map, const float* image, const double p[3], double yaw, int64_t now) {
  const tern_depth_view view = {.z32 = image,
                                .width = WIDTH,
                                .height = HEIGHT,
                                .stride = WIDTH,
                                .fx = FOCAL,
                                .fy = FOCAL,
                                .cx = 0.5 * WIDTH - 0.5,
                                .cy = 0.5 * HEIGHT - 0.5,
                                .scale = 1,
                                .min = 0.1,
                                .max = 10};
  const double c = 0.5 * cos(0.5 * yaw);
  const double s = 0.5 * sin(0.5 * yaw);
  const tern_pose pose = {{p[0], p[1], p[2]}, {c + s, -c - s, c - s, s - c}};
  return tern_map_begin_frame(map, &view, &pose, now) == TERN_RUNNING;
}

/* 100 ticks a second, and an image every third tick unless the map is busy. */
static int fly(tern_flight* flight, tern_map* map, int64_t tick, tern_flight_report* report) {
  static float image[WIDTH * HEIGHT];
  tern_command command;
  for (int k = 0; report->reason != TERN_FLIGHT_ARRIVED && k < 3000; ++k) {
    const int64_t now = k * tick;
    tern_flight_command(flight, now, &command);
    const tern_vec3 at = command.sample.position; /* a vehicle without errors */
    if (k % 3 == 0 && !tern_map_busy(map)) {
      const double p[3] = {at.x, at.y, at.z};
      const double yaw = atan2(command.look_at.y - at.y, command.look_at.x - at.x);
      take_image(p, yaw, image);
      if (!enter_frame(map, image, p, yaw, now)) return 0;
    }
    if (tern_flight_tick(flight, now, report) != TERN_OK) return 0;
  }
  return report->reason == TERN_FLIGHT_ARRIVED && report->mode == TERN_FLIGHT_REST;
}

int main(void) {
  const tern_vec3 corner = {-12.8, -6.4, -0.4};
  const tern_vec3 start = {0, 0, 1.5};
  const tern_vec3 goal = {8, 0, 1.5};
  const tern_limits limits = {.v_max = {3, 3, 2}, .a_max = {6, 6, 6}};
  const size_t bytes = tern_size_of(TERN_SIZE_WORKSPACE);
  tern_map_spec map_spec;
  tern_flight_spec spec;
  tern_map map;
  tern_planner planner;
  tern_flight flight;
  tern_flight_report report = {0};

  tern_map_spec_init(&map_spec, &corner, 0.2, (tern_voxel){128, 64, 20}, 0.3);
  tern_flight_spec_init(&spec, &limits);
  const size_t map_count = tern_map_words(&map_spec);
  const size_t count = tern_flight_words(map_spec.dims);
  uint64_t* map_words = malloc(map_count * sizeof *map_words);
  uint64_t* words = malloc(count * sizeof *words);
  void* workspace = malloc(bytes);
  const int good = map_words && words && workspace && tern_planner_init(&planner, workspace, bytes) == TERN_OK &&
                   tern_map_bind(&map, &map_spec, map_words, map_count, NULL) == TERN_OK &&
                   tern_map_assume_free(&map, &start, 1.2) == TERN_OK &&
                   tern_flight_start(&flight, &spec, &map, &planner, words, count, &start, 0, NULL) == TERN_OK &&
                   tern_flight_set_goal(&flight, &goal) == TERN_OK && fly(&flight, &map, spec.tick, &report);

  free(workspace);
  free(words);
  free(map_words);
  return good ? 0 : 1;
}
