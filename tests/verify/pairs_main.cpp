// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// tern_track_pairs SEED COUNT: the core's proofs of random plans beside random tracks, against exact numbers, for
// `tools/prove --pairs`. Prints the cases that fail, and then how many were proven, refused and failed.
#include <cstdio>
#include <cstdlib>

#include "exact_pair.hpp"

int main(int argc, char** argv) {
  if (argc != 3) {
    std::fprintf(stderr, "usage: tern_track_pairs SEED COUNT\n");
    return 2;
  }
  const unsigned long long seed = std::strtoull(argv[1], nullptr, 10);
  const int count = std::atoi(argv[2]);
  tern_test::Random random(seed);
  int proven = 0, refused = 0, failed = 0;
  for (int i = 0; i < count; ++i) {
    tern_test::TrackPair pair = tern_test::random_pair(random);
    tern_test::hold_pieces(pair);
    const tern_verify::PairFinding finding = tern_verify::prove_exactly(pair);
    proven += finding.proven ? 1 : 0;
    refused += finding.refused ? 1 : 0;
    failed += finding.is_unsound || finding.is_timid ? 1 : 0;
    if (finding.is_unsound) std::printf("seed %llu, case %d: proven, but not so\n", seed, i);
    if (finding.is_timid) std::printf("seed %llu, case %d: refused, with room\n", seed, i);
  }
  std::printf("%d %d %d\n", proven, refused, failed);
  return failed > 0 ? 1 : 0;
}
