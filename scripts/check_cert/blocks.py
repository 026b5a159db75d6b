"""The blocks of a document, and the statements in them as text."""

import re
import unicodedata

from .errors import Unreadable

FENCE = re.compile(r"^((?:[ \t]*(?:>|(?:[-*+]|[0-9]+[.)])(?=[ \t])))*[ \t]*)(`{3,}|~{3,})(.*)$")
UNSEEN = re.compile(
    "[\u034f\u115f\u1160\u17b4\u17b5\u180b-\u180f\u2065\u2800\u3164\ufe00-\ufe0f\uffa0"
    "\ufff0-\ufff8\U000e0000-\U000e0fff]"
)
TAG = re.compile(r"kane(?![\w-])")


def statements(text):
    """The text of each statement of all blocks, in order."""
    found = []
    for block in blocks(text):
        for number, line in enumerate(block):
            if hidden := next((c for c in line if unseen(c)), None):
                raise Unreadable(f"the character U+{ord(hidden):04X} among statements")
            if not line.strip(" \t") or line.lstrip(" \t").startswith("#"):
                continue
            if line[0] not in " \t":
                found.append([line])
            elif number == 0 or not began(block[:number]):
                raise Unreadable(f"nothing is continued by `{line}`")
            else:
                found[-1].append(line)
    return ["\n".join(lines) for lines in found]


def unseen(character):
    """Is it a character that nobody sees, or one that controls a terminal?"""
    kind = unicodedata.category(character)
    return kind in ("Cf", "Zl", "Zp") or (kind == "Cc" and character != "\t") or bool(UNSEEN.match(character))


def began(lines):
    """Has a statement begun in these lines?"""
    return any(line and line[0] not in " \t#" for line in lines)


def blocks(text):
    """The lines of each block tagged `kane`, without the margin of its fence."""
    lines = re.split("\r\n|\r|\n", text.removeprefix("\ufeff"))
    found, inside, hidden, fence, margin = [], None, False, None, ""
    for line in lines:
        if fence:
            bare = without_margin(line, margin)
            closing = bare.strip(" \t")
            if len(closing) >= len(fence) and set(closing) == {fence[0]}:
                fence = None
            elif inside is not None:
                inside.append(bare)
            continue
        if hidden:
            hidden = "-->" not in line
            continue
        match = FENCE.match(line)
        if match and not (match[2][0] == "`" and "`" in match[3]):
            margin, fence = match[1], match[2]
            inside = None
            if TAG.match(match[3].strip(" \t")):
                inside = []
                found.append(inside)
        elif "<!--" in line:
            hidden = "-->" not in line[line.rindex("<!--"):]
    if fence and inside is not None:
        raise Unreadable("a block is never closed")
    return found


def without_margin(line, margin):
    """Removes what stands before the fence: signs of quotations, and indentation."""
    quotes, at = margin.count(">"), 0
    while at < min(len(margin), len(line)) and (line[at] in " \t" or (line[at] == ">" and quotes)):
        quotes -= line[at] == ">"
        at += 1
    return line[at:]
