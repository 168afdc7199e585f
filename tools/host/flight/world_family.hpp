// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Families of random worlds to fly through, as in the literature on planning in unknown space.
#ifndef TERN_HOST_FLIGHT_WORLD_FAMILY_HPP
#define TERN_HOST_FLIGHT_WORLD_FAMILY_HPP

#include <cstdint>
#include <string>
#include <vector>

namespace tern_host {

/// One world of a family: "P25:7" is the seventh forest with a tree on 25 m^2, "P25@8:7" the same flown at 8 m/s.
struct FamilyMember {
  std::string family;  ///< one of family_names()
  double speed = 0.0;  ///< limit of velocity, m/s
  std::uint64_t seed = 0;
};

/// P49, P36, P25, P12: forests of thin trees. S05, S10, S20: thick cylinders. C: a hidden corner. B: a bug trap. O: a
/// storey with doors. M: a maze. L, G, I, D: missions. V, F, H, T30, E, R, W, N, Q, X, U: for a camera that is fixed to
/// the body. T1-50 to T1-250, T4, T5-50 to T5-200, B50, B100, CW, RX, MF, HU: things move. Y: a city. docs/simulator.md
/// describes them.
const std::vector<std::string>& family_names();

/// True where the text names a family, with or without a speed. The seed stays as it was.
bool parse_family(const std::string& text, FamilyMember& member);

/// True where the text names one world of a family.
bool parse_member(const std::string& text, FamilyMember& member);

/// The same for what may be a file's path, too. Throws RecordError where it is neither, but reads like a family.
bool is_member(const std::string& path, FamilyMember& member);

/// The world's file: obstacles, limits and seed. Equal members give equal text on every platform.
std::string world_text(const FamilyMember& member);

}  // namespace tern_host

#endif
