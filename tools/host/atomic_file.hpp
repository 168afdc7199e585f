// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TERN_HOST_ATOMIC_FILE_HPP
#define TERN_HOST_ATOMIC_FILE_HPP

#include <string>
#include <vector>

namespace tern_host {

struct Output {
  std::string path;
  std::string content;
};

/// Writes files whole or not at all: temporary files beside them take their places once all are complete. A full disk
/// leaves what was there before. A path that is there and no regular file (a terminal, a pipe) is written to directly,
/// and "-" is standard output. Throws std::runtime_error.
void write_files(const std::vector<Output>& outputs);
void write_file(const std::string& path, const std::string& content);

/// Standard output is for files named "-" alone: what else is printed there goes to standard error from now on. Throws
/// std::runtime_error.
void keep_standard_output_for_files();

}  // namespace tern_host

#endif
