// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// What every subcommand of the command line shares. A subcommand is a function that adds itself to the application:
// its options, and a callback that leaves the program's exit status in `exit_status`.
#ifndef TERN_CLI_COMMAND_HPP
#define TERN_CLI_COMMAND_HPP

#include <CLI/CLI.hpp>

namespace tern_cli {

constexpr int kExitOk = 0;
constexpr int kExitRefuted = 1;   ///< verify: a claim is refuted, or not proven
constexpr int kExitBadInput = 2;  ///< wrong usage, a bad file, or an output that cannot be written
constexpr int kExitNoPlan = 3;    ///< the planner answered, and the answer is no

void add_plan_command(CLI::App& app, int& exit_status);
void add_table_command(CLI::App& app, int& exit_status);
void add_fly_command(CLI::App& app, int& exit_status);
void add_solve_command(CLI::App& app, int& exit_status);
void add_map_command(CLI::App& app, int& exit_status);
void add_export_command(CLI::App& app, int& exit_status);
void add_page_command(CLI::App& app, int& exit_status);
void add_replay_command(CLI::App& app, int& exit_status);
void add_verify_command(CLI::App& app, int& exit_status);
void add_airspace_command(CLI::App& app, int& exit_status);
void add_intent_command(CLI::App& app, int& exit_status);
void add_swarm_command(CLI::App& app, int& exit_status);
void add_world_command(CLI::App& app, int& exit_status);

}  // namespace tern_cli

#endif
