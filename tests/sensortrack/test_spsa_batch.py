"""Many runs of one block: the same bits in C and NumPy; exact expectations lie in the intervals."""

import ctypes
import itertools

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from sensortrack.errors import InputError
from sensortrack.kernels.build import kernel
from sensortrack.normal_numbers import TABLE, normals
from sensortrack.random_numbers import philox
from sensortrack.simulation.spsa_batch import SpsaBatch

FULL = {"hessian": [[1.0, 0.4], [0.4, 0.6]], "noise": [[0.3, 0.1], [0.1, 0.2]]}
DIAGONAL = {"hessian": [1.0, 0.6], "noise": [[0.3, 0.0], [0.0, 0.2]]}
WIDE = {"hessian": np.linspace(0.1, 1.0, 66), "noise": 0.2}
BLOCKS = {"full": FULL, "diagonal": DIAGONAL, "wide": WIDE}
CASES = [
    (name, reading, law)
    for name in BLOCKS
    for reading in ("two", "one")
    for law in ("gaussian", "two_point")
]


def batch(name, **changes):
    given = BLOCKS[name] | {"alpha": 0.02, "beta": 0.7, "drift": 0.05, "blocks": 2}
    return SpsaBatch(**given | changes)


def bits(result):
    return [
        array.tobytes()
        for array in (result.means, result.squares, result.trajectory, result.errors)
    ]


@pytest.mark.parametrize("name,reading,law", CASES)
def test_c_and_numpy_give_the_same_bits(monkeypatch, name, reading, law):
    own = batch(name, reading=reading, law=law)
    assert kernel("spsa", native=True).library is not None
    in_c = own.run(45, 12, skip=5, seed=11, first_run=7, start=0.25)
    monkeypatch.setenv("SENSORTRACK_NO_COMPILER", "1")
    assert bits(own.run(45, 12, skip=5, seed=11, first_run=7, start=0.25)) == bits(in_c)


def test_words_and_normal_numbers_are_the_same_in_c():
    library = kernel("spsa", native=True).library
    counter, key = np.array([5, 6, 7, 8], dtype=np.uint64), np.array([1, 2], dtype=np.uint64)
    found = np.empty(4, dtype=np.uint64)
    library.sensortrack_spsa_words(*(ctypes.c_void_p(a.ctypes.data) for a in (counter, key, found)))
    assert tuple(found.tolist()) == philox((5, 6, 7, 8), (1, 2))
    drawn = np.random.default_rng(1).integers(0, 2**64, 5000, dtype=np.uint64)
    drawn[:4] = [0, 2**64 - 1, 2**12, 2**63]
    numbers = np.empty(len(drawn))
    call = library.sensortrack_spsa_normals
    call(
        ctypes.c_void_p(TABLE.ctypes.data),
        ctypes.c_void_p(drawn.ctypes.data),
        ctypes.c_int64(len(drawn)),
        ctypes.c_void_p(numbers.ctypes.data),
    )
    assert numbers.tobytes() == normals(drawn).tobytes()


@settings(max_examples=12, deadline=None)
@given(cut=st.integers(1, 69), seed=st.integers(0, 2**64 - 1))
def test_a_run_is_the_same_in_every_batch(cut, seed):
    own = batch("full")
    whole = own.run(70, 6, seed=seed)
    parts = [own.run(cut, 6, seed=seed), own.run(70 - cut, 6, seed=seed, first_run=cut)]
    for name in ("means", "squares", "errors"):
        both = np.concatenate([getattr(part, name) for part in parts])
        assert both.tobytes() == getattr(whole, name).tobytes()
    total = parts[0].trajectory + parts[1].trajectory
    assert total == pytest.approx(whole.trajectory, rel=1e-13)


@pytest.mark.parametrize("name", ["full", "diagonal"])
def test_other_units_of_length_give_the_same_numbers_in_those_units(name):
    given = BLOCKS[name]
    own = batch(name)
    other = batch(name, beta=0.7 * 32, drift=0.05 * 32, noise=1024 * np.array(given["noise"]))
    one, two = own.run(40, 8, seed=3, start=0.5), other.run(40, 8, seed=3, start=16.0)
    assert two.errors == pytest.approx(32 * one.errors, rel=1e-9, abs=1e-9)
    if name == "diagonal":  # the root of a full covariance is rounded
        assert (two.errors.tobytes(), two.squares.tobytes()) == (
            (32 * one.errors).tobytes(),
            (1024 * one.squares).tobytes(),
        )


