// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "target/table.hpp"

#include <cinttypes>
#include <cstdarg>
#include <cstdio>

namespace tern_target {
namespace {

__attribute__((format(printf, 1, 2))) std::string format(const char* pattern, ...) {
  char buffer[512];
  va_list arguments;
  va_start(arguments, pattern);
  std::vsnprintf(buffer, sizeof buffer, pattern, arguments);
  va_end(arguments);
  return buffer;
}

bool is_known(const Spread& spread) {
  return spread.max > 0.0;
}

std::string cells(const Spread& spread) {
  if (!is_known(spread)) return format("%14s%14s%14s", "-", "-", "-");
  return format("%14.0f%14.0f%14.0f", spread.median, spread.p99, spread.max);
}

std::string csv_cells(const Spread& spread, double scale, const char* pattern) {
  if (!is_known(spread)) return ",,,";
  std::string out;
  for (const double value : {spread.median, spread.p99, spread.max}) {
    char cell[64];
    std::snprintf(cell, sizeof cell, pattern, scale * value);
    out += std::string(",") + cell;
  }
  return out;
}

std::string csv_row(const std::string& name, const Figures& row) {
  std::string out = name + "," + row.stage + csv_cells(row.nanoseconds, 1e-3, "%.3f");
  out += row.has_work ? format(",%" PRIu64 ",%" PRIu64, row.work, row.bound) : ",,";
  return out + csv_cells(row.cycles, 1.0, "%.0f") + "\n";
}

}  // namespace

std::string table_heading() {
  return format("%-12s%14s%14s%14s%14s%14s%14s%10s%12s\n", "", "median ns", "p99 ns", "max ns", "median cycles",
                "p99 cycles", "max cycles", "work", "bound");
}

std::string table_of(const CaseFigures& figures) {
  std::string out = format("%s, bits %016" PRIx64 "\n", figures.name.c_str(), figures.bits);
  for (const Figures& row : figures.rows) {
    out += format("  %-10s", row.stage) + cells(row.nanoseconds) + cells(row.cycles);
    out += row.has_work ? format("%10" PRIu64 "%20" PRIu64 "\n", row.work, row.bound) : format("%10s%12s\n", "-", "-");
  }
  return out;
}

std::string csv_of(const std::vector<CaseFigures>& cases, const std::vector<std::string>& notes) {
  std::string out;
  for (const std::string& note : notes) out += "# " + note + "\n";
  out += "map,stage,median_us,p99_us,max_us,work,bound,median_cycles,p99_cycles,max_cycles\n";
  for (const CaseFigures& figures : cases) {
    for (const Figures& row : figures.rows) out += csv_row(figures.name, row);
  }
  return out;
}

}  // namespace tern_target
