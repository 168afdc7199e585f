// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include <cstdint>
#include <new>

#include "grid/grid_handle.hpp"
#include "map/map_handle.hpp"
#include "tern/tern_far_way.h"

namespace {

using tern::FarWay;
using tern::Status;

/// A tern_far_way's first word once a far way was started there; it follows the word.
constexpr std::uint64_t kFarWayTag = 0x7465726E2D666172u;

static_assert(sizeof(std::uint64_t) + sizeof(FarWay) <= sizeof(tern_far_way) &&
                  alignof(FarWay) <= alignof(tern_far_way),
              "raise TERN_FAR_WAY_WORDS");
static_assert(std::uint8_t{TERN_FAR_SEARCHING} == static_cast<std::uint8_t>(tern::FarState::kSearching), "");
static_assert(std::uint8_t{TERN_FAR_LEADS} == static_cast<std::uint8_t>(tern::FarState::kLeads), "");
static_assert(std::uint8_t{TERN_FAR_NO_WAY} == static_cast<std::uint8_t>(tern::FarState::kNoWay), "");

/// Stands in for a far way that was never started.
constexpr FarWay kNoFarWay{};

std::uint8_t answer(Status status) {
  return static_cast<std::uint8_t>(status);
}

/// The memory may be uninitialised. A volatile read gives the word one definite value.
bool holds_far_way(const tern_far_way* far_way) {
  return far_way != nullptr && *static_cast<const volatile std::uint64_t*>(far_way->opaque) == kFarWayTag;
}
FarWay* started(tern_far_way* far_way) {
  return holds_far_way(far_way) ? std::launder(reinterpret_cast<FarWay*>(far_way->opaque + 1)) : nullptr;
}
const FarWay& started(const tern_far_way* far_way) {
  return holds_far_way(far_way) ? *std::launder(reinterpret_cast<const FarWay*>(far_way->opaque + 1)) : kNoFarWay;
}

}  // namespace

extern "C" {

std::uint8_t tern_far_way_start(tern_far_way* far_way, const tern_far_way_spec* spec, tern_grid* coarse,
                                tern_planner* planner) {
  tern::Grid* const grid = tern::object(coarse);
  const bool has_all = far_way != nullptr && spec != nullptr && grid != nullptr && planner != nullptr;
  if (!has_all) return answer(Status::kInvalidArgument);
  FarWay begun;
  const Status status = begun.start(*spec, *grid, *std::launder(reinterpret_cast<tern::Planner*>(planner->opaque)));
  if (status != Status::kOk) return answer(status);
  new (far_way->opaque + 1) FarWay(begun);
  far_way->opaque[0] = kFarWayTag;
  return answer(status);
}

std::uint8_t tern_far_way_set_goal(tern_far_way* far_way, const tern_vec3* goal) {
  FarWay* const way = started(far_way);
  return answer(way == nullptr || goal == nullptr ? Status::kInvalidArgument : way->set_goal(*goal));
}

bool tern_far_way_tick(tern_far_way* far_way, const tern_vec3* position, const tern_flight_report* report,
                       const tern_map* map, std::int64_t t, std::uint32_t work, tern_vec3* near_goal) {
  FarWay* const way = started(far_way);
  const bool has_all = way != nullptr && position != nullptr && report != nullptr && map != nullptr;
  if (!has_all || near_goal == nullptr) return false;
  const bool is_new = way->tick(*position, *report, tern::object(map), t, work);
  if (is_new) *near_goal = way->near_goal();
  return is_new;
}

bool tern_far_way_is_last(const tern_far_way* far_way) {
  return started(far_way).is_last();
}

std::uint8_t tern_far_way_state(const tern_far_way* far_way) {
  return static_cast<std::uint8_t>(started(far_way).state());
}

double tern_far_way_left(const tern_far_way* far_way) {
  return started(far_way).left();
}

std::int32_t tern_far_way_searches(const tern_far_way* far_way) {
  return started(far_way).searches();
}

std::int32_t tern_far_way_marked(const tern_far_way* far_way) {
  return started(far_way).marked();
}

}  // extern "C"
