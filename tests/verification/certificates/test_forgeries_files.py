"""Files that are no certificates: bytes, sizes, depths, and what they may print."""

import json
import subprocess
import sys

import pytest

from verification.certificates import check

from .documents import CHECKER, document, judged, run_checker
from .samples import cuts, samples

SMALL = min((json.dumps(made) for made in samples().values() if made["witness"]), key=len)
"""The shortest certificate whose data are not enough by themselves."""


DEEP = 10**5


def patched(key, text):
    """The small certificate with the raw text of one value exchanged."""
    made = json.loads(SMALL)
    return json.dumps(made | {key: "@"}).replace('"@"', text)


UNREADABLE = {
    "nothing": "",
    "white space": " \n",
    "two certificates": SMALL + SMALL,
    "two certificates on two lines": SMALL + "\n" + SMALL,
    "something after it": SMALL + "x",
    "a float": patched("about", "1.5"),
    "a float that is whole": patched("about", "1.0"),
    "an exponent": patched("about", "1e5"),
    "a huge exponent": patched("about", "1e9999999"),
    "not a number": patched("about", "NaN"),
    "infinity": patched("about", "[Infinity]"),
    "less than all": patched("about", "-Infinity"),
    "a key given twice": '{"format": "x", ' + SMALL[1:],
    "an inner key given twice": patched("about", '{"a": 1, "a": 1}'),
    "a megabyte of digits": patched("about", "7" * 2**20),
    "digits beyond the limit": patched("about", "7" * 4301),
    "deep lists": "[" * DEEP + "]" * DEEP,
    "deep objects": '{"a":' * DEEP + "1" + "}" * DEEP,
    "a deep witness": patched("witness", "[" * DEEP + "]" * DEEP),
    "single quotes": SMALL.replace('"', "'"),
    "a comma too many": SMALL[:-1] + ",}",
    "a number with zeros before": patched("about", "007"),
    "a plus sign": patched("about", "+7"),
    "a mark before it": "\ufeff" + SMALL,
    "a control character": patched("about", '"\x01"'),
}


INVALID = {
    "no object": "[]",
    "a text": '"certificate"',
    "a number": "1",
    "null": "null",
    "true": "true",
    "an empty object": "{}",
    "a list of certificates": f"[{SMALL}]",
    "another format": patched("format", '"sensortrack-certificate/2"'),
    "a format that is a list": patched("format", '["sensortrack-certificate/1"]'),
    "a digest of another version": patched("digest", '"' + "0" * 64 + '"'),
    "a digest in capitals": SMALL.replace(
        json.loads(SMALL)["digest"], json.loads(SMALL)["digest"].upper()
    ),
    "an unknown statement": patched("name", '"theorem_2"'),
    "a name with a dot": patched("system", '""'),
    "a name that is a list": patched("name", "[]"),
    "an unknown case": patched("case", '"REFUTED?"'),
    "a case that is a list": patched("case", "[1]"),
    "another verdict": patched("verdict", '"CORRECTED"'),
    "a theorem relied on more": patched("relies_on", '["more"]'),
    "a megabyte of digits as text": patched("inputs", '{"graph": "' + "7" * 2**20 + '"}'),
    "moderately deep": patched("witness", "[" * 500 + "]" * 500),
    "moderately deep inputs": patched("inputs", "[" * 500 + "]" * 500),
}


@pytest.mark.parametrize("what", UNREADABLE)
def test_what_cannot_be_read(what, known, tmp_path):
    entry, status = judged(UNREADABLE[what], tmp_path / "it.json", known)
    assert (entry["valid"], status) == (False, 2)
    assert entry["reason"].isprintable()


@pytest.mark.parametrize("what", INVALID)
def test_what_proves_nothing(what, known, tmp_path):
    entry, status = judged(INVALID[what], tmp_path / "it.json", known)
    assert (entry["valid"], status) == (False, 1)
    assert entry["reason"].isprintable()


def test_a_file_cut_off_at_any_byte(known, tmp_path):
    path = tmp_path / "it.json"
    data = SMALL.encode()
    for end in range(len(data)):
        path.write_bytes(data[:end])
        entry, status = check.check_file(str(path), known)
        assert (entry["valid"], status) == (False, 2)
    path.write_bytes(data)
    assert check.check_file(str(path), known)[1] == 0


def test_any_byte_changed(known, tmp_path):
    """In the head it is refused; the producer's note and white space alone may differ."""
    path = tmp_path / "it.json"
    data = SMALL.encode()
    note = data.index(b'"about"')
    for place in range(len(data)):
        for byte in (data[place] ^ 1, 0x20, 0x39, 0x00, 0xFF):
            path.write_bytes(data[:place] + bytes([byte]) + data[place + 1 :])
            entry, _ = check.check_file(str(path), known)
            if entry["valid"] and not place > note:
                forged = json.loads(path.read_bytes())
                forged.pop("about")
                kept = json.loads(SMALL)
                kept.pop("about")
                assert entry["inputs"] == forged["inputs"]
                assert forged == kept or forged["witness"] != kept["witness"]


