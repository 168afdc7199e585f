// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// A stand-in for PX4's header, written from its documentation: what the example needs.
#pragma once

#undef __EXPORT  // newlib has one, too
#define __EXPORT __attribute__((visibility("default")))
