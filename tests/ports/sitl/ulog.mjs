// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// node ulog.mjs LOG: prints the records of some topics of a ULog, a line each, as @foxglove/ulog reads them.
import ulog from "@foxglove/ulog";
import node from "@foxglove/ulog/node.js";

const fields = { trajectory_setpoint: ["position", "velocity"], vehicle_status: ["nav_state"],
  vehicle_local_position: ["x", "y", "z"], vehicle_local_position_groundtruth: ["x", "y", "z"] };
const log = new ulog.ULog(new node.FileReader(process.argv[2]));
await log.open();
const topics = new Map([...log.subscriptions].filter(([, s]) => s.multiId === 0).map(([id, s]) => [id, s.name]));
const lines = {};
for (const name of Object.keys(fields)) lines[name] = [];
for await (const message of log.readMessages()) {
  if (message.type !== ulog.MessageType.Data) continue;
  const name = topics.get(message.msgId);
  if (fields[name] === undefined) continue;
  const numbers = fields[name].flatMap((field) => message.value[field]);
  lines[name].push(`${name} ${message.value.timestamp} ${numbers.map((v) => v.toFixed(6)).join(" ")}`);
}
for (const name of Object.keys(fields)) console.log(lines[name].join("\n"));
