// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <memory>
#include <stdexcept>
#include <string>

#include "cli/command.hpp"
#include "host/flight/flight_replay.hpp"
#include "host/replay.hpp"
#include "host/text_records.hpp"
#include "tern/self_test.hpp"

namespace tern_cli {
namespace {

/// More than any record has.
constexpr std::size_t kMostBytes = std::size_t{1} << 30;

/// What stands behind the answer, for both kinds.
int judge(const std::string& difference, std::uint64_t configuration) {
  const bool same = difference.empty();
  std::printf("; %s%s\n", same ? "every bit as recorded" : "differs from the record: ", difference.c_str());
  if (same) return kExitOk;
  if (configuration != tern::kConfigurationHash) std::printf("the library that recorded has other capacities\n");
  return kExitNoPlan;
}

int replay_plan(const std::string& path, const std::string& bytes) {
  const tern_host::Replay replayed = tern_host::replay(bytes);
  std::printf("%s: %s", path.c_str(), tern::status_name(replayed.status));
  if (replayed.status == tern::Status::kOk) {
    std::printf(", %d segments in %.3f s", replayed.plan.count, tern::duration(replayed.plan));
  }
  return judge(replayed.difference, replayed.record->configuration);
}

int replay_flight(const std::string& path, const std::string& bytes) {
  const tern_host::FlightReplay replayed = tern_host::replay_flight(bytes);
  std::printf("%s: %d ticks in %.3f s, %d frames", path.c_str(), replayed.ticks, replayed.seconds, replayed.frames);
  if (replayed.different_ticks > 0) std::printf(", %d ticks differ", replayed.different_ticks);
  return judge(replayed.difference, replayed.configuration);
}

int replay(const std::string& path) {
  try {
    const std::string bytes = tern_host::read_bytes(path, kMostBytes);
    return tern_host::is_flight_record(bytes) ? replay_flight(path, bytes) : replay_plan(path, bytes);
  } catch (const tern_host::RecordError&) {
    throw;
  } catch (const std::runtime_error& error) {
    throw std::runtime_error(path + ": " + error.what());
  }
}

}  // namespace

void add_replay_command(CLI::App& app, int& exit_status) {
  const auto path = std::make_shared<std::string>();
  CLI::App* const command =
      app.add_subcommand("replay", "Plan a recorded query or fly a recorded flight again, and compare the bits");
  command
      ->add_option("RECORD", *path,
                   "Record of `tern plan --record`, `tern fly --record`, tern_record_plan() or a tern_flight_recorder")
      ->required();
  command->footer("Exit status 3 where the answer differs from the record's.");
  command->callback([path, &exit_status] { exit_status = replay(*path); });
}

}  // namespace tern_cli
