// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The part of the golden corpus that an autopilot plans with the profile fmu to the same bits as every other profile:
// grids that fit into 400 KB together with the workspace, and plans that no capacity changes.
#ifndef TERN_TESTS_GOLDEN_FMU_CORPUS_HPP
#define TERN_TESTS_GOLDEN_FMU_CORPUS_HPP

#include <cstddef>
#include <cstdint>

namespace tern_golden {

/// Workspace and grid together, bytes.
constexpr std::size_t kFmuBytes = 409600;
/// Words of grid storage that each of these scenarios fits in.
constexpr std::size_t kFmuGridWords = 5000;

constexpr std::uint16_t kFmuScenarios[] = {
    0,   7,   8,   9,   11,  12,  13,  14,  15,  16,  18,  19,  20,  21,  23,  26,  27,  30,  31,  32,  33,
    35,  36,  38,  40,  41,  43,  44,  45,  46,  47,  49,  50,  51,  53,  55,  56,  57,  58,  60,  61,  66,
    68,  69,  70,  74,  78,  79,  82,  84,  85,  86,  89,  90,  92,  93,  94,  98,  99,  101, 103, 104, 105,
    107, 108, 110, 111, 114, 115, 119, 120, 121, 122, 123, 124, 127, 129, 130, 131, 132, 133, 136, 137, 138,
    139, 140, 141, 142, 144, 146, 152, 153, 158, 159, 164, 167, 169, 170, 171, 173, 174, 176, 177, 178, 181,
    182, 184, 185, 186, 187, 190, 191, 193, 194, 195, 196, 197, 199, 201, 202, 203, 204, 207, 208, 209, 211,
    212, 217, 219, 220, 222, 223, 225, 229, 230, 232, 235, 236, 237, 238, 239, 241, 242, 243, 244, 246, 247,
    250, 252, 253, 256, 257, 259, 260, 262, 263, 264, 266, 268, 270, 272, 274, 276, 277, 278, 283, 285};
constexpr int kFmuScenarioCount = sizeof kFmuScenarios / sizeof kFmuScenarios[0];

/// The golden hash over these scenarios alone, in their order.
constexpr std::uint64_t kFmuHash = 0xf9ef329faedb1a3du;

inline bool is_fmu_scenario(int index) {
  for (const std::uint16_t scenario : kFmuScenarios) {
    if (scenario == index) return true;
  }
  return false;
}

}  // namespace tern_golden

#endif
