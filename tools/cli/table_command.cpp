// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include <sys/stat.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <memory>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "cli/command.hpp"
#include "cli/output_paths.hpp"
#include "cli/summary.hpp"
#include "cli/warnings.hpp"
#include "host/atomic_file.hpp"
#include "host/flight/family_scenario.hpp"
#include "host/page/page.hpp"
#include "host/picture/picture.hpp"
#include "host/plan_file.hpp"
#include "host/plan_rows.hpp"

namespace tern_cli {
namespace {

constexpr double kCsvStep = 0.01;

struct TableOptions {
  std::vector<std::string> scenarios;
  std::string folder;
  std::string html;
  std::string rows;
  int repeat = 5;
  std::vector<std::string> overrides;
};

std::string base_name(const std::string& path) {
  const std::string file = path.substr(path.find_last_of('/') + 1);
  return file.substr(0, file.rfind(".txt"));
}

void make_folder(const std::string& folder) {
  if (mkdir(folder.c_str(), 0777) == 0 || errno == EEXIST) return;
  throw std::runtime_error(folder + ": cannot be made: " + std::strerror(errno));
}

void write_outputs(const std::string& stem, const tern_host::PlanResult& result) {
  std::vector<tern_host::Output> outputs = {{stem + ".json", tern_host::plan_json(result)},
                                            {stem + ".svg", tern_host::plan_svg(result)}};
  if (result.ok())
    outputs.push_back({stem + ".csv", tern_host::trajectory_csv(result.trajectory, kCsvStep, result.yaw.get())});
  tern_host::write_files(outputs);
}

/// Files of equal name from two folders would overwrite each other's plans.
void check_outputs(const TableOptions& options) {
  std::vector<std::string> outputs;
  for (const std::string& file : options.scenarios) {
    if (options.folder.empty()) break;
    for (const char* const kind : {".json", ".svg", ".csv"}) {
      outputs.push_back(options.folder + "/" + base_name(file) + kind);
    }
  }
  outputs.push_back(options.html);
  outputs.push_back(options.rows);
  check_output_paths(options.scenarios, outputs);
}

/// The plan is the same bits each time; its times are not. Returns the one whose total is the median.
tern_host::PlanResult plan_repeatedly(tern_host::Session& session, const tern_host::Scenario& scenario, int times) {
  std::vector<tern_host::PlanResult> results;
  for (int i = 0; i < times; ++i) results.push_back(session.plan(scenario));
  const auto faster = [](const tern_host::PlanResult& a, const tern_host::PlanResult& b) {
    return a.timing.total() < b.timing.total();
  };
  const auto median = results.begin() + times / 2;
  std::nth_element(results.begin(), median, results.end(), faster);
  return std::move(*median);
}

int table(const TableOptions& options) {
  if (!options.html.empty()) tern_host::check_page(options.scenarios.size());
  if (!options.folder.empty()) make_folder(options.folder);
  check_outputs(options);
  tern_host::Session session;
  int exit_status = kExitOk;
  std::vector<std::string> runs;
  std::string rows = tern_host::plan_rows_header();
  std::fputs(table_header().c_str(), stdout);
  for (const std::string& file : options.scenarios) {
    const tern_host::Scenario scenario = tern_host::named_scenario(file, options.overrides);
    print_warnings(scenario.warnings);
    const tern_host::PlanResult result = plan_repeatedly(session, scenario, options.repeat);
    if (!result.ok()) exit_status = kExitNoPlan;
    std::fputs(table_row(base_name(file), result).c_str(), stdout);
    if (!options.folder.empty()) write_outputs(options.folder + "/" + base_name(file), result);
    if (!options.rows.empty()) rows += tern_host::plan_row(result);
    if (!options.html.empty()) runs.push_back(tern_host::plan_run(result));
  }
  if (!options.html.empty()) tern_host::write_file(options.html, tern_host::page_html(runs));
  if (!options.rows.empty()) tern_host::write_file(options.rows, rows);
  return exit_status;
}

}  // namespace

void add_table_command(CLI::App& app, int& exit_status) {
  const auto options = std::make_shared<TableOptions>();
  CLI::App* const command = app.add_subcommand("table", "Plan several scenarios and print one row for each");
  command->add_option("SCENARIO", options->scenarios, "Scenario files (docs/formats.md), or FAMILY:SEED, e.g. P25:7")
      ->required();
  command->add_option("--out", options->folder, "Write each plan, table and picture into this folder")
      ->type_name("FOLDER");
  command->add_option("--html", options->html, "Write a page with all plans side by side in 3D (docs/page.md)")
      ->type_name("FILE");
  command->add_option("--rows", options->rows, "Write one line of CSV for each scenario, without times")
      ->type_name("FILE");
  command->add_option("--repeat", options->repeat, "Plans of each scenario; the one of median time is shown")
      ->capture_default_str()
      ->check(CLI::Range(1, 1000), "")
      ->type_name("N");
  command->add_option("--set", options->overrides, "Replace a setting in all scenarios, as for `tern plan`")
      ->type_name("KEY=VALUE")
      ->expected(1)
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
  command->footer("Exit status 3 where any scenario has no plan.");
  command->callback([options, &exit_status] { exit_status = table(*options); });
}

}  // namespace tern_cli
