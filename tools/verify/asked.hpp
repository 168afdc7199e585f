// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// What a plan file says that its plan was made for, against what the scenario asks for.
#ifndef TERN_VERIFY_ASKED_HPP
#define TERN_VERIFY_ASKED_HPP

#include "verify/json.hpp"
#include "verify/problem.hpp"

namespace tern_verify {

/// Ends, vias, limits, radius, margin and resolution of a plan file; boundary, blocks and fences are not in it.
Problem asked_of(const Json& plan);

/// In what of these two differ first, in words; empty where they are the same.
std::string difference(const Problem& a, const Problem& b);

}  // namespace tern_verify

#endif
