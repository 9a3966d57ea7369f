#!/usr/bin/python3
"""usage: framework/docs/check_links.py FOLDER

Follows every link of a built site, of its pages and its style sheets, to the file and the place in it that it names; links to other
sites are left alone. Prints those that lead nowhere; exit status 1 where there are any."""

import html
import pathlib
import re
import sys
import urllib.parse

IN_PAGE = re.compile(r'\b(?:href|src)="([^"]+)"')
IN_STYLE = re.compile(r"""url\(\s*["']?([^"')]+)""")
PLACE = re.compile(r'\b(?:id|name)="([^"]+)"')


def fault(link, source, places):
    """What is wrong with a link in the file `source`; None: nothing."""
    parts = urllib.parse.urlsplit(link)
    if parts.scheme or parts.netloc:
        return None
    if parts.path.startswith("/"):
        return "leads out of the site"
    target = (source.parent / urllib.parse.unquote(parts.path)).resolve() if parts.path else source
    if not target.exists():
        return "no such file"
    if parts.fragment and target in places and urllib.parse.unquote(parts.fragment) not in places[target]:
        return "no such place in it"
    return None


def main(arguments):
    if len(arguments) != 1 or not pathlib.Path(arguments[0]).is_dir():
        print(__doc__, file=sys.stderr)
        return 2
    site = pathlib.Path(arguments[0]).resolve()
    text = {path: path.read_text() for path in sorted(site.rglob("*")) if path.suffix in (".html", ".css")}
    places = {path: set(PLACE.findall(own)) for path, own in text.items() if path.suffix == ".html"}
    links = dead = 0
    for source, own in text.items():
        for link in (IN_PAGE if source.suffix == ".html" else IN_STYLE).findall(own):
            links += 1
            wrong = fault(html.unescape(link), source, places)
            if wrong:
                dead += 1
                print(f"{source.relative_to(site)}: {link}: {wrong}")
    print(f"{len(places)} pages, {links} links, {dead} dead")
    return 1 if dead else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
