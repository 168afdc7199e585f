// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TERN_CLI_WARNINGS_HPP
#define TERN_CLI_WARNINGS_HPP

#include <cstdio>
#include <string>
#include <vector>

namespace tern_cli {

/// One line each, on standard error.
inline void print_warnings(const std::vector<std::string>& warnings) {
  for (const std::string& warning : warnings) std::fprintf(stderr, "tern: warning: %s\n", warning.c_str());
}

}  // namespace tern_cli

#endif
