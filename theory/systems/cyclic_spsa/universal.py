"""Universal statements of cyclic SPSA."""

from __future__ import annotations

from typing import ClassVar

from ... import universal


class Universal(universal.Universal):
    """What is proved for all sensors, targets and laws of the noise, and the proof."""

    system: ClassVar[str] = "cyclic_spsa"
