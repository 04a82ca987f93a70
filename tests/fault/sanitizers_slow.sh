#!/usr/bin/env bash
# AddressSanitizer and UBSan find nothing in what uses memory, and ThreadSanitizer nothing where there are threads, in a locale that
# writes commas in numbers. The build for ThreadSanitizer is the optimized code of clang, which is held against references too. All
# this takes twenty minutes on two cores, half of it for two builds, in build-asan and build-tsan.
set -euo pipefail
cd "$JLT_SOURCE_DIR"
command -v clang > /dev/null || { echo "needs clang: tools/install-deps --checks"; exit 77; }
locales=$(mktemp -d)
trap 'rm -rf "$locales"' EXIT
localedef -i de_DE -f UTF-8 "$locales/de_DE.UTF-8"
export LOCPATH=$locales LC_ALL=de_DE.UTF-8

part() { # PRESET CTEST-OPTION...
    ctest --preset "$1" -j "$(nproc)" -LE '^slow$' "${@:2}"
}

# What is left out looks at texts or at what is installed, or takes minutes with sanitizers and runs no code that the others do not.
tools/build asan tests_unit tests_property tests_fault
texts='standard_headers|headers_alone|layers|symbols|documentation|widths|completion|clang_warnings'
left="property.(test_(invariant_curves|cancellation|map_batch)|scaled_planes|verify_reproducible|certificates"
left="$left|certificates_(symmetric|homoclinic))"
left="$left|unit.($texts|package|pictures|own_tables|tables_beside|progress|eigen_sweep)"
part asan -L 'unit|property|fault' -E "($left)\$"

tools/build tsan tests_reference property.test_batch_section property.test_batch_methods property.test_batch_memory
numbers='test_(eigen|eigen_digits|integrate_returns|section|tiers|verdicts|external_orbits)|plane_sections|pole_times|section_batch'
part tsan -R "test_batch_(section|methods|memory)\$|^reference.($numbers)\$"
