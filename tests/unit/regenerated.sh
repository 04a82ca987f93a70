#!/usr/bin/env bash
# generated/ is, byte for byte, what the tables of codegen/models say.
TTC=$JLT_BINARY_DIR/bin/ttc exec "$JLT_SOURCE_DIR/tools/regenerate" --check
