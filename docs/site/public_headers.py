"""Prints the headers of the library on one line: hottel.h, those beside it, and what these include."""

import re
from pathlib import Path

INCLUDE = re.compile(r'^#include "([^"]+)"', re.MULTILINE)


def headers_of(first: list[str]) -> list[str]:
    found, waiting = [], list(first)
    while waiting:
        header = waiting.pop(0)
        if header in found:
            continue
        found.append(header)
        waiting += INCLUDE.findall(Path(header).read_text(encoding="utf-8"))
    return found


if __name__ == "__main__":
    print(" ".join(headers_of(sorted(path.name for path in Path().glob("hottel*.h")))))
