// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// What the companion's workspace holds, in megabytes, in the words of docs/architecture.md.
#include "planner/layout.hpp"

#include <cstddef>
#include <cstdio>

namespace {

void print(const char* what, std::size_t bytes) {
  std::printf("| %s | %.2f |\n", what, static_cast<double>(bytes) / 1e6);
}

}  // namespace

int main() {
  using tern::Layout;
  print("`path`, `vias`, `corridor`, `trajectory`",
        sizeof Layout::path + sizeof Layout::vias + sizeof Layout::corridor + sizeof Layout::trajectory);
  print("`calls`, `pipeline`, `ends`, `stops`, `previous`", sizeof Layout::calls + sizeof Layout::pipeline +
                                                                sizeof Layout::ends + sizeof Layout::stops +
                                                                sizeof Layout::previous);
  print("`asked`, `world`", sizeof Layout::asked + sizeof Layout::world);
  print("`stage.search`", sizeof Layout::stage.search);
  print("`stage.reach`", sizeof Layout::stage.reach);
  print("`stage.shortcut`", sizeof Layout::stage.shortcut);
  print("`stage.corridor`", sizeof Layout::stage.corridor);
  print("`stage.trajectory`", sizeof Layout::stage.trajectory);
  print("`stage.check`", sizeof Layout::stage.check);
  return 0;
}
