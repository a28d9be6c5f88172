"""Claims about bearings and about the position that they determine."""

from __future__ import annotations

from ....claims import Claim
from .assumptions import APART, CROSSING, EXACT

SYSTEM = "bearing_dac"

BEARING = Claim(
    id="bearing_dac.section_1_bearing",
    system=SYSTEM,
    source="George, problem formulation, displays 1 and 2",
    title="A bearing is a unit vector that gives the position once the distance is known",
    statement="With phi_i = (cos, sin) of the bearing as a column and the distance rho_i, "
    "rho_i phi_i = p - s_i has |phi_i| = 1 and rho_i = |p - s_i|.",
    formula=r"\rho_i \varphi_i = p - s_i",
    sense="equality",
    assumes=(APART, EXACT),
)

IDENTITY = Claim(
    id="bearing_dac.prop_1_identity",
    system=SYSTEM,
    source="George, Proposition 1, second display",
    title="A bearing and the same turned by a right angle split the identity",
    statement="With h_i = (-sin, cos) of the bearing, phi_i phi_i' + h_i h_i' is the identity, and "
    "the two are orthonormal.",
    formula=r"\varphi_i\varphi_i^\top + \bar\varphi_i\bar\varphi_i^\top = I_2",
    sense="equality",
    assumes=(APART,),
)

CLOCKWISE = Claim(
    id="bearing_dac.prop_1_clockwise",
    system=SYSTEM,
    source="George, Proposition 1, first display",
    title="The vector (-sin, cos) is the bearing turned clockwise by a right angle",
    statement="Turning phi_i = (cos, sin) clockwise by a right angle gives h_i = (-sin, cos).",
    formula=r"\bar\varphi_i = \begin{bmatrix} -\sin\theta_i & \cos\theta_i \end{bmatrix}^\top",
    sense="equality",
    assumes=(APART,),
    printed="clockwise",
)

MEASUREMENT = Claim(
    id="bearing_dac.section_1_measurement",
    system=SYSTEM,
    source="George, problem formulation, displays 4 to 6",
    title="What a sensor measures is one linear equation for the position",
    statement="z_i = h_i's_i equals h_i'p for every sensor, so that z = Hp for the network.",
    formula=r"h_i^\top s_i = h_i^\top p, \qquad z = H p",
    sense="equality",
    assumes=(APART, EXACT),
)

COUNT = Claim(
    id="bearing_dac.assumption_1_count",
    system=SYSTEM,
    source="George, Assumption 1",
    title="More than two sensors are needed for a position",
    statement="The position needs rank H = 2 with more sensors than that, n > 2.",
    formula=r"\operatorname{rank} H = 2 < n",
    sense="threshold",
    assumes=(APART, EXACT),
    printed="n > 2",
)

UNIQUE = Claim(
    id="bearing_dac.section_1_unique",
    system=SYSTEM,
    source="George, problem formulation, display 7",
    title="The least-squares position is unique, and exact for exact bearings",
    statement="p* = (H'H)^-1 H'z is the only point with the smallest sum of squares of z - Hp, "
    "for any z; with z = Hp it is p.",
    formula=r"p^* = (H^\top H)^{-1} H^\top z",
    sense="equality",
    assumes=(CROSSING,),
)

CLAIMS: tuple[Claim, ...] = (BEARING, IDENTITY, CLOCKWISE, MEASUREMENT, COUNT, UNIQUE)
