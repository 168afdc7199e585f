// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "paper/run.hpp"

#include <algorithm>
#include <cstdio>
#include <ctime>
#include <fstream>
#include <stdexcept>
#include <thread>

#include "host/atomic_file.hpp"

namespace tern_bench {
namespace {

std::string processor() {
  std::ifstream file("/proc/cpuinfo");
  for (std::string line; std::getline(file, line);) {
    const std::size_t colon = line.find(": ");
    if (line.compare(0, 10, "model name") == 0 && colon != std::string::npos) return line.substr(colon + 2);
  }
  return "unknown processor";
}

std::string today() {
  const std::time_t now = std::time(nullptr);
  char text[16];
  std::strftime(text, sizeof text, "%Y-%m-%d", std::gmtime(&now));
  return text;
}

/// What the figures were measured on.
std::string machine() {
  return processor() + ", " + std::to_string(std::thread::hardware_concurrency()) + " cores, gcc " __VERSION__ ", " +
         today();
}

}  // namespace

tern_host::Scenario paper_map(int number) {
  return tern_host::read_scenario(std::string(TERN_MAPS_DIR) + "/map" + std::to_string(number) + ".txt");
}

void progress(const std::string& message) {
  std::fprintf(stderr, "  %s\n", message.c_str());
}

Table::Table(const std::string& columns)
    : columns_(1 + static_cast<std::size_t>(std::count(columns.begin(), columns.end(), ','))), text_(columns + "\n") {}

void Table::row(const std::vector<std::string>& values) {
  if (values.size() != columns_) throw std::logic_error("a row of another width than its table");
  for (const std::string& value : values) {
    if (value.find(',') != std::string::npos) throw std::logic_error("a comma within a value: " + value);
  }
  for (std::size_t i = 0; i < values.size(); ++i) text_ += (i > 0 ? "," : "") + values[i];
  text_ += "\n";
}

void Table::write(const Run& run, const std::string& name) const {
  tern_host::write_file(run.folder + "/" + name, "# " + machine() + (run.quick ? ", quick run" : "") + "\n" + text_);
}

}  // namespace tern_bench
