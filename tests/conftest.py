"""Settings that every test shares: the same examples everywhere, skips refused when strict.

With ``SENSORTRACK_STRICT=1`` in the environment a skipped test or module is a failure:
a run that was meant to check everything cannot be green because something was missing.
"""

import os
from collections.abc import Generator

import pytest
from hypothesis import settings

# Derandomized: the same examples on every machine. No deadline: a slow runner is no failure.
settings.register_profile("facts", derandomize=True, deadline=None, database=None)
settings.load_profile("facts")

STRICT = os.environ.get("SENSORTRACK_STRICT") == "1"


def _refuse_skip(report: pytest.TestReport | pytest.CollectReport) -> None:
    if STRICT and report.skipped and not hasattr(report, "wasxfail"):
        reason = report.longrepr[-1] if isinstance(report.longrepr, tuple) else report.longrepr
        report.outcome = "failed"
        report.longrepr = f"{report.nodeid}: refused in a strict run: {reason}"


@pytest.hookimpl(wrapper=True)
def pytest_runtest_makereport() -> Generator[None, pytest.TestReport, pytest.TestReport]:
    report = yield
    _refuse_skip(report)
    return report


@pytest.hookimpl(wrapper=True)
def pytest_make_collect_report() -> Generator[None, pytest.CollectReport, pytest.CollectReport]:
    report = yield
    _refuse_skip(report)
    return report
