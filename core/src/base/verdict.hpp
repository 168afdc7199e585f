// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TERN_BASE_VERDICT_HPP
#define TERN_BASE_VERDICT_HPP

#include "tern/status.hpp"

namespace tern {

/// The result of checking an input: kOk, or why it is refused and which field is at fault.
struct Verdict {
  Status status;
  Field field;
};

constexpr Verdict kAccepted{Status::kOk, Field::kNone};

}  // namespace tern

#endif
