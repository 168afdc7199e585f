// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The scenario parser under libFuzzer, for as long as one likes:
//   cmake --preset fuzz && cmake --build --preset fuzz && build/fuzz/tests/fuzz/scenario_fuzzer bench/maps
#include <cstdint>
#include <cstdio>
#include <cstdlib>

#include "fuzz/scenario_check.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string text(data, data + size);
  bool accepted = false;
  const std::string wrong = tern_fuzz::check_scenario_text(text, accepted);
  if (!wrong.empty()) {
    std::fprintf(stderr, "%s\n", wrong.c_str());
    std::abort();
  }
  return 0;
}
