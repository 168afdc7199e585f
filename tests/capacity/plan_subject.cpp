// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include <cstring>

#include "capacity/hook.hpp"
#include "capacity/requests.hpp"
#include "capacity/subject.hpp"
#include "tern/proof.hpp"

namespace tern_capacity {
namespace {

using tern::Status;

template <typename T>
void append(std::string& bits, const T& value) {
  bits.append(reinterpret_cast<const char*>(&value), sizeof value);
}

std::string bits_of(const tern::Trajectory& plan) {
  std::string bits;
  append(bits, plan.origin);
  for (int k = 0; k < plan.count; ++k) {
    append(bits, plan.segments[k].duration);
    append(bits, plan.segments[k].points);
  }
  return bits;
}

class PlanSubject : public Subject {
 public:
  explicit PlanSubject(std::uint64_t seed) : asked_(random_request(seed)) {}

  void renew() override { asked_->world.planner = tern::Planner(asked_->world.memory.get(), tern::kWorkspaceBytes); }

  Outcome run() override {
    tern_test::World& world = asked_->world;
    const Status status = world.replan();
    end();
    return {status, status == Status::kOk ? bits_of(world.trajectory) : "", wrong_with(world, status)};
  }

  /// Where an end moves, what a detour or a stop had no room for is that motion's fault.
  bool allows(Status status) const override {
    // A proof that runs out of pieces refuses the plan.
    const bool meets = status == Status::kNoClearTime || status == Status::kGoalCovered;
    if (meets || status == Status::kStartInContact) return asked_->world.request.track_count > 0;
    return Subject::allows(status) || status == Status::kCheckFailed || (status == Status::kNoTrajectory && moves());
  }

 private:
  bool moves() const {
    const tern::Request& request = asked_->world.request;
    const auto still = [](const tern::Vec3& v) { return v.x == 0.0 && v.y == 0.0 && v.z == 0.0; };
    return !still(request.start.velocity) || !still(request.start.acceleration) || !still(request.goal.velocity);
  }

  static std::string wrong_with(const tern_test::World& world, Status status) {
    const tern::Report& report = world.report;
    if (report.status != status) return "the report has another status";
    for (const tern::StageReport& stage : report.diagnostics.stages) {
      if (stage.work > stage.bound) return "a stage worked more than its bound";
    }
    if (status != Status::kOk) return world.trajectory_untouched() ? "" : "the output is not untouched";
    // No proof is made without a radius.
    const tern::Trajectory& plan = world.trajectory;
    if (world.spec.radius > 0.0 && tern::clear_until(world.grid, plan, 0.0) < tern::duration(plan)) {
      return "the plan is not clear";
    }
    return "";
  }

  std::unique_ptr<Asked> asked_;
};

}  // namespace

bool Subject::allows(Status status) const {
  const auto number = static_cast<int>(status);
  const bool capacity = number >= 50 && number < 70;
  return capacity || number >= 90;
}

std::unique_ptr<Subject> plan_subject(std::uint64_t seed) {
  return std::make_unique<PlanSubject>(seed);
}

}  // namespace tern_capacity