def exact_moments(own, start, updates):
    """E e and E|e|^2 right after each update, by going through all signs; two-point noise."""
    form = own.recursion
    hessian = np.diag(form.hessian) if form.hessian.ndim == 1 else form.hessian
    root = np.diag(form.root) if form.root.ndim == 1 else form.root
    size, found = len(hessian), []
    bits_of = np.array(list(itertools.product([-1.0, 1.0], repeat=size * (1 + form.instants))))
    delta = bits_of[:, :size]
    late = bits_of[:, -size:] @ root.T
    early = bits_of[:, size : 2 * size] @ root.T
    e = np.array([start])
    for _ in range(updates):
        now = e[:, None, :]
        drift = form.eta if form.instants == 2 else 0.0
        minus = now + drift - form.beta * delta - early
        plus = now + form.beta * delta - late
        costs = [np.einsum("rsi,ij,rsj->rs", d, hessian, d) / 2 for d in (minus, plus)]
        slope = (costs[1] - costs[0]) / (2 * form.beta)
        after = (now - form.alpha * delta * slope[..., None]).reshape(-1, size)
        found.append((after.mean(axis=0), (after**2).sum(axis=1).mean()))
        e = after - 2 * form.blocks * form.eta
    return found


@pytest.mark.parametrize("name", ["full", "diagonal"])
@pytest.mark.parametrize("reading", ["two", "one"])
def test_first_updates_have_the_moments_of_an_enumeration(name, reading):
    own = batch(name, reading=reading, law="two_point", alpha=0.3, beta=0.4)
    start = np.array([1.0, -0.5])
    wanted = exact_moments(own, start, 2)
    for k in (1, 2):
        found = own.run(20000, k, skip=k - 1, seed=5, start=start)
        mean, square = wanted[k - 1]
        assert (np.abs(found.mean - mean) < 5 * found.mean_error).all()
        assert abs(found.mean_square - square) < 5 * found.mean_square_error
        assert found.mean_square_error < 0.02 * square
        curve, error = found.curve
        assert (curve[-1], error[-1]) == pytest.approx(
            (found.mean_square, found.mean_square_error), rel=1e-9
        )


@pytest.mark.parametrize("law", ["gaussian", "two_point"])
@pytest.mark.parametrize("reading", ["two", "one"])
def test_targets_at_rest_leave_the_exact_stationary_error(reading, law):
    """H = h I, Xi = s I: closed forms of the second moment; the fourth moment of the noise counts.

    Two instants: D x s/(2(2 - x)) with x = alpha h D (1 + s/(2 beta^2)) for the Gaussian law, and
    alpha h D for x in the numerator where xi'H xi is constant. One instant:
    alpha h D^2 s/(2 - alpha h D).
    """
    size, h, s, alpha, beta = 2, 0.8, 0.6, 0.1, 0.5
    own = SpsaBatch([h] * size, alpha, beta, s, reading=reading, law=law)
    plain = alpha * h * size
    x = plain * (1 + s / (2 * beta**2))
    wanted = {
        ("two", "gaussian"): size * x * s / (2 * (2 - x)),
        ("two", "two_point"): size * plain * s / (2 * (2 - x)),
        ("one", "gaussian"): plain * size * s / (2 - plain),
        ("one", "two_point"): plain * size * s / (2 - plain),
    }[reading, law]
    found = own.run(1500, 400, skip=150, seed=17)
    assert found.mean_square_error < 0.01 * wanted
    assert abs(found.mean_square - wanted) < 4 * found.mean_square_error
    assert (np.abs(found.mean) < 4 * found.mean_error).all()


@pytest.mark.parametrize("blocks", [1, 3])
@pytest.mark.parametrize("reading,own_lag", [("two", -0.5), ("one", 0.0)])
def test_the_mean_lags_behind_targets_that_move(reading, own_lag, blocks):
    """-H^-1 2k eta/alpha + (2k - 1/2) eta, and 2k eta for one instant."""
    h, eta, alpha = np.array([0.5, 1.0]), np.array([0.2, -0.1]), 0.2
    lag = (2 * blocks + own_lag) * eta - 2 * blocks * eta / (alpha * h)
    own = SpsaBatch(h, alpha, 2.0, 0.1, eta, reading, blocks)
    start = lag - 2 * blocks * eta
    found = own.run(400, 60, skip=20, seed=23, start=start)
    assert (np.abs(found.mean - lag) < 4 * found.mean_error).all()
    assert (found.mean_error < 0.1 * np.abs(lag)).all()


