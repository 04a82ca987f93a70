#!/usr/bin/env bash
# A file that uses a name of the C library or of FLINT includes its header, itself or through headers of this project: what a
# header of another library happens to include differs from one release to the next.
set -euo pipefail
cd "$JLT_SOURCE_DIR"
python3 - << 'END'
import os, re, sys

FUNCTIONS = {  # followed by a parenthesis
    "stdlib.h": "malloc calloc realloc free qsort bsearch strtod strtol strtoul strtoll strtoull getenv setenv exit "
                "abort mkstemp mkdtemp",
    "string.h": "memcpy memmove memset memcmp memchr strlen strcmp strncmp strchr strrchr strstr strdup strndup "
                "strspn strcspn strpbrk strerror strsignal strtok_r",
    "math.h": "sqrt fabs sin cos tan exp log pow floor ceil fmax fmin hypot ldexp frexp isnan isfinite isinf signbit "
              "copysign nextafter fma atan atan2 remainder fmod round trunc lround llround log2 log10 ilogb scalbn "
              "cbrt expm1 log1p",
    "stdio.h": "printf fprintf snprintf vfprintf vsnprintf fputs fputc puts fopen fdopen fclose fread fwrite fflush "
               "fseek ftell getline ferror fileno perror sscanf open_memstream rename remove",
    "ctype.h": "isalpha isdigit isalnum isspace isprint tolower toupper",
    "stdarg.h": "va_start",
    "assert.h": "assert",
    "unistd.h": "fork execv execvp pipe dup2 unlink rmdir chdir fsync ftruncate isatty sysconf readlink getuid getpid",
    "fcntl.h": "open fcntl",
    "signal.h": "sigaction sigemptyset raise kill",
    "time.h": "clock_gettime nanosleep strftime gmtime localtime",
    "sys/stat.h": "stat fstat lstat mkdir chmod",
    "sys/wait.h": "waitpid",
    "dirent.h": "opendir readdir",
    "pthread.h": "pthread_create pthread_mutex_lock",
}
NAMES = {
    "stdio.h": "FILE EOF stdin stdout stderr",
    "math.h": "NAN INFINITY",
    "stdbool.h": "bool true false",
    "stdarg.h": "va_list",
    "errno.h": "errno ENOENT EEXIST EINTR ENOSPC",
    "limits.h": "INT_MAX INT_MIN UINT_MAX LONG_MAX LONG_MIN CHAR_BIT PATH_MAX",
    "float.h": "DBL_EPSILON DBL_MAX DBL_MIN DBL_MANT_DIG",
    "stdint.h": "uint64_t int64_t uint32_t int32_t uint16_t uint8_t uintptr_t SIZE_MAX UINT64_MAX INT64_MAX",
}
# Types of FLINT with a header each, and the types whose headers it includes in releases 2 and 3.
FLINT = {"mag": "fmpz", "arf": "mag", "arb": "arf", "acb": "arb", "arb_mat": "arb", "arb_poly": "arb", "acb_mat": "acb",
         "acb_poly": "acb", "fmpz": "", "fmpq": "fmpz", "fmpz_vec": "fmpz", "fmpq_vec": "fmpq", "fmpz_mat": "fmpz",
         "fmpq_mat": "fmpq", "fmpz_poly": "fmpz", "fmpq_poly": "fmpq", "fmpz_mpoly": "fmpz", "fmpz_mpoly_factor": "fmpz_mpoly",
         "fmpq_mpoly": "fmpz_mpoly fmpq", "nmod_mat": "nmod", "nmod_poly": "nmod", "nmod_poly_factor": "nmod_poly", "nmod": ""}
INCLUDE = re.compile(r'^\s*#\s*include\s+([<"])([^>"]+)[>"]', re.M)
ROOTS = ["src", "codegen", "generated", "tests", "tools/bench/program", "tests/unit"]


def headers(path, seen):
    """Standard headers that a file includes, through files of the project alone."""
    if path in seen:
        return set()
    seen.add(path)
    found = set()
    for kind, name in INCLUDE.findall(open(path, encoding="utf-8").read()):
        inside = [os.path.normpath(os.path.join(root, name)) for root in [os.path.dirname(path), *ROOTS]]
        own = next((file for file in inside if os.path.exists(file)), None)
        found |= headers(own, seen) if kind == '"' and own else {name}
    return found


def flint_types(words):
    """Types of FLINT whose names or functions, such as arb_mat_init or _fmpq_vec_init, are among the words."""
    used = set()
    for word in words:
        known = [name for name in FLINT if re.fullmatch(f"_?{name}(_\\w+)?", word)]
        used |= {max(known, key=len)} if known else set()
    return used


def with_included(types):
    """The types given, and all whose headers theirs include."""
    new = {inner for name in types for inner in FLINT[name].split()} - types
    return with_included(types | new) if new else types


def code(path):
    text = open(path, encoding="utf-8").read()
    for pattern in (r"/\*.*?\*/", r"//.*", r'"(\\.|[^"\\\n])*"', r"^\s*#\s*include.*$"):
        text = re.sub(pattern, "", text, flags=re.M if pattern[0] == "^" else re.S if "*?" in pattern else 0)
    return text


status = files = 0
for top in ("codegen", "src", "tools", "tests"):
    for folder, _, names in os.walk(top):
        for path in (os.path.join(folder, name) for name in names if name.endswith((".c", ".h"))):
            files += 1
            text, have = code(path), headers(path, set())
            if "inttypes.h" in have:
                have.add("stdint.h")
            calls = set(re.findall(r"(?<![\w.>])(\w+)\s*\(", text)) - set(re.findall(r"^static [^;(]*?(\w+)\(", text, re.M))
            words = set(re.findall(r"(?<![\w.>])\w+", text))
            flint = {os.path.basename(name)[:-2] for name in have} & set(FLINT)
            for missing in sorted(flint_types(words) - with_included(flint)):
                print(f"{path}: {missing}: <flint/{missing}.h> is not included")
                status = 1
            for table, used in ((FUNCTIONS, calls), (NAMES, words)):
                for header, known in table.items():
                    missing = used & set(known.split())
                    if header not in have and missing:
                        print(f"{path}: {', '.join(sorted(missing))}: <{header}> is not included")
                        status = 1
print(f"{files} files include what they use")
sys.exit(status)
END
