"""Counter-based random numbers: known answers, and the words of NumPy's generator."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from sensortrack.errors import InputError
from sensortrack.random_numbers import MASK, philox, signs, whole, words

WORD = st.integers(0, MASK)
PI = (
    (0x243F6A8885A308D3, 0x13198A2E03707344, 0xA4093822299F31D0, 0x082EFA98EC4E6C89),
    (0x452821E638D01377, 0xBE5466CF34E90C6C),
)
KNOWN = [
    (
        (0, 0, 0, 0),
        (0, 0),
        (0x16554D9ECA36314C, 0xDB20FE9D672D0FDC, 0xD7E772CEE186176B, 0x7E68B68AEC7BA23B),
    ),
    (
        (MASK,) * 4,
        (MASK,) * 2,
        (0x87B092C3013FE90B, 0x438C3C67BE8D0224, 0x9CC7D7C69CD777B6, 0xA09CAEBF594F0BA0),
    ),
    (
        *PI,
        (0xA528F45403E61D95, 0x38C72DBD566E9788, 0xA5A1610E72FD18B5, 0x57BD43B5E52B7FE6),
    ),
]
"""The answers that the authors of the generator publish with it, kat_vectors of Random123."""


@pytest.mark.parametrize("counter,key,answer", KNOWN)
def test_published_known_answers(counter, key, answer):
    assert philox(counter, key) == answer
    assert words(counter, key, 4).tolist() == list(answer)


@settings(max_examples=50)
@given(st.tuples(WORD, WORD, WORD, WORD), st.tuples(WORD, WORD), st.integers(1, 20))
def test_words_are_blocks_of_growing_counters(counter, key, count):
    whole = sum(word << (64 * k) for k, word in enumerate(counter))
    found = []
    for step in range(-(-count // 4)):
        number = (whole + step) % 2**256
        found += philox(tuple(number >> (64 * k) & MASK for k in range(4)), key)
    assert words(counter, key, count).tolist() == found[:count]


@given(st.tuples(WORD, WORD, WORD), st.integers(1, 600))
@settings(max_examples=20)
def test_signs_are_bits_and_do_not_depend_on_how_many_are_asked_for(rest, count):
    drawn = signs((0, *rest), (1, 2), 600)
    assert signs((0, *rest), (1, 2), count) == drawn[:count]
    bits = words((0, *rest), (1, 2), 12)
    wanted = [(int(bits[i // 64]) >> (i % 64) & 1) * 2 - 1 for i in range(600)]
    assert drawn == wanted


@pytest.mark.parametrize("value", [-1, 2**64, 0.5, True, np.nan])
def test_seeds_are_whole_numbers_of_one_word(value):
    with pytest.raises(InputError, match="seed"):
        whole("seed", value)
