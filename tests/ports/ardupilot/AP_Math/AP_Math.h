// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// A stand-in for ArduPilot's vectors.
#pragma once

#include <stdint.h>

struct Vector3f {
  float x, y, z;
  Vector3f() : x(0), y(0), z(0) {}
  Vector3f(float x0, float y0, float z0) : x(x0), y(y0), z(z0) {}
};
