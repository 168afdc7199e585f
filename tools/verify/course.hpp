// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The course that a flight's commands take: which of its commits is flown, and when.
#ifndef TERN_VERIFY_COURSE_HPP
#define TERN_VERIFY_COURSE_HPP

#include "verify/claim.hpp"
#include "verify/flight.hpp"

namespace tern_verify {

/// Commit number `commit` goes on as what is flown is at its takeover; the first one from rest at the start.
void prove_takeover(const Flight& flight, std::size_t commit, Claims& claims);

/// Where the status says so, the flight ends at rest at the goal.
void prove_goal(const Flight& flight, Claims& claims);

/// At the simulator's ticks: commands were those of the commits, the vehicle kept its margin, which all proofs assume,
/// and touched nothing. Throws InputError where the log's figures are better than its track; where they are worse, they
/// count.
void prove_flown(const Flight& flight, const std::vector<Solid>& solids, Claims& claims);

}  // namespace tern_verify

#endif
