// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// messages.mjs FOLDER: reads the messages that message_files.hpp wrote with Foxglove's decoder for ROS 2 and the
// definitions of ROS 2 Jazzy, compares each field with the list beside it, and writes the message again: the bytes must be
// the same. For a folder in which npm has installed both packages.
import { readdirSync, readFileSync } from "node:fs";
import { parse } from "@foxglove/rosmsg";
import { ros2jazzy } from "@foxglove/rosmsg-msgs-common";
import { MessageReader, MessageWriter } from "@foxglove/rosmsg2-serialization";

// PX4's, which npm does not have.
const px4 = {
  "px4_msgs/OffboardControlMode": "uint64 timestamp\nbool position\nbool velocity\nbool acceleration\nbool attitude\n" +
    "bool body_rate\nbool thrust_and_torque\nbool direct_actuator\n",
  "px4_msgs/TrajectorySetpoint": "uint64 timestamp\nfloat32[3] position\nfloat32[3] velocity\nfloat32[3] acceleration\n" +
    "float32[3] jerk\nfloat32 yaw\nfloat32 yawspeed\n",
};

/// The definitions of a message and of all that it contains, itself first.
function definitionsOf(name, found = new Map()) {
  const definition = px4[name] === undefined ? ros2jazzy[name] : parse(px4[name], { ros2: true })[0];
  if (definition === undefined) throw new Error(`no definition of ${name}`);
  found.set(name, { name, definitions: definition.definitions });
  for (const field of definition.definitions) {
    if (field.isComplex && !found.has(field.type)) definitionsOf(field.type, found);
  }
  return found;
}

function text(type, value) {
  if (!type.startsWith("float")) return String(type === "bool" ? Number(value) : value);
  const bits = new DataView(new ArrayBuffer(8));
  bits.setFloat64(0, value);
  return bits.getBigUint64(0).toString(16).padStart(16, "0");
}

/// The lines of a message, as message_files.hpp writes them.
function list(all, name, message, path, lines) {
  for (const field of all.get(name).definitions.filter((one) => !one.isConstant)) {
    const put = (value, at) => {
      if (field.isComplex) list(all, field.type, value, `${at}.`, lines);
      else if (field.type === "time" || field.type === "duration") lines.push(`${at}.sec ${value.sec}`, `${at}.nanosec ${value.nanosec}`);
      else lines.push(`${at} ${text(field.type, value)}`);
    };
    const value = message[field.name], at = path + field.name;
    if (!field.isArray) put(value, at);
    if (field.isArray && field.arrayLength === undefined) lines.push(`${at} ${value.length}`);
    if (field.isArray) value.forEach((one, k) => put(one, `${at}[${k}]`));
  }
  return lines;
}

const folder = process.argv[2];
const files = readdirSync(folder).filter((file) => file.endsWith(".cdr"));
if (files.length !== 10) throw new Error(`${files.length} messages in ${folder}, and not 10`);
for (const file of files) {
  const name = file.slice(0, -4).replace(".", "/");
  const all = definitionsOf(name), definitions = [...all.values()];
  const bytes = new Uint8Array(readFileSync(`${folder}/${file}`));
  const reader = new MessageReader(definitions);
  const message = reader.readMessage(bytes);
  const wanted = readFileSync(`${folder}/${file.slice(0, -4)}.txt`, "utf8").trimEnd().split("\n");
  const found = list(all, name, message, "", []);
  const k = wanted.findIndex((line, index) => line !== found[index]);
  if (k >= 0 || found.length !== wanted.length) throw new Error(`${name}: "${wanted[k]}" was written, "${found[k]}" read`);
  if (reader.lastReadHadTrailingBytes()) throw new Error(`${name}: bytes are left`);
  const again = new MessageWriter(definitions).writeMessage(message);
  if (Buffer.compare(again, bytes) !== 0) throw new Error(`${name}: written again, it has other bytes`);
  console.log(`${name}: ${found.length} fields, ${bytes.length} bytes`);
}
