// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// A whole plan through as many vias as there may be, to and fro in an empty grid, each with a tolerance.
#include "caps/cap.hpp"

namespace tern_caps {
namespace {

constexpr tern::Voxel kDims{512, 64, 32};
constexpr std::size_t kResults = (tern::kWorkspaceBytes / 64 + 1) * 64;

struct Results {
  tern::Via vias[tern::kMaxVias];
  tern::Trajectory plan;
  tern::Report report;
};

}  // namespace

void via_caps() {
  auto& results = state_at<Results>(kResults);
  tern::Grid grid = make_grid(kDims, 0.1, 0.3);
  grid.inflate();
  tern::Request request = request_between({1.0, 3.0, 1.5}, {50.0, 3.0, 1.5});
  for (int v = 0; v < tern::kMaxVias; ++v) {
    const double x = 1.0 + 49.0 * (v + 1) / (tern::kMaxVias + 1);
    results.vias[v] = tern::Via{{x, v % 2 == 0 ? 1.0 : 5.0, v % 3 == 0 ? 1.0 : 2.0}, 0.3, false, false, {}};
  }
  request.vias = results.vias;
  request.via_count = tern::kMaxVias;
  tern::Planner planner(memory(), tern::kWorkspaceBytes);
  const std::uint64_t instructions = count([&] { planner.plan(grid, request, results.plan, results.report); });
  std::uint64_t passed = 0;
  while (passed < tern::kMaxVias && results.report.vias[passed].time > 0.0) ++passed;
  report(
      {"vias", "mission", instructions, passed, tern::kMaxVias,
       static_cast<std::uint64_t>(results.report.diagnostics.stages[static_cast<int>(tern::Stage::kTrajectory)].work),
       1});
}

}  // namespace tern_caps
