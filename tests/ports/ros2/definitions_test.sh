#!/bin/sh
# Copyright (c) 2026, the Tern authors
# SPDX-License-Identifier: BSD-3-Clause
#
# definitions_test.sh FOLDER: gets the definitions of ROS 2's messages with npm into FOLDER, and compares
# standins/messages.hpp with what definitions.mjs writes from them.
set -eu
here=$(dirname "$(realpath "$0")")
mkdir -p "$1"
cd "$1"
if ! command -v npm >/dev/null; then
  echo "skipped: npm is not installed"
  exit 0
fi
if [ ! -d node_modules/@foxglove/rosmsg-msgs-common ] &&
  ! npm install --prefix . --no-audit --no-fund --prefer-offline @foxglove/rosmsg-msgs-common@3.2.3; then
  echo "skipped: npm cannot get @foxglove/rosmsg-msgs-common"
  exit 0
fi
cp "$here/definitions.mjs" .
node definitions.mjs >messages.hpp
diff messages.hpp "$here/standins/messages.hpp"
