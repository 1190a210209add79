"""How far long work is, for people."""

from __future__ import annotations

import importlib
import sys
from typing import Any, TextIO

__all__ = ["ProgressBar"]


class ProgressBar:
    """A bar for `progress=` of a Simulation: of tqdm where that is installed, else a line of text that is written over.

    ProgressBar(file=None). file: where to, standard error where None. A bar may serve any number of simulations.

    >>> import io
    >>> bar = hottel.ProgressBar(file=io.StringIO())
    >>> cube = hottel.Simulation(hottel.read_scene("scenes/space/cube.json"), progress=bar)
    >>> len(cube.factors)
    13
    """

    def __init__(self, file: TextIO | None = None) -> None:
        """Makes a bar; nothing is drawn before there is something to tell."""
        self._file = file
        self._stage: str | None = None
        self._bar: Any = None
        self._told = -1

    def __call__(self, stage: str, fraction: float) -> None:
        """Tells that so much of a stage is done, 0 to 1."""
        if stage != self._stage:
            self.close()
            self._stage = stage
            self._bar = self._new_bar(stage)
        percent = int(100 * fraction)
        if percent == self._told:
            return
        if self._bar is not None:
            self._bar.update(percent - max(self._told, 0))
        else:
            print(f"\r{stage}: {percent:3} %", end="", file=self._file or sys.stderr, flush=True)
        self._told = percent

    def close(self) -> None:
        """Ends the line of the stage that was told of last."""
        if self._bar is not None:
            self._bar.close()
        elif self._stage is not None:
            print(file=self._file or sys.stderr)
        self._stage, self._bar, self._told = None, None, -1

    def _new_bar(self, stage: str) -> Any:
        try:
            tqdm = importlib.import_module("tqdm.auto").tqdm
        except ImportError:
            return None
        return tqdm(total=100, desc=stage, unit="%", file=self._file)
