/* Copyright (c) 2026, the Tern authors
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * A C program compiled with other capacities than the archive: its tern_trajectory has another size. It overlooks every
 * answer, and each call says so again without touching what it was given. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "tern/tern.h"

#define REQUIRE(condition)                                    \
  do {                                                        \
    if (!(condition)) {                                       \
      fprintf(stderr, "line %d: %s\n", __LINE__, #condition); \
      return 1;                                               \
    }                                                         \
  } while (0)

static int refused(uint8_t status) {
  return strcmp(tern_status_name(status), "invalid_argument") == 0;
}

static int named(const tern_report* report) {
  return refused(report->status) && strcmp(tern_field_name(report->field), "configuration") == 0;
}

static int check_planner(tern_planner* planner, const tern_grid* grid) {
  struct {
    tern_trajectory trajectory;
    unsigned char beyond[64 * 1024];
  } out, before;
  tern_request request;
  tern_report report;
  memset(&out, 0x5A, sizeof out);
  before = out;
  tern_request_init(&request);
  request.start.position = (tern_vec3){0.5, 0.5, 0.5};
  request.goal.position = (tern_vec3){1.5, 0.5, 0.5};
  request.limits.v_max = request.limits.a_max = (tern_vec3){2.0, 2.0, 2.0};
  REQUIRE(refused(tern_plan(planner, grid, &request, &out.trajectory, &report)) && named(&report));
  REQUIRE(refused(tern_plan_begin(planner, grid, &request)));
  REQUIRE(refused(tern_plan_step(planner, 1000)));
  REQUIRE(refused(tern_plan_finish(planner, &out.trajectory, &report)) && named(&report));
  REQUIRE(memcmp(&out, &before, sizeof out) == 0);
  return 0;
}

int main(void) {
  const tern_grid_spec spec = {{0.0, 0.0, 0.0}, 0.1, {20, 10, 10}, {{0.0, 0.0, 0.0}, {2.0, 1.0, 1.0}}, 0.1, 0.0};
  const size_t bytes = tern_size_of(TERN_SIZE_WORKSPACE);
  const size_t words = tern_grid_words(spec.dims);
  uint64_t* storage = malloc(words * sizeof *storage);
  void* memory = malloc(bytes);
  uint32_t faults = 0;
  tern_grid grid;
  tern_planner planner;
  REQUIRE(storage != NULL && memory != NULL);
  REQUIRE(tern_header_hash() != tern_configuration_hash());
  REQUIRE(tern_self_test(tern_header_hash(), &faults) != 0 && faults == TERN_FAULT_CONFIGURATION);
  REQUIRE(tern_grid_bind(&grid, &spec, storage, words) == 0 && tern_grid_inflate(&grid) == 0);
  REQUIRE(refused(tern_planner_init(&planner, memory, bytes)));
  if (check_planner(&planner, &grid) != 0) return 1;
  /* Who knows the library's own capacities may say so. */
  REQUIRE(tern_planner_init_for(&planner, memory, bytes, tern_configuration_hash()) == 0);
  free(memory);
  free(storage);
  return 0;
}
