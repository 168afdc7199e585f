// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The workspace of the profile that this is compiled with, in the README's words.
#include <cstdio>

#include "tern/workspace.hpp"

int main(int, char** argv) {
  constexpr double kBytes = static_cast<double>(tern::kWorkspaceBytes);
  if (kBytes < 1e6) {
    std::printf("| `%s` | %.0f KB |\n", argv[1], kBytes / 1e3);
  } else {
    std::printf(kBytes < 1e7 ? "| `%s` | %.1f MB |\n" : "| `%s` | %.0f MB |\n", argv[1], kBytes / 1e6);
  }
  return 0;
}
