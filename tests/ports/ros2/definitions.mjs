// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Writes standins/messages.hpp and standins/fields.hpp from the definitions of ROS 2 Jazzy, with all fields: in a folder in
// which `npm install @foxglove/rosmsg-msgs-common` was run, `node definitions.mjs messages > messages.hpp`, and the same
// for fields.
import { ros2jazzy } from "@foxglove/rosmsg-msgs-common";

const wanted = ["std_msgs/Empty", "std_msgs/UInt8MultiArray", "geometry_msgs/PoseStamped",
  "geometry_msgs/TransformStamped", "nav_msgs/Odometry",
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

/// Calls `each` with a message, after those that it contains.
function walk(name, each) {
  if (written.has(name)) return;
  written.add(name);
  const fields = definition(name);
  for (const field of fields) if (field.isComplex) walk(field.type.replace("/msg/", "/"), each);
  each(...name.split("/"), fields);
}

function writeMessage(space, message, fields) {
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

/// A function that hands each field with its name to `visit`, in the order of the definition.
function writeFields(space, message, fields) {
  console.log(`template <typename Visit>\nvoid each_field(const ${space}::msg::${message}& m, Visit& visit) {`);
  for (const field of fields) if (!field.isConstant) console.log(`  visit("${field.name}", m.${field.name});`);
  console.log("}");
}

const head = `// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//`;

function writeAllFields() {
  console.log(`${head}
// The fields of messages.hpp, one after the other. definitions.mjs wrote this file, and a test compares the two.
#pragma once

#include "messages.hpp"

// clang-format off
namespace tern_test {
template <typename Visit>
void each_field(const builtin_interfaces::msg::Time& m, Visit& visit) {
  visit("sec", m.sec);
  visit("nanosec", m.nanosec);
}
template <typename Visit>
void each_field(const builtin_interfaces::msg::Duration& m, Visit& visit) {
  visit("sec", m.sec);
  visit("nanosec", m.nanosec);
}`);
  wanted.slice(1).forEach((name) => walk(name, writeFields));  // the first one is empty
  console.log(`}  // namespace tern_test`);
}

function writeAllMessages() {
  console.log(`${head}
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
  wanted.forEach((name) => walk(name, writeMessage));
  console.log(`}  // namespace ${open}::msg`);
}

if (process.argv[2] === "messages") writeAllMessages();
if (process.argv[2] === "fields") writeAllFields();
