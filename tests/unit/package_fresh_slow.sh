#!/usr/bin/env bash
# On a machine that holds nothing but Debian's minimum apt installs the package of the programs with what it depends on; there
# they run. With the package for development an example builds with a compiler and pkg-config alone, and Python opens the
# library. When the packages are removed nothing of them is left. Needs root, mmdebstrap and Debian's archive.
set -euo pipefail
[ "$(id -u)" -eq 0 ] || { echo "only root can make a root"; exit 77; }
command -v mmdebstrap > /dev/null || { echo "mmdebstrap is missing (apt-get install mmdebstrap)"; exit 77; }
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
(cd "$JLT_BINARY_DIR" && cpack -G DEB -B "$scratch") > "$scratch/log" 2>&1 || { cat "$scratch/log"; exit 1; }

root=$scratch/root
mmdebstrap --quiet --variant=minbase "$(. /etc/os-release && echo "$VERSION_CODENAME")" "$root" ||
    { echo "no root can be made here"; exit 77; }
# How this machine reaches the archive (a proxy, clocks that differ) serves in the root too.
cp -r /etc/apt/apt.conf.d/. "$root/etc/apt/apt.conf.d/"
cp /etc/resolv.conf "$root/etc/resolv.conf"
cp "$scratch"/*.deb "$root/root"
cat > "$root/root/try" <<'SH'
set -eux
export DEBIAN_FRONTEND=noninteractive
apt-get update -q
apt-get install -y -q --no-install-recommends /root/jellett_*.deb
hash -r
ttc prove /usr/share/jellett/models/lorenz.tt | tail -1
jellett section --start eta=0.1,gamma3=-0.6 --returns 5 | tail -1 | cut -d, -f2-5,9 > /root/expected
! command -v gcc
apt-get install -y -q --no-install-recommends /root/libjellett*.deb gcc libc6-dev pkg-config python3
gcc -std=c11 /usr/share/jellett/examples/section.c -o /root/section $(pkg-config --cflags --libs jellett) -lm
/root/section | tail -1 > /root/said
jellett simulate /usr/share/jellett/models/lorenz.tt --start x=1,y=2,z=20 --times 1
python3 -c 'import ctypes; ctypes.CDLL("libjellett.so.0").jlt_handle_section_known'
cut -c1-14 /root/expected /root/said | uniq | wc -l | grep -x 1 # ten digits of the time
apt-get purge -y -q jellett libjellett0 libjellett-dev
find / -xdev -name '*jellett*' ! -path '/root/*' ! -path '/proc/*' ! -path '/var/*' | tee /root/left
[ ! -s /root/left ]
SH
unshare --mount --pid --fork --kill-child bash -euc 'mount -t proc proc "$0/proc"; exec chroot "$0" bash /root/try' "$root" > \
    "$scratch/log" 2>&1 ||
    { tail -40 "$scratch/log"; exit 1; }
grep -E '^Setting up (lib)?jellett|claims' "$scratch/log"
