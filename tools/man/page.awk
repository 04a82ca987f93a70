# Turns what a command says in --help, a line a paragraph or an option, into sections of a man page: synopsis, description and
# options; or, with part=end, examples and other pages. known: the commands that have pages.
function literal(text) {
    gsub(/\\/, "\\e", text)
    gsub(/-/, "\\-", text)
    return text ~ /^[.']/ ? "\\&" text : text
}

# A sentence a line, as the space behind it is the terminal's.
function sentences(text,    out) {
    text = literal(text)
    while (match(text, /[.] [A-Z]/)) {
        out = out substr(text, 1, RSTART) "\n"
        text = substr(text, RSTART + 2)
    }
    return out text "\n"
}

# "-a, --start=NAME=VALUE,...", of which either may be missing.
function flags(text,    part, count, i, at, name, out) {
    count = split(text, part, /, +/)
    if (part[1] ~ /^--/) count = 1 # commas are of its argument
    else if (count > 1) { part[2] = substr(text, index(text, "--")); count = 2 }
    else count = 1
    for (i = 1; i <= count; i++) {
        at = part[i] ~ /^--/ ? index(part[i], "=") : 0
        name = literal(substr(part[i], 2, (at ? at : length(part[i]) + 1) - 2))
        out = out (i > 1 ? " , " : "") "Fl " name (at ? " Ns = Ns Ar " literal(substr(part[i], at + 1)) : "")
    }
    return out
}

function paragraph(line) {
    if (line ~ /^Exit status: / || line == "Examples:") return
    sub(/ Examples?:$/, "", line)
    if (line ~ /^Columns.*:$/) {
        text = text ".Ss " substr(line, 1, length(line) - 1) "\n"
        return
    }
    if (text != "") text = text ".Pp\n"
    text = text sentences(line)
    while (match(line, program " [a-z]+")) {
        named = substr(line, RSTART + length(program) + 1, RLENGTH - length(program) - 1)
        line = substr(line, RSTART + RLENGTH)
        if (named != command && index(" " known " ", " " named " ") && !(named in others)) {
            others[named] = 1
            see = see " ,\n.Xr " program "-" named " 1"
        }
    }
}

# What was held back until it is known what follows: a heading of options, or a paragraph that ends in a colon.
function release() {
    if (held != "") paragraph(held)
    held = ""
}

function close_list() {
    if (listing) options = options ".El\n"
    listing = 0
}

function close_display(    count, line, wide, i) {
    if (shown == "") return
    sub(/\n+$/, "\n", shown)
    count = split(shown, line, "\n")
    wide = 0
    for (i = 1; i <= count; i++) wide = wide || length(line[i]) > 100
    for (i = 1; wide && i <= count; i++) { # no terminal shows such lines whole: paragraphs, with blanks to break them at
        gsub(/, */, ", ", line[i])
        sub(/^ +/, "", line[i])
        if (line[i] != "") text = text ".Pp\n" line[i] "\n"
    }
    if (wide) {
        shown = ""
        return
    }
    shown = ".Bd -literal\n" shown ".Ed\n"
    if (shown ~ /^[^\n]*\n  (jellett|ttc) /) examples = examples shown
    else text = text shown
    shown = ""
}

/^Usage: |^  or: / {
    sub(/^ *[^:]*: +[^ ]+ [^ ]+ */, "")
    sub(/\[OPTION\.\.\.\] */, "")
    usage = usage ".Nm " program " " command "\n.Op Ar option ...\n"
    if ($0 ~ /^\[/) usage = usage ".Op Ar " substr($0, 2, length($0) - 2) "\n"
    else if ($0 != "") usage = usage ".Ar " $0 "\n"
    next
}

/^  -|^      --/ {
    if (held != "") {
        close_list()
        options = options ".Ss " substr(held, 1, length(held) - 1) "\n"
        held = ""
    }
    if (!listing) options = options ".Bl -tag -width Ds\n"
    listing = 1
    what = $0
    sub(/^  +/, "", what)
    at = match(what, /  +/)
    options = options ".It " flags(substr(what, 1, at - 1)) "\n" sentences(substr(what, at + RLENGTH))
    next
}

/^$/ { if (shown != "") shown = shown "\n"; next }
/^  / { release(); shown = shown literal($0) "\n"; next }
{ release(); close_display() }
/:$/ { held = $0; next }
{ paragraph($0) }

END {
    release()
    close_list()
    close_display()
    if (part != "end") printf ".Sh SYNOPSIS\n%s.Sh DESCRIPTION\n%s.Sh OPTIONS\n%s", usage, text, options
    else printf "%s.Sh SEE ALSO\n.Xr %s 1%s\n", examples != "" ? ".Sh EXAMPLES\n" examples : "", program, see
}
