/* Copyright (c) 2026, the Tern authors
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * docs/missions.md: missions in C, as one plan through a known world and in flight. */
#include <stdlib.h>

#include "tern/tern_flight.h"

/* Two points to pass, the second one at rest, and the way back. */
static int plan_mission(tern_planner* planner, const tern_grid* grid, tern_trajectory* plan, tern_report* report) {
  const tern_via vias[2] = {{.position = {3, 0, 1.5}, .tolerance = 0.3}, {.position = {3, 2, 1.5}, .stop = 1}};
  tern_request request;
  tern_request_init(&request);
  request.start.position = (tern_vec3){0, 0, 1.5};
  request.goal.position = (tern_vec3){0, 0.5, 1.5};
  request.limits.v_max = (tern_vec3){3, 3, 2};
  request.limits.a_max = (tern_vec3){6, 6, 6};
  request.vias = vias; /* they must stay until the plan is done */
  request.via_count = 2;
  return tern_plan(planner, grid, &request, plan, report) == 0;
}

/* The same in flight; the last point is the goal. */
static int fly_mission(tern_flight* flight) {
  const tern_via points[3] = {
      {.position = {3, 0, 1.5}, .tolerance = 0.3}, {.position = {3, 2, 1.5}, .stop = 1}, {.position = {0, 0.5, 1.5}}};
  return tern_flight_set_mission(flight, points, 3, TERN_VIA_SKIP) == 0;
}

int main(void) {
  const tern_vec3 corner = {-25.6, -15, -0.4};
  const tern_vec3 start = {0, 0, 1.5};
  const tern_limits limits = {.v_max = {3, 3, 2}, .a_max = {6, 6, 6}};
  const size_t bytes = tern_size_of(TERN_SIZE_WORKSPACE);
  tern_map_spec map_spec;
  tern_flight_spec spec;
  tern_map map;
  tern_grid grid;
  tern_planner planner;
  tern_flight flight;
  static tern_trajectory plan;
  tern_report report;
  tern_flight_report state = {0};
  int good;

  tern_map_spec_init(&map_spec, &corner, 0.2, (tern_voxel){256, 150, 20}, 0.35);
  tern_flight_spec_init(&spec, &limits);
  const size_t map_count = tern_map_words(&map_spec);
  const size_t count = tern_flight_words(map_spec.dims);
  uint64_t* map_words = malloc(map_count * sizeof *map_words);
  uint64_t* words = malloc(count * sizeof *words);
  void* workspace = malloc(bytes);
  good = map_words && words && workspace && tern_planner_init(&planner, workspace, bytes) == 0 &&
         tern_map_bind(&map, &map_spec, map_words, map_count, NULL) == 0 && tern_map_assume_free(&map, &start, 6) == 0;

  good = good && tern_map_route(&map, &grid) == 0 && plan_mission(&planner, &grid, &plan, &report) &&
         report.vias[0].distance <= 0.3 + 1e-9 && report.vias[0].time < report.vias[1].time;

  good = good && tern_flight_start(&flight, &spec, &map, &planner, words, count, &start, 0, NULL) == 0 &&
         fly_mission(&flight);
  for (int64_t now = 0; good && state.reason != TERN_FLIGHT_ARRIVED && now < 20000000000; now += spec.tick) {
    good = tern_flight_tick(&flight, now, &state) == 0;
  }
  good = good && state.passed == 3;

  free(workspace);
  free(words);
  free(map_words);
  return good ? 0 : 1;
}
