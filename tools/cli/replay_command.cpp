// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include <cstddef>
#include <cstdio>
#include <memory>
#include <stdexcept>
#include <string>

#include "cli/command.hpp"
#include "host/replay.hpp"
#include "host/text_records.hpp"
#include "tern/self_test.hpp"

namespace tern_cli {
namespace {

/// More than any record has.
constexpr std::size_t kMostBytes = std::size_t{1} << 30;

int replay(const std::string& path) {
  tern_host::Replay replayed;
  try {
    replayed = tern_host::replay(tern_host::read_bytes(path, kMostBytes));
  } catch (const std::runtime_error& error) {
    throw std::runtime_error(path + ": " + error.what());
  }
  std::printf("%s: %s", path.c_str(), tern::status_name(replayed.status));
  if (replayed.status == tern::Status::kOk) {
    std::printf(", %d segments in %.3f s", replayed.plan.count, tern::duration(replayed.plan));
  }
  const bool same = replayed.difference.empty();
  std::printf("; %s%s\n", same ? "every bit as recorded" : "differs from the record: ", replayed.difference.c_str());
  if (same) return kExitOk;
  if (replayed.record->configuration != tern::kConfigurationHash) {
    std::printf("the library that recorded has other capacities\n");
  }
  return kExitNoPlan;
}

}  // namespace

void add_replay_command(CLI::App& app, int& exit_status) {
  const auto path = std::make_shared<std::string>();
  CLI::App* const command = app.add_subcommand("replay", "Plan a recorded query again, and compare the bits");
  command->add_option("RECORD", *path, "Record of a query, from `tern plan --record` or tern_record_plan()")
      ->required();
  command->footer("Exit status 3 where the answer differs from the record's.");
  command->callback([path, &exit_status] { exit_status = replay(*path); });
}

}  // namespace tern_cli
