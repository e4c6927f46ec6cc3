"""Tables that scripts write into documents, each between two comments that name it."""

import re
import sys


def table(head, rows, numbers=0):
    """Returns the lines of a table whose last columns, as many as `numbers`, are numbers."""
    rules = ["---"] * (len(head) - numbers) + ["---:"] * numbers
    return [f"| {' | '.join(row)} |" for row in (head, rules, *rows)]


def write(document, blocks):
    """Writes the lines of each block, {name: lines}, between its comments in the document."""
    text = document.read_text(encoding="utf-8")
    for name, lines in blocks.items():
        begin, end = rf"<!-- {name}, made by .* -->\n", rf"<!-- {name}: to here -->\n"
        parts = re.split(f"({begin})(?s:.*?)({end})", text)
        if len(parts) != 4:
            sys.exit(f"{document}: it has {len(parts) // 3} blocks named {name}; "
                     "write the two comments of one as in docs/bench.md")  # fmt: skip
        before, begin, end, after = parts
        text = before + begin + "".join(f"{line}\n" for line in lines) + end + after
    document.write_text(text, encoding="utf-8")
