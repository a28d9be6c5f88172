"""What certificates about the simulated estimator (24) prove."""

from __future__ import annotations

from ....statements import Case, Statement

STATEMENTS: tuple[Statement, ...] = (
    Statement(
        "variational",
        "eq_24_measured",
        {
            "REFUTED": Case(
                "REFUTED",
                "for all M, K, C > 0 of any size, every h > 0, any number of sensors with "
                "weights l of sum one, and constant velocities W of the sensors and z of the "
                "target: if the measured value of z itself stands in (24) for every sensor, the "
                "velocity estimate is wrong by u - r with r = 2z - W l, and the position error "
                "taken from the o with K o = -C r obeys (20); -r'Ko = r'Cr > 0 unless r = 0",
                (
                    "-x + y - h*s == 0",
                    "-M*s + M*t + h*C*t + h*K*y == 0",
                    "-T(r)*K*o == T(r)*C*r",
                    "pd(C)",
                    "W*l + u - z - z*T(j)*l == -r + u",
                ),
            ),
        },
        symbols={
            "C": "positive definite: n",
            "K": "positive definite: n",
            "M": "positive definite: n",
            "W": "matrix: n N",
            "b": "vector: n",
            "h": "positive",
            "j": "vector: N",
            "l": "vector: N",
            "o": "vector: n",
            "p": "vector: n",
            "q": "vector: n",
            "r": "vector: n",
            "s": "vector: n",
            "t": "vector: n",
            "u": "vector: n",
            "w": "vector: n",
            "x": "vector: n",
            "y": "vector: n",
            "z": "vector: n",
        },
        given=(
            "-p + q - h*W*l - h*u + h*z*T(j)*l",
            "-M*u + M*w + h*C*w - h*K*b + h*K*q - h**2*K*z",
            "C*r + K*o",
            "W*l + r - 2*z",
            "b + o - p + x",
            "b + o - q + y + h*z",
            "r + s - u",
            "r + t - w",
            "-1 + T(j)*l",
        ),
    ),
    Statement(
        "variational",
        "eq_24_measured_repair",
        {
            "PROVED": Case(
                "PROVED",
                "for all M, K, C > 0 of any size, any number of sensors with weights l of sum "
                "one, any velocities W of theirs and a constant velocity z of the target: with "
                "the measured relative velocities S in (24) the velocity estimate is wrong by u "
                "only, the errors x, u obey (20), and for every h > 0 with 4M + 2hC - h^2 K > 0 "
                "they tend to 0",
                (
                    "-x + y - h*u == 0",
                    "-M*u + M*w + h*C*w + h*K*y == 0",
                    "schur(M + h*C, -2*M - h*C + h**2*K, M)",
                    "-S*l + W*l + u - z == u",
                ),
            ),
        },
        symbols={
            "C": "positive definite: n",
            "K": "positive definite: n",
            "M": "positive definite: n",
            "Q": "positive definite: n",
            "S": "matrix: n N",
            "W": "matrix: n N",
            "b": "vector: n",
            "h": "positive",
            "j": "vector: N",
            "l": "vector: N",
            "p": "vector: n",
            "q": "vector: n",
            "u": "vector: n",
            "w": "vector: n",
            "x": "vector: n",
            "y": "vector: n",
            "z": "vector: n",
        },
        given=(
            "-p + q + h*S*l - h*W*l - h*u",
            "-M*u + M*w + h*C*w - h*K*b + h*K*q - h**2*K*z",
            "b - p + x",
            "b - q + y + h*z",
            "-4*M + Q - 2*h*C + h**2*K",
            "S - W + z*T(j)",
            "-1 + T(j)*l",
        ),
    ),
    Statement(
        "variational",
        "section_4_converge",
        {
            "REFUTED": Case(
                "REFUTED",
                "for all M, K, C > 0 of any size, every h > 0 and every target with a constant "
                "acceleration a: the errors of (24) without noise, taken from the constant pair "
                "(o, r) with r = ha/2 and K o = -C r, obey (20); since -r'Ko = r'Cr > 0 unless "
                "a = 0, no solution of (24) tends to 0",
                (
                    "-x + y - h*s == 0",
                    "-M*s + M*t + h*C*t + h*K*y == 0",
                    "-T(r)*K*o == T(r)*C*r",
                    "pd(C)",
                ),
            ),
        },
        symbols={
            "C": "positive definite: n",
            "K": "positive definite: n",
            "M": "positive definite: n",
            "a": "vector: n",
            "b": "vector: n",
            "h": "positive",
            "o": "vector: n",
            "p": "vector: n",
            "q": "vector: n",
            "r": "vector: n",
            "s": "vector: n",
            "t": "vector: n",
            "u": "vector: n",
            "v": "vector: n",
            "w": "vector: n",
            "x": "vector: n",
            "y": "vector: n",
        },
        given=(
            "-p + q - h*u - h*v",
            "-M*u + M*w + h*C*w - h*K*b + h*K*q - h**2*K*v - 1/2*h**3*K*a",
            "C*r + K*o",
            "r - 1/2*h*a",
            "b + o - p + x",
            "b + o - q + y + h*v + 1/2*h**2*a",
            "r + s - u",
            "r + t - w",
        ),
    ),
    Statement(
        "variational",
        "section_4_converge_offset",
        {
            "REFUTED": Case(
                "REFUTED",
                "M, K, C are symmetric positive definite, every solution of (20) tends to 0 at "
                "the step h, and the position error of (24) without noise therefore tends to "
                "the o with K o = -(h/2) C a, which is not 0",
                (
                    "pd(M)",
                    "pd(K)",
                    "pd(C)",
                    "h > 0",
                    "schur(M + h*C, -2*M - h*C + h**2*K, M)",
                    "exists(o, K*o == -h/2*C*a, T(o)*o > 0)",
                ),
            ),
        },
        inputs={"C": "matrix", "K": "matrix", "M": "matrix", "a": "matrix", "h": "number"},
    ),
    Statement(
        "variational",
        "section_4_converge_repair",
        {
            "PROVED": Case(
                "PROVED",
                "for all M, K, C > 0 of any size and every target with a constant acceleration: "
                "with the mean of the velocities v and z that are measured at both ends of the "
                "step in the first line of (24), the errors x, u without noise obey (20), and "
                "for every h > 0 with 4M + 2hC - h^2 K > 0 they tend to 0",
                (
                    "-x + y - h*u == 0",
                    "-M*u + M*w + h*C*w + h*K*y == 0",
                    "schur(M + h*C, -2*M - h*C + h**2*K, M)",
                ),
            ),
        },
        symbols={
            "C": "positive definite: n",
            "K": "positive definite: n",
            "M": "positive definite: n",
            "Q": "positive definite: n",
            "a": "vector: n",
            "b": "vector: n",
            "h": "positive",
            "p": "vector: n",
            "q": "vector: n",
            "u": "vector: n",
            "v": "vector: n",
            "w": "vector: n",
            "x": "vector: n",
            "y": "vector: n",
            "z": "vector: n",
        },
        given=(
            "-p + q - h*u - 1/2*h*v - 1/2*h*z",
            "-M*u + M*w + h*C*w - h*K*b + h*K*q - h**2*K*v - 1/2*h**3*K*a",
            "b - p + x",
            "b - q + y + h*v + 1/2*h**2*a",
            "-4*M + Q - 2*h*C + h**2*K",
            "-v + z - h*a",
        ),
    ),
    Statement(
        "variational",
        "section_4_converge_uniform",
        {
            "PROVED": Case(
                "PROVED",
                "for all M, K, C > 0 of any size and every target with a constant velocity v: "
                "the errors x, u of (24) as printed, without noise, obey (20), and for every h "
                "> 0 with 4M + 2hC - h^2 K > 0 they tend to 0",
                (
                    "-x + y - h*u == 0",
                    "-M*u + M*w + h*C*w + h*K*y == 0",
                    "schur(M + h*C, -2*M - h*C + h**2*K, M)",
                ),
            ),
        },
        symbols={
            "C": "positive definite: n",
            "K": "positive definite: n",
            "M": "positive definite: n",
            "Q": "positive definite: n",
            "b": "vector: n",
            "h": "positive",
            "p": "vector: n",
            "q": "vector: n",
            "u": "vector: n",
            "v": "vector: n",
            "w": "vector: n",
            "x": "vector: n",
            "y": "vector: n",
        },
        given=(
            "-p + q - h*u - h*v",
            "-M*u + M*w + h*C*w - h*K*b + h*K*q - h**2*K*v",
            "b - p + x",
            "b - q + y + h*v",
            "-4*M + Q - 2*h*C + h**2*K",
        ),
    ),
    Statement(
        "variational",
        "section_4_noise_robust",
        {
            "PROVED": Case(
                "PROVED",
                "for every linear recursion z+ = A z + G n of any size, N > 1 sensors and the "
                "stationary covariance P of z when n is the mean of N independent white noises "
                "of one covariance V: the mean's covariance is V/N, and with one sensor less "
                "N/(N-1) P is stationary; f and g stand for 1/(N-1) and 1/N, l for equal weights",
                ("T(l)*l == g", "f*N*P == A*(f*N*P)*T(A) + f*G*V*T(G)"),
            ),
        },
        symbols={
            "A": "matrix: n",
            "G": "matrix: n m",
            "N": "positive",
            "P": "symmetric: n",
            "V": "symmetric: m",
            "f": "positive",
            "g": "positive",
            "j": "vector: k",
            "l": "vector: k",
        },
        given=("P - A*P*T(A) - g*G*V*T(G)", "g*N - 1", "f*N - f - 1", "l - g*j", "T(j)*j - N"),
    ),
    Statement(
        "variational",
        "section_4_sensor_loss",
        {
            "PROVED": Case(
                "PROVED",
                "for all M, K, C > 0 of any size, any set of sensors with weights of sum one at "
                "a sample (B1, R1, W1, S1, l1) and any other at the next (B2, R2, W2, S2, l2), "
                "exact measurements and a constant velocity of the target: the averages are the "
                "target's position and velocity before and after, so the errors x, u obey (20) "
                "across the change, and for every h > 0 with 4M + 2hC - h^2 K > 0 they tend to 0",
                (
                    "-x + y - h*u == 0",
                    "-M*u + M*w + h*C*w + h*K*y == 0",
                    "schur(M + h*C, -2*M - h*C + h**2*K, M)",
                    "B1*l1 - R1*l1 == b",
                    "-S2*l2 + W2*l2 == v",
                ),
            ),
        },
        symbols={
            "B1": "matrix: n N1",
            "B2": "matrix: n N2",
            "C": "positive definite: n",
            "K": "positive definite: n",
            "M": "positive definite: n",
            "Q": "positive definite: n",
            "R1": "matrix: n N1",
            "R2": "matrix: n N2",
            "S1": "matrix: n N1",
            "S2": "matrix: n N2",
            "W1": "matrix: n N1",
            "W2": "matrix: n N2",
            "b": "vector: n",
            "h": "positive",
            "j1": "vector: N1",
            "j2": "vector: N2",
            "l1": "vector: N1",
            "l2": "vector: N2",
            "p": "vector: n",
            "q": "vector: n",
            "u": "vector: n",
            "v": "vector: n",
            "w": "vector: n",
            "x": "vector: n",
            "y": "vector: n",
        },
        given=(
            "-p + q + h*S1*l1 - h*W1*l1 - h*u",
            "-M*u + M*w + h*C*w - h*K*B2*l2 + h*K*R2*l2 + h*K*q",
            "b - p + x",
            "b - q + y + h*v",
            "-4*M + Q - 2*h*C + h**2*K",
            "-B1 + R1 + b*T(j1)",
            "S1 - W1 + v*T(j1)",
            "-1 + T(j1)*l1",
            "-B2 + R2 + b*T(j2) + h*v*T(j2)",
            "S2 - W2 + v*T(j2)",
            "-1 + T(j2)*l2",
        ),
    ),
    Statement(
        "variational",
        "section_4_sensor_loss_kept",
        {
            "PROVED": Case(
                "PROVED",
                "for all M, K, C > 0 of any size, any sensors whose weights have the sum f > 0 "
                "instead of one, exact measurements and a target at rest in b: the estimate "
                "taken from f b obeys (20), and for every h > 0 with 4M + 2hC - h^2 K > 0 they "
                "tend to 0, so that the position error tends to -(1 - f) b: with two of three "
                "weights 1/3, to a third of the distance from the origin",
                (
                    "-x + y - h*u == 0",
                    "-M*u + M*w + h*C*w + h*K*y == 0",
                    "schur(M + h*C, -2*M - h*C + h**2*K, M)",
                ),
            ),
        },
        symbols={
            "B": "matrix: n N",
            "C": "positive definite: n",
            "K": "positive definite: n",
            "M": "positive definite: n",
            "Q": "positive definite: n",
            "R": "matrix: n N",
            "S": "matrix: n N",
            "W": "matrix: n N",
            "b": "vector: n",
            "f": "positive",
            "h": "positive",
            "j": "vector: N",
            "l": "vector: N",
            "p": "vector: n",
            "q": "vector: n",
            "u": "vector: n",
            "w": "vector: n",
            "x": "vector: n",
            "y": "vector: n",
        },
        given=(
            "-p + q + h*S*l - h*W*l - h*u",
            "-M*u + M*w + h*C*w - h*K*B*l + h*K*R*l + h*K*q",
            "-p + x + f*b",
            "-q + y + f*b",
            "-4*M + Q - 2*h*C + h**2*K",
            "-B + R + b*T(j)",
            "S - W",
            "T(j)*l - f",
        ),
    ),
)
