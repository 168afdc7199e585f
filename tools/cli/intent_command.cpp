// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>
#include <cstdio>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "cli/command.hpp"
#include "cli/output_paths.hpp"
#include "cli/warnings.hpp"
#include "host/atomic_file.hpp"
#include "host/flight/family_scenario.hpp"
#include "host/intent/conflicts.hpp"
#include "host/intent/intent_frame.hpp"
#include "host/intent/intent_json.hpp"
#include "host/intent/intent_operator.hpp"
#include "host/intent/intent_text.hpp"
#include "host/intent/replan.hpp"
#include "host/intent/tube_volumes.hpp"
#include "host/map/map_files.hpp"
#include "host/plan_file.hpp"

namespace tern_cli {
namespace {

struct IntentOptions {
  std::string plan;
  std::string scenario;
  std::vector<std::string> operators;
  std::vector<std::string> overrides;
  std::vector<double> origin;
  double height = NAN;
  double height_amsl = NAN;
  double undulation = NAN;
  tern_host::ToldFrame told;
  double rest = NAN;
  tern_host::TubeSettings tube;
  double longest_delay = 3600.0;
  tern_host::UtmEntity intent;
  std::vector<std::string> others;
  std::string json;
  std::string plan_json;
};

void check_frame(IntentOptions& options) {
  tern_host::EarthFrame& frame = options.told.frame;
  if (!options.origin.empty()) frame.origin = tern_host::EarthOrigin{options.origin[0], options.origin[1]};
  if (!std::isnan(options.height)) frame.height = options.height;
  if (!std::isnan(options.height_amsl)) options.told.heights.origin_sea_level = options.height_amsl;
  if (!std::isnan(options.undulation)) options.told.heights.undulation = options.undulation;
  if (!frame.epoch.empty() && !tern_host::parse_instant(frame.epoch)) {
    throw std::runtime_error("--epoch must be like 2026-03-01T09:30:00Z, with a time zone");
  }
}

void check_options(IntentOptions& options) {
  const int given =
      (options.plan.empty() ? 0 : 1) + (options.scenario.empty() ? 0 : 1) + (options.operators.empty() ? 0 : 1);
  if (given != 1) throw std::runtime_error("give a PLAN, --scenario or --operators, and one of them alone");
  if (!options.plan.empty() && !(options.plan_json.empty() && options.overrides.empty())) {
    throw std::runtime_error("--plan and --set need --scenario: a PLAN is made already");
  }
  if (!options.operators.empty() && !(options.plan_json.empty() && options.json.empty())) {
    throw std::runtime_error("--operators writes no files: leave out --json and --plan");
  }
  if (!options.operators.empty() && !options.intent.id.empty()) {
    throw std::runtime_error("--operators names each intent after its scenario's file: leave out --id");
  }
  check_frame(options);
  if (options.rest < 0.0 || options.rest > 86400.0) throw std::runtime_error("--rest must be 0 to 86400 s");
  if (!(options.longest_delay >= 0.0 && options.longest_delay <= 1e6)) {
    throw std::runtime_error("--longest-delay must be 0 to 1000000 s");
  }
  options.intent.id = tern_host::entity_id(options.intent.id);
  const std::string& id = options.intent.id;
  if (id.empty() && !options.json.empty()) throw std::runtime_error("--json needs --id, the intent's UUID");
  if (!id.empty() && !tern_host::is_entity_id(id)) {
    throw std::runtime_error("--id must be a UUID of version 4, such as 2f8343be-6482-4d1b-a474-16847e01af1e");
  }
  const std::string& state = options.intent.state;
  if (state != "Accepted" && state != "Activated") {
    throw std::runtime_error("--state must be Accepted or Activated: a plan is never off nominal");
  }
}

std::vector<tern_host::UtmEntity> read_others(const std::vector<std::string>& paths) {
  std::vector<tern_host::UtmEntity> all;
  for (const std::string& path : paths) {
    for (tern_host::UtmEntity& entity : tern_host::read_utm_file(path)) all.push_back(std::move(entity));
  }
  return all;
}

std::string summary(const std::vector<tern_host::Conflict>& conflicts, std::size_t others) {
  if (others == 0) return "";
  const std::string count = std::to_string(conflicts.size());
  return (conflicts.empty() ? "no conflict" : count + (conflicts.size() == 1 ? " conflict" : " conflicts")) + " with " +
         std::to_string(others) + " of others\n";
}

int report(const IntentOptions& options, const tern_host::UtmEntity& intent,
           const std::vector<tern_host::UtmEntity>& others, const tern_host::ZoneHeights& heights,
           std::vector<tern_host::Output> outputs) {
  const std::vector<tern_host::Conflict> conflicts = tern_host::conflicts_of(intent, others, heights.frame());
  if (!options.json.empty()) outputs.push_back({options.json, tern_host::intent_json(intent)});
  tern_host::write_files(outputs);
  std::fputs(tern_host::volumes_text(intent, heights).c_str(), stdout);
  std::fputs(tern_host::conflicts_text(conflicts, others).c_str(), stdout);
  std::fputs(summary(conflicts, others.size()).c_str(), stdout);
  return tern_host::has_binding(conflicts) ? kExitNoPlan : kExitOk;
}

/// The frame of options and file; the epoch goes to the settings of volumes.
tern_host::IntentFrame frame_of(IntentOptions& options, const tern_host::EarthFrame& in_file, const std::string& file) {
  tern_host::IntentFrame frame = tern_host::intent_frame(options.told, in_file, file);
  options.tube.epoch = frame.epoch;
  return frame;
}

/// The vehicle stays as long as the plan's end is clear, unless it is told otherwise.
double rest_of(const IntentOptions& options, double in_file) {
  return std::isnan(options.rest) ? in_file : options.rest;
}

int show_plan(IntentOptions& options) {
  std::vector<std::string> inputs = options.others;
  inputs.push_back(options.plan);
  check_output_paths(inputs, {options.json});
  tern_host::TimedPath path = tern_host::read_timed_path(options.plan);
  const tern_host::IntentFrame frame = frame_of(options, path.earth, options.plan);
  const double rest = rest_of(options, path.rest);
  if (rest > 0.0) path = tern_host::with_rest(path, rest);
  options.intent.volumes = tern_host::tube_volumes(path, frame.heights.frame(), options.tube);
  return report(options, options.intent, read_others(options.others), frame.heights, {});
}

/// Plans, and gives way where that must be.
int show_scenario(IntentOptions& options) {
  const tern_host::Scenario scenario = tern_host::named_scenario(options.scenario, options.overrides);
  print_warnings(scenario.warnings);
  std::vector<std::string> inputs = options.others;
  for (const std::string& path : tern_host::input_paths(scenario)) inputs.push_back(path);
  check_output_paths(inputs, {options.json, options.plan_json});
  const tern_host::IntentFrame frame = frame_of(options, scenario.earth, options.scenario);
  const std::vector<tern_host::UtmEntity> others = read_others(options.others);
  tern_host::Session session;
  const std::vector<tern_host::Proposal> proposals =
      tern_host::proposals_of(session, scenario, options.intent, others, frame.heights.frame(),
                              {options.tube, rest_of(options, scenario.rest_clear), options.longest_delay});
  const tern_host::Proposal* const best = tern_host::best_of(proposals);
  std::FILE* const to = best == nullptr ? stderr : stdout;
  std::fputs(tern_host::proposals_text(proposals).c_str(), to);
  if (best == nullptr) return kExitNoPlan;
  std::vector<tern_host::Output> outputs;
  if (!options.plan_json.empty()) outputs.push_back({options.plan_json, tern_host::plan_json(best->result)});
  return report(options, best->intent, others, frame.heights, outputs);
}

/// Each scenario is an operator's. All write to one store in memory.
int show_operators(IntentOptions& options) {
  constexpr int kRounds = 10;
  std::vector<tern_host::Scenario> scenarios;
  for (const std::string& file : options.operators) {
    scenarios.push_back(tern_host::named_scenario(file, options.overrides));
  }
  const tern_host::IntentFrame earth = frame_of(options, scenarios[0].earth, options.operators[0]);
  const tern_host::LocalFrame& frame = earth.heights.frame();
  tern_host::IntentStore store(frame);
  for (tern_host::UtmEntity& entity : read_others(options.others)) {
    entity.ovn.clear();  // it is new to this store
    const bool is_new = store.put(entity, key_of(store.relevant(entity))).accepted;
    if (!is_new) throw std::runtime_error("--others: " + entity.id + " is there twice");
  }
  std::vector<tern_host::IntentOperator> operators;
  for (std::size_t i = 0; i < scenarios.size(); ++i) {
    tern_host::check_same_frame(earth, scenarios[i].earth, options.operators[i]);
    tern_host::UtmEntity like = options.intent;
    like.id = options.operators[i];
    operators.emplace_back(
        scenarios[i], like, frame,
        tern_host::ReplanSettings{options.tube, rest_of(options, scenarios[i].rest_clear), options.longest_delay});
  }
  std::string log;
  const bool all = tern_host::plan_until_accepted(operators, store, kRounds, log);
  std::fputs(log.c_str(), stdout);
  return all ? kExitOk : kExitNoPlan;
}

int show_intent(IntentOptions& options) {
  check_options(options);
  if (!options.operators.empty()) return show_operators(options);
  return options.scenario.empty() ? show_plan(options) : show_scenario(options);
}

void add_frame_options(CLI::App& command, IntentOptions& options) {
  command
      .add_option("--origin", options.origin, "Of the plan's frame, degrees (default: as the plan or scenario says)")
      ->type_name("LATITUDE LONGITUDE")
      ->expected(2);
  CLI::Option* const height =
      command.add_option("--height", options.height, "Of the origin above the WGS84 ellipsoid, m (default: likewise)");
  command.add_option("--height-amsl", options.height_amsl, "Of the origin above mean sea level, m")->excludes(height);
  CLI::Option* const undulation = command.add_option(
      "--undulation", options.undulation, "Mean sea level above the WGS84 ellipsoid, m: heights are printed AMSL, too");
  command.add_option("--geoid", options.told.heights.geoid_file, "The same by a geoid, such as egm96-5.pgm")
      ->type_name("FILE")
      ->excludes(undulation);
  command
      .add_option("--epoch", options.told.frame.epoch,
                  "When the plan's clock is 0, e.g. 2026-03-01T09:30:00Z (default: as the plan or scenario says)")
      ->type_name("TIME");
}

void add_tube_options(CLI::App& command, IntentOptions& options) {
  command.add_option("--looseness", options.tube.looseness, "How far a volume may be from the plan's tube, m")
      ->capture_default_str();
  command.add_option("--longest", options.tube.longest, "How much of the plan a volume may hold, s")
      ->capture_default_str();
  command.add_option("--clock-error", options.tube.clock_error, "By how many seconds the vehicle's clock may be off");
  command.add_option("--rest", options.rest,
                     "How long the vehicle stays where the plan ends, s (default: rest_clear of the plan or scenario)");
}

void add_scenario_options(CLI::App& command, IntentOptions& options) {
  command.add_option("--scenario", options.scenario, "Plan this, and give way where that must be")->type_name("FILE");
  command
      .add_option("--operators", options.operators,
                  "Let an operator for each of these scenarios plan until all are accepted by a store in memory")
      ->type_name("FILE")
      ->expected(1, 100);
  command.add_option("--set", options.overrides, "Replace a setting of the scenario, as for tern plan")
      ->type_name("KEY=VALUE")
      ->expected(1)
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
  command.add_option("--longest-delay", options.longest_delay, "How much later the flight may begin, s")
      ->capture_default_str();
  command.add_option("--plan", options.plan_json, "Write the plan that gives way")->type_name("FILE");
}

}  // namespace

void add_intent_command(CLI::App& app, int& exit_status) {
  const auto options = std::make_shared<IntentOptions>();
  tern_host::UtmEntity& intent = options->intent;
  intent.state = "Accepted";
  CLI::App* const command =
      app.add_subcommand("intent", "Make an operational intent (ASTM F3548) of a plan, and check it against others'");
  command->add_option("PLAN", options->plan, "A plan, as tern plan --json writes it");
  add_scenario_options(*command, *options);
  add_frame_options(*command, *options);
  add_tube_options(*command, *options);
  command->add_option("--others", options->others, "Operational intents and constraints of others")
      ->type_name("FILE")
      ->expected(1, 1000);
  command->add_option("--id", intent.id, "The intent's UUID; others with it are its earlier versions");
  command->add_option("--manager", intent.manager, "Who answers for the intent, as others know it");
  command->add_option("--base-url", intent.base_url, "Of the service that answers questions about it");
  command->add_option("--priority", intent.priority, "The larger goes first")->capture_default_str();
  command->add_option("--state", intent.state, "Accepted or Activated")->capture_default_str();
  command->add_option("--json", options->json, "Write the operational intent")->type_name("FILE");
  command->callback([options, &exit_status] { exit_status = show_intent(*options); });
}

}  // namespace tern_cli
