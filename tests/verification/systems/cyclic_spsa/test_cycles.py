"""Limits of cycles of blocks beside the limits of the blocks."""

import json
from fractions import Fraction

import pytest

from sensortrack.errors import InputError
from verification.certificates import check
from verification.certificates.make import statements
from verification.inputs import read_inputs
from verification.systems.cyclic_spsa.stability.cycles import LISTS, blocks_step_limit
from verification.systems.cyclic_spsa.stability.steps import step_limit

NOISE = ((1, 0, 0, 0), (0, 2, 0, 0), (0, 0, 3, 1), (0, 0, 1, 3))


def cycle(blocks, **changes):
    """Values as the command line makes them."""
    noise = tuple(tuple(map(Fraction, row)) for row in NOISE)
    h = tuple(map(Fraction, (1, 1, 2, 3)))
    plain = {"h": h, "H": None, "Xi": noise, "eta": (Fraction(0),), "beta": Fraction(1)}
    return plain | {"reading": "two", "blocks": blocks} | changes


def test_the_block_with_the_smallest_limit_decides():
    answer = blocks_step_limit(cycle(((0, 1), (2, 3))))
    # 2/(2(1 + 3/2) + 3(1 + 3/2))
    assert answer.exact == {"kind": "rational", "value": "4/25"}
    entry = check.check_document(answer.certificate, statements())
    assert entry["inputs"]["h"] == [["2"], ["3"]]
    assert entry["inputs"]["k"] == "2"
    assert "block 2 decides" in answer.notes[0]
    limits = [block["limit"] for block in answer.more["blocks_limits"]().data]
    assert limits == [2 / 3.5, 0.16]


def test_one_block_is_all_of_it():
    values = cycle(((3, 2, 1, 0),))
    whole = step_limit({k: v for k, v in values.items() if k != "blocks"} | {"k": Fraction(1)})
    assert blocks_step_limit(values).exact == whole.exact


def test_equal_blocks_have_their_common_limit():
    values = cycle(((0, 1), (2, 3)), h=(Fraction(1),) * 4, Xi=((Fraction(0),),))
    answer = blocks_step_limit(values)
    assert answer.exact == {"kind": "rational", "value": "1"}
    assert answer.value == 1


@pytest.mark.parametrize(
    "blocks,words",
    [
        (((0, 1), (2,)), "no list has 3"),
        (((0, 1), (1, 2, 3)), "coordinate 1 is in lists 1 and 2"),
        (((0, 1, 2), (3,)), "coordinates 2 and 3 are in two lists"),
        (((0, 1), (2, 3, 4)), "list 2 has 4"),
    ],
)
def test_blocks_that_are_none_are_named(blocks, words):
    with pytest.raises(InputError, match=words) as error:
        blocks_step_limit(cycle(blocks))
    assert error.value.name == "blocks"


def test_coupled_blocks_are_refused():
    rows = [[Fraction(2 if i == j else 0) for j in range(4)] for i in range(4)]
    rows[0][2] = rows[2][0] = Fraction(1)
    values = cycle(((0, 1), (2, 3)), h=None, H=tuple(map(tuple, rows)))
    with pytest.raises(InputError, match="couples 0 and 2"):
        blocks_step_limit(values)


def test_half_a_target_is_refused():
    with pytest.raises(InputError, match="3 coordinates"):
        blocks_step_limit(cycle(((0, 1), (2,)), h=(Fraction(1),) * 3, Xi=((Fraction(0),),)))


@pytest.mark.parametrize(
    "bad", ["[]", "3", "[0, 1]", "[[]]", "[[0, -1]]", "[[0.5]]", "[[true]]", "x"]
)
def test_what_is_no_list_of_lists_is_refused(bad):
    with pytest.raises(InputError) as error:
        read_inputs([LISTS], {"blocks": json.loads(bad) if bad != "x" else bad}, None)
    assert error.value.name == "blocks"
