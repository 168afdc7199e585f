// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TERN_TESTS_SUPPORT_OWN_FOLDER_HPP
#define TERN_TESTS_SUPPORT_OWN_FOLDER_HPP

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <string>
#include <system_error>

namespace tern_test {

/// A folder of this process alone, with a slash at its end; removed when the process ends. Tests run side by side.
inline const std::string& own_folder() {
  static const struct Folder {
    Folder() { std::filesystem::create_directories(path); }
    ~Folder() {
      std::error_code ignored;
      std::filesystem::remove_all(path, ignored);
    }
    std::string path = testing::TempDir() + "tern_" + std::to_string(getpid()) + "/";
  } folder;
  return folder.path;
}

}  // namespace tern_test

#endif
