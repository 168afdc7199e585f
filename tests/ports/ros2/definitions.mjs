// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Writes standins/messages.hpp from the definitions of ROS 2 Jazzy, with all fields: in a folder in which
// `npm install @foxglove/rosmsg-msgs-common` was run, `node definitions.mjs > messages.hpp`.
import { ros2jazzy } from "@foxglove/rosmsg-msgs-common";

const wanted = ["std_msgs/Empty", "geometry_msgs/PoseStamped", "geometry_msgs/TransformStamped", "nav_msgs/Odometry",
  "nav_msgs/Path", "sensor_msgs/CameraInfo", "sensor_msgs/Image", "sensor_msgs/PointCloud2",
  "trajectory_msgs/MultiDOFJointTrajectory", "visualization_msgs/MarkerArray", "diagnostic_msgs/DiagnosticArray"];
const plain = { bool: "bool", byte: "std::uint8_t", char: "std::uint8_t", float32: "float", float64: "double",
  string: "std::string", time: "builtin_interfaces::msg::Time", duration: "builtin_interfaces::msg::Duration" };
for (const bits of [8, 16, 32, 64]) {
  plain[`int${bits}`] = `std::int${bits}_t`;
  plain[`uint${bits}`] = `std::uint${bits}_t`;
}

function definition(name) {
  const found = ros2jazzy[name] ?? ros2jazzy[name.replace("/", "/msg/")];
  if (found === undefined) throw new Error(`no definition of ${name}`);
  return found.definitions;
}

function typeOf(field) {
  const one = plain[field.type] ?? field.type.replace("/msg/", "/").replace("/", "::msg::");
  if (!field.isArray) return one;
  return field.arrayLength === undefined ? `std::vector<${one}>` : `std::array<${one}, ${field.arrayLength}>`;
}

const written = new Set();
let open = "builtin_interfaces";
function enter(space) {
  if (space === open) return console.log("");
  console.log(`}  // namespace ${open}::msg\n\nnamespace ${space}::msg {`);
  open = space;
}

function write(name) {
  if (written.has(name)) return;
  written.add(name);
  const fields = definition(name);
  for (const field of fields) if (field.isComplex) write(field.type.replace("/msg/", "/"));
  const [space, message] = name.split("/");
  enter(space);
  console.log(`struct ${message} {`);
  for (const field of fields) {
    if (field.isConstant && field.type !== "string") {
      console.log(`  static constexpr ${typeOf(field)} ${field.name} = ${field.value};`);
    } else if (!field.isConstant) {
      console.log(`  ${typeOf(field)} ${field.name}{${field.defaultValue ?? ""}};`);
    }
  }
  console.log("};");
}

console.log(`// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The messages of ROS 2 Jazzy that port/ros uses, with all their fields. definitions.mjs wrote this file, and a test
// compares the two.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

// clang-format off
namespace builtin_interfaces::msg {
struct Time {
  std::int32_t sec{};
  std::uint32_t nanosec{};
};
struct Duration {
  std::int32_t sec{};
  std::uint32_t nanosec{};
};`);
wanted.forEach(write);
console.log(`}  // namespace ${open}::msg`);
