// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// One plan or route in progress. It lies in the workspace, next to the memory of the stages.
#ifndef TERN_PLANNER_PLAN_HPP
#define TERN_PLANNER_PLAN_HPP

#include <cstdint>

#include "base/work.hpp"
#include "planner/pipeline.hpp"
#include "tern/corridor.hpp"
#include "tern/grid.hpp"
#include "tern/path.hpp"
#include "tern/planner.hpp"
#include "tern/report.hpp"
#include "tern/request.hpp"
#include "tern/trajectory.hpp"

namespace tern {

struct Layout;

/// The public calls are those of Planner. This class keeps their order, and watches the clock and the grid.
class Plan {
 public:
  /// `memory` holds this plan and must outlive it.
  explicit Plan(Layout& memory) noexcept : memory_(&memory), pipeline_(memory) {}

  void set_clock(ClockFn clock, void* context) noexcept;
  Status begin(const Grid& grid, const Request& request) noexcept;
  Status begin(const Grid& grid, const Request& request, const Trajectory& pace, double pace_time) noexcept;
  Status begin_route(const Grid& grid, const Request& request) noexcept;
  Status step(Work& work) noexcept;
  Status step(std::uint32_t work) noexcept;
  Status finish(Trajectory& trajectory, Report& report) noexcept;
  Status finish_route(Report& report) noexcept;
  Stage stage() const noexcept { return pipeline_.stage(); }
  const Path* path() const noexcept;
  const Corridor* corridor() const noexcept;

 private:
  Status begin_query(const Grid& grid, const Request& request, const PlanMode& mode) noexcept;
  std::uint64_t ticks() const noexcept { return clock_ != nullptr ? clock_(clock_context_) : 0; }
  Status close(bool is_route, Report& report) noexcept;

  Layout* memory_;
  ClockFn clock_ = nullptr;
  void* clock_context_ = nullptr;
  const Grid* grid_ = nullptr;
  GridVersion version_{};  // of the grid when the plan began
  bool begun_ = false;     // until finish()
  bool is_route_ = false;
  Work slice_;  // what step() was given; a debt between two calls
  Pipeline pipeline_;
};

}  // namespace tern

#endif
