"""Files stay small enough to be read in one go."""

from statistics import quantiles

from tests.meta.repository import ROOT, tracked_files

AIM = 250
LIMIT = 500

# A file above the limit stands here with the reason why it is one file.
LONGER: dict[str, str] = {
    "verification/certificates/check.py": (
        "the one program that has to be believed is read in one go"
    ),
}

WRITTEN_BY_HAND = (".py", ".c", ".h", ".js", ".css", ".html", ".md", ".toml", ".yml")
PRODUCED = ("sensortrack/generated/", "sensortrack/data/")


def lines(name: str) -> int:
    return len((ROOT / name).read_text().splitlines())


SIZES = {
    name: lines(name)
    for name in tracked_files()
    if name.endswith(WRITTEN_BY_HAND) and not name.startswith(PRODUCED)
}


def test_no_file_is_longer_than_the_limit() -> None:
    too_long = {n: size for n, size in SIZES.items() if size > LIMIT and n not in LONGER}
    assert not too_long, f"above {LIMIT} lines; split them, or give a reason in LONGER"


def test_exemptions_are_still_needed() -> None:
    stale = [name for name in LONGER if SIZES.get(name, 0) <= LIMIT]
    assert not stale, "no longer above the limit; take them out of LONGER"
    assert all(len(reason) > 20 for reason in LONGER.values())


def test_four_files_in_five_meet_the_aim() -> None:
    sizes = [size for name, size in SIZES.items() if name.endswith(".py")]
    above = sorted(name for name, size in SIZES.items() if name.endswith(".py") and size > AIM)
    assert quantiles(sizes, n=5)[-1] <= AIM, f"more than a fifth is above {AIM} lines: {above}"
