// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Writes the records of an Onboard's flights to files.
#ifndef TERN_ONBOARD_RECORD_FILES_HPP
#define TERN_ONBOARD_RECORD_FILES_HPP

#include <fstream>
#include <optional>
#include <string>

#include "tern_onboard/onboard.hpp"

namespace tern_onboard {

/// Each flight gets a file flight_SECONDS.record, named by when it began. Not thread-safe, and slow where a disk is:
/// save() from a thread that may wait, several times a second.
class RecordFiles {
 public:
  /// Makes the folder if it is missing, and tells `onboard` to record. An empty name: nothing is recorded. Throws
  /// std::invalid_argument with what is wrong with the folder.
  RecordFiles(Onboard& onboard, const std::string& folder);
  /// Writes what was recorded since the last call. The files are whole after it. Answers what went wrong, once; else
  /// an empty text.
  std::string save();

 private:
  bool write(const RecordPart& part);

  Onboard& onboard_;
  std::string folder_, path_;
  std::ofstream file_;
  std::optional<std::int64_t> begun_;  // of the flight of the file
  bool failed_ = false;
};

}  // namespace tern_onboard

#endif
