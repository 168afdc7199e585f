// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// A stand-in for ArduPilot's vectors.
#pragma once

#include <math.h>
#include <stddef.h>
#include <stdint.h>

struct Vector3f {
  float x, y, z;
  Vector3f() : x(0), y(0), z(0) {}
  Vector3f(float x0, float y0, float z0) : x(x0), y(y0), z(z0) {}
  Vector3f operator+(const Vector3f& v) const { return Vector3f(x + v.x, y + v.y, z + v.z); }
  Vector3f operator-(const Vector3f& v) const { return Vector3f(x - v.x, y - v.y, z - v.z); }
  float length() const { return sqrtf(x * x + y * y + z * z); }
};
