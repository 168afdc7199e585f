// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TERN_BASE_VERDICT_HPP
#define TERN_BASE_VERDICT_HPP

#include "tern/status.hpp"

namespace tern {

/// Whether an input is accepted; if not, why, and which field the refusal is about.
struct Verdict {
  Status status;
  Field field;
};

constexpr Verdict kAccepted{Status::kOk, Field::kNone};

}  // namespace tern

#endif
