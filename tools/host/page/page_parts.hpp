// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The files of tools/web and three.js, which the build puts into the program (embed_page.cmake).
#ifndef TERN_HOST_PAGE_PAGE_PARTS_HPP
#define TERN_HOST_PAGE_PAGE_PARTS_HPP

#include <string>

namespace tern_host {

/// The page around its data: a document with `kDataMark` where the data goes.
std::string page_template();
constexpr const char* kDataMark = "@DATA@";

/// Was three.js there when Tern was built?
bool has_three();

}  // namespace tern_host

#endif
