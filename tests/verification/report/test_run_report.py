"""The page and the Markdown of a run."""

import pytest

from tests.verification.report.run_sample import run, write_run
from tests.verification.report.test_report import HOSTILE, Page, built


def test_page_and_markdown_of_a_run_say_the_same(tmp_path):
    html, text = built(write_run(tmp_path, run()))
    for words in (
        "A helix seen by two sensors: position error 0.0213 m rms, every proved bound held",
        "raw average",
        "s2 no longer sees the target",
        "83.3 %",
        "the gains are not printed; M = K = 1, C = 2",
    ):
        assert words in html
        assert words in text.replace("\\", "")


def test_a_run_page_is_balanced_and_links_to_itself_only(tmp_path):
    html, _ = built(write_run(tmp_path, run()))
    page = Page(html)
    assert len(set(page.ids)) == len(page.ids)
    assert all(link[1:] in page.ids for link in page.links)
    assert html.count('role="img"') == 4


def test_a_crossed_bound_is_said_first(tmp_path):
    data = run()
    data["bounds"][0] |= {"holds": False, "reached": 1.3}
    html, text = built(write_run(tmp_path, data))
    assert "one bound crossed" in html
    assert "one bound crossed" in text
    assert "crosses a bound" in html


def test_a_run_without_bounds_events_or_error_is_reported(tmp_path):
    data = run(bounds=[], events=[], assumptions=[])
    for estimate in data["estimates"]:
        estimate.update(data["target"])
    html, _ = built(write_run(tmp_path, data))
    assert "No bound is proved for this setting" in html


def test_names_in_a_run_are_only_shown(tmp_path):
    data = run(title=HOSTILE, about=HOSTILE, notes=[HOSTILE], assumptions=[HOSTILE])
    data["events"][0]["text"] = data["sensors"][0]["name"] = HOSTILE
    html, text = built(write_run(tmp_path, data))
    assert "img" not in Page(html).tags
    assert "<img" not in text.replace("\\<", "")


def test_a_long_run_is_simplified_and_stays_light(tmp_path):
    html, _ = built(write_run(tmp_path, run(steps=6000)))
    assert len(html) < 120_000


@pytest.mark.parametrize("content", ["{}", "[]", '{"format": "other"}', "no json"])
def test_what_is_no_run_is_refused(tmp_path, content):
    (tmp_path / "run.json").write_text(content)
    with pytest.raises(ValueError, match=r"run|Expecting"):
        built(tmp_path)
