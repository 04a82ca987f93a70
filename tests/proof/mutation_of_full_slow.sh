#!/usr/bin/env bash
# Every term of the top in all its coordinates matters to some claim (a minute and a half).
exec ttc prove --mutate "$JLT_SOURCE_DIR/codegen/models/spherical_top_full.tt"
