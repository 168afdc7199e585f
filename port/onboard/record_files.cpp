// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "tern_onboard/record_files.hpp"

#include <sys/stat.h>

#include <cstdio>
#include <stdexcept>

namespace tern_onboard {

RecordFiles::RecordFiles(Onboard& onboard, const std::string& folder) : onboard_(onboard), folder_(folder) {
  if (folder.empty()) return;
  struct stat found {};
  mkdir(folder.c_str(), 0777);
  if (stat(folder.c_str(), &found) != 0 || !S_ISDIR(found.st_mode)) {
    throw std::invalid_argument("the folder \"" + folder +
                                "\" for records is refused: it is no folder, and cannot be made");
  }
  onboard.record_flights();
}

std::string RecordFiles::save() {
  if (folder_.empty()) return {};
  for (const RecordPart& part : onboard_.take_record()) {
    if (failed_ || write(part)) continue;
    failed_ = true;
    return path_ + " cannot be written: flights are not recorded any more. Is the disk full?";
  }
  return {};
}

bool RecordFiles::write(const RecordPart& part) {
  if (begun_ != part.begun) {
    char name[64];
    std::snprintf(name, sizeof name, "/flight_%.3f.record", 1e-9 * static_cast<double>(part.begun));
    begun_ = part.begun;
    path_ = folder_ + name;
    file_ = std::ofstream(path_, std::ios::binary | std::ios::trunc);
  } else {
    file_.seekp(-static_cast<std::streamoff>(kRecordEnd), std::ios::end);
  }
  file_.write(reinterpret_cast<const char*>(part.bytes.data()), static_cast<std::streamsize>(part.bytes.size()));
  return static_cast<bool>(file_.flush());
}

}  // namespace tern_onboard
