"""The page, the Markdown and the terminal say the same, and nothing in them is acted upon."""

import base64
import io
import re
from html.parser import HTMLParser
from itertools import combinations, pairwise

import numpy as np
import pytest

from tests.verification.report.sample import FACTS, NETWORK, claim, write
from verification.report import build
from verification.report.page import HERE
from verification.report.records import count, headline, read_findings
from verification.report.terminal import show

HOSTILE = "</script><img onerror=alert(1)>"
VOID = {"meta", "link", "br", "hr", "img", "input"}


class Page(HTMLParser):
    """Collects ids and links, and insists on balanced tags."""

    def __init__(self, text):
        super().__init__()
        self.open, self.ids, self.links, self.tags = [], [], [], set()
        self.feed(text)
        assert self.open == []

    def handle_starttag(self, tag, attrs):
        values = dict(attrs)
        self.tags.add(tag)
        self.ids += [values["id"]] if "id" in values else []
        self.links += [values["href"]] if "href" in values else []
        if tag not in VOID:
            self.open.append(tag)

    def handle_startendtag(self, tag, attrs):
        self.handle_starttag(tag, attrs)
        if tag not in VOID:
            self.open.pop()

    def handle_endtag(self, tag):
        assert self.open.pop() == tag


def built(folder):
    html, text = build(folder)
    return html.read_text(), text.read_text()


def terminal(folder, **options):
    stream = io.TextIOWrapper(io.BytesIO(), encoding="utf-8")
    show(folder, stream=stream, **options)
    stream.flush()
    return stream.buffer.getvalue().decode()


@pytest.fixture
def folder(tmp_path):
    return write(tmp_path, [claim(k) for k in range(7)])


def test_tags_balance_ids_are_unique_and_every_link_lands(folder):
    page = Page(built(folder)[0])
    assert len(set(page.ids)) == len(page.ids)
    for link in page.links:
        inside = link.startswith("data:application/json;base64,") or link[1:] in page.ids
        assert inside or link.startswith("certificates/"), link


def test_nothing_is_requested_from_anywhere(folder):
    html, _ = built(folder)
    assert not re.search(r"(src|href)=.(https?:)?//", html)
    assert set(re.findall(r"url\(.", html)) <= {"url(#"}
    assert "default-src 'none'" in html.replace("&#39;", "'")


def test_the_same_records_give_the_same_bytes(folder):
    assert built(folder) == built(folder)


def test_three_reports_carry_the_same_claims_in_the_same_order(folder):
    html, text = built(folder)
    ids = [f"toy.claim_{k}" for k in range(7)]
    for report in (html, text.replace("\\", ""), terminal(folder)):
        places = [report.index(name) for name in ids]
        assert places == sorted(places)
        for words in (
            "3.8284",
            "CORRECTED",
            "2.207",
            "Berlin, Bonn",
            headline(read_findings(folder)),
        ):
            assert words in report


def test_hostile_names_are_only_shown(tmp_path):
    bad = dict.fromkeys(("title", "source", "reason", "repair", "printed", "sharp"), HOSTILE)
    bad |= {"statement": HOSTILE, "assumptions": [HOSTILE], "relies_on": [HOSTILE]}
    network = NETWORK | {"graph": HOSTILE, "cut": [HOSTILE, "\x1b[31mred"], "names": [HOSTILE] * 4}
    facts = FACTS | {"command": HOSTILE}
    folder = write(tmp_path, [claim(1, **bad, formula=HOSTILE)], [network], facts)
    html, text = built(folder)
    page = Page(html)
    assert "img" not in page.tags
    assert html.count("<script") == 1
    assert "<img" not in re.sub(r"`[^`]*`", "", text).replace("\\<", "")
    assert "\x1b" not in terminal(folder)


def test_two_hundred_claims_stay_light(tmp_path):
    html, _ = built(write(tmp_path, [claim(k) for k in range(200)]))
    assert len(html.encode()) < 600_000


def test_a_certificate_goes_into_the_page_whole_or_not_at_all(tmp_path):
    folder = write(tmp_path, [claim(k) for k in range(3)])
    (folder / "certificates" / "toy.claim_2.json").write_text("y" * 5000)
    html, _ = built(folder)
    held = [base64.b64decode(text) for text in re.findall(r"base64,([^\"]*)", html)]
    assert held == [b"x" * 1234] * 2
    assert 'href="certificates/toy.claim_2.json"' in html


def test_a_figure_says_what_it_shows_and_marks_the_deciding_value(folder):
    html, _ = built(folder)
    figure = html[html.index('<figure id="toy.claim_1-figure"') :].split("</figure>")[0]
    for words in ("<desc", "The printed line falls below the sharp one", "3.414", "fails here"):
        assert words in figure
    assert figure.count('class="line ') == 2
    assert "Below the sharp line agreement fails" in figure


def test_what_the_text_leaves_open_is_listed_with_what_is_missing(folder):
    for report in built(folder):
        for words in ("the error is small", "how small", "left open by the text"):
            assert words in report


def test_headings_skip_no_level_and_landmarks_are_there(folder):
    html, _ = built(folder)
    levels = [
        int(level) for level in re.findall(r"<h([1-6])", html.partition('<header class="top"')[2])
    ]
    assert levels.count(1) == 1
    assert all(b - a <= 1 for a, b in pairwise(levels))
    for landmark in ("<header", "<nav", "<main", "<footer", 'lang="en"'):
        assert landmark in html


