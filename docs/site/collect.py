"""Collects the pages of the project, and the files that they link to, for mkdocs: collect.py FOLDER.

Pages keep their places, so that their links hold. What stands in docs/README.md, in its order, is the menu. A link to a
folder without a page becomes plain text.
"""

import json
import re
import shutil
import subprocess
import sys
from pathlib import Path

LINK = re.compile(r"(?<!!)\[([^\]]+)\]\(([^)#\s]+)(#[^)\s]*)?\)")
IMAGE = re.compile(r"!\[[^\]]*\]\(([^)\s]+)\)")
REFERENCE = """# C++ reference

[The headers that are installed](library/files.html), each with its contract, and [all classes](library/annotated.html).
What to begin with: [the library](docs/library.md).
"""
MENU_ITEM = re.compile(r"^- .*?\[([^\]]+)\]\(([^)#]+)\)")


def is_local(target: str) -> bool:
    return "://" not in target and not target.startswith("mailto:")


def pages() -> list[Path]:
    listed = subprocess.run(["git", "ls-files", "*.md"], check=True, capture_output=True, text=True)
    return [Path(line) for line in listed.stdout.splitlines()]


def linked_text(page: Path, text: str, files: set[Path]) -> str:
    """The page as it stands on the site; adds the files that it needs."""

    def link(match: re.Match) -> str:
        words, target, place = match.group(1), match.group(2), match.group(3) or ""
        if not is_local(target):
            return match.group(0)
        path = page.parent / target
        if path.is_dir():
            return f"[{words}]({target.rstrip('/')}/README.md{place})" if (path / "README.md").exists() else words
        if path.suffix != ".md":
            files.add(Path(path.resolve().relative_to(Path.cwd())))
        return match.group(0)

    for image in IMAGE.findall(text):
        if is_local(image):
            files.add(Path((page.parent / image).resolve().relative_to(Path.cwd())))
    return LINK.sub(link, text)


def menu() -> list:
    """What docs/README.md lists, under its headings."""
    sections: list = [{"hottel": "README.md"}, {"Documentation": "docs/README.md"}]
    items: list = []
    for line in Path("docs/README.md").read_text(encoding="utf-8").splitlines():
        if line.endswith(":") and not line.startswith("-"):
            items = []
            sections.append({line.rstrip(":"): items})
        elif match := MENU_ITEM.match(line):
            path = Path("docs", match.group(2)).resolve().relative_to(Path.cwd())
            if path.suffix == ".md":
                items.append({match.group(1): str(path)})
    return sections


def main(folder: Path) -> None:
    source = folder / "pages"
    files: set[Path] = set()
    for page in pages():
        place = source / page
        place.parent.mkdir(parents=True, exist_ok=True)
        place.write_text(linked_text(page, page.read_text(encoding="utf-8"), files), encoding="utf-8")
    for file in sorted(files):
        (source / file).parent.mkdir(parents=True, exist_ok=True)
        shutil.copy(file, source / file)
    (source / "reference.md").write_text(REFERENCE, encoding="utf-8")
    settings = {
        "site_name": "hottel",
        "docs_dir": "pages",
        "theme": {"name": "mkdocs", "navigation_depth": 2, "highlightjs": False},
        "nav": menu() + [{"C++ reference": "reference.md"}],
        "plugins": ["search"],
        "use_directory_urls": False,
        "markdown_extensions": ["tables", "fenced_code", {"toc": {"permalink": True, "slugify": "SLUGIFY"}}],
    }
    text = json.dumps(settings, indent=1, ensure_ascii=False)
    (folder / "mkdocs.yml").write_text(text.replace('"SLUGIFY"', "!!python/name:slug.slug"), encoding="utf-8")


if __name__ == "__main__":
    main(Path(sys.argv[1]))
