"""For the site's Python reference: examples in docstrings are programs, not quotations."""

import re

from griffe import Extension

EXAMPLE = re.compile(r"^>>> .*\n?(?:^\S.*\n?)*", re.MULTILINE)


class Examples(Extension):
    def on_instance(self, *, obj, **_):
        if obj.docstring:
            obj.docstring.value = EXAMPLE.sub(lambda found: f"```pycon\n{found[0].rstrip()}\n```\n", obj.docstring.value)
