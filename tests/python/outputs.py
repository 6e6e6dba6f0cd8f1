"""What is wrong with an output for who shows notebooks: JupyterLab, VS Code and exported pages.

All three take HTML first, then SVG, Markdown and PNG; TeX alone VS Code leaves to an extension. It puts HTML and SVG into its page
as they are, where several stand together, its policy forbids most of what would be loaded, and it looks for no TeX in HTML.
"""

import xml.etree.ElementTree as ET
from collections.abc import Iterable, Mapping
from html.parser import HTMLParser
from typing import Any

# Elements that have no end.
EMPTY = {"br", "col", "hr", "img", "wbr"}
# Not `style`: with one come tables of pandas, whose rules name the table alone.
FORBIDDEN = {"script", "link", "meta", "base", "object", "embed", "form", "html", "body", "head"}


class _Html(HTMLParser):
    def __init__(self, text: str) -> None:
        super().__init__()
        self.wrong: list[str] = []
        self._open: list[str] = []
        self.feed(text)
        self.close()
        self.wrong += [f"<{one}> has no end" for one in self._open]

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        if tag not in EMPTY:
            self._open.append(tag)
        if tag in FORBIDDEN:
            self.wrong.append(f"<{tag}> in HTML")
        for name, value in attrs:
            if name.startswith("on"):
                self.wrong.append(f"{name} of <{tag}> is a script")
            if name in ("src", "href") and not (value or "").startswith(("data:", "#")):
                self.wrong.append(f"<{tag}> loads {value}")
        if tag == "iframe":
            given = dict(attrs)
            if not given.get("srcdoc") or "allow-same-origin" in (given.get("sandbox") or "allow-same-origin"):
                self.wrong.append("a frame that is no page of its own")

    def handle_endtag(self, tag: str) -> None:
        if not self._open or self._open.pop() != tag:
            self.wrong.append(f"</{tag}> ends nothing")

    def handle_data(self, data: str) -> None:
        if "style" not in self._open and "$" in data:
            self.wrong.append(f"TeX in HTML: {data}")


def _of_svg(text: str) -> Iterable[str]:
    root = ET.fromstring(text)
    if root.tag != "{http://www.w3.org/2000/svg}svg":
        yield f"it is <{root.tag}>"
    for one in root.iter():
        tag = one.tag.rpartition("}")[2]
        if tag in ("script", "style", "foreignObject", "image", "a", "use"):
            yield f"<{tag}> in SVG"
        if "id" in one.attrib:
            yield f"the identifier {one.attrib['id']}, which other drawings on the page may have"


def wrong_in(output: Mapping[str, Any]) -> list[str]:
    """All that is wrong with an output's forms, by their names."""
    if "text/plain" not in output:
        return ["there is no text/plain"]
    wrong = []
    if "text/latex" in output:
        tex = output["text/latex"].strip()
        if not (tex.startswith("$") and tex.endswith("$")):
            wrong.append(f"TeX that nobody takes for it: {tex}")
    if "text/html" in output:
        wrong += _Html(output["text/html"]).wrong
    if "image/svg+xml" in output:
        wrong += _of_svg(output["image/svg+xml"])
    return wrong
