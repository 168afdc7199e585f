// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include <cstdio>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "cli/command.hpp"
#include "cli/output_paths.hpp"
#include "host/atomic_file.hpp"
#include "host/corridor_solver.hpp"

namespace tern_cli {
namespace {

using Json = nlohmann::ordered_json;
using tern_host::CorridorAnswer;
using tern_host::CorridorAnswers;

struct SolveOptions {
  std::vector<std::string> files;
  std::string json;
  int repeat = 20;
};

/// Either of the two answers that are a proof.
bool has_verdict(const CorridorAnswer& answer) {
  return answer.status == tern::Status::kOk || answer.status == tern::Status::kInfeasible;
}

/// The name of the status where there is no verdict.
std::string verdict(const CorridorAnswer& answer) {
  return answer.status == tern::Status::kOk ? "feasible" : tern::status_name(answer.status);
}

Json result_json(const std::string& id, const CorridorAnswers& answers) {
  const CorridorAnswer& cold = answers.cold;
  const bool feasible = cold.status == tern::Status::kOk;
  return {{"id", id},
          {"verdict", verdict(cold)},
          {"objective_scaled", feasible ? Json(cold.objective) : Json(nullptr)},
          {"max_violation", feasible ? Json(cold.violation) : Json(nullptr)},
          {"kkt_residual", cold.residual},
          {"iterations", cold.iterations},
          {"active", cold.active},
          {"time_us", cold.time_us},
          {"warm_verdict", verdict(answers.warm)},
          {"warm_objective_scaled",
           answers.warm.status == tern::Status::kOk ? Json(answers.warm.objective) : Json(nullptr)},
          {"warm_iterations", answers.warm.iterations},
          {"warm_time_us", answers.warm.time_us}};
}

void print_header() {
  std::printf("%-34s%-16s%16s%11s%8s%11s%10s%10s\n", "programme", "verdict", "objective", "iterations", "active",
              "residual", "us", "warm us");
}

void print_row(const std::string& id, const CorridorAnswers& answers) {
  const CorridorAnswer& cold = answers.cold;
  char objective[32] = "-";
  if (cold.status == tern::Status::kOk) std::snprintf(objective, sizeof objective, "%.9g", cold.objective);
  std::printf("%-34s%-16s%16s%11d%8d%11.1e%10.2f%10.2f\n", id.c_str(), verdict(cold).c_str(), objective,
              cold.iterations, cold.active, cold.residual, cold.time_us, answers.warm.time_us);
}

int solve(const SolveOptions& options) {
  check_output_paths(options.files, {options.json});
  std::vector<tern_host::CorridorCase> cases;
  for (const std::string& file : options.files) cases.push_back(tern_host::read_corridor_case(file));
  tern_host::CorridorSolver solver;
  Json results = Json::array();
  int exit_status = kExitOk;
  print_header();
  for (const tern_host::CorridorCase& c : cases) {
    const CorridorAnswers answers = solver.solve(c, options.repeat);
    if (!has_verdict(answers.cold)) exit_status = kExitNoPlan;
    print_row(c.id, answers);
    results.push_back(result_json(c.id, answers));
  }
  if (!options.json.empty()) tern_host::write_file(options.json, Json({{"results", results}}).dump(1) + "\n");
  return exit_status;
}

}  // namespace

void add_solve_command(CLI::App& app, int& exit_status) {
  const auto options = std::make_shared<SolveOptions>();
  CLI::App* const command = app.add_subcommand("solve", "Solve single corridor programmes and print one row for each");
  command->add_option("FILE", options->files, "Corridor programmes (docs/formats.md)")->required();
  command->add_option("--json", options->json, "Write the results as JSON")->type_name("OUT");
  command->add_option("--repeat", options->repeat, "Solves of each programme; times are those of the fastest")
      ->capture_default_str()
      ->check(CLI::Range(1, 100000));
  command->footer("Exit status 3 where a programme was found neither feasible nor infeasible.");
  command->callback([options, &exit_status] { exit_status = solve(*options); });
}

}  // namespace tern_cli
