"""The documentation as a site: framework/docs/build."""
import pathlib
import re
import shutil
import sys

PROJECT = pathlib.Path(__file__).resolve().parent.parent.parent

sys.path.insert(0, str(PROJECT / "framework/docs"))
sys.dont_write_bytecode = True
import reference  # noqa: E402

project = "Cirque"
author = "The Cirque authors"
copyright = author
extensions = ["myst_parser"]
myst_enable_extensions = ["dollarmath"]
myst_heading_anchors = 3
html_theme = "furo"
html_static_path = ["static"]
html_title = "Cirque"
html_show_sphinx = html_show_copyright = False
html_copy_source = html_show_sourcelink = False
exclude_patterns = ["README.md"]
templates_path = []

# Pages of the project that lie elsewhere, by what they are called here.
ELSEWHERE = {
    "config": "experiments/CONFIG.md",
    "contributing": "CONTRIBUTING.md",
    "changelog": "CHANGELOG.md",
    "best_maps": "results/best_maps.md",
}


def link_within_site(source, folder):
    """Links from a page in this folder of the project, those to pages of the site as such."""
    pages = {PROJECT / path: f"{page}.md" for page, path in ELSEWHERE.items()}

    def lead(match):
        target, _, anchor = match[1].partition("#")
        path = (folder / target).resolve()
        here = pages.get(path) or (path.name if path.parent == PROJECT / "framework" / "docs" else target)
        return f"]({here}{'#' if anchor else ''}{anchor})"

    return re.sub(r"\]\(([^):]+)\)", lead, source)


def read_page(app, page, source):
    if page.startswith("reference/"):
        source[0] = reference.page(page.split("/")[1])
        return
    path = PROJECT / ELSEWHERE.get(page, f"framework/docs/{page}.md")
    source[0] = link_within_site(path.read_text(), path.parent)


def made_elsewhere(app, env, added, changed, removed):
    """Pages whose source is no file of this folder, so that nobody knows whether they have changed."""
    return [page for page in env.found_docs if page in ELSEWHERE or page.startswith("reference/")]


def keep_within_site(app, exception):
    """Debian's theme names a style sheet by where Debian's web servers have it: a copy of that goes beside it."""
    styles = pathlib.Path(app.outdir) / "_static/styles"
    served = re.compile(r"url\(/javascript/([^)]+)\)")
    for sheet in [] if exception else styles.glob("*.css"):
        text = sheet.read_text()
        for path in served.findall(text):
            shutil.copy(pathlib.Path("/usr/share/javascript") / path, styles)
        sheet.write_text(served.sub(lambda match: f"url({pathlib.PurePath(match[1]).name})", text))


def setup(app):
    app.connect("build-finished", keep_within_site)
    app.connect("env-get-outdated", made_elsewhere)
    app.connect("source-read", read_page)
