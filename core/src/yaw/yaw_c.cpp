// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include <cstdint>
#include <new>

#include "tern/tern_yaw.h"

namespace {

using tern::Status;
using tern::YawPlanner;

/// A tern_yaw_planner's first word once a plan was begun there; the planner follows it.
constexpr std::uint64_t kYawTag = 0x7465726E2D796177u;
constexpr std::uint8_t kInvalid = static_cast<std::uint8_t>(Status::kInvalidArgument);

static_assert(sizeof(std::uint64_t) + sizeof(YawPlanner) <= sizeof(tern_yaw_planner) &&
                  alignof(YawPlanner) <= alignof(tern_yaw_planner),
              "raise TERN_YAW_PLANNER_WORDS");

std::uint8_t code(Status status) {
  return static_cast<std::uint8_t>(status);
}

/// Null if no plan was begun. The memory may never have been written; reading its first word as volatile makes sure
/// that the word has one value.
YawPlanner* object(tern_yaw_planner* planner) {
  if (planner == nullptr || *static_cast<const volatile std::uint64_t*>(planner->opaque) != kYawTag) return nullptr;
  return std::launder(reinterpret_cast<YawPlanner*>(planner->opaque + 1));
}

}  // namespace

extern "C" {

void tern_yaw_request_init(tern_yaw_request* request, const tern_heading* start, double rate_max,
                           double acceleration_max) {
  if (request == nullptr || start == nullptr) return;
  *request = tern::yaw_request(*start, rate_max, acceleration_max);
}

std::uint8_t tern_yaw_plan_begin(tern_yaw_planner* planner, const tern_trajectory* trajectory,
                                 const tern_yaw_request* request) {
  if (planner == nullptr || trajectory == nullptr || request == nullptr) return kInvalid;
  YawPlanner* const plans = object(planner);
  if (plans != nullptr) return code(plans->begin(*trajectory, *request));
  planner->opaque[0] = kYawTag;
  return code((new (planner->opaque + 1) YawPlanner)->begin(*trajectory, *request));
}

std::uint8_t tern_yaw_plan_step(tern_yaw_planner* planner, std::uint32_t work) {
  YawPlanner* const plans = object(planner);
  return plans == nullptr ? kInvalid : code(plans->step(work));
}

std::uint8_t tern_yaw_plan_finish(tern_yaw_planner* planner, tern_yaw_plan* plan) {
  YawPlanner* const plans = object(planner);
  return plans == nullptr || plan == nullptr ? kInvalid : code(plans->finish(*plan));
}

std::uint8_t tern_plan_yaw(tern_yaw_planner* planner, const tern_trajectory* trajectory,
                           const tern_yaw_request* request, tern_yaw_plan* plan) {
  if (plan == nullptr) return kInvalid;
  const std::uint8_t begun = tern_yaw_plan_begin(planner, trajectory, request);
  if (begun != code(Status::kRunning)) return begun;
  tern_yaw_plan_step(planner, UINT32_MAX);
  return tern_yaw_plan_finish(planner, plan);
}

double tern_yaw_duration(const tern_yaw_plan* plan) {
  return plan == nullptr ? 0.0 : tern::duration(*plan);
}

void tern_yaw_evaluate(const tern_yaw_plan* plan, double t, tern_yaw_sample* sample) {
  if (sample != nullptr) *sample = plan == nullptr ? tern::evaluate(tern::YawPlan{}, t) : tern::evaluate(*plan, t);
}

}  // extern "C"
