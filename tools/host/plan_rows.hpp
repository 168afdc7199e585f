// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TERN_HOST_PLAN_ROWS_HPP
#define TERN_HOST_PLAN_ROWS_HPP

#include <string>

#include "host/session.hpp"

namespace tern_host {

/// A table of many plans as CSV: one line each, without times, so that equal plans give equal lines. docs/formats.md
/// names the columns.
std::string plan_rows_header();
std::string plan_row(const PlanResult& result);

}  // namespace tern_host

#endif
