// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Whether the target has registers of 16 bytes for several numbers. Where it has none, compilers keep vector types in
// memory and copy them at each step, so plain structures and loops with the same results take their place.
#ifndef TERN_BASE_VECTORS_HPP
#define TERN_BASE_VECTORS_HPP

#if defined(__SSE2__) || defined(__aarch64__) || defined(__wasm_simd128__)
#define TERN_HAS_VECTORS 1
#else
#define TERN_HAS_VECTORS 0
#endif

#endif
