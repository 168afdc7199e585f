// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include <cinttypes>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <memory>
#include <stdexcept>
#include <string>

#include "cli/command.hpp"
#include "cli/output_paths.hpp"
#include "host/atomic_file.hpp"
#include "host/flight/flight_replay.hpp"
#include "host/page/page.hpp"
#include "host/page/replayed_run.hpp"
#include "host/replay.hpp"
#include "host/swarm/swarm_record.hpp"
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

struct ReplayOptions {
  std::string record, html;
};

int replay_flight(const ReplayOptions& options, const std::string& bytes) {
  const std::string& path = options.record;
  if (!options.html.empty()) {
    const std::string name = path.substr(path.find_last_of('/') + 1);
    tern_host::write_file(options.html, tern_host::page_html({tern_host::replayed_run(name, bytes)}));
  }
  const tern_host::FlightReplay replayed = tern_host::replay_flight(bytes);
  std::printf("%s: %d ticks in %.3f s, %d frames", path.c_str(), replayed.ticks, replayed.seconds, replayed.frames);
  if (replayed.different_ticks > 0) std::printf(", %d ticks differ", replayed.different_ticks);
  return judge(replayed.difference, replayed.configuration);
}

int replay_swarm(const std::string& path, const std::string& bytes) {
  const tern_host::SwarmRecord record = tern_host::read_swarm_record(bytes);
  const std::string difference = tern_host::replay_swarm(record);
  std::size_t ticks = 0;
  for (const tern_host::SwarmRecord::Vehicle& vehicle : record.vehicles) ticks += vehicle.ticks.size();
  std::printf("%s: %s, %zu ticks of %zu vehicles, %zu packets, hash %016" PRIx64, path.c_str(), record.world.c_str(),
              ticks, record.vehicles.size(), record.packets.size(), record.hash());
  return judge(difference, tern::kConfigurationHash);
}

int replay(const ReplayOptions& options) {
  const std::string& path = options.record;
  if (!options.html.empty()) tern_host::check_page(1);
  check_output_paths({path}, {options.html});
  try {
    const std::string bytes = tern_host::read_bytes(path, kMostBytes);
    if (tern_host::is_flight_record(bytes)) return replay_flight(options, bytes);
    if (!options.html.empty()) throw std::runtime_error("--html shows recorded flights, and this is none");
    if (tern_host::is_swarm_record(bytes)) return replay_swarm(path, bytes);
    return replay_plan(path, bytes);
  } catch (const tern_host::RecordError&) {
    throw;
  } catch (const std::exception& error) {
    throw std::runtime_error(path + ": " + error.what());
  }
}

}  // namespace

void add_replay_command(CLI::App& app, int& exit_status) {
  const auto options = std::make_shared<ReplayOptions>();
  CLI::App* const command = app.add_subcommand(
      "replay", "Plan a recorded query or fly a recorded flight or swarm again, and compare the bits");
  command
      ->add_option("RECORD", options->record,
                   "Record of `tern plan --record`, `tern fly --record`, `tern swarm --record`, tern_record_plan() or "
                   "a tern_flight_recorder")
      ->required();
  command->add_option("--html", options->html, "A page of a recorded flight, to turn and play")->type_name("FILE");
  command->footer("Exit status 3 where the answer differs from the record's.");
  command->callback([options, &exit_status] { exit_status = replay(*options); });
}

}  // namespace tern_cli
