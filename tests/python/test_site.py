"""The pages of the site (tools/site): collected as mkdocs takes them."""

import json
import re
import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]


def collected(tmp_path):
    subprocess.run([sys.executable, "docs/site/collect.py", str(tmp_path)], check=True, cwd=ROOT)
    return tmp_path / "pages"


def test_what_pages_link_to_is_there(tmp_path):
    pages = collected(tmp_path)
    targets = 0
    for page in pages.rglob("*.md"):
        if page.name == "reference.md":
            continue
        for target in re.findall(r"\]\(([^)#\s]+)[^)]*\)", page.read_text(encoding="utf-8")):
            if "://" in target:
                continue
            targets += 1
            assert (page.parent / target).is_file(), (page, target)
    assert targets > 300


def test_the_menu_has_the_pages_that_docs_list(tmp_path):
    pages = collected(tmp_path)
    text = (tmp_path / "mkdocs.yml").read_text(encoding="utf-8").replace("!!python/name:slug.slug", '"slug"')
    menu = json.loads(text)["nav"]
    listed = [page for section in menu for items in section.values() if isinstance(items, list) for item in items
              for page in item.values()]
    assert "docs/glossary.md" in listed and "docs/design/house.md" in listed
    assert len(listed) == len(set(listed)) > 30
    assert all((pages / page).is_file() for page in listed)


def test_the_library_is_hottel_h_and_what_stands_beside_it():
    headers = subprocess.run([sys.executable, "docs/site/public_headers.py"], check=True, cwd=ROOT, capture_output=True,
                             text=True).stdout.split()
    assert headers[0] == "hottel.h"
    assert all((ROOT / header).is_file() for header in headers)
    assert "solver/plane/simulation/simulation.h" in headers
    assert "hottel_pictures.h" in headers and "viewer/picture/plane/scene_picture.h" in headers
