# usage: awk -v within=1e-6 -f agree.awk EXPECTED ACTUAL
#
# Whether two texts agree, as the opening of run.sh says. Where they do not, ACTUAL is written out with its lines that agree with
# some expected line replaced by that, so that a diff shows the others alone.
# Exit status: 0 they agree, 1 they do not.

# Numbers of a line, and the texts before each and after the last; returns how many there are. A sign belongs to its number
# unless it stands between two operands.
function split_line(line, texts, numbers,    count, text, number, before) {
    count = 0
    text = ""
    while (match(line, /[-+]?([0-9]+(\.[0-9]+)?|\.[0-9]+)([eE][-+]?[0-9]+)?/)) {
        number = substr(line, RSTART, RLENGTH)
        text = text substr(line, 1, RSTART - 1)
        line = substr(line, RSTART + RLENGTH)
        before = substr(text, length(text), 1)
        if (number ~ /^[-+]/ && before ~ /[A-Za-z0-9_)]/) {
            text = text substr(number, 1, 1)
            number = substr(number, 2)
        }
        numbers[++count] = number
        texts[count] = text
        text = ""
    }
    texts[count + 1] = text line
    return count
}

function size(x) { return x < 0 ? -x : x }
function larger(x, y) { return x > y ? x : y }
function is_whole(number) { return number !~ /[.eE]/ }

BEGIN { pi = atan2(0, -1) }

function numbers_agree(one, other,    x, y) {
    if (one == other "") return 1 # as texts
    x = one + 0
    y = other + 0
    if (is_whole(one) && is_whole(other)) return x == 0 && y == 0
    if (size(size(x) - pi) < 1e-9 && size(size(y) - pi) < 1e-9) return 1 # one angle
    return size(x - y) <= within * larger(size(x), size(y)) || larger(size(x), size(y)) < within / 1000
}

function squeezed(text) {
    gsub(/ +/, " ", text)
    return text
}

function lines_agree(one, other,    count, i, moved) {
    if (one "" == other "") return 1
    if (one ~ / \.\.\.$/) return substr(one, 1, length(one) - 3) "" == substr(other, 1, length(one) - 3) ""
    count = split_line(one, texts_one, numbers_one)
    if (count == 0 || split_line(other, texts_other, numbers_other) != count) return 0
    for (i = 1; i <= count; i++) {
        if (!numbers_agree(numbers_one[i] "", numbers_other[i] "")) return 0
        if (length(numbers_one[i]) != length(numbers_other[i])) moved = 1
    }
    for (i = 1; i <= count + 1; i++)
        if (texts_one[i] != texts_other[i] && !(moved && squeezed(texts_one[i]) == squeezed(texts_other[i]))) return 0
    return 1
}

# Whether the expected lines first ... last, none of which is dots, agree with as many actual ones after `start`.
function run_agrees(first, last, start,    i) {
    for (i = first; i <= last; i++)
        if (!lines_agree(expected[i], actual[start + i - first + 1])) return 0
    return 1
}

# Runs of lines between dots are found from the top, each at the first place where it agrees: an earlier place never leaves less
# for those after it.
function all_agree(    i, first, last, start, floating) {
    start = 0
    first = 1
    floating = 0
    while (first <= expecting) {
        if (expected[first] == "...") {
            floating = 1
            first++
            continue
        }
        for (last = first; last < expecting && expected[last + 1] != "..."; last++) { }
        if (floating && last == expecting) start = larger(start, found - (last - first + 1))
        while (start + last - first + 1 <= found && !run_agrees(first, last, start)) {
            if (!floating) return 0
            start++
        }
        start += last - first + 1
        if (start > found) return 0
        floating = 0
        first = last + 1
    }
    return floating || start == found
}

FILENAME == ARGV[1] { expected[++expecting] = $0; next }
{ actual[++found] = $0 }

END {
    if (all_agree()) exit 0
    for (i = 1; i <= found; i++) {
        shown = actual[i]
        for (j = 1; j <= expecting; j++)
            if (lines_agree(expected[j], actual[i])) {
                shown = expected[j]
                break
            }
        print shown
    }
    exit 1
}
