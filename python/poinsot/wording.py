"""How the words of the program are said in Python.

Messages say how values are given on the command line, --set 'm=2 kg', where a caller writes m='2 kg'.
"""

from __future__ import annotations

import re

from . import _core

_SETTING = re.compile(r"--set (?:'(?P<quoted>.+?)=(?P<text>.*?)'(?!=)|(?P<name>[^\s=]+)=(?P<value>[^\s;,)]+))(?P<more> (?=--set ))?")


def _setting(match: re.Match[str]) -> str:
    name, value = match["quoted"] or match["name"], match["text"] or match["value"]
    # A dot over a name is none of Python.
    given = f"{name}='{value}'" if name.isidentifier() else f'{{"{name}": \'{value}\'}}'
    return given + (", " if match["more"] else "")


def in_python(text: str) -> str:
    """The text with keywords of a call where it speaks of options of the command line."""
    if "--" not in text:
        return text
    # Where a value that was set is wrong, it stands in the place of a file.
    if text.startswith(("--set ", "--letter ")) and not text.startswith("--set '"):
        option, _, rest = text.partition(" ")
        text = rest if option == "--set" else f"letters: {rest}"
    text = _SETTING.sub(_setting, text.replace("write --set before each: ", "name each: "))
    text = re.sub(r"--situation (\w+)", r"situation='\1'", text)
    text = text.replace("record to another file, or add --force", "record to another file, or say replace=True")
    return text.replace("by --set", "by keywords of the call").replace("with --set", "with keywords of the call")


def language_help(word: str) -> str:
    """What a word of the language of problem files means, with an example."""
    if not isinstance(word, str):
        raise TypeError(f"a word is a text, as 'revolute', not {word!r}")
    found = _core.language_help(word)
    if not found:
        hint = _core.did_you_mean(word, _core.language_words()) or "language_words() has them all"
        raise ValueError(f"the language has no word '{word}' ({hint})")
    return found
