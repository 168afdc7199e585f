// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>
#include <cstdio>
#include <limits>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "cli/command.hpp"
#include "cli/output_paths.hpp"
#include "cli/summary.hpp"
#include "cli/warnings.hpp"
#include "host/atomic_file.hpp"
#include "host/export/export_proof.hpp"
#include "host/export/held_end.hpp"
#include "host/export/plan_export.hpp"
#include "host/figures.hpp"
#include "host/flight/family_scenario.hpp"
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
  std::vector<double> origin{0.0, 0.0, 0.0};
  double reserve = 0.0;
  double yaw_error = tern::kCrazyflieYaw;
  std::vector<std::string> overrides;
};

/// One form: its name, its size, how far it is from the plan, and how it is proven.
struct Form {
  std::string name;
  std::string size;
  const tern::ExportError& error;
  const tern::Trajectory* curve = nullptr;
};

std::string error_text(const tern::ExportError& error, bool has_yaw) {
  char text[200];
  std::snprintf(text, sizeof text, "off the plan by at most %.2g m, %.2g m/s, %.2g m/s^2", error.position,
                error.velocity, error.acceleration);
  std::string all = text;
  if (has_yaw) {
    std::snprintf(text, sizeof text, ", %.2g rad, %.2g rad/s", error.yaw, error.yaw_rate);
    all += text;
  }
  return all;
}

/// How long the plan lasts, and what becomes of the yaw plan after the trajectory's end.
std::string end_text(const PlanResult& result) {
  const double end = tern::duration(result.trajectory);
  const std::string seconds = tern_host::fixed(end, 3) + " s";
  if (result.yaw == nullptr) return seconds + ", no yaw planned";
  if (tern_host::ends_at_rest(result.trajectory)) {
    return seconds + ", then held until " + tern_host::fixed(tern_host::export_end(result), 3) +
           " s, when the yaw plan ends";
  }
  const tern::YawSample nose = tern::evaluate(*result.yaw, end);
  const double last = tern::evaluate(*result.yaw, tern::duration(*result.yaw)).angle;
  return seconds + ", yaw as planned until then: the plan ends in motion, where the yaw is cut off at " +
         brief(nose.angle) + " rad and " + brief(nose.yaw.rate) + " rad/s, on its way to " + brief(last) + " rad";
}

/// Plans with limits lowered by the reserve, writes the plan's forms, and proves them with the scenario's own limits.
class Export {
 public:
  Export(const ExportOptions& options, const tern_host::Scenario& scenario, const PlanResult& result)
      : options_(options), scenario_(scenario), result_(result) {
    text_ = scenario.name + ": " + std::to_string(result.trajectory.count) + " segments, " + end_text(result) + "\n";
  }

  void add_raw() {
    if (options_.raw.empty() && options_.csv.empty()) return;
    const tern_host::RawForm form = tern_host::crazyflie_raw(result_, origin());
    if (!options_.raw.empty()) outputs_.push_back({options_.raw, form.bytes()});
    if (!options_.csv.empty()) outputs_.push_back({options_.csv, form.csv()});
    add({"raw",
         std::to_string(form.pieces.size()) + " pieces, " + std::to_string(132 * form.pieces.size()) + " bytes of 4096",
         form.error});
  }

  void add_compressed() {
    if (options_.compressed.empty()) return;
    const tern_host::CompressedForm form = tern_host::crazyflie_compressed(result_, origin());
    outputs_.push_back({options_.compressed, form.bytes});
    add({"compressed", std::to_string(form.curve.count) + " pieces, " + std::to_string(form.bytes.size()) + " bytes",
         form.error, &form.curve});
    const tern_host::Figures figures = tern_host::measure(form.curve, scenario_);
    char use[120];
    std::snprintf(use, sizeof use, "%.1f %% of the velocity limits, %.1f %% of the acceleration limits",
                  100.0 * figures.v_use, 100.0 * figures.a_use);
    text_ += std::string("              uses ") + use + "\n";
  }

  void add_streams() {
    if (!options_.mavlink.empty()) {
      const tern_host::SetpointStream stream = tern_host::mavlink_stream(result_, options_.rate, origin());
      outputs_.push_back({options_.mavlink, stream.content});
      add({"mavlink", std::to_string(stream.count) + " frames", stream.error});
    }
    if (!options_.multidof.empty()) {
      const tern_host::SetpointStream stream = tern_host::multidof_yaml(result_, options_.rate, origin());
      outputs_.push_back({options_.multidof, stream.content});
      add({"multidof", std::to_string(stream.count) + " points", stream.error});
    }
  }

