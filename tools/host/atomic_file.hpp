// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TERN_HOST_ATOMIC_FILE_HPP
#define TERN_HOST_ATOMIC_FILE_HPP

#include <string>

namespace tern_host {

/// Writes a file whole or not at all: a temporary file beside it takes its place once it is complete, so that a reader
/// or a full disk never meets half a file and what was there before is lost only to its successor. A path that is
/// there and no regular file (a terminal, a pipe) is written to directly. Throws std::runtime_error.
void write_file(const std::string& path, const std::string& content);

}  // namespace tern_host

#endif
