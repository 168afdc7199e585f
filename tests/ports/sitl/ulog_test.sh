#!/bin/sh
# Copyright (c) 2026, the Tern authors
# SPDX-License-Identifier: BSD-3-Clause
#
# ulog_test.sh FOLDER LOG...: compares what port/sitl/flight_log.py and npm's @foxglove/ulog read of logs. npm installs
# into FOLDER.
set -eu
here=$(dirname "$(realpath "$0")")
folder=$1
shift
mkdir -p "$folder"
if ! command -v npm >/dev/null; then
  echo "skipped: npm is not installed"
  exit 0
fi
if [ ! -d "$folder/node_modules/@foxglove/ulog" ] &&
  ! npm install --prefix "$folder" --no-audit --no-fund --prefer-offline @foxglove/ulog@2.3.2; then
  echo "skipped: npm cannot get @foxglove/ulog"
  exit 0
fi
cp "$here/ulog.mjs" "$folder"
for log; do
  node "$folder/ulog.mjs" "$log" >"$folder/foxglove.txt"
  python3 -B "$here/ulog.py" "$here/../../../port/sitl" "$log" >"$folder/ours.txt"
  cmp "$folder/foxglove.txt" "$folder/ours.txt"
  echo "$log: $(wc -l <"$folder/ours.txt") records agree"
done
