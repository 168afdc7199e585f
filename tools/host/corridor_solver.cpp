// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "host/corridor_solver.hpp"

#include <algorithm>

#include "qp/solver.hpp"
#include "tern_port/port.hpp"

namespace tern_host {

struct CorridorSolver::Memory {
  tern::QpProblem problem;
  tern::QpProblem moved;
  tern::QpSolver solver;
  tern::QpSolution solution;
};

namespace {

/// More than any solve can use.
constexpr std::uint32_t kUnlimited = 0xFFFFFFFFu;

double microseconds(std::uint64_t ticks) {
  return static_cast<double>(ticks) * (1e6 / tern_port::ticks_per_second());
}

CorridorAnswer describe(tern::Status status, const tern::QpSolution& solution, const CorridorProgramme& programme) {
  CorridorAnswer answer;
  answer.status = status;
  answer.iterations = solution.iterations;
  answer.active = solution.active_count;
  answer.residual = status == tern::Status::kInfeasible ? solution.farkas_residual
                                                        : std::max(solution.stationarity, solution.complementarity);
  if (status != tern::Status::kOk) return answer;
  answer.objective = programme.objective(solution);
  answer.violation = programme.violation(solution);
  return answer;
}

}  // namespace

CorridorSolver::CorridorSolver() : memory_(new Memory) {}
CorridorSolver::~CorridorSolver() = default;

template <typename Begin>
CorridorSolver::Run CorridorSolver::run(const tern::QpProblem& problem, Begin begin) {
  tern::Work work{kUnlimited};
  const std::uint64_t before = tern_port::ticks(nullptr);
  begin();
  const tern::Status status = tern::qp_advance(memory_->solver, problem, work, memory_->solution);
  return {status, microseconds(tern_port::ticks(nullptr) - before)};
}

void CorridorSolver::record(const Run& run, bool first, const CorridorProgramme& programme, CorridorAnswer& answer) {
  if (first) answer = describe(run.status, memory_->solution, programme);
  answer.time_us = first ? run.us : std::min(run.us, answer.time_us);
}

CorridorAnswers CorridorSolver::solve(const CorridorCase& c, int repetitions) {
  const CorridorProgramme cold(c, false);
  const CorridorProgramme warm(c, true);
  cold.assemble(memory_->problem);
  warm.assemble(memory_->moved);
  CorridorAnswers answers;
  for (int i = 0; i < repetitions; ++i) {
    const auto from_nothing = [&] { tern::qp_begin(memory_->solver, memory_->problem, nullptr, 0); };
    const auto from_rows = [&] {
      tern::qp_begin(memory_->solver, memory_->moved, memory_->solution.active, memory_->solution.active_count);
    };
    record(run(memory_->problem, from_nothing), i == 0, cold, answers.cold);
    record(run(memory_->moved, from_rows), i == 0, warm, answers.warm);
  }
  return answers;
}

}  // namespace tern_host
