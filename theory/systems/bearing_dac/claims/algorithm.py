"""Claims about the positions that the sensors compute."""

from __future__ import annotations

from ....claims import Claim
from .assumptions import (
    APART,
    AVERAGED,
    CONNECTED,
    CROSSING,
    EXACT,
    FIXED,
    INCLUSION,
    RATE,
    START,
)

SYSTEM = "bearing_dac"

POSITION = Claim(
    id="bearing_dac.theorem_2_position",
    system=SYSTEM,
    source="George, Theorem 2",
    title="From exact averages every sensor computes the position",
    statement="While a sensor's P_x and q_x are the averages, its p_i is p*, and p for exact "
    "bearings.",
    formula=r"p_i(t) = p^*(t)",
    sense="equality",
    assumes=(CROSSING, EXACT, AVERAGED),
)

TIME = Claim(
    id="bearing_dac.theorem_2_time",
    system=SYSTEM,
    source="George, Theorem 2 with Theorem 1",
    title="Every sensor knows the position from the printed time on",
    statement="With the printed gain, p_i = p* for all t >= t0 + |x(t0)|/lambda_2.",
    formula=r"p_i(t) = p^*(t) \quad \text{for all } t \ge t^*",
    sense="upper",
    assumes=(APART, CROSSING, EXACT, FIXED, RATE, CONNECTED, START, INCLUSION),
    printed="|x(t0)|/lambda_2",
)

START_INVERSE = Claim(
    id="bearing_dac.algorithm_1_line_12",
    system=SYSTEM,
    source="George, Algorithm 1, lines 2 and 12",
    title="Every sensor computes a position from the start",
    statement="For all t >= t0 the matrix P_x of each sensor has an inverse. (Reading: from t0 "
    "on.)",
    formula=r"p_i(t) = (P_{x_i}(t))^{-1} q_{x_i}(t) \quad \text{for all } t \ge t_0",
    sense="property",
    assumes=(APART, CROSSING, START),
    printed="all t >= t0",
)

LATER_INVERSE = Claim(
    id="bearing_dac.algorithm_1_line_12_later",
    system=SYSTEM,
    source="George, Algorithm 1, lines 2 and 12",
    title="Every sensor computes a position at all times after the start",
    statement="For all t > t0 the matrix P_x of each sensor has an inverse. (Reading: after t0.)",
    formula=r"p_i(t) = (P_{x_i}(t))^{-1} q_{x_i}(t) \quad \text{for all } t > t_0",
    sense="property",
    assumes=(APART, CROSSING, CONNECTED, START, INCLUSION),
    printed="all t > t0",
)

CLAIMS: tuple[Claim, ...] = (POSITION, TIME, START_INVERSE, LATER_INVERSE)
