/* Copyright (c) 2026, the Tern authors
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * docs/integration.md: a plan and a replan in C. */
#include <stdlib.h>

#include "tern/tern.h"

static uint64_t words[10329]; /* tern_grid_words((tern_voxel){100, 64, 40}) */

static int make_map(tern_grid* grid) {
  const tern_grid_spec spec = {{0, 0, 0}, 0.1, {100, 64, 40}, {{0, 0, 0}, {10, 6.4, 4}}, 0.25, 0};
  const tern_box wall = {{4, 0, 0}, {4.5, 4, 4}};
  return tern_grid_bind(grid, &spec, words, sizeof words / sizeof *words) == 0 &&
         tern_grid_mark_box(grid, &wall) == 0 && tern_grid_inflate(grid) == 0;
}

static int plan_once(tern_planner* planner, const tern_grid* grid, tern_request* request, tern_trajectory* plan) {
  tern_report report;
  tern_request_init(request);
  request->start.position = (tern_vec3){1, 1, 1};
  request->goal.position = (tern_vec3){9, 1, 1};
  request->limits.v_max = (tern_vec3){2, 2, 1};
  request->limits.a_max = (tern_vec3){2, 2, 1};
  return tern_plan(planner, grid, request, plan, &report) == 0;
}

/* Replaces `plan` by a new one that begins when your clock shows `begin`, in nanoseconds. 0: `plan` is as it was. */
static int replan(tern_planner* planner, const tern_grid* grid, tern_request* request, int64_t begin,
                  tern_trajectory* plan) {
  const double t = tern_time_on(plan, begin); /* s since the beginning of the old plan */
  tern_report report;
  tern_sample then;
  tern_evaluate(plan, t, &then);
  request->begin = begin;
  request->start = (tern_state){then.position, then.velocity, then.acceleration, then.jerk};
  request->previous = plan;
  request->previous_time = t;
  return tern_plan(planner, grid, request, plan, &report) == 0;
}

int main(void) {
  static tern_trajectory plan;
  const size_t bytes = tern_size_of(TERN_SIZE_WORKSPACE);
  void* workspace = malloc(bytes);
  tern_planner planner;
  tern_grid grid;
  tern_request request;
  int good = workspace != NULL && tern_planner_init(&planner, workspace, bytes) == 0 && make_map(&grid) &&
             plan_once(&planner, &grid, &request, &plan) && tern_duration(&plan) > 4.0 &&
             replan(&planner, &grid, &request, 1000000000, &plan) && plan.begin == 1000000000;
  free(workspace);
  return good ? 0 : 1;
}
