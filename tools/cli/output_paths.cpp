// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "cli/output_paths.hpp"

#include <filesystem>
#include <stdexcept>
#include <system_error>

namespace tern_cli {
namespace {

namespace fs = std::filesystem;

bool is_device(const std::string& path) {
  std::error_code error;
  return fs::exists(path, error) && !fs::is_regular_file(path, error);
}

/// Two names of one file: a hard link, or the same path but for links and dots. It need not be there yet.
bool same_file(const std::string& a, const std::string& b) {
  std::error_code error;
  if (fs::equivalent(a, b, error)) return true;
  return fs::weakly_canonical(fs::absolute(a), error) == fs::weakly_canonical(fs::absolute(b), error);
}

}  // namespace

void check_output_paths(const std::vector<std::string>& inputs, const std::vector<std::string>& outputs) {
  for (std::size_t i = 0; i < outputs.size(); ++i) {
    if (outputs[i].empty() || is_device(outputs[i])) continue;
    for (const std::string& input : inputs) {
      if (same_file(outputs[i], input)) throw std::runtime_error(outputs[i] + ": is an input and would be overwritten");
    }
    for (std::size_t j = 0; j < i; ++j) {
      if (!outputs[j].empty() && same_file(outputs[i], outputs[j])) {
        throw std::runtime_error(outputs[i] + ": would be written twice");
      }
    }
  }
}

}  // namespace tern_cli
