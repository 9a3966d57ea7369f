#!/usr/bin/env python3
"""Draws architecture.svg: the folders of framework/cirque on their floors (floors.txt), and an
arrow for every folder that includes another, with the number of its include lines.

    framework/docs/draw_architecture.py [OUT.svg]      default: architecture.svg beside this script

Ends with status 1 and draws nothing when an include points up or sideways.
"""
import re
import sys
from collections import Counter
from pathlib import Path

DOCS = Path(__file__).resolve().parent
SOURCES = DOCS.parent / "cirque"
INCLUDE = re.compile(r'^\s*#\s*include\s*["<]cirque/(\w+)/', re.M)

WIDTH, MARGIN, GAP = 1240, 20, 22  # of the picture, around it, between boxes [px]
BOX_HEIGHT, FLOOR_HEIGHT = 50, 128  # of a box, from floor to floor [px]
WIDEST_BOX = 176  # of a box that shares its floor [px]
COLOURS = ["#3b82c4", "#d0602c", "#4f9d4a", "#a85fb8", "#b8922a", "#c94f6d", "#2f9e94", "#7d7f8c"]

STYLE = """
  text { font-family: system-ui, sans-serif; fill: #1f2328; text-anchor: middle; }
  .name { font-size: 17px; font-weight: 600; }
  .small { font-size: 12px; fill: #59636e; }
  .count { font-size: 10.5px; font-weight: 600; }
  .box { fill: #f6f8fa; stroke: #59636e; }
  .leaf { fill: none; stroke: #59636e; stroke-dasharray: 5 4; }
  .arrow { fill: none; stroke-opacity: 0.75; }
  .paper { fill: #ffffff; }
  @media (prefers-color-scheme: dark) {
    text { fill: #e6edf3; } .small { fill: #9198a1; } .box { fill: #1c2128; stroke: #9198a1; }
    .leaf { stroke: #9198a1; } .paper { fill: #0d1117; }
  }
"""


def read_floors():
    """The floors from the ground up, each a list of folders."""
    lines = (DOCS / "floors.txt").read_text().splitlines()
    return [line.split() for line in lines if line and not line.startswith("#")]


def count_includes(folders):
    """(number of sources of a folder, number of include lines from a folder to another)."""
    files, includes = Counter(), Counter()
    for path in sorted(SOURCES.rglob("*")):
        folder = path.relative_to(SOURCES).parts[0]
        if path.suffix not in (".h", ".cc") or folder not in folders:
            continue
        files[folder] += 1
        for target in INCLUDE.findall(path.read_text()):
            if target != folder:
                includes[folder, target] += 1
    return files, includes


def place_boxes(floors):
    """The box (x, y, width) of every folder; a folder alone on its floor is as wide as the house."""
    boxes = {}
    for floor, folders in enumerate(reversed(floors), start=1):
        n = len(folders)
        room = (WIDTH - 2 * MARGIN - (n - 1) * GAP) / n
        width = room if n == 1 else min(room, WIDEST_BOX)
        # Boxes of one floor stand apart as far as there is room.
        step = (WIDTH - 2 * MARGIN) / n
        for k, folder in enumerate(folders):
            x = MARGIN + (k + 0.5) * step - width / 2
            boxes[folder] = (x, MARGIN + 44 + (floor - 1) * FLOOR_HEIGHT + 62, width)
    return boxes


def spread(box, names, boxes):
    """Where on an edge of a box the arrows of `names` begin or end: in the order of their places."""
    x, _, width = box
    order = sorted(names, key=lambda name: boxes[name][0] + boxes[name][2] / 2)
    return {name: x + width * (k + 0.5) / len(order) for k, name in enumerate(order)}


def arrow(start, end, colour, count, title):
    (x0, y0), (x1, y1) = start, end
    bend = min(60, 0.5 * (y1 - y0))
    width = 1 + 0.35 * min(count, 12) ** 0.7
    path = f"M{x0:.1f},{y0:.1f} C{x0:.1f},{y0 + bend:.1f} {x1:.1f},{y1 - bend:.1f} {x1:.1f},{y1 - 7:.1f}"
    head = f"M{x1 - 4:.1f},{y1 - 8:.1f} L{x1 + 4:.1f},{y1 - 8:.1f} L{x1:.1f},{y1:.1f} Z"
    return (f'<g><title>{title}</title><path class="arrow" stroke="{colour}" '
            f'stroke-width="{width:.2f}" d="{path}"/><path fill="{colour}" d="{head}"/></g>')


def draw_arrows(includes, boxes, colours):
    """The arrows, and the numbers where they begin."""
    ends, lines, counts = {}, [], []
    for folder in boxes:
        ends[folder] = spread(boxes[folder], [a for a, b in includes if b == folder], boxes)
    for folder, box in boxes.items():
        starts = spread(box, [b for a, b in includes if a == folder], boxes)
        for target, x in starts.items():
            count = includes[folder, target]
            start, end = (x, box[1] + BOX_HEIGHT), (ends[target][folder], boxes[target][1])
            title = f"{folder} includes {target}: {count}"
            lines.append(arrow(start, end, colours[folder], count, title))
            counts.append(f'<text class="count" style="fill:{colours[folder]}" x="{x:.1f}" '
                          f'y="{start[1] - 4:.1f}">{count}</text>')
    return lines, counts


def draw_box(name, box, note, style="box"):
    x, y, width = box
    return (f'<rect class="{style}" x="{x:.1f}" y="{y}" width="{width:.1f}" '
            f'height="{BOX_HEIGHT}" rx="5"/>'
            f'<text class="name" x="{x + width / 2:.1f}" y="{y + 18}">{name}</text>'
            f'<text class="small" x="{x + width / 2:.1f}" y="{y + 33}">{note}</text>')


def draw(floors, files, includes):
    boxes = place_boxes(floors)
    colours = {name: COLOURS[k % len(COLOURS)] for k, name in enumerate(sorted(boxes))}
    lines, counts = draw_arrows(includes, boxes, colours)
    house = WIDTH - 2 * MARGIN
    parts = [draw_box("experiments  bench  tests", (MARGIN, MARGIN, house),
                      "leaves: they include all floors, and nobody includes them", "leaf")]
    parts += lines
    parts += [draw_box(name, box, f"{files[name]} files") for name, box in boxes.items()]
    height = max(y for _, y, _ in boxes.values()) + BOX_HEIGHT + MARGIN
    return "\n".join([
        f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {WIDTH} {height}" width="{WIDTH}" '
        f'height="{height}">', "<title>Floors of framework/cirque</title>",
        f"<style>{STYLE}</style>", '<rect class="paper" width="100%" height="100%"/>',
        *parts, *counts, "</svg>", ""])


def main():
    floors = read_floors()
    floor_of = {folder: k for k, folders in enumerate(floors) for folder in folders}
    files, includes = count_includes(floor_of)
    faults = [f"{a} includes {b}, which does not lie below it" for a, b in sorted(includes)
              if floor_of.get(b, len(floors)) >= floor_of[a]]
    if faults:
        sys.exit("\n".join(faults))
    out = Path(sys.argv[1]) if len(sys.argv) > 1 else DOCS / "architecture.svg"
    out.write_text(draw(floors, files, includes))


if __name__ == "__main__":
    main()
