"""Universal statements of the bearing-based average consensus."""

from __future__ import annotations

from typing import ClassVar

from ... import universal


class Universal(universal.Universal):
    """What is proved for all networks, and the proof."""

    system: ClassVar[str] = "bearing_dac"
