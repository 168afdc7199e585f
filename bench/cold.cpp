// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The first plan of a process beside the next one. Each scenario is planned in a process of its own, twice: first with
// memory that nothing has touched, so that every page of the workspace and the grid that the plan needs is a fault, and
// then again as a first plan on its map. Page faults are the minor ones of the whole plan, with laying out and marking
// the grid.
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <iterator>
#include <map>
#include <stdexcept>
#include <string>
#include <vector>

#include "host/atomic_file.hpp"
#include "host/session.hpp"
#include "stage_rows.hpp"

namespace {

using tern_bench::kStageRows;
using tern_bench::quantile;

constexpr std::size_t kStages = std::size(kStageRows);
constexpr std::size_t kRows = kStages + 1;

/// Microseconds of each row of kStageRows, and page faults.
struct Sample {
  double row[kRows];
};

/// A scenario's two plans.
struct Pair {
  Sample cold;
  Sample warm;
};

double minor_faults() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_minflt);
}

Sample plan_once(tern_host::Session& session, const tern_host::Scenario& scenario) {
  const double before = minor_faults();
  const tern_host::PlanResult result = session.plan(scenario);
  Sample sample{};
  sample.row[kStages] = minor_faults() - before;
  for (std::size_t k = 0; k < kStages; ++k) sample.row[k] = kStageRows[k].time(result);
  return sample;
}

/// Runs in the child; its exit status says whether the parent gets a pair.
int plan_twice(const tern_host::Scenario& scenario, int out) {
  tern_host::Session session;
  Pair pair{};
  pair.cold = plan_once(session, scenario);
  pair.warm = plan_once(session, scenario);
  return write(out, &pair, sizeof pair) == static_cast<ssize_t>(sizeof pair) ? 0 : 1;
}

Pair in_own_process(const tern_host::Scenario& scenario) {
  int ends[2];
  if (pipe(ends) != 0) throw std::runtime_error("no pipe");
  std::fflush(stdout);
  const pid_t child = fork();
  if (child < 0) throw std::runtime_error("no process");
  if (child == 0) _exit(plan_twice(scenario, ends[1]));
  close(ends[1]);
  Pair pair{};
  const bool read_all = read(ends[0], &pair, sizeof pair) == static_cast<ssize_t>(sizeof pair);
  close(ends[0]);
  int status = 0;
  waitpid(child, &status, 0);
  if (!read_all || status != 0) throw std::runtime_error(scenario.name + ": the process failed");
  return pair;
}

/// The file's name without folder, ending and number: forest_30_012.txt is of the family forest_30.
std::string family_of(const std::string& path) {
  const std::size_t slash = path.rfind('/');
  std::string name = path.substr(slash == std::string::npos ? 0 : slash + 1);
  name = name.substr(0, name.rfind('.'));
  const std::size_t number = name.rfind('_');
  const bool numbered = number != std::string::npos && number + 1 < name.size() &&
                        name.find_first_not_of("0123456789", number + 1) == std::string::npos;
  return numbered ? name.substr(0, number) : name;
}

/// "median,max" of one row.
std::string figures(const std::vector<Pair>& pairs, Sample Pair::*which, std::size_t row) {
  std::vector<double> values;
  values.reserve(pairs.size());
  for (const Pair& pair : pairs) values.push_back((pair.*which).row[row]);
  char text[64];
  std::snprintf(text, sizeof text, "%.1f,%.1f", quantile(values, 0.5), quantile(values, 1.0));
  return text;
}

std::string rows_of(const std::string& family, const std::vector<Pair>& pairs) {
  std::string rows;
  for (std::size_t k = 0; k < kRows; ++k) {
    const std::string name = k < kStages ? kStageRows[k].name : "page faults";
    rows += family + "," + name + "," + figures(pairs, &Pair::cold, k) + "," + figures(pairs, &Pair::warm, k) + "\n";
  }
  return rows;
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app{"The first plan of a process beside the next one."};
  std::vector<std::string> paths;
  std::string csv_file;
  app.add_option("scenarios", paths, "Scenario files")->required()->check(CLI::ExistingFile);
  app.add_option("--csv", csv_file, "Write the table as CSV as well")->type_name("OUT");
  CLI11_PARSE(app, argc, argv);
  try {
    std::map<std::string, std::vector<Pair>> families;
    for (const std::string& path : paths) {
      families[family_of(path)].push_back(in_own_process(tern_host::read_scenario(path)));
    }
    std::string csv = "family,row,cold_median,cold_max,warm_median,warm_max\n";
    for (const auto& [family, pairs] : families) csv += rows_of(family, pairs);
    std::fputs(csv.c_str(), stdout);
    if (!csv_file.empty()) tern_host::write_file(csv_file, csv);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
  return 0;
}
