// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Solves corridor cases as they stand and with the start shifted, and takes the time.
#ifndef TERN_HOST_CORRIDOR_SOLVER_HPP
#define TERN_HOST_CORRIDOR_SOLVER_HPP

#include <memory>

#include "host/corridor_case.hpp"
#include "host/corridor_programme.hpp"
#include "tern/status.hpp"

namespace tern_host {

/// One solve. An answer has an objective and a violation where status is kOk; both are 0 otherwise.
struct CorridorAnswer {
  tern::Status status = tern::Status::kOk;
  double objective = 0.0;  ///< scaled, see CorridorProgramme::objective
  double violation = 0.0;  ///< metres, m/s, m/s^2
  double residual = 0.0;   ///< larger of stationarity and complementarity; of A'y where infeasible (see qp.hpp)
  int iterations = 0;
  int active = 0;      ///< rows in the working set, or in the proof of infeasibility
  double time_us = 0;  ///< least of all repetitions
};

struct CorridorAnswers {
  CorridorAnswer cold;  ///< from the programme alone: factorisation and solve
  CorridorAnswer warm;  ///< the start shifted, from the active set of the cold solve
};

/// The solver's memory, on the heap once for many cases.
class CorridorSolver {
 public:
  CorridorSolver();
  ~CorridorSolver();

  /// Solves cold and warm, `repetitions` >= 1 times in turn; the answers are the same bits each time.
  CorridorAnswers solve(const CorridorCase& c, int repetitions);

 private:
  struct Memory;
  struct Run {
    tern::Status status;
    double us;
  };

  template <typename Begin>
  Run run(const tern::QpProblem& problem, Begin begin);
  void record(const Run& run, bool first, const CorridorProgramme& programme, CorridorAnswer& answer);

  std::unique_ptr<Memory> memory_;
};

}  // namespace tern_host

#endif
