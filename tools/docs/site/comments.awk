# A header as doxygen is to read it: its opening comment is of the file, every other one of what it stands before or, after code, behind;
# and each of the words by which comments here say what a function does opens a paragraph.
function paragraphs(line) {
    return gensub(/(^ \*|[.;])( +)(Errors|Out|In|In\/out|Cost|Source): /, "\\1\n *\n *  @b \\3: ", "g", line)
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
