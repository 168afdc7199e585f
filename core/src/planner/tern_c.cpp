// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include <cstddef>
#include <cstdint>
#include <new>

#include "grid/grid_handle.hpp"
#include "tern/tern_corridor.h"
#include "tern/track_class.hpp"

namespace {

using tern::Grid;
using tern::kGridTag;
using tern::kNoGrid;
using tern::object;
using tern::Planner;
using tern::Status;

static_assert(sizeof(std::uint64_t) + sizeof(Grid) <= sizeof(tern_grid) && alignof(Grid) <= alignof(tern_grid),
              "raise TERN_GRID_WORDS");
static_assert(sizeof(Planner) <= sizeof(tern_planner) && alignof(Planner) <= alignof(tern_planner),
              "raise TERN_PLANNER_WORDS");

static_assert(std::uint32_t{TERN_FAULT_FLUSH_TO_ZERO} == tern::kFaultFlushToZero, "");
static_assert(std::uint32_t{TERN_FAULT_ROUNDING_MODE} == tern::kFaultRoundingMode, "");
static_assert(std::uint32_t{TERN_FAULT_CONTRACTION} == tern::kFaultContraction, "");
static_assert(std::uint32_t{TERN_FAULT_ARITHMETIC} == tern::kFaultArithmetic, "");
static_assert(std::uint32_t{TERN_FAULT_CONFIGURATION} == tern::kFaultConfiguration, "");
static_assert(std::uint32_t{TERN_FAULT_RECIPROCAL_MATH} == tern::kFaultReciprocalMath, "");
static_assert(std::uint32_t{TERN_FAULT_NO_SIGNED_ZEROS} == tern::kFaultNoSignedZeros, "");
static_assert(std::uint32_t{TERN_FAULT_ASSOCIATIVE_MATH} == tern::kFaultAssociativeMath, "");
static_assert(std::uint32_t{TERN_FAULT_SINGLE_PRECISION_CONSTANT} == tern::kFaultSinglePrecisionConstant, "");

constexpr std::uint8_t kInvalid = static_cast<std::uint8_t>(Status::kInvalidArgument);

std::uint8_t code(Status status) {
  return static_cast<std::uint8_t>(status);
}
Planner& object(tern_planner* planner) {
  return *std::launder(reinterpret_cast<Planner*>(planner->opaque));
}
const Planner& object(const tern_planner* planner) {
  return *std::launder(reinterpret_cast<const Planner*>(planner->opaque));
}

}  // namespace

