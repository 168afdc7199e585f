// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The kept corpora in every build, whole and cut short: what the fuzzers found interesting stays right.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <vector>

#include "fuzz/fuzz_checks.hpp"

namespace {

using Bytes = std::vector<std::uint8_t>;

Bytes read(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  return Bytes(std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>());
}

class Corpus : public ::testing::TestWithParam<tern_fuzz::Target> {};

TEST_P(Corpus, Holds) {
  const tern_fuzz::Target& target = GetParam();
  std::size_t files = 0;
  for (const auto& entry :
       std::filesystem::directory_iterator(std::string(TERN_SOURCE_DIR) + "/tests/fuzz/corpus/" + target.name)) {
    const Bytes bytes = read(entry.path());
    EXPECT_EQ(target.check(bytes.data(), bytes.size()), "") << entry.path();
    EXPECT_EQ(target.check(bytes.data(), bytes.size() / 2), "") << "the first half of " << entry.path();
    ++files;
  }
  EXPECT_GE(files, 3u);
}

INSTANTIATE_TEST_SUITE_P(Targets, Corpus, ::testing::ValuesIn(tern_fuzz::kTargets),
                         [](const auto& test) { return std::string(test.param.name); });

}  // namespace
