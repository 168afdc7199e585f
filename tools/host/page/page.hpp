// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Plans and flights as one page of HTML with everything in it (docs/page.md). A run is one of them, as the text of a
// JSON object.
#ifndef TERN_HOST_PAGE_PAGE_HPP
#define TERN_HOST_PAGE_PAGE_HPP

#include <string>
#include <vector>

#include "host/session.hpp"

namespace tern_host {

/// The plan, or how far it came, as a run.
std::string plan_run(const PlanResult& result);

/// The page that shows these runs side by side, `1 .. kMaxRuns` of them. Throws std::runtime_error for another number,
/// and where Tern was built without three.js.
std::string page_html(const std::vector<std::string>& runs);

/// Throws what page_html would throw for so many runs, before anything is planned for it.
void check_page(std::size_t runs);

/// The runs of a page that page_html made. Throws std::runtime_error where the text is no such page.
std::vector<std::string> runs_of_page(const std::string& html, const std::string& name);

/// Views that still have room beside each other.
constexpr std::size_t kMaxRuns = 12;

}  // namespace tern_host

#endif
