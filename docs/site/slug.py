"""The anchors of headings as GitHub makes them, so that links hold on both."""

import re


def slug(heading: str, separator: str) -> str:
    text = re.sub(r"<[^>]*>", "", heading).strip().lower()
    return re.sub(r"[^\w\- ]", "", text).replace(" ", separator)
