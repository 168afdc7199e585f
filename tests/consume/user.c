/* Copyright (c) 2026, the Tern authors
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * The C interface from C99: sizes, self-test, a plan around a wall, its evaluation, and grids that are bound again. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "tern/tern.h"

#define REQUIRE(condition)                                   \
  do {                                                       \
    if (!(condition)) {                                      \
      printf("%s:%d: %s\n", __FILE__, __LINE__, #condition); \
      return 1;                                              \
    }                                                        \
  } while (0)

static int is(uint8_t status, const char* name) {
  return strcmp(tern_status_name(status), name) == 0;
}

static int check_layout(void) {
  REQUIRE(tern_abi() == TERN_ABI);
  REQUIRE(tern_size_of(TERN_SIZE_REQUEST) == sizeof(tern_request));
  REQUIRE(tern_size_of(TERN_SIZE_TRAJECTORY) == sizeof(tern_trajectory));
  REQUIRE(tern_size_of(TERN_SIZE_REPORT) == sizeof(tern_report));
  REQUIRE(tern_size_of(TERN_SIZE_GRID_SPEC) == sizeof(tern_grid_spec));
  REQUIRE(tern_size_of(99) == 0 && tern_size_of(-1) == 0);
  REQUIRE(tern_self_test(tern_configuration_hash(), NULL) == 0);
  REQUIRE(tern_self_test(tern_configuration_hash() + 1, NULL) != 0);
  return 0;
}

static const tern_grid_spec spec = {
    {-1.0, 0.0, 0.0}, 0.1, {30, 30, 20}, {{-1.0, 0.0, 0.0}, {2.0, 3.0, 2.0}}, 0.15, 0.0};

static int make_grid(tern_grid* grid, uint64_t** words) {
  const tern_box wall = {{0.4, 0.0, 0.0}, {0.6, 2.0, 2.0}};
  const size_t count = tern_grid_words(spec.dims);
  REQUIRE(count > 0);
  *words = realloc(*words, count * sizeof **words);
  REQUIRE(tern_grid_bind(grid, &spec, *words, count) == 0);
  REQUIRE(tern_grid_mark_box(grid, &wall) == 0);
  REQUIRE(tern_grid_inflate(grid) == 0);
  return 0;
}

static int check_plan(const tern_trajectory* trajectory, const tern_report* report) {
  tern_sample start, end;
  const double duration = tern_duration(trajectory);
  REQUIRE(report->status == 0 && trajectory->count >= 2 && duration > 1.0);
  tern_evaluate(trajectory, 0.0, &start);
  tern_evaluate(trajectory, duration + 1.0, &end);
  REQUIRE(fabs(start.position.x + 0.5) < 1e-9 && fabs(end.position.x - 1.5) < 1e-9);
  REQUIRE(fabs(end.velocity.x) < 1e-9);
  return 0;
}

static int check_refusals(tern_planner* planner, const tern_grid* grid, tern_request* request,
                          tern_trajectory* trajectory, tern_report* report) {
  REQUIRE(tern_plan(NULL, grid, request, trajectory, report) != 0);
  REQUIRE(tern_plan(planner, grid, NULL, trajectory, report) != 0);
  request->start.position.x = 0.5;
  REQUIRE(tern_plan(planner, grid, request, trajectory, report) != 0);
  printf("refused as it must be: %s, %s\n", tern_status_name(report->status), tern_status_meaning(report->status));
  request->search = 77;
  REQUIRE(tern_plan(planner, grid, request, trajectory, report) != 0);
  REQUIRE(strcmp(tern_stage_name(report->stage), "request") == 0);
  REQUIRE(strcmp(tern_field_name(report->field), "search") == 0);
  return 0;
}

/* Memory that holds no grid is refused by every call. */
static int check_unbound(tern_planner* planner, const tern_request* request, tern_trajectory* trajectory,
                         tern_report* report) {
  tern_grid grid;
  const tern_box box = {{0.0, 0.0, 0.0}, {0.5, 0.5, 0.5}};
  const tern_vec3 point = {0.0, 0.0, 0.0};
  tern_grid_spec bad = spec;
  bad.cell = -1.0;
  memset(&grid, 0, sizeof grid);
  for (int turn = 0; turn < 2; ++turn) {
    REQUIRE(is(tern_grid_mark_box(&grid, &box), "invalid_argument"));
    REQUIRE(is(tern_grid_clear_box(&grid, &box), "invalid_argument"));
    REQUIRE(is(tern_grid_mark_points(&grid, &point, 1, NULL), "invalid_argument"));
    REQUIRE(is(tern_grid_inflate(&grid), "invalid_argument"));
    REQUIRE(is(tern_plan(planner, &grid, request, trajectory, report), "invalid_argument"));
    REQUIRE(is(tern_plan_begin(planner, &grid, request), "invalid_argument"));
    REQUIRE(is(tern_plan_step(planner, 10), "invalid_argument"));
    REQUIRE(is(tern_plan_finish(planner, trajectory, report), "invalid_argument"));
    REQUIRE(is(tern_grid_bind(&grid, &bad, NULL, 0), "invalid_argument")); /* and does not bind it */
  }
  return 0;
}

