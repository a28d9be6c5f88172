"""What George claims about the consensus."""

from __future__ import annotations

from ...claims import Assumption, Claim

RATE = Assumption("A2", "every averaged entry has a rate of at most gamma in size, almost always")
CONNECTED = Assumption("A3", "the graph is undirected, without weights and connected")
START = Assumption("A4", "the internal states start at zero")
INCLUSION = Assumption(
    "A5", "the discontinuous law is read in Filippov's sense: at a tie, any sign between -1 and 1"
)
BALANCED = Assumption(
    "A6",
    "the graph is directed with positive weights, strongly connected, and balanced: the weights "
    "into and out of each node have equal sums",
)
MOORE_PENROSE = Assumption("A7", "( )^+ is the Moore-Penrose inverse")
GENERALIZED = Assumption("A8", "( )^+ is any generalized inverse: any G with A G A = A")

FORM = Claim(
    id="bearing_dac.lemma_1_quadratic_form",
    system="bearing_dac",
    source="George, Lemma 1",
    title="The Laplacian of a balanced directed graph has a quadratic form that is never negative",
    statement="For every x, x'Lx is at least zero; it is zero for constant vectors only; the ones "
    "are a left and a right null vector. (Reading: semidefinite means the quadratic form.)",
    formula=r"x^\top \mathcal{L} x \ge 0, \quad x^\top \mathcal{L} x = 0 \iff x \in "
    r"\operatorname{span}\{\mathbf{1}\}",
    sense="property",
    assumes=(BALANCED,),
)

SYMMETRIC = Claim(
    id="bearing_dac.lemma_1_symmetric",
    system="bearing_dac",
    source="George, Lemma 1",
    title="The Laplacian of a balanced directed graph is symmetric with eigenvalues of at least "
    "zero",
    statement="L equals its transpose and has no negative eigenvalue. (Reading: semidefinite "
    "matrices are symmetric, as most books define.)",
    formula=r"\mathcal{L} = \mathcal{L}^\top \succeq 0",
    sense="property",
    assumes=(BALANCED,),
)

IDENTITY = (
    r"M = \mathcal{L}\mathcal{L}^{+} = \mathcal{B}\mathcal{B}^\top(\mathcal{B}\mathcal{B}^\top)^{+}"
    r" = \mathcal{B}(\mathcal{B}^\top\mathcal{B})^{+}\mathcal{B}^\top"
)

MOORE = Claim(
    id="bearing_dac.lemma_2_moore_penrose",
    system="bearing_dac",
    source="George, Lemma 2",
    title="The Laplacian times its Moore-Penrose inverse removes the mean",
    statement="M = I - 11'/n equals LL^+ and B(B'B)^+B' with the Moore-Penrose inverse.",
    formula=IDENTITY,
    sense="equality",
    assumes=(CONNECTED, MOORE_PENROSE),
)

ANY_INVERSE = Claim(
    id="bearing_dac.lemma_2_generalized",
    system="bearing_dac",
    source="George, Lemma 2",
    title="The Laplacian times any of its generalized inverses removes the mean",
    statement="M = I - 11'/n equals LG for every G with LGL = L. (Reading: the generalized inverse "
    "of the text is any such G.)",
    formula=IDENTITY,
    sense="equality",
    assumes=(CONNECTED, GENERALIZED),
)

GAIN = Claim(
    id="bearing_dac.theorem_1_gain",
    system="bearing_dac",
    source="George, Theorem 1",
    title="A gain of one plus gamma times the root of n over lambda_2 always gives agreement",
    statement="With beta >= 1 + gamma sqrt(n)/lambda_2, the error of consensus reaches zero in "
    "finite time and stays there, from every start and for every admissible disturbance. (The "
    "printed bounds on n and lambda_2 only make beta larger.)",
    formula=r"\beta \ge 1 + \gamma \frac{\sqrt{n}}{\lambda_2}",
    sense="threshold",
    assumes=(RATE, CONNECTED, START, INCLUSION),
    printed="1 + gamma sqrt(n)/lambda_2",
)

TIME = Claim(
    id="bearing_dac.theorem_1_time",
    system="bearing_dac",
    source="George, Theorem 1",
    title="Agreement is reached within the norm of the start over lambda_2",
    statement="With beta >= 1 + gamma sqrt(n)/lambda_2, the error of consensus is zero from the "
    "time t0 + |x(t0)|/lambda_2 on.",
    formula=r"\tilde{x}(t) = 0 \quad \text{for } t \ge t_0 + \frac{\|x(t_0)\|_2}{\lambda_2}",
    sense="upper",
    assumes=(RATE, CONNECTED, START, INCLUSION),
    printed="|x(t0)|/lambda_2",
)

CLAIMS = (FORM, SYMMETRIC, MOORE, ANY_INVERSE, GAIN, TIME)
