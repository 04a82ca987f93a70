#!/usr/bin/env bash
# Includes point one way: a folder of src/ includes only folders listed above it, codegen/ likewise, and nothing of src/, generated/
# and codegen/runtime/, which is copied there, only libc (Arb in ball files, vector instructions in lanes); src/top/command_* are
# commands of src/cli; tools/bench/program stands below src/cli; src/jellett.h, which no file includes, may include what src/scene
# may; outside libraries are called from their one place; no include goes in a circle, and no files call each other in one.
set -euo pipefail
awk() { LC_ALL=C command awk "$@"; } # numbers have points in any locale
cd "$JLT_SOURCE_DIR"

# For awk: whether there is such a file.
there_is='function there_is(path) {
    if (!(path in looked)) looked[path] = system("test -f " path) == 0
    return looked[path]
}'

# FILE:LINE INCLUDED, one a line; <NAME> for system headers, NAME otherwise.
includes() {
    find "$@" -name '*.[ch]' -exec awk '
        match($0, /^[ \t]*#[ \t]*include[ \t]*[<"][^>"]+[>"]/) {
            name = $0
            sub(/^[ \t]*#[ \t]*include[ \t]*/, "", name)
            if (name ~ /^</) sub(/>.*/, ">", name)
            else { sub(/^"/, "", name); sub(/".*/, "", name) }
            print FILENAME ":" FNR, name
        }' {} +
}

failures=$({
    includes src tools/bench/program | awk "$there_is"'
        function fail(message) { print place ": includes " $2 ": " message }
        BEGIN {
            count = split("core kernel integrate dynamics analysis ext report top scene spectrum validated claims shards cli bench",
            order, " ")
            for (i = 1; i <= count; i++) rank[order[i]] = i
            split("integrate dynamics analysis top scene", callers, " ")
            for (i in callers) calls_ext[callers[i]] = 1
            home["gsl/"] = home["flint/"] = home["arb"] = home["acb"] = home["arpack"] = home["mpi"] = "ext"
            home["libconfig"] = "scene"
            home["jansson"] = "report"
            home["sqlite3"] = home["zlib"] = "shards"
        }
        {
            place = $1
            split(place, part, "/")
            here = $1 ~ /^src\/top\/command_/ ? "cli" : $1 ~ /^src\/jellett\.h:/ ? "scene" : part[2]
            if (!(here in rank)) { fail("src/" here " is no layer"); next }
            if (here == "bench" && $2 == "bench.h") next
            if ($2 ~ /^</) {
                for (prefix in home)
                    if (index($2, "<" prefix) == 1 && rank[here] < rank[home[prefix]] || \
                        index($2, "<" prefix) == 1 && home[prefix] == "ext" && here != "ext" && !(here == "validated" &&
                        prefix ~ /^(flint|arb|acb)/))
                        fail("only src/" home[prefix] (home[prefix] == "ext" ? "" : " and layers below it") " may")
                next
            }
            if ($2 == "jellett.h") { fail("it is for users of the library"); next }
            if (there_is("src/" $2)) {
                split($2, target, "/")
                there = $2 ~ /^top\/command_/ ? "cli" : target[1]
                if (there == here) next
                if (there == "ext" && here in calls_ext) next
                if (here == "ext" && there != "core") fail("ext calls core alone")
                else if (rank[there] > rank[here]) fail("src/" there " stands below src/" here)
            } else if (there_is("generated/" $2)) {
                if ($2 != "kernel_abi.h" && here != "kernel" && !($2 == "kernel_ball.h" && here == "ext"))
                    fail("only src/kernel knows single models, only src/ext kernels in balls")
            } else if (there_is("codegen/" $2)) {
                if (rank[here] < rank["spectrum"]) fail("only src/spectrum and rooms below it may call the compiler")
            } else fail("no such header; name it from src/, as in \"core/status.h\"")
        }'
    includes codegen | awk "$there_is"'
        BEGIN {
            count = split("base expression read show algebra ball prove challenge discover fields optimize " \
                          "kernels emit readback build command", order, " ")
            for (i = 1; i <= count; i++) rank[order[i]] = i
        }
        { split($1, part, "/") }
        part[2] == "runtime" { next }
        !(part[2] in rank) { print $1 ": codegen/" part[2] " is no room"; next }
        $2 ~ /^</ { next }
        !there_is("codegen/" $2) { print $1 ": includes " $2 ": name it from codegen/, which knows nothing outside itself"
            next }
        { split($2, target, "/") }
        rank[target[1]] > rank[part[2]] { print $1 ": includes " $2 ": codegen/" target[1] " stands below codegen/" part[2] }'
    includes generated codegen/runtime | awk "$there_is"'
        BEGIN {
            split("assert complex ctype errno fenv float inttypes limits math stdalign stdbool stddef stdint stdlib string " \
                  "tgmath", names, " ")
            for (i in names) libc["<" names[i] ".h>"] = 1
        }
        $2 in libc { next }
        $1 ~ /lanes/ && ($2 == "<immintrin.h>" || $2 == "<arm_neon.h>") { next }
        $1 ~ /ball/ && $2 ~ /^<(flint\/)?(arb|acb|arf|mag|fmpq|fmpz)[a-z_]*\.h>$/ { next }
        $2 !~ /^</ {
            folder = $1; sub(/\/[^\/]*$/, "", folder)
            if (folder != "codegen/runtime" && there_is("generated/" $2) || there_is(folder "/" $2)) next
        }
        { print $1 ": includes " $2 ": generated files, and those that are copied there, " \
            "include libc only (ball files Arb as well)" }'
    # Circles: walk every header depth first; grey is on the path from the start, black is done.
    includes src codegen generated tools/bench/program | awk "$there_is"'
        $2 ~ /^</ { next }
        {
            from = $1; sub(/:[0-9]+$/, "", from)
            folder = from; sub(/\/[^\/]*$/, "", folder)
            target = ""
            split("src/ generated/ codegen/ " folder "/", roots, " ")
            for (i = 1; i <= 4 && target == ""; i++)
                if (there_is(roots[i] $2)) target = roots[i] $2
            if (target != "") edge[from, ++edges[from]] = target
        }
        function visit(node, path,    i, next_node) {
            color[node] = "grey"
            for (i = 1; i <= edges[node]; i++) {
                next_node = edge[node, i]
                if (color[next_node] == "grey") print next_node ": includes itself by way of " path " -> " node
                else if (color[next_node] == "") visit(next_node, path " -> " node)
            }
            color[node] = "black"
        }
        END { for (node in edges) if (color[node] == "") visit(node, "") }'
    # Files whose code names functions of each other in a circle, which tsort tells; tables of functions do not count.
    objects=$(find "$JLT_BINARY_DIR/CMakeFiles" -name '*.o' | while IFS= read -r object; do
        source=${object#*.dir/}
        case $source in src/* | codegen/*) if [ -f "${source%.o}" ]; then printf '%s\n' "$object"; fi ;; esac
    done)
    { nm -A --defined-only -g $objects; readelf -rW $objects; } | awk '
        function file_of(object) { sub(/^.*\.dir\//, "", object); sub(/\.o(:.*)?$/, "", object); return object }
        NF == 3 && $2 ~ /^[TDRB]$/ { home[$3] = file_of($1) }
        /^File: / { file = file_of($2) }
        /^Relocation section/ { code = $3 ~ /\.text/ }
        code && $1 ~ /^[0-9a-f]+$/ { sub(/@.*/, "", $5); if ($5 in home && home[$5] != file) print file, home[$5] }' |
        sort -u | { tsort 2>&1 > /dev/null || true; } | sed -n 's/^tsort: \([a-z]\)/calls in a circle: \1/p'
})
if [ -n "$failures" ]; then
    printf '%s\n' "$failures"
    exit 1
fi
echo "$(includes src codegen generated tools/bench/program | wc -l) includes point the right way"
