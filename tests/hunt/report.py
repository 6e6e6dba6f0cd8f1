"""What was found, kept as files that show it, and told."""
import re


def file_name(find, number):
    word = re.sub(r"[^A-Za-z0-9]+", "-", f"{find.statement.name} {find.kind}").strip("-")
    return f"{find.relation}-{number}-{word}"[:110]


def keep(find, folder, number, command):
    """Writes both statements of a find, with what disagrees and how to repeat it on top."""
    folder.mkdir(parents=True, exist_ok=True)
    name = file_name(find, number)
    heading = [f"Relation {find.relation}: {find.kind}.", find.words, f"To repeat it: {command}"]
    comment = "".join(f"# {line}\n" for text in heading for line in text.splitlines())
    for statement, suffix in ((find.statement, ""), (find.varied, "-varied")):
        if statement is None:
            continue
        settings = "".join(f"# --set '{key}={value}'\n" for key, value in statement.settings.items())
        (folder / f"{name}{suffix}.yaml").write_text(comment + settings + statement.text())
        for mesh, text in statement.files.items():
            (folder / mesh).write_text(text)
    return folder / f"{name}.yaml"
