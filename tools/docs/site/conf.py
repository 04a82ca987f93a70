# Sphinx's settings for the site that tools/docs/render makes.
import re

from docutils import nodes
from pygments.lexer import RegexLexer, bygroups, using
from pygments.lexers.shell import BashLexer
from pygments.token import Generic

project = "jellett"
extensions = ["myst_parser", "breathe"]
root_doc = "README"
html_theme = "furo"
html_title = "jellett"
html_static_path = ["style.css"]
html_css_files = ["style.css"]
html_show_sourcelink = False
html_show_copyright = False
html_show_sphinx = False
html_copy_source = False
html_use_index = False
smartquotes = False  # -- is an option
myst_heading_anchors = 4  # as on a forge: #words-of-the-heading
pygments_style = "default"  # of these two styles remarks behind commands are readable
pygments_dark_style = "native"
highlight_language = "text"
breathe_projects = {"jellett": "xml"}
breathe_default_project = "jellett"
breathe_domain_by_extension = {"h": "c"}
breathe_default_members = ("members", "undoc-members")
breathe_show_include = False
breathe_show_define_initializer = True


class Transcript(RegexLexer):
    """Commands stand behind "$ ", and go on behind a backslash; all else is what they say, also behind "# "."""

    name = "console"
    tokens = {
        "root": [
            (r"^(\$ )((?:.*\\\n)*.*\n?)", bygroups(Generic.Prompt, using(BashLexer))),
            (r".*\n", Generic.Output),
        ]
    }


KEPT = re.compile(r"([-+]?[0-9][0-9.]*e-[0-9]+|(?<![-\w])--?[a-z][-a-z]*)")
TEXT = (nodes.paragraph, nodes.inline, nodes.emphasis, nodes.strong, nodes.term, nodes.literal)


def keep_together(app, tree, name):
    """A line does not end behind the hyphen of a number such as 1e-12, or those of an option such as --grid or -o."""
    for text in list(tree.findall(nodes.Text)):
        parts = KEPT.split(text.astext())
        if len(parts) > 1 and isinstance(text.parent, TEXT):
            kept = [nodes.inline("", part, classes=["kept"]) if k % 2 else nodes.Text(part) for k, part in enumerate(parts)]
            text.parent.replace(text, kept)


def setup(app):
    app.add_lexer("console", Transcript)
    app.connect("doctree-resolved", keep_together)