def test_a_small_perturbation_diverges_on_every_path_without_any_noise():
    """alpha = 0.2, beta = 0.03, eta = 1: the error is multiplied by 4.13 or -2.53, and 2 is taken
    off, so that beyond 2 it grows whatever the signs are."""
    own = SpsaBatch([1.0], 0.2, 0.03, 0.0, 1.0)
    errors = [own.run(64, n, seed=1, start=5.0).errors for n in range(1, 8)]
    for before, after in itertools.pairwise(errors):
        ratio = after / before
        assert (np.abs(after) > np.abs(before)).all()
        assert (np.abs(ratio) < 5).all()


@pytest.mark.parametrize("compiler", ["0", "1"])
def test_an_error_without_bounds_is_counted_and_not_warned_of(monkeypatch, compiler):
    monkeypatch.setenv("SENSORTRACK_NO_COMPILER", compiler)
    found = SpsaBatch([1.0], 1e200, 1.0, 1.0).run(3, 4)
    assert not np.isfinite([found.mean_square, found.mean_square_error, found.curve[0][-1]]).any()


@pytest.mark.parametrize(
    "numbers,error",
    [
        ((1, 0.05, 1.0, 0.25), 0.060145),
        ((2, 0.02, 1.0, 1.0), 0.175863),
        ((12, 0.002, 1.0, 1.0), 0.331632),
    ],
)
def test_isotropic_blocks_have_the_values_of_an_earlier_computation(numbers, error):
    """Coordinates, step, perturbation, variance: root-mean-square errors from another program."""
    size, alpha, beta, variance = numbers
    skip = int(4 / alpha)
    runs = 1800 // size
    found = SpsaBatch(np.ones(size), alpha, beta, variance).run(runs, 3 * skip, skip, seed=29)
    assert abs(found.mean_square - error**2) < 4 * found.mean_square_error
    assert found.mean_square_error < 0.03 * error**2


@pytest.mark.parametrize(
    "changes,name",
    [
        ({"alpha": 0.0}, "alpha"),
        ({"beta": -1.0}, "beta"),
        ({"beta": np.nan}, "beta"),
        ({"reading": "three"}, "reading"),
        ({"law": "cauchy"}, "law"),
        ({"blocks": 0}, "k"),
        ({"blocks": 1.5}, "k"),
        ({"hessian": [1.0, 0.0]}, "h"),
        ({"hessian": []}, "h"),
        ({"hessian": 1.0}, "h"),
        ({"hessian": [[1.0, 2.0], [2.0, 1.0]]}, "H"),
        ({"hessian": [[1.0, 0.1], [0.2, 1.0]]}, "H"),
        ({"hessian": [[1.0, 0.1]]}, "H"),
        ({"hessian": [1.0, np.nan]}, "h"),
        ({"noise": -0.1}, "Xi"),
        ({"noise": [[1.0, 2.0], [2.0, 1.0]]}, "Xi"),
        ({"noise": [[1.0, 0.5], [0.4, 1.0]]}, "Xi"),
        ({"noise": np.eye(3)}, "Xi"),
        ({"noise": np.inf}, "Xi"),
        ({"drift": [1.0, 2.0, 3.0]}, "eta"),
        ({"drift": np.inf}, "eta"),
        ({"drift": "north"}, "eta"),
        ({"alpha": "a"}, "alpha"),
        ({"beta": None}, "beta"),
        ({"hessian": ["a"]}, "h"),
        ({"hessian": [[1.0, 2.0], [3.0]]}, "H"),
        ({"hessian": [[1j, 0], [0, 1]]}, "H"),
        ({"noise": "x"}, "Xi"),
        ({"reading": None}, "reading"),
    ],
)
def test_bad_blocks_are_refused_by_name(changes, name):
    with pytest.raises(InputError) as error:
        batch("full", **changes)
    assert error.value.name == name


@pytest.mark.parametrize(
    "changes,name",
    [
        ({"runs": 0}, "runs"),
        ({"runs": 2.5}, "runs"),
        ({"updates": 0}, "updates"),
        ({"skip": 5}, "skip"),
        ({"skip": -1}, "skip"),
        ({"seed": -1}, "seed"),
        ({"first_run": -1}, "first_run"),
        ({"start": [1.0, 2.0, 3.0]}, "start"),
        ({"start": np.nan}, "start"),
        ({"start": "here"}, "start"),
        ({"runs": 2**40}, "runs"),
        ({"updates": 2**40}, "updates"),
    ],
)
def test_bad_numbers_of_runs_are_refused_by_name(changes, name):
    with pytest.raises(InputError) as error:
        batch("full").run(**{"runs": 3, "updates": 5} | changes)
    assert error.value.name == name
