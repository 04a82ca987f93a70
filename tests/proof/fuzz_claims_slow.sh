#!/usr/bin/env bash
# Two thousand random tables with random claims: no verdict is contradicted, by a point or by how the claim was made, and
# no prover ends by a fault.
set -euo pipefail
fuzz_claims 2000 1000000
