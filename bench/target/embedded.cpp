// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "target/embedded.hpp"

#include "timing/cases.hpp"

namespace tern_target {
namespace {

tern_host::Scenario scenario_of(const tern_timing::Case& input) {
  tern_host::Scenario out;
  out.name = input.name;
  out.boundary = input.boundary;
  out.resolution = input.resolution;
  out.radius = input.radius;
  out.start = input.request.start;
  out.goal = input.request.goal;
  out.limits = input.request.limits;
  for (int b = 0; b < input.block_count; ++b) out.blocks.push_back({input.blocks[b], false});
  return out;
}

}  // namespace

std::vector<tern_host::Scenario> embedded_scenarios() {
  std::vector<tern_host::Scenario> out;
  for (int i = 0; i < tern_timing::kCaseCount; ++i) out.push_back(scenario_of(tern_timing::kCases[i]));
  return out;
}

}  // namespace tern_target
