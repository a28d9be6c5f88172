"""What long work is doing, for whoever wants to know: nobody, unless a command says so."""

from __future__ import annotations

import sys
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from contextvars import ContextVar

Listener = Callable[[str], None]

_LISTENER: ContextVar[Listener | None] = ContextVar("listener", default=None)


def tell(text: str) -> None:
    """Say what is being done, in a few words."""
    listener = _LISTENER.get()
    if listener is not None:
        listener(text)


@contextmanager
def listening(listener: Listener) -> Iterator[None]:
    """Let a function hear what is told meanwhile."""
    token = _LISTENER.set(listener)
    try:
        yield
    finally:
        _LISTENER.reset(token)


@contextmanager
def shown_on_terminal() -> Iterator[None]:
    """Show what is told in one line of stderr, which is empty again in the end; only a terminal."""
    if not sys.stderr.isatty():
        yield
        return

    def show(text: str) -> None:
        sys.stderr.write(f"\r\x1b[K{text[:78]}")
        sys.stderr.flush()

    try:
        with listening(show):
            yield
    finally:
        show("")
