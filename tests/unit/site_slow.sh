#!/usr/bin/env bash
# The site is rendered without a warning, its links and anchors lead somewhere, and it loads nothing from elsewhere. Needs what
# tools/install-deps --docs installs.
set -euo pipefail
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
cd "$JLT_SOURCE_DIR"
tools/docs/render "$scratch/site" > "$scratch/log" 2>&1 || {
    cat "$scratch/log"
    ! grep -q '^render: missing' "$scratch/log" || exit 77
    exit 1
}
python3 tools/docs/links --site "$scratch/site"
for page in index man/jellett man/ttc api/dynamics api/kernel_abi gallery/README tools/docs/commands; do
    [ -s "$scratch/site/$page.html" ] || { echo "there is no page $page"; exit 1; }
done
pictures=$(grep -o '<img [^>]*src="[^"]*\.svg"' "$scratch/site/gallery/README.html" | wc -l)
[ "$pictures" -ge "$(cat tools/scenes/*.scene | grep -c 'plot = ')" ] || { echo "the gallery has $pictures pictures"; exit 1; }

# A heading of the gallery has a picture under it; code in a list is code.
bare=$(tr -d '\n' < "$scratch/site/gallery/README.html" | sed 's/<h2>/\n&/g' | sed -n '/^<h2>/{/<img/!p}' | cut -c1-100)
[ -z "$bare" ] || { echo "no picture in the gallery under: $bare"; exit 1; }
plain=$(grep -rlE '<p>[a-z]+ = (&quot;|[({])' --include='*.html' "$scratch/site" || true)
[ -z "$plain" ] || { echo "scenes as running text in: $plain"; exit 1; }

# No line ends behind the hyphen of a number such as 1e-12, or those of an option such as --grid or -o.
python3 - "$scratch/site" << 'END'
import pathlib, re, sys
for page in pathlib.Path(sys.argv[1]).rglob("*.html"):
    for text in re.findall(r"<p>(.*?)</p>", page.read_text(), re.S):
        bare = re.sub(r'<pre\b.*?</pre>|<span class="kept">.*?</span>|<[^>]*>', " ", text, flags=re.S)
        broken = re.search("[0-9]e-[0-9]|(?<![-\\w])--?[a-z]", bare)
        if broken: sys.exit(f"{page}: a line may end inside {bare[broken.start():][:20]!r} of: {bare[:100]}")
END

# Names on man pages are whole, and what they quote is code.
grep -q '>share/jellett/models/\*\.tt<' "$scratch/site/man/jellett.html" || { echo "man pages lose stars of file names"; exit 1; }
quoted=$(grep -rl '<p>[^<]*`' --include='*.html' "$scratch/site/man" || true)
[ -z "$quoted" ] || { echo "backticks in: $quoted"; exit 1; }
