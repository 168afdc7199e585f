// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TERN_HOST_SESSION_HPP
#define TERN_HOST_SESSION_HPP

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "host/scenario.hpp"
#include "tern/tern.hpp"
#include "tern/yaw.hpp"

namespace tern_host {

/// What a session measures with.
struct Clock {
  tern::ClockFn read;
  void* context;            ///< handed to `read`; outlives the session
  double ticks_per_second;  ///< 1e6 leaves a counter's ticks as they are where Timing says microseconds
};

/// The platform's own clock, by tern_port.
Clock platform_clock();

/// Microseconds a stage by the session's clock; zeros where the clock said nothing.
struct Timing {
  double inflate = 0.0;
  double stages[tern::kStageCount] = {};

  double of(tern::Stage stage) const { return stages[static_cast<int>(stage)]; }
  double total() const;
};

/// All that came of planning one scenario.
struct PlanResult {
  Scenario scenario;
  tern::GridSpec grid{};
  tern::Report report{};  ///< report.status says how it went
  Timing timing;
  std::unique_ptr<tern::Path> path;          ///< grid frame; null where the stage was not reached
  std::unique_ptr<tern::Corridor> corridor;  ///< likewise
  tern::Trajectory trajectory{};             ///< empty unless ok()
  std::string closed_way{};                  ///< what would open a way, in words, if somebody asked (closed_way.hpp)
  /// Null unless the scenario wants one; yaw_status says why not where it does.
  std::unique_ptr<tern::YawPlan> yaw;
  tern::Status yaw_status = tern::Status::kOk;
  tern::Limits limits{};  ///< that the planner had: slower than the scenario's where a chain of keep-ins asks for that

  /// What a request with all fences answered, where the plan comes from others (FenceChoice) though their number fits.
  tern::Status among_all = tern::Status::kOk;

  bool ok() const { return report.status == tern::Status::kOk; }
  /// Of Report::track, which must name one.
  const std::string& track_name() const { return scenario.tracks[static_cast<std::size_t>(report.track)].id; }
};

/// A planner with the memory it needs, for one scenario after another.
class Session {
 public:
  explicit Session(const Clock& clock = platform_clock());

  /// Lays out, fills and inflates the grid, and plans, from the instant `previous_time` of `previous` if that is given.
  /// Of more fences than a request takes, it plans among those that matter (FenceChoice), and proves the plan against
  /// all. A keep-out for a while that leaves no clear time is tried once more as one that always holds. A plan that is
  /// too fast for a chain of keep-ins for a while is made again with lower limits on speed. Throws ScenarioError where
  /// the grid does not fit.
  PlanResult plan(const Scenario& scenario, const tern::Trajectory* previous = nullptr, double previous_time = 0.0);

  /// The record of the last plan (tern/record.hpp). Its grid must have been bound.
  std::string record(const PlanResult& result) const;

 private:
  PlanResult plan_among(const Scenario& scenario, const tern::Limits& limits, const tern::Trajectory* previous,
                        double previous_time);
  PlanResult plan_chosen(const Scenario& scenario, const tern::Limits& limits, const tern::Trajectory* previous,
                         double previous_time);
  PlanResult plan_once(const Scenario& scenario, const tern::Limits& limits, const tern::Trajectory* previous,
                       double previous_time);
  tern::Status build_grid(PlanResult& result);
  double microseconds(std::uint64_t ticks) const;

  Clock clock_;
  std::unique_ptr<unsigned char[]> memory_;
  std::vector<std::uint64_t> words_;
  tern::Grid grid_;
  tern::Planner planner_;
};

}  // namespace tern_host

#endif
