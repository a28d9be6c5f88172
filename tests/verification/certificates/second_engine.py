"""A second road to definiteness: what the checker multiplies out, balls of real numbers decide.

The first engine shows a matrix E to be positive definite by an integer G with G E G' dominant; this
one factors E = LDL' in ball arithmetic. They share no line below the statement's own matrices.
"""

from verification.certificates import check
from verification.exact.balls import ball_definite

PRECISIONS = (64, 128, 256, 1024)


def definite_matrices_of(document, statements):
    """Matrices that a certificate shows to be positive definite.

    Parameters
    ----------
    document : dict
        A valid certificate.
    statements : dict
        The entries of statements.json.

    Returns
    -------
    list of list of list of Fraction
    """
    proofs = []

    def proof(*arguments):
        proofs.append(check.Proof(*arguments))
        return proofs[-1]

    check.check_document(document, statements, proof)
    return proofs[0].proved


def decided_by_balls(rows):
    """True, False, or None if even the widest precision cannot tell."""
    answers = (ball_definite(rows, bits) for bits in PRECISIONS)
    return next((answer for answer in answers if answer is not None), None)
