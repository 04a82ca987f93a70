#!/usr/bin/env bash
# `cpack -G DEB` makes packages of the programs, of the shared library, and of what is built with it; each has what it should,
# with a changelog of its version, and depends on the packages of all libraries that are loaded. Unpacked into any folder, the
# programs run from there and the examples build. lintian, where it is installed, finds no error.
set -euo pipefail
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
status=0
fail() { echo "$*"; status=1; }

(cd "$JLT_BINARY_DIR" && umask 077 && cpack -G DEB -B "$scratch") > "$scratch/log" 2>&1 || { cat "$scratch/log"; exit 1; }
version=$(jellett --version | sed 's/^jellett //;q')
architecture=$(dpkg --print-architecture)
tree=$scratch/root/usr
has() { # PACKAGE, and paths in it
    local package=$1 path file=$scratch/$1_${version}_$architecture.deb doc=share/doc/$1
    [ -f "$file" ] || { echo "no $file among $(ls "$scratch")"; exit 1; }
    dpkg-deb -x "$file" "$scratch/$package"
    dpkg-deb -x "$file" "$scratch/root"
    for path in "${@:2}" "$doc/copyright" "$doc/changelog.gz"; do
        [ -e "$scratch/$package/usr/$path" ] || [ -L "$scratch/$package/usr/$path" ] || fail "$package has no /usr/$path"
    done
    gzip -dc "$scratch/$package/usr/$doc/changelog.gz" > "$scratch/changelog"
    [ "$(dpkg-parsechangelog -l "$scratch/changelog" -S Version)" = "$version" ] || fail "the changelog is not of $version"
}
has jellett bin/ttc bin/jellett libexec/jellett/jellett-bench share/jellett/models/spherical_top.tt share/man/man1/ttc.1.gz \
    share/man/man1/jellett.1.gz share/zsh/vendor-completions/_jellett
has libjellett0 lib/libjellett.so.0
has libjellett-dev lib/libjellett.so lib/libjellett.a include/jellett/jellett.h include/jellett/scene/handle.h \
    share/jellett/generated/kernel_abi.h share/jellett/examples/section.c
[ "$(find "$scratch"/{jellett,libjellett0,libjellett-dev} -type f | wc -l)" = "$(find "$scratch/root" -type f | wc -l)" ] ||
    fail "a file is in two packages"
library=$(find "$tree" -name libjellett.so)
if command -v lintian > /dev/null; then
    lintian --allow-root --fail-on error "$scratch"/*.deb > "$scratch/log" 2>&1 ||
        { cat "$scratch/log"; fail "^ lintian finds errors"; }
fi
[ -z "$(find "$scratch/root" ! -type l \( -perm /022 -o ! -perm -044 \))" ] || fail "permissions are the umask's"
! grep -rlIF -e "$JLT_BINARY_DIR" -e "$scratch" "$tree" || fail "^ these files name the folder in which they were built"

# What the loader asks for is in packages that this one depends on; who calls Z3 or Arb, which package they are in, is dpkg's to
# say.
depends_of() {
    echo " $(dpkg-deb -f "$scratch/$1_${version}_$architecture.deb" Depends | sed -E 's/ \([^)]*\)//g; s/ *[,|] */ /g') "
}
declare -A owners=()
for file in "$tree/bin/ttc" "$tree/bin/jellett" "$tree/libexec/jellett/jellett-bench" "$library"; do
    depends=$(depends_of jellett)
    [ "$file" != "$library" ] || depends=$(depends_of libjellett0)
    while read -r soname; do
        path=$(ldd "$file" | awk -v name="$soname" '$1 == name { print $3 }')
        [ -n "${owners[$soname]-}" ] || owners[$soname]=$(dpkg -S "*/$soname" 2>/dev/null | sed 's/:.*//' | sort -u)
        found=no
        for name in ${owners[$soname]}; do [[ $depends != *" $name "* ]] || found=yes; done
        [ $found = yes ] ||
            fail "${file##*/} needs $soname ($path, of ${owners[$soname]:-no package}), and the package does not depend on it"
    done < <(readelf -d "$file" | sed -n 's/.*NEEDED.*\[\(.*\)\]/\1/p' | grep -v '^ld-linux')
done

# From the folder alone; the path of the build is forgotten.
here=$PATH
export PATH=$tree/bin:/usr/local/bin:/usr/bin:/bin XDG_CACHE_HOME=$scratch
ttc prove "$tree/share/jellett/models/lorenz.tt" > "$scratch/proved" || fail "ttc prove: exit status $?"
for program in jellett ttc; do
    [ "$(command -v $program)" = "$tree/bin/$program" ] || fail "$program is not that of the package"
done
jellett bench eigenvalues --repeats 1 > "$scratch/measured" || fail "jellett bench: exit status $?"
grep -q '^jellett,closed form' "$scratch/measured" || fail "jellett bench measures nothing"
simulate=(--start x=1,y=2,z=20 --times 1 --method dop853) # by kernels without lanes in both
jellett simulate lorenz "${simulate[@]}" | grep -v '^#' > "$scratch/built_in"
jellett simulate "$tree/share/jellett/models/lorenz.tt" "${simulate[@]}" | grep -v '^#' > "$scratch/loaded"
[ "$(wc -l < "$scratch/built_in")" = 2 ] || fail "jellett simulate has no row"
cmp "$scratch/built_in" "$scratch/loaded" || fail "a table compiled from there is another"
PATH=$here jellett simulate lorenz "${simulate[@]}" | grep -v '^#' | cmp - "$scratch/built_in" ||
    fail "the program built is another"

if ! nm "$JLT_BINARY_DIR/libjellett.a" 2>/dev/null | grep -E '__[at]san_init' > /dev/null; then
    PKG_CONFIG_LIBDIR=$(dirname "$(find "$tree" -name jellett.pc)")
    export PKG_CONFIG_LIBDIR
    # Word splitting is how pkg-config's answer is meant to be read.
    # shellcheck disable=SC2046
    "$JLT_CC" -std=c11 "$tree/share/jellett/examples/section.c" -o "$scratch/section" $(pkg-config --cflags --libs jellett) -lm
    [ "$(LD_LIBRARY_PATH=${library%/*} "$scratch/section" | wc -l)" = 5 ] || fail "section.c does not run"
fi
[ $status -ne 0 ] || stat -c '%n: %s bytes' "$scratch"/*.deb
exit $status
