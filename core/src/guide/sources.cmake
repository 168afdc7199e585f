# Copyright (c) 2026, the Tern authors
# SPDX-License-Identifier: BSD-3-Clause
set(TERN_STAGE_SOURCES
  block_map.cpp block_parts.cpp block_search.cpp block_words.cpp guided_extract.cpp guided_search.cpp page_store.cpp pocket.cpp
  split_blocks.cpp voxel_search.cpp)