/* A bind that is refused leaves the grid that was there; one that is not ends the plan that is under way. */
static int check_bound_again(tern_planner* planner, tern_grid* grid, const tern_request* request,
                             tern_trajectory* trajectory, tern_report* report) {
  const tern_grid_spec small = {{-1.0, 0.0, 0.0}, 0.1, {5, 5, 5}, {{-1.0, 0.0, 0.0}, {-0.5, 0.5, 0.5}}, 0.0, 0.0};
  const tern_box wall = {{0.4, 0.0, 0.0}, {0.6, 2.0, 2.0}};
  const size_t count = tern_grid_words(small.dims);
  uint64_t* words = malloc(count * sizeof *words);
  tern_grid_spec bad = spec;
  bad.cell = -1.0;
  REQUIRE(words != NULL);
  REQUIRE(is(tern_grid_bind(grid, &bad, words, count), "invalid_argument"));
  REQUIRE(is(tern_grid_bind(grid, &small, words, count - 1), "invalid_argument"));
  REQUIRE(tern_plan(planner, grid, request, trajectory, report) == 0);
  REQUIRE(is(tern_plan_begin(planner, grid, request), "running"));
  REQUIRE(is(tern_plan_step(planner, 2), "running"));
  REQUIRE(tern_grid_bind(grid, &small, words, count) == 0);
  REQUIRE(tern_grid_mark_box(grid, &wall) == 0 && tern_grid_inflate(grid) == 0);
  REQUIRE(is(tern_plan_step(planner, 2), "map_changed"));
  REQUIRE(is(tern_plan_finish(planner, trajectory, report), "map_changed"));
  free(words);
  return 0;
}

int main(void) {
  tern_grid grid;
  tern_planner planner;
  tern_request request;
  tern_report report;
  uint64_t* words = NULL;
  void* memory = malloc(tern_size_of(TERN_SIZE_WORKSPACE));
  tern_trajectory* trajectory = malloc(sizeof *trajectory);
  REQUIRE(memory != NULL && trajectory != NULL);
  if (check_layout() != 0 || make_grid(&grid, &words) != 0) return 1;
  REQUIRE(tern_planner_init(&planner, memory, tern_size_of(TERN_SIZE_WORKSPACE)) == 0);
  tern_request_init(&request);
  request.start.position = (tern_vec3){-0.5, 0.5, 1.0};
  request.goal.position = (tern_vec3){1.5, 0.5, 1.0};
  request.limits.v_max = (tern_vec3){2.0, 2.0, 1.0};
  request.limits.a_max = (tern_vec3){2.0, 2.0, 1.0};
  REQUIRE(tern_plan(&planner, &grid, &request, trajectory, &report) == 0);
  if (check_plan(trajectory, &report) != 0) return 1;
  if (check_unbound(&planner, &request, trajectory, &report) != 0) return 1;
  if (check_bound_again(&planner, &grid, &request, trajectory, &report) != 0 || make_grid(&grid, &words) != 0) return 1;
  if (check_refusals(&planner, &grid, &request, trajectory, &report) != 0) return 1;
  free(words);
  free(trajectory);
  free(memory);
  return 0;
}
