// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cerrno>
#include <cinttypes>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <exception>
#include <iostream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "cli/command.hpp"
#include "host/atomic_file.hpp"
#include "host/text_records.hpp"
#include "tern/self_test.hpp"

namespace {

std::string version_text() {
  char hash[17];
  std::snprintf(hash, sizeof hash, "%016" PRIx64, tern::configuration_hash());
  return std::string("tern ") + TERN_VERSION + "\nprofile " + TERN_PROFILE_NAME + "\nconfiguration " + hash;
}

/// `--set a=1 b=2` as `--set a=1 --set b=2`, so that the option takes several values and still no positional argument.
/// In reverse order, as CLI11 wants it.
std::vector<std::string> reversed_arguments(int argc, char** argv) {
  std::vector<std::string> arguments;
  bool setting = false;
  for (int i = 1; i < argc; ++i) {
    const std::string argument = argv[i];
    const bool further =
        setting && arguments.back() != "--set" && argument[0] != '-' && argument.find('=') != std::string::npos;
    if (further) arguments.push_back("--set");
    setting = argument == "--set" || further || (setting && arguments.back() == "--set");
    arguments.push_back(argument);
  }
  std::reverse(arguments.begin(), arguments.end());
  return arguments;
}

/// A word where the command belongs that is none: CLI11 would only ask for a command.
void check_command(const CLI::App& app, int argc, char** argv) {
  if (argc < 2 || argv[1][0] == '-') return;
  std::string names;
  for (const CLI::App* command : app.get_subcommands([](const CLI::App*) { return true; })) {
    if (command->get_name() == argv[1]) return;
    names += (names.empty() ? "" : ", ") + command->get_name();
  }
  throw std::runtime_error("there is no command " + tern_host::quote(argv[1]) + "; the commands are: " + names);
}

/// A file named "-" is standard output, which then has nothing else in it.
void make_way_for_files(const std::vector<std::string>& arguments) {
  if (std::find(arguments.begin(), arguments.end(), "-") != arguments.end()) {
    tern_host::keep_standard_output_for_files();
  }
}

/// A full disk shows only once what was printed is written.
void flush_output() {
  std::cout.flush();
  if (std::fflush(stdout) != 0 || std::ferror(stdout) != 0) {
    throw std::runtime_error(std::string("standard output: cannot be written: ") + std::strerror(errno));
  }
}

int run(int argc, char** argv) {
  CLI::App app("Tern plans safe, smooth trajectories for multirotors through maps of obstacles.", "tern");
  app.footer(
      "Exit status: 0 where there is a plan, 2 for wrong usage or a bad file, 3 where there is no plan (solve: no "
      "verdict).\n"
      "verify: 1 where a claim is refuted or not proven.\n"
      "`tern COMMAND --help` explains a command; docs/tools.md and docs/formats.md explain all of them.");
  app.set_version_flag("--version", version_text(), "Print version, capacity profile and configuration hash");
  app.require_subcommand(1);
  app.failure_message([](const CLI::App* command, const CLI::Error& error) {
    return "tern: " + CLI::FailureMessage::simple(command, error);
  });
  int exit_status = tern_cli::kExitOk;
  tern_cli::add_plan_command(app, exit_status);
  tern_cli::add_table_command(app, exit_status);
  tern_cli::add_fly_command(app, exit_status);
  tern_cli::add_solve_command(app, exit_status);
  tern_cli::add_map_command(app, exit_status);
  tern_cli::add_export_command(app, exit_status);
  tern_cli::add_page_command(app, exit_status);
  tern_cli::add_replay_command(app, exit_status);
#ifdef TERN_HAS_VERIFY
  tern_cli::add_verify_command(app, exit_status);
#endif
  tern_cli::add_swarm_command(app, exit_status);
  tern_cli::add_world_command(app, exit_status);
#ifdef TERN_HAS_AIRSPACE
  tern_cli::add_airspace_command(app, exit_status);
  tern_cli::add_intent_command(app, exit_status);
#endif
  check_command(app, argc, argv);
  std::vector<std::string> arguments = reversed_arguments(argc, argv);
  make_way_for_files(arguments);
  try {
    app.parse(std::move(arguments));
  } catch (const CLI::ParseError& error) {
    exit_status = app.exit(error) == 0 ? tern_cli::kExitOk : tern_cli::kExitBadInput;
  }
  flush_output();
  return exit_status;
}

}  // namespace

int main(int argc, char** argv) {
  // A limit on file sizes is then an error of write(), which cleans up, and no end in the middle of a file.
  std::signal(SIGXFSZ, SIG_IGN);
  try {
    return run(argc, argv);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "tern: %s\n", error.what());
    return tern_cli::kExitBadInput;
  }
}
