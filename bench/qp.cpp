// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The solver alone on corridor programmes: one row a number of segments, over all files that are given.
//   tern_bench_qp [--csv OUT] [--repeat N] FILE...
#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <map>
#include <string>
#include <vector>

#include "host/atomic_file.hpp"
#include "host/corridor_solver.hpp"
#include "quantile.hpp"

namespace {

using tern_bench::quantile;
using tern_host::CorridorAnswers;

/// What is tabulated of all programmes with one number of segments.
struct Column {
  std::vector<double> cold;
  std::vector<double> warm;
  std::vector<double> iterations;
  std::vector<double> warm_iterations;
  std::vector<double> active;
  double residual = 0.0;
  int undecided = 0;
};

double median(const std::vector<double>& values) {
  return quantile(values, 0.5);
}

double most(const std::vector<double>& values) {
  return quantile(values, 1.0);
}

bool decided(tern::Status status) {
  return status == tern::Status::kOk || status == tern::Status::kInfeasible;
}

void add(const CorridorAnswers& answers, Column& column) {
  column.cold.push_back(answers.cold.time_us);
  column.warm.push_back(answers.warm.time_us);
  column.iterations.push_back(answers.cold.iterations);
  column.warm_iterations.push_back(answers.warm.iterations);
  column.active.push_back(answers.cold.active);
  if (answers.cold.status == tern::Status::kOk) column.residual = std::max(column.residual, answers.cold.residual);
  column.undecided += decided(answers.cold.status) && decided(answers.warm.status) ? 0 : 1;
}

double most_of_ten(const std::vector<double>& values) {
  return quantile(values, 0.9);
}

std::string format(const char* row, int segments, const Column& c) {
  char text[256];
  std::snprintf(text, sizeof text, row, segments, c.cold.size(), median(c.cold), most_of_ten(c.cold), most(c.cold),
                median(c.warm), most_of_ten(c.warm), most(c.warm), median(c.iterations), most_of_ten(c.iterations),
                most(c.iterations), median(c.warm_iterations), most(c.warm_iterations), median(c.active),
                most_of_ten(c.active), most(c.active), c.residual, c.undecided);
  return text;
}

void print(const std::map<int, Column>& columns) {
  std::printf("%4s%7s%28s%25s%20s%12s%18s%11s%11s\n", "M", "cases", "cold us: median p90 max", "warm us: same",
              "iterations: same", "warm (max)", "active: same", "residual", "undecided");
  for (const auto& [segments, column] : columns) {
    const char* const row =
        "%4d%7zu%10.2f%9.1f%9.1f%9.2f%8.1f%8.1f%8.0f%6.0f%6.0f%6.0f (%3.0f)%7.0f%5.0f%6.0f%11.1e%11d\n";
    std::fputs(format(row, segments, column).c_str(), stdout);
  }
}

std::string csv(const std::map<int, Column>& columns) {
  std::string text =
      "segments,cases,cold_median_us,cold_p90_us,cold_max_us,warm_median_us,warm_p90_us,warm_max_us,iterations_median,"
      "iterations_p90,iterations_max,warm_iterations_median,warm_iterations_max,active_median,active_p90,active_max,"
      "kkt_residual,undecided\n";
  for (const auto& [segments, column] : columns) {
    const char* const row = "%d,%zu,%.2f,%.2f,%.2f,%.2f,%.2f,%.2f,%.0f,%.0f,%.0f,%.0f,%.0f,%.0f,%.0f,%.0f,%.1e,%d\n";
    text += format(row, segments, column);
  }
  return text;
}

void measure(const std::vector<std::string>& files, int repeat, const std::string& csv_file) {
  tern_host::CorridorSolver solver;
  std::map<int, Column> columns;
  for (const std::string& file : files) {
    const tern_host::CorridorCase c = tern_host::read_corridor_case(file);
    add(solver.solve(c, repeat), columns[c.segments]);
  }
  print(columns);
  if (!csv_file.empty()) tern_host::write_file(csv_file, csv(columns));
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app("Times of the solver on corridor programmes, cold and with the start shifted.");
  std::vector<std::string> files;
  std::string csv_file;
  int repeat = 50;
  app.add_option("FILE", files, "Corridor programmes (docs/formats.md)")->required();
  app.add_option("--csv", csv_file, "Write the table as CSV as well")->type_name("OUT");
  app.add_option("--repeat", repeat, "Solves of each; the fastest counts")
      ->capture_default_str()
      ->check(CLI::Range(1, 100000));
  CLI11_PARSE(app, argc, argv);
  try {
    measure(files, repeat, csv_file);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 2;
  }
  return 0;
}
