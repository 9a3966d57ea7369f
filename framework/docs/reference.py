#!/usr/bin/env python3
"""usage: framework/docs/reference.py [FOLDER...]

The C++ reference: pages of the site made from the public headers, a page a folder. Prints those of the folders, or all.
"""
import pathlib
import re
import sys

FRAMEWORK = pathlib.Path(__file__).resolve().parent.parent


def public_headers(folder):
    """Those of a folder of the library ("core"); "cirque": those of no folder."""
    listed = (FRAMEWORK / "public_headers.txt").read_text().split("\n")
    headers = [line for line in listed if line.startswith("cirque/")]
    return [header for header in headers if header.split("/")[-2] == folder]


def without_bodies(code):
    """A declaration without what is between the braces of functions, and without private members."""
    if re.match(r"(template <[^{]*>\s*)?(class|struct|enum)\b", code):
        return without_private(code)
    return cut_body(code)


def cut_body(code):
    """Up to the brace at depth 0 that opens a body, initialisers of a constructor left out too."""
    depth = 0
    for i, char in enumerate(code):
        if char == "(":
            depth += 1
        elif char == ")":
            depth -= 1
        elif char == "{" and depth == 0 and (" = " not in code[:i] or "operator" in code[:i]):
            return re.sub(r"(?s)\)\s*:(?!:).*", ")", code[:i]).rstrip() + ";"
    return code


def members(body):
    """The members of a class with the comments before them, as pieces of text that together are the body."""
    pieces, piece, depth = [], "", 0
    for line in body.splitlines(keepends=True):
        piece += line
        code = re.sub(r"//.*", "", line)
        depth += code.count("{") + code.count("(") - code.count("}") - code.count(")")
        text = code.strip()
        if depth == 0 and (text.endswith((";", "}", ":")) and not text.startswith(":") or not text and not line.strip()):
            pieces.append(piece)
            piece = ""
    return pieces + [piece]


def without_private(code):
    open_brace, close_brace = code.find("{"), code.rfind("}")
    if code.startswith("enum") or open_brace < 0:
        return code
    kept, hidden = [], False
    for piece in members(code[open_brace + 1 : close_brace]):
        label = re.match(r"\s*(public|private|protected):", piece)
        if label:
            hidden = label[1] == "private"
        if hidden or (label and hidden):
            continue
        comment = re.match(r"(\s*(?:///?[^\n]*\n\s*)*)", piece)[1]
        rest = piece[len(comment) :]
        if re.search(r"\)[^;]*\{", rest) and not re.match(r"(struct|class|enum)\b", rest):
            rest = cut_body(rest) + "\n"
        kept.append(comment + rest)
    return code[: open_brace + 1] + "".join(kept).rstrip() + "\n}" + code[close_brace + 1 :]


def declarations(text):
    """(comment, code) of everything at the top of a header: comments of /// lines, without them."""
    text = re.sub(r"(?m)^\s*#.*(?:\\\n.*)*\n", "\n", text)
    text = re.sub(r"(?m)^namespace [\w:]* ?\{\n|^\}  // namespace.*\n", "\n", text)
    comment, code, depth = [], "", 0
    for line in text.splitlines():
        if not code and line.startswith("///"):
            comment.append(line[4:])
            continue
        if not code and not line.strip():
            if comment:
                yield comment, ""
            comment = []
            continue
        if not code and line.startswith("//"):
            continue
        code += line + "\n"
        bare = re.sub(r"//.*|\"[^\"]*\"", "", line)
        depth += bare.count("{") + bare.count("(") - bare.count("}") - bare.count(")")
        if depth == 0 and bare.rstrip().endswith((";", "}")):
            yield comment, code.rstrip()
            comment, code = [], ""


def name_of(code):
    """What a declaration declares, for a heading."""
    code = re.sub(r"\btemplate <[^{;(]*?>\s*(?=class|struct|[\w:]+[ &*<])", "", code, count=1)
    kind = re.match(r"(?:\[\[\w+\]\]\s*)?(class|struct|enum class|using)\s+(\w+)(<[^{:]*>)?", code)
    if kind:
        return kind[2] + (kind[3] or "")
    head = code.split("(")[0].split("=")[0].split("{")[0]
    words = re.findall(r"operator\s*\S+|[\w:]+(?=\s*(?:<[^<>]*>)?\s*$)", head.strip())
    return words[-1] if words else ""


def escaped(line):
    """What Markdown would take for its own, outside of `code`."""
    parts = line.split("`")
    return "`".join(part if i % 2 else re.sub(r"([*_<>\[\]|$])", r"\\\1", part) for i, part in enumerate(parts))


def prose(comment):
    """A comment as Markdown: indented lines as they stand, those of lists and the rest as text."""
    lines, fenced, listed = [], False, False
    for line in comment:
        listed = line.startswith("* ") or (listed and line.startswith("  "))
        verbatim = line.startswith("  ") and not listed
        if verbatim != fenced:
            lines += ["", "```text"] if verbatim else ["```", ""]
        fenced = verbatim
        lines.append(line if verbatim else "* " + escaped(line[2:]) if line.startswith("* ") else escaped(line))
    return "\n".join(lines + (["```"] if fenced else []))


def page(folder):
    """The page of a folder."""
    lines = [f"# {folder}/" if folder != "cirque" else "# cirque.h, openmesh.h", ""]
    for header in public_headers(folder):
        lines += [f"## {header}", "", "```cpp", f'#include "{header}"', "```", ""]
        for comment, code in declarations((FRAMEWORK / header).read_text()):
            name = name_of(code)
            if "::" in name:  # a member, defined outside of its class
                continue
            if name and (comment or re.match(r"(class|struct|enum)\b", code)) and not re.match(r"(class|struct) \w+;$", code):
                lines += [f"### {name}", ""]
            lines += [prose(comment), ""]
            if code:
                lines += ["```cpp", re.sub(r"///<?", "//", without_bodies(code)), "```", ""]
    return "\n".join(lines)


def folders():
    listed = (FRAMEWORK / "public_headers.txt").read_text().split("\n")
    return sorted({line.split("/")[-2] for line in listed if line.startswith("cirque/")})


if __name__ == "__main__":
    print("\n".join(page(folder) for folder in sys.argv[1:] or folders()))
