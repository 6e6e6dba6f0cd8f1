#!/usr/bin/env python3
"""Makes a copy of FLINT that needs no NTL, for who gives the Python package away with its libraries.

FLINT of Debian is compiled with an interface to NTL, seven functions that neither Arb nor poinsot calls; NTL brings
gf2x, which is under the GPL. The copy needs, in the place of NTL, a library of the names that the interface refers to and
nothing else: a function among them ends the program with a message. docs/decisions.md says why it is done so.

usage: without_ntl.py MODULE FOLDER    MODULE: what is linked with FLINT. Writes nothing if its FLINT needs no NTL.

Needs gcc, readelf, ldd and patchelf. Status 1 if something besides FLINT refers to NTL.
"""

import re
import shutil
import subprocess
import sys
from pathlib import Path

STANDS_IN = "libflint_without_ntl.so"


def output(*command: str) -> str:
    return subprocess.run(command, check=True, capture_output=True, text=True).stdout


def needed(library: str) -> dict[str, str]:
    """All libraries that are loaded with this one: their paths by their names."""
    return dict(re.findall(r"(\S+) => (/\S+)", output("ldd", library)))


def symbols(library: str, defined: bool) -> dict[str, tuple[str, int]]:
    """Kind and size of each."""
    found = {}
    for line in output("readelf", "--wide", "--dyn-syms", library).splitlines():
        parts = line.split()
        # Number, value, size, kind, binding, visibility, section, name.
        if len(parts) >= 8 and re.fullmatch(r"\d+:", parts[0]) and (parts[6] != "UND") == defined:
            found[parts[7].split("@")[0]] = (parts[3], int(parts[2], 0))
    return found


def source(names: dict[str, tuple[str, int]]) -> str:
    lines = [
        "#include <stdio.h>",
        "#include <stdlib.h>",
        "static void missing(void) {",
        '  fputs("This copy of FLINT was made without NTL: its interface to NTL cannot be called.\\n", stderr);',
        "  abort();",
        "}",
    ]
    for name, (kind, size) in sorted(names.items()):
        if kind in ("FUNC", "IFUNC"):
            lines.append(f"void {name}(void) {{ missing(); }}")
        else:
            # Variables that only functions above would fill; large ones keep their alignment.
            lines.append(f"{'__thread ' if kind == 'TLS' else ''}_Alignas(16) char {name}[{size}];")
    return "\n".join(lines) + "\n"


def main() -> int:
    module, folder = sys.argv[1], Path(sys.argv[2])
    libraries = needed(module)
    flint = next((path for name, path in libraries.items() if re.fullmatch(r"libflint\.so\.\d+", name)), None)
    if flint is None:
        return 0
    ntl_name, ntl = next(((name, path) for name, path in needed(flint).items() if name.startswith("libntl.so")), ("", ""))
    if not ntl:
        return 0
    of_ntl = symbols(ntl, defined=True)
    # Functions of the interface take what NTL calls so.
    others = [module, *(path for path in libraries.values() if path not in (flint, ntl))]
    users = [path for path in others if any(name in of_ntl or "NTL" in name for name in symbols(path, defined=False))]
    if users:
        print(f"without_ntl: {', '.join(users)} would miss NTL", file=sys.stderr)
        return 1
    names = {name: of_ntl[name] for name in symbols(flint, defined=False) if name in of_ntl}

    folder.mkdir(parents=True, exist_ok=True)
    text = folder / "flint_without_ntl.c"
    text.write_text(source(names))
    output("gcc", "-shared", "-fPIC", "-O1", f"-Wl,-soname,{STANDS_IN}", "-o", str(folder / STANDS_IN), str(text))
    copy = folder / re.sub(r"(\.so\.\d+).*", r"\1", Path(flint).name)
    shutil.copyfile(Path(flint).resolve(), copy)
    output("patchelf", "--replace-needed", ntl_name, STANDS_IN, str(copy))
    print(f"{copy} needs {STANDS_IN}, with {len(names)} names, in the place of {ntl_name}")
    return 0


if __name__ == "__main__":
    raise SystemExit(main())
