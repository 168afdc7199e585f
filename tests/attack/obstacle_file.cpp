// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "attack/obstacle_file.hpp"

#include <fstream>
#include <sstream>
#include <stdexcept>

namespace tern_attack {

std::vector<SolidRun> read_runs(const std::string& path) {
  std::ifstream file(path);
  if (!file) throw std::runtime_error(path + ": cannot be opened");
  std::vector<SolidRun> runs;
  std::string line;
  for (int number = 1; std::getline(file, line); ++number) {
    if (line.compare(0, 4, "run ") != 0) continue;
    SolidRun run{};
    if (!(std::istringstream(line.substr(4)) >> run.begin >> run.end >> run.y >> run.z)) {
      throw std::runtime_error(path + ":" + std::to_string(number) + ": 'run' needs 4 whole numbers");
    }
    runs.push_back(run);
  }
  return runs;
}

void write_runs(const std::string& path, const std::vector<SolidRun>& runs) {
  std::ofstream file(path);
  for (const SolidRun& run : runs) {
    file << "run " << run.begin << ' ' << run.end << ' ' << run.y << ' ' << run.z << '\n';
  }
  if (!file.flush()) throw std::runtime_error(path + ": cannot be written");
}

}  // namespace tern_attack
