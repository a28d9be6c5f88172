"""A second road to the implicit step on trees: dynamic programming instead of cuts.

What a subtree adds to the derivative of the objective, as a function of the value at the other end
of its link, is piecewise linear, does not fall, and is clipped to the link's capacity. It is kept
as the corners between the two constant ends.
"""

from itertools import pairwise


def height(corners, x):
    """Value of the function with these corners."""
    if x <= corners[0][0]:
        return corners[0][1]
    if x >= corners[-1][0]:
        return corners[-1][1]
    (a, low), (b, high) = next(pair for pair in pairwise(corners) if pair[1][0] >= x)
    return low + (high - low) * (x - a) / (b - a)


def solve(own, messages, target):
    """The x with x - own + the messages at x = target; the left side rises with slope 1 or more."""

    def total(x):
        return x - own + sum(height(corners, x) for corners in messages)

    marks = sorted({x for corners in messages for x, _ in corners})
    left = [x for x in marks if total(x) <= target]
    right = [x for x in marks if total(x) > target]
    if not left:
        end = right[0] if right else own
        return end - (total(end) - target)
    if not right:
        return left[-1] + (target - total(left[-1]))
    (a, low), (b, high) = (left[-1], total(left[-1])), (right[0], total(right[0]))
    return a + (b - a) * (target - low) / (high - low)


def tree_prox(network, y, length):
    """argmin 1/2 |x - y|^2 + length TV(x) on a tree."""
    near = [{} for _ in y]
    for (i, j), w in zip(network.edges.tolist(), network.exact_weights(), strict=True):
        near[i][j] = near[j][i] = length * w
    walk, parent = [0], {0: None}
    for i in walk:
        walk += [j for j in near[i] if j not in parent and parent.setdefault(j, i) == i]
    heard = {i: [] for i in walk}
    sent = {}
    for i in reversed(walk[1:]):
        most = near[i][parent[i]]
        ends = [solve(y[i], heard[i], target) for target in (-most, most)]
        marks = sorted({*ends, *(x for c in heard[i] for x, _ in c if ends[0] < x < ends[1])})
        sent[i] = [(x, x - y[i] + sum(height(c, x) for c in heard[i])) for x in marks]
        heard[parent[i]].append(sent[i])
    x = {0: solve(y[0], heard[0], 0)}
    for i in walk[1:]:  # clipped: the child follows its parent as far as its link pulls
        least, most = sent[i][0][0], sent[i][-1][0]
        x[i] = min(max(x[parent[i]], least), most)
    return tuple(x[i] for i in range(len(y)))