extern "C" {

std::int32_t tern_abi(void) {
  return TERN_ABI;
}

std::uint64_t tern_configuration_hash(void) {
  return tern::configuration_hash();
}

std::size_t tern_size_of(std::int32_t what) {
  switch (what) {
    case TERN_SIZE_REQUEST:
      return sizeof(tern::Request);
    case TERN_SIZE_TRAJECTORY:
      return sizeof(tern::Trajectory);
    case TERN_SIZE_REPORT:
      return sizeof(tern::Report);
    case TERN_SIZE_GRID_SPEC:
      return sizeof(tern::GridSpec);
    case TERN_SIZE_WORKSPACE:
      return tern::kWorkspaceBytes;
    case TERN_SIZE_WORKSPACE_ALIGNMENT:
      return tern::kWorkspaceAlignment;
  }
  return 0;
}

const char* tern_status_name(std::uint8_t status) {
  return tern::status_name(static_cast<Status>(status));
}

const char* tern_status_meaning(std::uint8_t status) {
  return tern::status_meaning(static_cast<Status>(status));
}

const char* tern_stage_name(std::uint8_t stage) {
  return tern::stage_name(static_cast<tern::Stage>(stage));
}

const char* tern_field_name(std::uint8_t field) {
  return tern::field_name(static_cast<tern::Field>(field));
}

const char* tern_finding_name(std::uint8_t finding) {
  return tern::finding_name(static_cast<tern::Finding>(finding));
}

std::uint8_t tern_self_test(std::uint64_t hash, std::uint32_t* faults) {
  return code(tern::self_test(hash, faults));
}

std::size_t tern_grid_words(tern_voxel dims) {
  return tern::grid_words(dims);
}

std::uint8_t tern_grid_bind(tern_grid* grid, const tern_grid_spec* spec, std::uint64_t* words, std::size_t word_count) {
  if (grid == nullptr || spec == nullptr) return kInvalid;
  const Grid* before = object(grid);
  Grid bound = before != nullptr ? *before : kNoGrid;
  const Status status = bound.bind(*spec, words, word_count);
  if (status != Status::kOk) return code(status);
  new (grid->opaque + 1) Grid(bound);
  grid->opaque[0] = kGridTag;
  return code(status);
}

std::uint8_t tern_grid_mark_box(tern_grid* grid, const tern_box* world) {
  Grid* marked = object(grid);
  if (marked == nullptr || world == nullptr) return kInvalid;
  return code(marked->mark_box(*world));
}

std::uint8_t tern_grid_clear_box(tern_grid* grid, const tern_box* world) {
  Grid* cleared = object(grid);
  if (cleared == nullptr || world == nullptr) return kInvalid;
  return code(cleared->clear_box(*world));
}

std::uint8_t tern_grid_mark_cylinder(tern_grid* grid, const tern_cylinder* world) {
  Grid* marked = object(grid);
  if (marked == nullptr || world == nullptr) return kInvalid;
  return code(marked->mark_cylinder(*world));
}

std::uint8_t tern_grid_mark_points(tern_grid* grid, const tern_vec3* world, std::size_t count, std::size_t* inside) {
  Grid* marked = object(grid);
  return marked == nullptr ? kInvalid : code(marked->mark_points(world, count, inside));
}

std::uint8_t tern_grid_mark_grid(tern_grid* coarse, const tern_grid* fine, std::uint8_t* field) {
  Grid* marked = object(coarse);
  tern::Field wrong = tern::Field::kStorage;
  Status status = Status::kInvalidArgument;
  if (marked != nullptr && fine != nullptr) status = marked->mark_grid(object(fine), &wrong);
  if (field != nullptr) *field = static_cast<std::uint8_t>(wrong);
  return code(status);
}

std::uint8_t tern_grid_inflate(tern_grid* grid) {
  Grid* inflated = object(grid);
  if (inflated == nullptr || !inflated->bound()) return kInvalid;
  inflated->inflate();
  return code(Status::kOk);
}

std::uint8_t tern_planner_init_for(tern_planner* planner, void* memory, std::size_t bytes,
                                   std::uint64_t configuration) {
  if (planner == nullptr) return kInvalid;
  // There is a planner even if it was refused: a caller who ignores this answer gets it again from every plan.
  new (planner->opaque) Planner(memory, bytes, configuration);
  const bool usable = memory != nullptr && bytes >= tern::kWorkspaceBytes && configuration == tern::kConfigurationHash;
  return usable ? code(Status::kOk) : kInvalid;
}

std::uint8_t tern_planner_set_clock(tern_planner* planner, std::uint64_t (*clock)(void*), void* context) {
  if (planner == nullptr) return kInvalid;
  object(planner).set_clock(clock, context);
  return code(Status::kOk);
}

void tern_request_init(tern_request* request) {
  if (request != nullptr) *request = tern::Request{};
}

std::uint8_t tern_plan(tern_planner* planner, const tern_grid* grid, const tern_request* request,
                       tern_trajectory* trajectory, tern_report* report) {
  if (planner == nullptr || grid == nullptr || request == nullptr || trajectory == nullptr || report == nullptr) {
    return kInvalid;
  }
  return code(object(planner).plan(object(grid), *request, *trajectory, *report));
}

std::uint8_t tern_plan_begin(tern_planner* planner, const tern_grid* grid, const tern_request* request) {
  if (planner == nullptr || grid == nullptr || request == nullptr) return kInvalid;
  return code(object(planner).begin(object(grid), *request));
}

std::uint8_t tern_track_of(const tern_trajectory* trajectory, double radius, tern_track_piece* pieces,
                           std::int32_t room, tern_track* track) {
  if (trajectory == nullptr || track == nullptr) return kInvalid;
  return code(tern::track_of(*trajectory, radius, pieces, room, *track));
}

std::uint8_t tern_track_of_class(std::uint8_t kind, tern_track* track) {
  return track == nullptr ? kInvalid : code(tern::track_of_class(static_cast<tern::TrackClass>(kind), *track));
}

void tern_box_halfspaces(const tern_box* box, tern_halfspace planes[6]) {
  if (box == nullptr || planes == nullptr) return;
  tern::Halfspace out[tern::kBoxPlanes];
  tern::box_planes(*box, out);
  for (int p = 0; p < tern::kBoxPlanes; ++p) planes[p] = out[p];
}

std::uint8_t tern_plan_step(tern_planner* planner, std::uint32_t work) {
  return planner == nullptr ? kInvalid : code(object(planner).step(work));
}

std::uint8_t tern_plan_finish(tern_planner* planner, tern_trajectory* trajectory, tern_report* report) {
  if (planner == nullptr || trajectory == nullptr || report == nullptr) return kInvalid;
  return code(object(planner).finish(*trajectory, *report));
}

std::uint8_t tern_route(tern_planner* planner, const tern_grid* grid, const tern_request* request,
                        tern_report* report) {
  if (planner == nullptr || grid == nullptr || request == nullptr || report == nullptr) return kInvalid;
  return code(object(planner).route(object(grid), *request, *report));
}

std::uint8_t tern_route_begin(tern_planner* planner, const tern_grid* grid, const tern_request* request) {
  if (planner == nullptr || grid == nullptr || request == nullptr) return kInvalid;
  return code(object(planner).begin_route(object(grid), *request));
}

std::uint8_t tern_route_finish(tern_planner* planner, tern_report* report) {
  return planner == nullptr || report == nullptr ? kInvalid : code(object(planner).finish_route(*report));
}

std::int32_t tern_path(const tern_planner* planner, tern_vec3* points, std::int32_t room) {
  const tern::Path* path = planner == nullptr ? nullptr : object(planner).path();
  if (path == nullptr) return 0;
  const std::int32_t fit = points == nullptr ? 0 : room;
  for (int i = 0; i < path->count && i < fit; ++i) points[i] = path->points[i];
  return path->count;
}

std::int32_t tern_corridor(const tern_planner* planner, tern_polyhedron* polyhedra, std::int32_t room) {
  const tern::Corridor* corridor = planner == nullptr ? nullptr : object(planner).corridor();
  if (corridor == nullptr) return 0;
  const std::int32_t fit = polyhedra == nullptr ? 0 : room;
  for (int i = 0; i < corridor->count && i < fit; ++i) polyhedra[i] = corridor->polyhedra[i];
  return corridor->count;
}

double tern_duration(const tern_trajectory* trajectory) {
  return trajectory == nullptr ? 0.0 : tern::duration(*trajectory);
}

double tern_time_on(const tern_trajectory* trajectory, std::int64_t now) {
  return trajectory == nullptr ? 0.0 : tern::time_on(*trajectory, now);
}

void tern_evaluate(const tern_trajectory* trajectory, double t, tern_sample* sample) {
  if (sample == nullptr) return;
  *sample = trajectory == nullptr ? tern::Sample{} : tern::evaluate(*trajectory, t);
}

void tern_flat(const tern_sample* sample, const tern_yaw* yaw, tern_flat_state* state) {
  if (state == nullptr) return;
  *state =
      tern::flat_state(sample == nullptr ? tern::Sample{} : *sample, yaw == nullptr ? tern::Yaw{1.0, 0.0, 0.0} : *yaw);
}

}  // extern "C"