def test_style_and_script_stay_small():
    assert (HERE / "page.js").stat().st_size < 4000
    assert (HERE / "page.js").stat().st_size + (HERE / "style.css").stat().st_size < 22_000


def test_a_plain_terminal_is_ascii_and_a_narrow_one_keeps_verdict_and_id(folder):
    text = terminal(folder, plain=True)
    assert text.isascii()
    assert "^ CORRECTED" in text
    assert "toy.claim_6" in text


def test_records_without_networks_or_values_are_reported_as_well(tmp_path):
    bare = claim(4, printed=None, sharp=None, printed_value=None, sharp_value=None, certificates=[])
    bare |= {"replay": [], "formula": "", "margin_text": "", "relies_on": [], "assumptions": []}
    folder = write(tmp_path, [bare], [])
    (folder / "networks.json").unlink()
    html, text = built(folder)
    assert "UNDECIDED" in html
    assert "UNDECIDED" in text
    assert "left undecided" in text


@pytest.mark.parametrize(
    "verdicts,words",
    [
        (["PROVED"] * 9, "All nine printed claims hold"),
        (["PROVED"], "The one printed claim hold"),
        ([], "No claim"),
        (
            ["PROVED", "CORRECTED", "CORRECTED", "REFUTED"],
            "Of four printed claims, one holds as printed, two hold once corrected and one is "
            "false",
        ),
        (["PROVED", "UNDECIDED"], "Of two printed claims, one holds as printed"),
        (["UNDECIDED"], "Of one printed claim, none is decided by proof"),
    ],
)
def test_the_headline_is_the_result(tmp_path, verdicts, words):
    folder = write(tmp_path, [claim(k, verdict=v) for k, v in enumerate(verdicts)])
    assert words in headline(read_findings(folder))


def test_counts_are_words_up_to_twelve():
    assert (count(1, "claim"), count(12, "claim"), count(13, "claim")) == (
        "one claim",
        "twelve claims",
        "13 claims",
    )


def themes():
    """Colour tokens of the light and the dark theme, from the style sheet."""
    light, dark = re.findall(r"(?::root|data-theme=dark\]){color-scheme[^}]*}", css())
    return {
        name: dict(re.findall(r"--([\w-]+):(#[0-9a-f]+)", block))
        for name, block in (("light", light), ("dark", dark))
    }


def css():
    return (HERE / "style.css").read_text()


def linear(colour):
    digits = colour[1:] if len(colour) == 7 else "".join(2 * c for c in colour[1:])
    values = np.array([int(digits[k : k + 2], 16) / 255 for k in (0, 2, 4)])
    return np.where(values <= 0.04045, values / 12.92, ((values + 0.055) / 1.055) ** 2.4)


def contrast(a, b):
    low, high = sorted(float(linear(c) @ [0.2126, 0.7152, 0.0722]) for c in (a, b))
    return (high + 0.05) / (low + 0.05)


@pytest.mark.parametrize("theme", ["light", "dark"])
def test_text_has_contrast_on_every_ground(theme):
    tokens = themes()[theme]
    for ink in ("ink", "ink2", "ink3", "link"):
        assert contrast(tokens[ink], tokens["paper"]) >= 4.5
    for verdict in ("PROVED", "CORRECTED", "REFUTED", "SUPPORTED", "UNDECIDED"):
        assert contrast(tokens[verdict], tokens[f"{verdict}-bg"]) >= 4.5
        assert contrast(tokens[verdict], tokens["paper"]) >= 4.5


# Linear-light matrices of Viénot, Brettel & Mollon (1999) for red- and green-blind eyes, and of
# Machado, Oliveira & Fernandes (2009), severity 1, for blue-blind ones.
BLINDNESS = {
    "protan": [[0.11238, 0.88762, 0], [0.11238, 0.88762, 0], [0.00401, -0.00401, 1]],
    "deutan": [[0.29275, 0.70725, 0], [0.29275, 0.70725, 0], [-0.02234, 0.02234, 1]],
    "tritan": [
        [1.25553, -0.07675, -0.17878],
        [-0.07841, 0.93081, 0.1476],
        [0.00473, 0.69137, 0.3039],
    ],
}


def lab(rgb):
    xyz = np.array([[0.4124, 0.3576, 0.1805], [0.2126, 0.7152, 0.0722], [0.0193, 0.1192, 0.9505]])
    t = xyz @ np.clip(rgb, 0, 1) / np.array([0.9505, 1.0, 1.089])
    f = np.where(t > 0.008856, np.cbrt(t), 7.787 * t + 16 / 116)
    return np.array([116 * f[1] - 16, 500 * (f[0] - f[1]), 200 * (f[1] - f[2])])


@pytest.mark.parametrize("theme", ["light", "dark"])
@pytest.mark.parametrize("blindness", sorted(BLINDNESS))
def test_verdict_colours_stay_apart_for_colour_blind_eyes(theme, blindness):
    """Icon and word differ as well; the colours must still be tellable where they meet."""
    tokens = themes()[theme]
    seen = {
        verdict: lab(np.array(BLINDNESS[blindness]) @ linear(tokens[verdict]))
        for verdict in ("PROVED", "CORRECTED", "REFUTED", "SUPPORTED", "UNDECIDED")
    }
    nearest = min(float(np.linalg.norm(a - b)) for a, b in combinations(seen.values(), 2))
    assert nearest >= 8
