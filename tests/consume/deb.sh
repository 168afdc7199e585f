#!/bin/sh
# Copyright (c) 2026, the Tern authors
# SPDX-License-Identifier: BSD-3-Clause
#
# deb.sh CPACK BUILD FOLDER PROJECT [PYTHON]: makes the Debian package of BUILD, unpacks it below FOLDER, and uses what is
# in it: the command line, the library for CMake and for a Makefile, the Python package, licence and documentation.
set -eu
cpack=$1 build=$2 folder=$3 project=$4 python=${5:-}

rm -rf "$folder"
mkdir -p "$folder/root" "$folder/make"
(cd "$build" && "$cpack" -G DEB -B "$folder" >"$folder/cpack.log") || { cat "$folder/cpack.log"; exit 1; }
dpkg-deb --info "$folder"/*.deb
dpkg-deb --extract "$folder"/*.deb "$folder/root"
usr=$folder/root/usr

"$usr/bin/tern" --version
cmp "$usr/share/doc/tern/LICENSE" "$project/../../../LICENSE"
test -s "$usr/share/doc/tern/docs/architecture.md"
cmake -S "$project" -B "$folder/project" -DCMAKE_PREFIX_PATH="$usr" -DCMAKE_BUILD_TYPE=Release >/dev/null
cmake --build "$folder/project" >/dev/null
ctest --test-dir "$folder/project" --output-on-failure
pc=$(dirname "$(find "$usr" -name tern.pc)")
(cd "$folder/make" && PKG_CONFIG_PATH=$pc make -f "$project/Makefile")
if [ -n "$python" ]; then
  library=$(find "$usr" -name libtern_shared.so)
  PYTHONPATH=$usr/lib/python3/dist-packages TERN_LIBRARY=$library "$python" -c "import tern; print(tern.__file__)"
fi
