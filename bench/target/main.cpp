// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// tern_target_bench: how long each stage takes on this machine, from one file that needs nothing beside it. Copied to a
// board and run there; docs/timing.md says how to read and hand in what it writes.
#include <CLI/CLI.hpp>
#include <algorithm>
#include <cinttypes>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <exception>
#include <memory>
#include <string>
#include <vector>

#include "golden/corpus_run.hpp"
#include "golden/golden_hash.hpp"
#include "host/atomic_file.hpp"
#include "target/embedded.hpp"
#include "target/machine.hpp"
#include "target/realtime.hpp"
#include "target/table.hpp"

namespace {

constexpr int kExitOk = 0;
constexpr int kExitWrong = 1;  // the self-test, the golden bits, a plan, or the file
constexpr int kExitUsage = 2;

struct Options {
  int repetitions = 100;
  int processor = -1;
  std::vector<std::string> cases;
  std::string csv;
  std::string expected;  // hexadecimal; empty: the recorded hash
};

std::vector<std::string> names_of(const std::vector<tern_host::Scenario>& scenarios) {
  std::vector<std::string> out;
  for (const tern_host::Scenario& scenario : scenarios) out.push_back(scenario.name);
  return out;
}

/// Is this machine one on which Tern computes what it computes everywhere?
bool same_bits_as_everywhere(const Options& options) {
  std::uint32_t faults = 0;
  if (tern::self_test(tern::configuration_hash(), &faults) != tern::Status::kOk) {
    std::printf("self-test: FAILED, faults 0x%" PRIx32 "\n", faults);
    return false;
  }
  const auto memory = std::make_unique<tern_golden::Memory>();
  const auto ignore = [](int, tern::Status, const tern::Report&, std::uint64_t) {};
  const std::uint64_t hash = tern_golden::run_corpus(*memory, ignore).hash;
  const std::uint64_t expected =
      options.expected.empty() ? tern_golden::kGoldenHash : std::strtoull(options.expected.c_str(), nullptr, 16);
  const bool equal = hash == expected;
  std::printf("self-test: ok\ngolden bits of %d scenarios: %016" PRIx64 ", expected %016" PRIx64 ": %s\n",
              tern_golden::kScenarioCount, hash, expected, equal ? "equal" : "DIFFERENT");
  return equal;
}

std::string today() {
  char text[16];
  const std::time_t now = std::time(nullptr);
  std::strftime(text, sizeof text, "%Y-%m-%d", std::gmtime(&now));
  return text;
}

/// Heading of the table and of the file.
std::vector<std::string> notes_of(const Options& options, const tern_target::Realtime& realtime, bool has_cycles) {
  std::vector<std::string> out = tern_target::lines_of(tern_target::describe_machine(realtime.processor));
  out.push_back("real time: " + tern_target::describe(realtime));
  out.push_back(has_cycles ? "cycles: perf_event_open, user space, in plans of their own"
                           : "cycles: not permitted here (/proc/sys/kernel/perf_event_paranoid, or no counter)");
  out.push_back(today() + ", " + std::to_string(options.repetitions) + " plans a row, microseconds in the file");
  return out;
}

bool is_wanted(const Options& options, const std::string& name) {
  return options.cases.empty() || std::find(options.cases.begin(), options.cases.end(), name) != options.cases.end();
}

void run(const Options& options, const std::vector<tern_host::Scenario>& scenarios) {
  // Memory first: what is locked is locked with it.
  tern_target::Measurement measurement;
  const tern_target::Realtime realtime = tern_target::request_realtime(options.processor);
  const std::vector<std::string> notes = notes_of(options, realtime, measurement.has_cycles());
  for (const std::string& note : notes) std::printf("%s\n", note.c_str());
  std::printf("\n%s", tern_target::table_heading().c_str());
  std::vector<tern_target::CaseFigures> cases;
  for (const tern_host::Scenario& scenario : scenarios) {
    if (!is_wanted(options, scenario.name)) continue;
    cases.push_back(measurement.measure(scenario, options.repetitions));
    std::printf("%s", tern_target::table_of(cases.back()).c_str());
    std::fflush(stdout);
  }
  if (!options.csv.empty()) tern_host::write_file(options.csv, tern_target::csv_of(cases, notes));
}

std::string is_hash(const std::string& text) {
  const bool holds = text.size() == 16 && text.find_first_not_of("0123456789abcdef") == std::string::npos;
  return holds ? "" : "not 16 hexadecimal digits: " + text;
}

void add_options(CLI::App& app, Options& options, const std::vector<tern_host::Scenario>& scenarios) {
  app.add_option("--repetitions", options.repetitions, "Plans a row")
      ->capture_default_str()
      ->check(CLI::Range(1, 1000000), "")
      ->type_name("N");
  app.add_option("--cpu", options.processor, "Processor to run on; the last one allowed where not given")
      ->check(CLI::NonNegativeNumber, "")
      ->type_name("N");
  app.add_option("--case", options.cases, "Only this scenario; may be repeated")
      ->check(CLI::IsMember(names_of(scenarios)))
      ->type_name("NAME");
  app.add_option("--csv", options.csv, "Write the table for bench/results/<board>/stages.csv")->type_name("FILE");
  app.add_option("--expect", options.expected, "Golden bits of another version, instead of this one's own")
      ->check(CLI::Validator(is_hash, ""))
      ->type_name("HEX");
  app.footer(
      "Exit status: 0; 1 where the self-test fails, a plan's bits are not the expected ones or the file cannot be\n"
      "written; 2 for wrong usage. Run it as root for SCHED_FIFO, locked memory and cycles.");
}

}  // namespace

int main(int argc, char** argv) {
  const std::vector<tern_host::Scenario> scenarios = tern_target::embedded_scenarios();
  Options options;
  CLI::App app("Times of Tern's stages on this machine", "tern_target_bench");
  add_options(app, options, scenarios);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? kExitOk : kExitUsage;
  }
  try {
    if (!same_bits_as_everywhere(options)) return kExitWrong;
    run(options, scenarios);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "tern_target_bench: %s\n", error.what());
    return kExitWrong;
  }
  return kExitOk;
}
