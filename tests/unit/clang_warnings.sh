#!/usr/bin/env bash
# clang finds nothing to warn of in any file of src/ and codegen/ that another compiler has built. It compiles them by the same
# commands, and writes nothing.
set -euo pipefail
command -v clang > /dev/null || exit 77
python3 - << 'END'
import concurrent.futures, json, os, shlex, subprocess, sys

sources = tuple(os.path.join(os.environ["JLT_SOURCE_DIR"], folder, "") for folder in ("src", "codegen"))
commands = {}
for entry in json.load(open(os.path.join(os.environ["JLT_BINARY_DIR"], "compile_commands.json"))):
    if entry["file"].startswith(sources) and entry["file"].endswith(".c"):
        commands.setdefault(entry["file"], entry)

def check(entry):
    words = shlex.split(entry["command"])
    cut = words.index("-o")
    words[cut:cut + 2] = ["-fsyntax-only", "-Werror"]
    compiler = next(i for i, word in enumerate(words) if word.startswith("-"))
    return subprocess.run(["clang", *words[compiler:]], cwd=entry["directory"], capture_output=True, text=True)

with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
    wrong = [found.stderr for found in pool.map(check, commands.values()) if found.returncode != 0]
print(*wrong, f"{len(commands)} files, {len(wrong)} of them with warnings", sep="\n")
sys.exit(bool(wrong) or len(commands) < 400)
END
