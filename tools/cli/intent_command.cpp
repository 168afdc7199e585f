// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include <cstdio>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "cli/command.hpp"
#include "cli/output_paths.hpp"
#include "host/atomic_file.hpp"
#include "host/intent/conflicts.hpp"
#include "host/intent/intent_json.hpp"
#include "host/intent/intent_text.hpp"
#include "host/intent/tube_volumes.hpp"

namespace tern_cli {
namespace {

struct IntentOptions {
  std::string plan;
  std::vector<double> origin;
  double height = 0.0;
  std::string epoch;
  double rest = 0.0;
  tern_host::TubeSettings tube;
  tern_host::UtmEntity intent;
  std::vector<std::string> others;
  std::string json;
};

void check_options(IntentOptions& options) {
  const auto epoch = tern_host::parse_instant(options.epoch);
  if (!epoch) throw std::runtime_error("--epoch must be like 2026-03-01T09:30:00Z, with a time zone");
  options.tube.epoch = *epoch;
  if (!(options.rest >= 0.0 && options.rest <= 86400.0)) throw std::runtime_error("--rest must be 0 to 86400 s");
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

int show_intent(IntentOptions& options) {
  check_options(options);
  std::vector<std::string> inputs = options.others;
  inputs.push_back(options.plan);
  check_output_paths(inputs, {options.json});
  const tern_host::LocalFrame frame({{options.origin[0], options.origin[1]}, options.height});
  tern_host::TimedPath path = tern_host::read_timed_path(options.plan);
  if (options.rest > 0.0) path = tern_host::with_rest(path, options.rest);
  tern_host::UtmEntity& intent = options.intent;
  intent.volumes = tern_host::tube_volumes(path, frame, options.tube);
  const std::vector<tern_host::UtmEntity> others = read_others(options.others);
  const std::vector<tern_host::Conflict> conflicts = tern_host::conflicts_of(intent, others, frame);
  if (!options.json.empty()) tern_host::write_file(options.json, tern_host::intent_json(intent));
  std::fputs(tern_host::volumes_text(intent).c_str(), stdout);
  std::fputs(tern_host::conflicts_text(conflicts, others).c_str(), stdout);
  std::fputs(summary(conflicts, others.size()).c_str(), stdout);
  return tern_host::has_binding(conflicts) ? kExitNoPlan : kExitOk;
}

void add_frame_options(CLI::App& command, IntentOptions& options) {
  command.add_option("--origin", options.origin, "Of the plan's frame, degrees")
      ->type_name("LATITUDE LONGITUDE")
      ->expected(2)
      ->required();
  command.add_option("--height", options.height, "Of the origin above the WGS84 ellipsoid, m")->required();
  command.add_option("--epoch", options.epoch, "When the plan's clock is 0, e.g. 2026-03-01T09:30:00Z")
      ->type_name("TIME")
      ->required();
}

void add_tube_options(CLI::App& command, IntentOptions& options) {
  command.add_option("--looseness", options.tube.looseness, "How far a volume may be from the plan's tube, m")
      ->capture_default_str();
  command.add_option("--longest", options.tube.longest, "How much of the plan a volume may hold, s")
      ->capture_default_str();
  command.add_option("--clock-error", options.tube.clock_error, "By how many seconds the vehicle's clock may be off");
  command.add_option("--rest", options.rest, "How long the vehicle stays where the plan ends, s");
}

}  // namespace

void add_intent_command(CLI::App& app, int& exit_status) {
  const auto options = std::make_shared<IntentOptions>();
  tern_host::UtmEntity& intent = options->intent;
  intent.state = "Accepted";
  CLI::App* const command =
      app.add_subcommand("intent", "Make an operational intent (ASTM F3548) of a plan, and check it against others'");
  command->add_option("PLAN", options->plan, "A plan, as tern plan --json writes it")->required();
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
