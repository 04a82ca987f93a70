#!/usr/bin/env bash
# All certificates replay, are made again bit for bit, and those that a second program serves are proved by it too.
set -euo pipefail
cd "$JLT_SOURCE_DIR"
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
jellett check tools/certificates/*.json > "$scratch/out"
[ "$(grep -c ': proved$' "$scratch/out")" -eq "$(ls tools/certificates/*.json | wc -l)" ]
tools/certificates/make "$scratch"
for certificate in tools/certificates/*.json; do cmp "$certificate" "$scratch/${certificate##*/}"; done
for name in sink mixed_attractor roessler_1 symmetric elliptic mixed_island turn_over turn_over_box; do
    python3 tools/check_certificate.py tools/certificates/$name.json
done
