// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include <cstdio>
#include <memory>
#include <string>
#include <vector>

#include "cli/command.hpp"
#include "cli/output_paths.hpp"
#include "cli/summary.hpp"
#include "host/atomic_file.hpp"
#include "host/export/plan_export.hpp"
#include "host/figures.hpp"
#include "host/map/map_files.hpp"
#include "host/number.hpp"

namespace tern_cli {
namespace {

using tern_host::brief;
using tern_host::PlanResult;

struct ExportOptions {
  std::string scenario;
  std::string raw;
  std::string csv;
  std::string compressed;
  std::string mavlink;
  std::string multidof;
  double rate = 50.0;
  std::vector<std::string> overrides;
};

std::string error_text(const tern_host::ExportError& error) {
  char text[120];
  std::snprintf(text, sizeof text, "off the plan by at most %.2g m, %.2g m/s, %.2g m/s^2", error.position,
                error.velocity, error.acceleration);
  return text;
}

/// Two lines on the curve that the rounded numbers fly. Throws where it is not proven clear of the map.
std::string compressed_text(const PlanResult& result, const std::string& bytes) {
  const tern_host::CompressedCurve curve = tern_host::compressed_curve(result, bytes);
  if (!curve.clear) {
    throw std::runtime_error("the compressed form, rounded to millimetres, is proven clear only until " +
                             brief(curve.clear_until) + " s. Plan with a radius larger by 0.01 m, or use the raw form");
  }
  const tern_host::Figures figures = tern_host::measure(curve.trajectory, result.scenario);
  char use[120];
  std::snprintf(use, sizeof use, "%.1f %% of the velocity limits, %.1f %% of the acceleration limits",
                100.0 * figures.v_use, 100.0 * figures.a_use);
  return "  compressed  " + std::to_string(bytes.size()) + " bytes, " + error_text(curve.error) +
         "\n              proven clear; uses " + use + "\n";
}

int export_plan(const ExportOptions& options) {
  const tern_host::Scenario scenario = tern_host::read_scenario(options.scenario, options.overrides);
  check_output_paths(tern_host::input_paths(scenario),
                     {options.raw, options.csv, options.compressed, options.mavlink, options.multidof});
  const PlanResult result = tern_host::Session().plan(scenario);
  if (!result.ok() || result.yaw_status != tern::Status::kOk) {
    std::fputs((result.ok() ? yaw_failure(result) : failure_summary(result)).c_str(), stderr);
    return kExitNoPlan;
  }
  std::vector<tern_host::Output> outputs;
  std::string text = scenario.name + ": " + std::to_string(result.trajectory.count) + " segments, " +
                     tern_host::fixed(tern::duration(result.trajectory), 3) + " s, yaw " +
                     (result.yaw != nullptr ? "as planned" : "0") + "\n";
  if (!options.raw.empty()) outputs.push_back({options.raw, tern_host::crazyflie_raw(result)});
  if (!options.csv.empty()) outputs.push_back({options.csv, tern_host::crazyflie_csv(result)});
  if (!options.raw.empty() || !options.csv.empty()) {
    text += "  raw         " + std::to_string(132 * result.trajectory.count) + " bytes of 4096, " +
            error_text(tern_host::raw_error(result)) + "\n";
  }
  if (!options.compressed.empty()) {
    outputs.push_back({options.compressed, tern_host::crazyflie_compressed(result)});
    text += compressed_text(result, outputs.back().content);
  }
  if (!options.mavlink.empty()) outputs.push_back({options.mavlink, tern_host::mavlink_stream(result, options.rate)});
  if (!options.multidof.empty()) outputs.push_back({options.multidof, tern_host::multidof_yaml(result, options.rate)});
  tern_host::write_files(outputs);
  std::fputs(text.c_str(), stdout);
  return kExitOk;
}

}  // namespace

void add_export_command(CLI::App& app, int& exit_status) {
  const auto options = std::make_shared<ExportOptions>();
  CLI::App* const command = app.add_subcommand("export", "Plan one scenario and write it for a flight stack");
  command->add_option("SCENARIO", options->scenario, "Scenario file (docs/formats.md)")->required();
  CLI::Option_group* const files = command->add_option_group("Files");
  files->add_option("--crazyflie-raw", options->raw, "Pieces as the firmware stores them, 132 bytes each")
      ->type_name("FILE");
  files->add_option("--crazyflie-csv", options->csv, "The same as a table, for cflib and Crazyswarm")
      ->type_name("FILE");
  files->add_option("--crazyflie-compressed", options->compressed, "The compressed form, if it is still proven clear")
      ->type_name("FILE");
  files->add_option("--mavlink", options->mavlink, "Frames of SET_POSITION_TARGET_LOCAL_NED, for PX4 and ArduPilot")
      ->type_name("FILE");
  files->add_option("--multidof", options->multidof, "trajectory_msgs/MultiDOFJointTrajectory as YAML, for ROS")
      ->type_name("FILE");
  files->require_option(1, 0);
  command->add_option("--rate", options->rate, "Frames or points a second, of --mavlink and --multidof")
      ->capture_default_str()
      ->check(CLI::PositiveNumber)
      ->type_name("HERTZ");
  command->add_option("--set", options->overrides, "Replace a setting of the scenario, e.g. --set yaw=motion")
      ->type_name("KEY=VALUE")
      ->expected(1)
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
  command->footer("Files are written all and whole, or not at all.");
  command->callback([options, &exit_status] { exit_status = export_plan(*options); });
}

}  // namespace tern_cli
