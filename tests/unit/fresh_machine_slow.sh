#!/usr/bin/env bash
# Both commands of the README pass on machines that hold nothing but Debian's minimum.
exec "$JLT_SOURCE_DIR/tools/test-fresh"
