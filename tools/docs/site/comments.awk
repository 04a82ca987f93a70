# A header as doxygen is to read it: its opening comment is of the file, every other one of what it stands before or, after
# code, behind; and each of the words by which comments here say what a function does opens a paragraph.
function paragraphs(line) {
    line = gensub(/`([^`]*)`/, "<code>\\1</code>", "g", line)
    return gensub(/(^ \*|[.;])( +)(Errors|Out|In|In\/out|Cost|Source): /, "\\1\n *\n *  @b \\3: ", "g", line)
}
# Constants in an enum without a name are listed as macros, which have names: { A = 1, B = 2 }, or { A, B } for 0, 1.
/^enum \{.*\};/ {
    if (match($0, /\/\*.*\*\//)) print "/**" substr($0, RSTART + 2, RLENGTH - 2)
    sub(/^enum \{ */, "")
    sub(/ *\};.*/, "")
    count = split($0, constants, / *, */)
    for (i = 1; i <= count; i++) {
        if (constants[i] !~ /=/) constants[i] = constants[i] " = " (i - 1)
        sub(/ *= */, " (", constants[i])
        print "#define " constants[i] ")"
    }
    next
}
!started && /^\/\*\*/ { started = 1; sub(/^\/\*\*/, "/** @file\n *") }
!started { print; next }
!inside && /^[ \t]*\/\*/ { sub(/\/\*\*?/, "/**"); inside = 1 }
!inside && /\/\* / { sub(/\/\* /, "/**< "); inside = 1 }
# An example is indented, after an empty line.
inside && empty && /^[ \t]*\*      / { print " *  @code{.c}"; example = 1 }
example && !/^[ \t]*\*      / { print " *  @endcode"; example = 0 }
inside && !example { $0 = paragraphs($0) }
{ empty = /^[ \t]*\*$/ }
/\*\// { inside = 0 }
{ print }
