#!/bin/sh
# Copyright (c) 2026, the Tern authors
# SPDX-License-Identifier: BSD-3-Clause
#
# definitions_test.sh FOLDER MESSAGES: gets the definitions of ROS 2's messages with npm into FOLDER, compares
# standins/messages.hpp and fields.hpp with what definitions.mjs writes from them, and reads the messages that
# ports_ros2_test wrote to the folder MESSAGES.
set -eu
here=$(dirname "$(realpath "$0")")
mkdir -p "$1"
cd "$1"
if ! command -v npm >/dev/null; then
  echo "skipped: npm is not installed"
  exit 0
fi
if [ ! -d node_modules/@foxglove/rosmsg2-serialization ] &&
  ! npm install --prefix . --no-audit --no-fund --prefer-offline @foxglove/rosmsg-msgs-common@3.2.3 \
    @foxglove/rosmsg2-serialization@3.1.0; then
  echo "skipped: npm cannot get @foxglove/rosmsg-msgs-common and @foxglove/rosmsg2-serialization"
  exit 0
fi
cp "$here/definitions.mjs" "$here/messages.mjs" .
for file in messages fields; do
  node definitions.mjs "$file" >"$file.hpp"
  diff "$file.hpp" "$here/standins/$file.hpp"
done
node messages.mjs "$2"
