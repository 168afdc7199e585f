// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Decompression by Debian's liblzf, where the build has it.
#include "host/map/cloud_table.hpp"

#ifdef TERN_HAS_LZF
#include <lzf.h>
#endif

namespace tern_host {

#ifdef TERN_HAS_LZF

std::string unpack(const char* packed, std::size_t packed_size, std::size_t size, const Place& place) {
  std::string bytes(size, '\0');
  if (size == 0) return bytes;
  const unsigned int got =
      lzf_decompress(packed, static_cast<unsigned int>(packed_size), bytes.data(), static_cast<unsigned int>(size));
  if (got != size) throw RecordError(place, "its compressed data are broken: copy the file again");
  return bytes;
}

#else

std::string unpack(const char*, std::size_t, std::size_t, const Place& place) {
  throw RecordError(place,
                    "its data are compressed, and this build is without liblzf: save it as binary or ascii, or install "
                    "liblzf-dev, then configure and build");
}

#endif

}  // namespace tern_host