  void write() const {
    tern_host::write_files(outputs_);
    std::fputs(text_.c_str(), stdout);
  }

 private:
  tern::Vec3 origin() const { return {options_.origin[0], options_.origin[1], options_.origin[2]}; }

  void add(const Form& form) {
    std::string name = form.name;
    name.resize(12, ' ');
    const std::string proof = proof_of(form);
    text_ += "  " + name + form.size + ", " + error_text(form.error, result_.yaw != nullptr) + "\n              " +
             proof + "\n";
  }

  std::string proof_of(const Form& form) const {
    try {
      if (!(form.error.yaw <= options_.yaw_error)) {
        throw std::runtime_error(
            "turns up to " + brief(form.error.yaw) +
            " rad away from the yaw plan. Plan a slower yaw (yaw_rate, yaw_acceleration), or allow "
            "it with --yaw-error");
      }
      return tern_host::prove_export(scenario_, {result_.trajectory, form.error, form.curve, origin()});
    } catch (const std::runtime_error& error) {
      throw std::runtime_error(scenario_.name + ": the " + form.name + " form " + error.what() +
                               ". Nothing was written");
    }
  }

  const ExportOptions& options_;
  const tern_host::Scenario& scenario_;
  const PlanResult& result_;
  std::vector<tern_host::Output> outputs_;
  std::string text_;
};

/// `what` follows "must be".
CLI::Validator positive(double most, const std::string& what) {
  const auto check = [most, what](const std::string& text) {
    double value = 0.0;
    const bool is_number = tern_host::parse_number(text, value) == tern_host::NumberError::kNone;
    return is_number && value > 0.0 && value <= most ? std::string() : "must be " + what;
  };
  return CLI::Validator(check, "");
}

void check_numbers(const ExportOptions& options) {
  for (const double x : options.origin) {
    if (!std::isfinite(x)) throw std::invalid_argument("--origin must be three finite numbers");
  }
  if (!std::isfinite(options.reserve)) throw std::invalid_argument("--reserve must be a finite number");
}

int export_plan(const ExportOptions& options) {
  check_numbers(options);
  const tern_host::Scenario scenario = tern_host::named_scenario(options.scenario, options.overrides);
  print_warnings(scenario.warnings);
  check_output_paths(tern_host::input_paths(scenario),
                     {options.raw, options.csv, options.compressed, options.mavlink, options.multidof});
  tern_host::Scenario planned = scenario;
  planned.limits = tern_host::scaled(scenario.limits, 1.0 - options.reserve / 100.0);
  const PlanResult result = tern_host::Session().plan(planned);
  if (!result.ok() || result.yaw_status != tern::Status::kOk) {
    std::fputs((result.ok() ? yaw_failure(result) : failure_summary(result)).c_str(), stderr);
    return kExitNoPlan;
  }
  Export forms(options, scenario, result);
  forms.add_raw();
  forms.add_compressed();
  forms.add_streams();
  forms.write();
  return kExitOk;
}

void add_judgement_options(CLI::App& command, ExportOptions& options) {
  command
      .add_option("--origin", options.origin,
                  "The point of the world that becomes 0, in the world's axes: for MAVLink, "
                  "the autopilot's local origin. Numbers are finer near to it")
      ->expected(3)
      ->check(CLI::Number)
      ->type_name("X Y Z");
  command.add_option("--reserve", options.reserve, "Plan with limits lower by this; prove with the scenario's")
      ->check(CLI::Range(0.0, 90.0))
      ->type_name("PERCENT");
  command.add_option("--yaw-error", options.yaw_error, "How far a Crazyflie's yaw may be off the yaw plan")
      ->capture_default_str()
      ->check(positive(std::numeric_limits<double>::max(), "a number of radians above 0"))
      ->type_name("RAD");
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
      ->check(positive(1000.0, "a number above 0, at most 1000"))
      ->type_name("HERTZ");
  add_judgement_options(*command, *options);
  command->add_option("--set", options->overrides, "Replace a setting of the scenario, e.g. --set yaw=motion")
      ->type_name("KEY=VALUE")
      ->expected(1)
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
  command->footer("Files are written all and whole, or not at all: if one form is not proven, none is.");
  command->callback([options, &exit_status] { exit_status = export_plan(*options); });
}

}  // namespace tern_cli
