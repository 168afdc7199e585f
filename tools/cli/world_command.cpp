// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include <cstdio>
#include <memory>
#include <stdexcept>
#include <string>

#include "cli/command.hpp"
#include "host/atomic_file.hpp"
#include "host/flight/family_scenario.hpp"
#include "host/flight/world_family.hpp"
#include "host/text_records.hpp"

namespace tern_cli {
namespace {

struct WorldOptions {
  std::string name;
  std::string out;
  bool scenario = false;
};

int write_world(const WorldOptions& options) {
  tern_host::FamilyMember member;
  if (!tern_host::parse_member(options.name, member)) {
    throw std::runtime_error(tern_host::quote(options.name) + " is no world of a family, such as P25:7");
  }
  const std::string text = options.scenario ? tern_host::scenario_text(tern_host::read_flight_world(options.name, {}))
                                            : tern_host::world_text(member);
  if (options.out.empty()) {
    std::fputs(text.c_str(), stdout);
  } else {
    tern_host::write_file(options.out, text);
  }
  return kExitOk;
}

}  // namespace

void add_world_command(CLI::App& app, int& exit_status) {
  const auto options = std::make_shared<WorldOptions>();
  CLI::App* const command = app.add_subcommand("world", "Write a world of a family as a file, to change it");
  command->add_option("FAMILY:SEED", options->name, "A random world, e.g. P25:7, or P25@8:7 at 8 m/s")->required();
  command->add_flag("--scenario", options->scenario, "As a scenario for `tern plan`, not as a world for `tern fly`");
  command->add_option("--out", options->out, "Write this file instead of standard output")->type_name("FILE");
  command->callback([options, &exit_status] { exit_status = write_world(*options); });
}

}  // namespace tern_cli
