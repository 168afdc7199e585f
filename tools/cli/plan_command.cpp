// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include <cstdio>
#include <memory>
#include <string>
#include <vector>

#include "cli/command.hpp"
#include "cli/output_paths.hpp"
#include "cli/summary.hpp"
#include "cli/warnings.hpp"
#include "host/atomic_file.hpp"
#include "host/closed_way.hpp"
#include "host/flight/family_scenario.hpp"
#include "host/map/map_files.hpp"
#include "host/number.hpp"
#include "host/page/page.hpp"
#include "host/picture/picture.hpp"
#include "host/plan_file.hpp"

namespace tern_cli {
namespace {

struct PlanOptions {
  std::string scenario;
  std::string json;
  std::string csv;
  std::string svg;
  std::string html;
  std::string record;
  std::string view = "page";
  double csv_step = 0.01;
  std::vector<std::string> overrides;
};

std::string picture(const PlanOptions& options, const tern_host::PlanResult& result) {
  return options.view == "oblique" ? tern_host::oblique_svg(result) : tern_host::plan_svg(result);
}

/// Everything is made before anything is written.
void write_outputs(const PlanOptions& options, const tern_host::Session& session, const tern_host::PlanResult& result) {
  std::vector<tern_host::Output> outputs;
  if (!options.json.empty()) outputs.push_back({options.json, tern_host::plan_json(result)});
  if (!options.svg.empty()) outputs.push_back({options.svg, picture(options, result)});
  if (!options.html.empty()) outputs.push_back({options.html, tern_host::page_html({tern_host::plan_run(result)})});
  if (!options.record.empty()) outputs.push_back({options.record, session.record(result)});
  if (!options.csv.empty() && result.ok()) {
    outputs.push_back({options.csv, tern_host::trajectory_csv(result.trajectory, options.csv_step, result.yaw.get())});
  }
  tern_host::write_files(outputs);
}

int plan(const PlanOptions& options) {
  if (!options.html.empty()) tern_host::check_page(1);
  const tern_host::Scenario scenario = tern_host::named_scenario(options.scenario, options.overrides);
  print_warnings(scenario.warnings);
  check_output_paths(tern_host::input_paths(scenario),
                     {options.json, options.csv, options.svg, options.html, options.record});
  tern_host::Session session;
  tern_host::PlanResult result = session.plan(scenario);
  const tern::Report& report = result.report;
  if (report.status == tern::Status::kNoPath || report.goal_missed == tern::Status::kNoPath) {
    result.closed_way = tern_host::describe_closed_way(scenario);
  }
  write_outputs(options, session, result);
  if (result.ok()) {
    std::fputs(plan_summary(result).c_str(), stdout);
    if (result.yaw_status == tern::Status::kOk) return kExitOk;
    std::fputs(yaw_failure(result).c_str(), stderr);
    return kExitNoPlan;
  }
  std::fputs(failure_summary(result).c_str(), stderr);
  return kExitNoPlan;
}

std::string check_step(const std::string& text) {
  double step = 0.0;
  const bool valid = tern_host::parse_number(text, step) == tern_host::NumberError::kNone && step > 0.0;
  return valid ? "" : "must be a number of seconds above 0";
}

}  // namespace

void add_plan_command(CLI::App& app, int& exit_status) {
  const auto options = std::make_shared<PlanOptions>();
  CLI::App* const command = app.add_subcommand("plan", "Plan one scenario and print a summary");
  command
      ->add_option("SCENARIO", options->scenario,
                   "Scenario file: map, start, goal, limits (docs/formats.md); or FAMILY:SEED, e.g. P25:7")
      ->required();
  command->add_option("--json", options->json, "Write the plan, or how far it came, as JSON")->type_name("FILE");
  command
      ->add_option(
          "--csv", options->csv,
          "Write t, position, velocity, acceleration, jerk, snap, and the yaw where one is planned, as a table")
      ->type_name("FILE");
  command->add_option("--csv-step", options->csv_step, "Time between the table's rows, seconds")
      ->capture_default_str()
      ->check(check_step, "")
      ->type_name("SECONDS");
  command->add_option("--svg", options->svg, "Draw map, paths, corridor, trajectory and profiles")->type_name("FILE");
  command->add_option("--html", options->html, "Write a page to look at the plan in 3D, over time (docs/page.md)")
      ->type_name("FILE");
  command->add_option("--record", options->record, "Write grid, request and answer, for `tern replay`")
      ->type_name("FILE");
  command
      ->add_option("--view", options->view,
                   "What --svg draws: page (top and side view, profiles) or oblique (the flight through the map)")
      ->capture_default_str()
      ->check(CLI::IsMember({"page", "oblique"}))
      ->type_name("VIEW");
  command
      ->add_option(
          "--set", options->overrides,
          "Replace a setting of the scenario: start, goal, start_velocity, start_acceleration, start_jerk, "
          "goal_velocity, goal_acceleration, goal_jerk, resolution, radius, tracking_margin, v_max, a_max, v_min, "
          "a_min, v_horizontal, a_horizontal, j_max, j_horizontal, thrust_max, thrust_min, tilt_tangent, rate_max, "
          "time_weight, search (fast or optimal), "
          "goal_mode (exact or nearest), unknown (free or solid), yaw (motion, fixed, point or timed), start_yaw, "
          "start_yaw_rate, start_yaw_acceleration, yaw_rate_max, yaw_acceleration_max; "
          "e.g. --set radius=0.1 --set goal=1,2,3")
      ->type_name("KEY=VALUE")
      ->expected(1)
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
  command->footer("Files are written all and whole, or not at all. No table is written where there is no plan.");
  command->callback([options, &exit_status] { exit_status = plan(*options); });
}

}  // namespace tern_cli
