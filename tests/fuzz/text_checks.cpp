// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Entry points that read text.
#include <algorithm>
#include <cmath>

#include "fuzz/fuzz_checks.hpp"
#include "fuzz/scenario_check.hpp"
#include "host/corridor_solver.hpp"

namespace tern_fuzz {
namespace {

constexpr int kMostSegments = 4;  // larger programmes only take longer

/// The largest coordinate of a joint.
double size_of(const tern_host::CorridorCase& c) {
  double size = 0.0;
  for (const tern::Vec3& p : c.waypoints) size = std::max({size, std::abs(p.x), std::abs(p.y), std::abs(p.z)});
  return size;
}

std::string wrong_with(const tern_host::CorridorAnswer& answer, const tern_host::CorridorCase& c) {
  if (answer.iterations < 0 || answer.active < 0) return "a count is negative";
  // Without a verdict, the numbers are those of wherever the solver gave up.
  if (answer.status != tern::Status::kOk && answer.status != tern::Status::kInfeasible) return "";
  const bool finite =
      std::isfinite(answer.objective) && std::isfinite(answer.violation) && std::isfinite(answer.residual);
  if (!finite) return "a number of the answer is not finite";
  if (answer.status != tern::Status::kOk) return "";
  // A row's rounding goes with its numbers, and those of all rows with the joints. Normals need not have length 1.
  double largest = std::max({c.v_max, c.a_max, size_of(c)});
  for (const auto& planes : c.planes) {
    for (const tern::Halfspace& h : planes) {
      const double reach = std::abs(h.normal.x) + std::abs(h.normal.y) + std::abs(h.normal.z);
      largest = std::max({largest, std::abs(h.offset), reach * (1.0 + size_of(c))});
    }
  }
  return answer.violation > 1e-6 * (1.0 + largest) ? "an answer breaks its rows" : "";
}

}  // namespace

std::string check_scenario(const std::uint8_t* data, std::size_t size) {
  bool accepted = false;
  return check_scenario_text(std::string(data, data + size), accepted);
}

std::string check_solve(const std::uint8_t* data, std::size_t size) {
  static tern_host::CorridorSolver solver;
  try {
    const tern_host::CorridorCase c = tern_host::parse_corridor_case(std::string(data, data + size), "fuzz.txt");
    if (c.segments > kMostSegments) return "";
    const tern_host::CorridorAnswers answers = solver.solve(c, 1);
    const std::string wrong = wrong_with(answers.cold, c);
    return wrong.empty() ? wrong_with(answers.warm, c) : wrong;
  } catch (const tern_host::RecordError& error) {
    return error.place().file != "fuzz.txt" || error.reason().empty() ? "an error without file or reason" : "";
  }
}

}  // namespace tern_fuzz
