// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TERN_CLI_OUTPUT_PATHS_HPP
#define TERN_CLI_OUTPUT_PATHS_HPP

#include <string>
#include <vector>

namespace tern_cli {

/// Throws std::runtime_error where an output is one of the inputs, or two outputs are one file, under whatever names.
/// Empty outputs are none. Devices and pipes may be named as often as one likes.
void check_output_paths(const std::vector<std::string>& inputs, const std::vector<std::string>& outputs);

}  // namespace tern_cli

#endif
