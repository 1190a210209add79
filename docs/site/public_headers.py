"""Prints the headers that hottel.h has, itself first, on one line."""

import re
from pathlib import Path

INCLUDE = re.compile(r'^#include "([^"]+)"', re.MULTILINE)


def headers_of(first: str) -> list[str]:
    found, waiting = [], [first]
    while waiting:
        header = waiting.pop(0)
        if header in found:
            continue
        found.append(header)
        waiting += INCLUDE.findall(Path(header).read_text(encoding="utf-8"))
    return found


if __name__ == "__main__":
    print(" ".join(headers_of("hottel.h")))