@pytest.mark.parametrize("data", [b"\xff\xfe", SMALL.encode("utf-16"), b"\x00" * 100, b'"\xc3"'])
def test_other_encodings(data, known, tmp_path):
    path = tmp_path / "it.json"
    path.write_bytes(data)
    assert check.check_file(str(path), known)[1] == 2


def test_a_file_that_is_absent_a_folder_or_too_large(known, tmp_path, monkeypatch):
    assert check.check_file(str(tmp_path / "none.json"), known)[1] == 2
    assert check.check_file(str(tmp_path), known)[1] == 2
    monkeypatch.setattr(check, "FILE_BYTES", len(SMALL) - 1)
    entry, status = judged(SMALL, tmp_path / "it.json", known)
    assert status == 2
    assert "a file of this size" in entry["reason"]


def test_a_deep_file_does_not_hurt_the_next_one(known, tmp_path):
    """Nor does a large enumeration before a deep file."""
    n = 500
    graph = {"nodes": [str(i) for i in range(n)], "edges": [[i, i + 1] for i in range(n - 1)]}
    part = {"kind": "enumeration", "order": list(range(n))}
    made = document(
        known["bearing_dac.gain"],
        {"graph": graph, "gamma": "0", "beta": "0"},
        [cuts(part)],
        name="bearing_dac.gain",
    )
    for name, text in (("a", json.dumps(made)), ("b", "[" * DEEP), ("c", SMALL)):
        (tmp_path / f"{name}.json").write_text(text)
    ran = run_checker("--json", *sorted(tmp_path.glob("*.json")))
    assert ran.returncode == 2, ran.stderr
    assert [entry["valid"] for entry in json.loads(ran.stdout)] == [True, False, True]


def test_exit_statuses(tmp_path):
    for name, text in (("valid", SMALL), ("invalid", INVALID["null"]), ("unreadable", "{")):
        (tmp_path / name).write_text(text)

    def status(*names):
        return run_checker(*(tmp_path / name for name in names)).returncode

    assert status("valid") == 0
    assert status("valid", "valid") == 0
    assert status("valid", "invalid") == 1
    assert status("invalid", "unreadable", "valid") == 2
    assert status("none") == 2
    assert run_checker().returncode == 2
    assert run_checker("--help").returncode == 0
    for bad in ("none", "unreadable"):
        ran = run_checker("--statements", tmp_path / bad, tmp_path / "valid")
        assert ran.returncode == 2
        assert "Traceback" not in ran.stderr


def test_statements_of_another_shape_make_everything_invalid(tmp_path):
    (tmp_path / "it.json").write_text(SMALL)
    name = f"{json.loads(SMALL)['system']}.{json.loads(SMALL)['name']}"
    for text in (
        "[]",
        "{}",
        "1",
        json.dumps([name]),
        json.dumps({name: {}}),
        json.dumps({name: []}),
    ):
        (tmp_path / "statements.json").write_text(text)
        ran = run_checker("--statements", tmp_path / "statements.json", tmp_path / "it.json")
        assert ran.returncode == 1
        assert "Traceback" not in ran.stderr


TRICKS = ["\x1b[2J\x1b[1;1HVALID", "x\nVALID other.json", "\u202edilav", "\x07\x00", "\ud800"]


@pytest.mark.parametrize("trick", TRICKS)
def test_reasons_play_no_tricks_with_a_terminal(trick, tmp_path):
    made = json.loads(SMALL)
    for forged in (made | {"name": trick}, made | {"digest": trick}, made | {"format": trick}):
        (tmp_path / "it.json").write_text(json.dumps(forged))
        ran = run_checker(tmp_path / "it.json")
        assert ran.returncode == 1, ran.stderr
        lines = ran.stdout.splitlines()
        assert [line.startswith("INVALID ") for line in lines] == [True, False]
        assert all(line.isascii() and line.isprintable() for line in lines)


def test_the_checker_stands_alone(tmp_path):
    """Copied away with its statements, by any Python, it needs nothing else."""
    for name in ("check.py", "statements.json"):
        (tmp_path / name).write_bytes(CHECKER.with_name(name).read_bytes())
    (tmp_path / "it.json").write_text(SMALL)
    (tmp_path / "fractions.py").write_text("raise SystemExit('a module planted beside it')")
    ran = subprocess.run(
        [sys.executable, "-I", "-S", "check.py", "it.json"],
        cwd=tmp_path,
        capture_output=True,
        text=True,
        check=False,
    )
    assert ran.returncode == 0, ran.stderr
    assert ran.stdout.startswith("VALID it.json")
