// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include <cstdio>
#include <fstream>
#include <sstream>

#include "attack/runner.hpp"

namespace tern_attack {
namespace {

using Row = std::vector<std::string>;

std::string joined(const std::map<std::string, std::uint64_t>& counts) {
  std::string text;
  for (const auto& entry : counts) {
    text += (text.empty() ? "" : ", ") + entry.first + " " + std::to_string(entry.second);
  }
  return text.empty() ? "none" : text;
}

Row row_of(const char* name, const Tally& t, const std::map<std::string, std::uint64_t>& violations) {
  std::map<std::string, std::uint64_t> refused;
  for (int s = 1; s < 256; ++s) {
    if (t.status[s] != 0) refused[tern::status_name(static_cast<tern::Status>(s))] = t.status[s];
  }
  return {name,
          std::to_string(t.cases),
          std::to_string(t.plans),
          std::to_string(t.replans),
          std::to_string(t.needed),
          std::to_string(t.compared),
          std::to_string(t.status[0]),
          std::to_string(t.optimised) + " / " + std::to_string(t.stop_and_go) + " / " + std::to_string(t.hover) +
              " / " + std::to_string(t.followed),
          std::to_string(t.plans == 0 ? 0 : t.work / t.plans),
          joined(refused),
          joined(violations)};
}

std::vector<Row> rows_of(const Options& options, const Progress& progress) {
  std::vector<Row> rows{{"family", "cases", "plans", "replans among them", "replans that needed the previous plan",
                         "compared", "ok", "optimised / stop-and-go / hover / previous", "units a plan", "refused",
                         "violations"}};
  Tallies all{};
  std::map<std::string, std::uint64_t> sum;
  for (int f = 0; f < kFamilies; ++f) {
    if (options.family >= 0 && f != options.family) continue;
    std::map<std::string, std::uint64_t> violations;
    for (const Violation& v : progress.violations) {
      if (static_cast<int>(family_of(v.number)) != f) continue;
      ++violations[v.kind];
      ++sum[v.kind];
    }
    const Tally& t = progress.tallies[static_cast<std::size_t>(f)];
    rows.push_back(row_of(family_name(static_cast<Family>(f)), t, violations));
    Tallies one{};
    one[0] = t;
    add(one, all);
  }
  rows.push_back(row_of("all", all[0], sum));
  return rows;
}

std::string markdown(const Options& options, const Progress& progress) {
  std::ostringstream out;
  bool head = true;
  for (const Row& row : rows_of(options, progress)) {
    out << '|';
    for (const std::string& cell : row) out << ' ' << cell << " |";
    out << '\n';
    if (head) {
      for (std::size_t k = 0; k < row.size(); ++k) out << "| --- ";
      out << "|\n";
    }
    head = false;
  }
  std::uint64_t cases = 0;
  for (const Tally& t : progress.tallies) cases += t.cases;
  char line[160];
  std::snprintf(line, sizeof line, "\nSeed %llu: %llu cases in %.0f s, %.0f cases/s, %zu violations.\n",
                static_cast<unsigned long long>(options.seed), static_cast<unsigned long long>(cases), progress.seconds,
                static_cast<double>(cases) / std::max(1e-3, progress.seconds), progress.violations.size());
  return out.str() + line;
}

}  // namespace

void print_table(const Options& options, const Progress& progress) {
  std::printf("%s", markdown(options, progress).c_str());
}

void write_tables(const Options& options, const Progress& progress) {
  if (options.folder.empty()) return;
  const std::string path = state_path(options);
  std::ofstream(path + ".md") << markdown(options, progress);
  std::ofstream csv(path + ".csv");
  for (const Row& row : rows_of(options, progress)) {
    for (std::size_t k = 0; k < row.size(); ++k) csv << (k > 0 ? "," : "") << '"' << row[k] << '"';
    csv << '\n';
  }
  std::ofstream lines(path + ".violations.txt");
  for (const Violation& v : progress.violations) lines << violation_line(options, v) << '\n';
}

}  // namespace tern_attack
