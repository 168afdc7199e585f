// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// What must hold of any bytes. Each function returns what is wrong, empty where nothing is. libFuzzer runs them for as
// long as one likes; the tests run them over the kept corpora.
#ifndef TERN_TESTS_FUZZ_FUZZ_CHECKS_HPP
#define TERN_TESTS_FUZZ_FUZZ_CHECKS_HPP

#include <cstddef>
#include <cstdint>
#include <string>

namespace tern_fuzz {

using Check = std::string (*)(const std::uint8_t* data, std::size_t size);

/// A scenario's text: finite numbers and a grid within the capacities, or an error with file and printable reason.
std::string check_scenario(const std::uint8_t* data, std::size_t size);
/// A corridor programme's text: an error, or a verdict whose numbers are finite and within tolerance.
std::string check_solve(const std::uint8_t* data, std::size_t size);
/// A map's spec, and depth images with poses: what is not known to be free is solid in the safe grid.
std::string check_depth(const std::uint8_t* data, std::size_t size);
/// A record: refused, or read and written again with the same bytes. Also with length and checksum put right.
std::string check_record(const std::uint8_t* data, std::size_t size);
/// A grid and a request of any numbers: a plan from start to goal, or a status and an untouched output.
std::string check_request(const std::uint8_t* data, std::size_t size);
/// Zones in any format that is read: fences of finite numbers, or an error with file or reason. Where there is no
/// `tern airspace`, it is no target.
std::string check_airspace(const std::uint8_t* data, std::size_t size);

struct Target {
  const char* name;  ///< of its corpus, too
  Check check;
};
constexpr Target kTargets[] = {{"scenario", check_scenario}, {"solve", check_solve},
                               {"depth", check_depth},       {"record", check_record},
#ifdef TERN_HAS_AIRSPACE
                               {"airspace", check_airspace},
#endif
                               {"request", check_request}};

}  // namespace tern_fuzz

#endif
