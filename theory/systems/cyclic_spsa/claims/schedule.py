"""Claims about the cycle, its blocks and Algorithm 1, (15) to (20)."""

from __future__ import annotations

from ....claims import Claim
from .assumptions import (
    ACTIVE_SUM,
    COUNTED,
    DRIFTING,
    EXACT_SIGHT,
    OBSERVED_SUM,
    ONE_INSTANT,
    PERTURBATION,
    SEEN,
    TWO_INSTANTS,
    WHOLE_NUMBERS,
    WHOLE_SUM,
)

SYSTEM = "cyclic_spsa"

DECREASING = Claim(
    id="cyclic_spsa.section_3_decreasing",
    system=SYSTEM,
    source="Erofeeva & Granichin, section 3, first paragraph",
    title="Steps that decrease to zero lose a target that keeps moving",
    statement="If the step tends to zero while the targets drift, the mean error exceeds every "
    "bound.",
    formula=r"\alpha_T\to0,\ \eta\ne0\ \Rightarrow\ \limsup_T\lvert E(\hat\theta_T-\theta_T)\rvert="
    r"\infty",
    sense="property",
    assumes=(DRIFTING, PERTURBATION),
)

BLOCKS = Claim(
    id="cyclic_spsa.eq_15_blocks",
    system=SYSTEM,
    source="Erofeeva & Granichin, (15), (19), (20)",
    title="Any partition of the coordinates into blocks serves, also one that splits a target",
    statement="Blocks need to be disjoint and to cover all coordinates, and no more, for the "
    "pseudogradient to be made of the active coordinates' errors.",
    formula=r"\bigcup_u I_u=D,\qquad I_u\cap I_v=\emptyset",
    sense="property",
    assumes=(WHOLE_SUM, TWO_INSTANTS),
    printed="any partition",
)

INDEX = Claim(
    id="cyclic_spsa.section_3_active_index",
    system=SYSTEM,
    source="Erofeeva & Granichin, section 3, after (15)",
    title="The number (t mod 2k) div 2 is that of the active block at both instants of a pair",
    statement="At the instants 2k(T-1) + 2u - 1 and 2k(T-1) + 2u the active index (t mod 2k) div 2 "
    "is one and the same, so that it names block u.",
    formula=r"(t\bmod 2k)\div 2=((t-1)\bmod 2k)\div 2,\qquad t\ \text{even}",
    sense="equality",
    assumes=(WHOLE_NUMBERS,),
    printed="(t mod 2k) div 2",
)

SHIFT = Claim(
    id="cyclic_spsa.section_3_shift",
    system=SYSTEM,
    source="Erofeeva & Granichin, section 3, polynomial A(lambda)",
    title="Shifts by 2k - 2, u of them, lead back to the last update of block u",
    statement="At the end of a cycle block u was last updated u(2k - 2) instants before, so that "
    "A(lambda) applied to theta has each block as it was when its estimate was made.",
    formula=r"\mathcal A(\lambda)\theta_t=\sum_{u=1}^k A_{2kT+2u}\,\theta_{t-u(2k-2)}",
    sense="equality",
    assumes=(WHOLE_NUMBERS,),
    printed="u (2k - 2)",
)

NEIGHBOURS = Claim(
    id="cyclic_spsa.section_3_neighbours",
    system=SYSTEM,
    source="Erofeeva & Granichin, section 3, after (16)",
    title="The neighbours of a sensor are the rows with an entry in a column of C",
    statement="With c_jk > 0 where sensor j can speak to k, {j : c_jk > 0} holds the sensors that "
    "sensor j can speak to.",
    formula=r"N_t^j=\{j:c_t^{j,k}>0\}",
    sense="property",
    assumes=(SEEN,),
    printed="{j : c_jk > 0}",
)

FEASIBLE = Claim(
    id="cyclic_spsa.eq_17_feasible",
    system=SYSTEM,
    source="Erofeeva & Granichin, (18), (19) and the initialization of Algorithm 1",
    title="Blocks within the limit of targets at a time exist for every number of targets",
    statement="For every limit m_max >= 1 the targets of a sensor can be put into disjoint blocks "
    "of at most m_max.",
    formula=r"k=\lceil N/m_{\max}\rceil",
    sense="property",
    assumes=(SEEN,),
    printed="a sequence exists",
)

SENDER = Claim(
    id="cyclic_spsa.eq_20_sender",
    system=SYSTEM,
    source="Erofeeva & Granichin, (20)",
    title="A neighbour's measurement can be put at the sensor's own place",
    statement="The cost of sensor j takes the measurement of each of its targets with the place of "
    "sensor j, also those that a neighbour made and sent.",
    formula=r"\varphi^{-1}(s^j,z^{i,q})=r^i\quad\text{for a neighbour}\ q",
    sense="equality",
    assumes=(EXACT_SIGHT,),
    printed="s of the receiver",
)

CLOCK = Claim(
    id="cyclic_spsa.algorithm_1_clock",
    system=SYSTEM,
    source="Erofeeva & Granichin, Algorithm 1, step 3.1",
    title="The instants 2T + 2u of different pairs differ",
    statement="Step 3.1 gives each pair u of each cycle T an instant of its own.",
    formula=r"t\leftarrow 2T+2u",
    sense="property",
    assumes=(WHOLE_NUMBERS,),
    printed="2T + 2u",
)

BASE = Claim(
    id="cyclic_spsa.algorithm_1_base_point",
    system=SYSTEM,
    source="Erofeeva & Granichin, Algorithm 1, steps 3.2 and 3.5",
    title="The estimate of the instant 2T holds the newest value of the active block",
    statement="The two points of a pair are taken around the newest estimate of the active block, "
    "which is that of the instant 2T.",
    formula=r"x_{t-1}=\hat\theta_{2T}-\beta\Delta_T,\qquad x_t=\hat\theta_{2T}+\beta\Delta_T",
    sense="property",
    assumes=(WHOLE_NUMBERS,),
    printed="index 2T",
)

FIRST_COST = Claim(
    id="cyclic_spsa.algorithm_1_first_cost",
    system=SYSTEM,
    source="Erofeeva & Granichin, Algorithm 1, step 3.4",
    title="What the first cost of a pair needs is known when it is computed",
    statement="Step 3.4 takes the cost f_t, with the measurement of t, at the first point; "
    "everything that it needs has been assigned by then.",
    formula=r"y_{t-1}^-\leftarrow f_t(x_{t-1})",
    sense="property",
    assumes=(ONE_INSTANT,),
    printed="f_t",
)

SECOND_COST = Claim(
    id="cyclic_spsa.algorithm_1_second_cost",
    system=SYSTEM,
    source="Erofeeva & Granichin, Algorithm 1, step 3.7",
    title="The printed steps determine the second cost",
    statement="After step 3.7 the cost y+ at the second point has a value, so that steps 3.8 and "
    "3.9 give one next estimate.",
    formula=r"\hat\nabla_t\leftarrow A_t\Delta_T\frac{y_t^+-y_{t-1}^-}{2\beta}",
    sense="property",
    assumes=(PERTURBATION,),
    printed="the formula of step 3.8",
)

PREVIOUS = Claim(
    id="cyclic_spsa.algorithm_1_previous",
    system=SYSTEM,
    source="Erofeeva & Granichin, Algorithm 1, step 3.9",
    title="The estimate from which step 3.9 starts, that of t - 1, has been assigned",
    statement="Each new estimate is the one of t - 1 less a step, and that one exists.",
    formula=r"\hat\theta_t\leftarrow\hat\theta_{t-1}-\alpha\hat\nabla_t",
    sense="property",
    assumes=(WHOLE_NUMBERS,),
    printed="index t - 1",
)

INACTIVE_ACTIVE = Claim(
    id="cyclic_spsa.algorithm_1_inactive_active",
    system=SYSTEM,
    source="Erofeeva & Granichin, Algorithm 1, steps 3.2 and 3.5, and (20)",
    title="Zeros at inactive coordinates change nothing if the cost has active targets alone",
    statement="With the sum of (20) over active targets, the cost is the same whatever stands at "
    "the other coordinates.",
    formula=r"f(A x)=f(x)",
    sense="equality",
    assumes=(ACTIVE_SUM,),
)

INACTIVE_OBSERVED = Claim(
    id="cyclic_spsa.algorithm_1_inactive_observed",
    system=SYSTEM,
    source="Erofeeva & Granichin, Algorithm 1, steps 3.2 and 3.5, and (20)",
    title="Zeros at inactive coordinates add nothing to costs of all targets at two instants",
    statement="With the sum of (20) over all observed targets, those that are not active drop out "
    "of the difference of the two costs, each with the measurement of its own instant.",
    formula=r"\frac{f_t(Ax_t)-f_{t-1}(Ax_{t-1})}{2\beta}\ \text{free of inactive targets}",
    sense="property",
    assumes=(OBSERVED_SUM, TWO_INSTANTS),
    printed="nothing is added",
)

INACTIVE_SAME = Claim(
    id="cyclic_spsa.algorithm_1_inactive_same",
    system=SYSTEM,
    source="Erofeeva & Granichin, Algorithm 1, steps 3.2 and 3.5, and (20)",
    title="Zeros at inactive coordinates add nothing to costs of all targets at one instant",
    statement="With the sum of (20) over all observed targets, those that are not active drop out "
    "of the difference of the two costs, both with the same measurement.",
    formula=r"f_t(Ax_t)-f_t(Ax_{t-1})\ \text{free of inactive targets}",
    sense="property",
    assumes=(OBSERVED_SUM, ONE_INSTANT),
)

CHEAP = Claim(
    id="cyclic_spsa.section_6_cheap",
    system=SYSTEM,
    source="Erofeeva & Granichin, section 6",
    title="A cycle of Algorithm 1 costs a sensor in proportion to its coordinates",
    statement="Operations of a cycle, and numbers kept, are at most a constant times the number of "
    "coordinates that the sensor follows, however the blocks are chosen.",
    formula=r"\sum_{u=1}^k\bigl(a\lvert I_u\rvert+b\bigr)\le(a+b)\,d",
    sense="upper",
    assumes=(COUNTED,),
)

CLAIMS: tuple[Claim, ...] = (
    DECREASING,
    BLOCKS,
    INDEX,
    SHIFT,
    NEIGHBOURS,
    FEASIBLE,
    SENDER,
    CLOCK,
    BASE,
    FIRST_COST,
    SECOND_COST,
    PREVIOUS,
    INACTIVE_ACTIVE,
    INACTIVE_OBSERVED,
    INACTIVE_SAME,
    CHEAP,
)
