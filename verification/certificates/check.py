#!/usr/bin/env python3
"""Re-validate SensorTrack certificates: this one file and the Python standard library.

    python -I -S check.py FILE... [--json] [--statements FILE]

A certificate holds data (rationals), the name and digest of a statement, and a witness. The statement stands
in statements.json beside this file and is printed; every matrix in it is computed here from the data, so a
witness can make the proof succeed or fail, but never change what is proved. Each kind of witness rests on one
elementary lemma, proved in docs/verification/lemmas.md. Exit status: 0 all valid, 1 one is not, 2 one is unreadable.
"""
import ast, hashlib, json, math, operator, pathlib, re, sys
from fractions import Fraction

FORMAT = "sensortrack-certificate/1"
FILE_BYTES, DIGITS = 1 << 26, 4000  # of a file; of a number
DENOMINATORS, SCALED = 100_000, 1_000_000_000  # digits of all denominators together; of all numbers over one
NODES, CUT_STEPS, PRODUCTS = 600, 2_000_000, 10_000  # of a matrix of a graph; of a proof; of terms of expressions
LIVE = 1 << 31  # twice the bytes that an elimination may hold
POSITIVE = {"positive definite", "positive semidefinite"}
NUMBER = re.compile(rf"-?[0-9]{{1,{DIGITS}}}(/[1-9][0-9]{{0,{DIGITS - 1}}})?")

class Reject(Exception):
    """The certificate does not prove its statement."""
def need(condition, message):
    if not condition:
        raise Reject(message)

def read_json(path):
    """JSON of integers (Python refuses more than 4300 digits) and texts, without a key given twice."""
    def refuse(text):
        raise ValueError(f"{text[:40]} is not accepted")
    def once(pairs):
        return dict(pairs) if len({key for key, _ in pairs}) == len(pairs) else refuse("a key given twice")
    with open(path, encoding="utf-8") as file:
        text = file.read(FILE_BYTES + 1)
    text = text if len(text) <= FILE_BYTES else refuse("a file of this size")
    return json.loads(text, object_pairs_hook=once, parse_float=refuse, parse_constant=refuse)

def number(value):
    need(type(value) is int or (type(value) is str and NUMBER.fullmatch(value)), f"{value!r:.40} is no rational")
    return Fraction(value)
def whole(value):
    need(number(value).denominator == 1, f"{value} is no integer")
    return number(value).numerator
def listed(value, length=None, of=lambda entry: entry):
    need(type(value) is list and length in (None, len(value)), f"a list of {length or 'some'} is due")
    return [of(entry) for entry in value]
def fields(item, kinds):
    need(type(item) is dict and item.get("kind") in [*kinds], f"one of {[*kinds]} is due")
    need({*item} == {"kind", *kinds[item["kind"]].split()}, f"keys of {item['kind']}")
    return dict(item)
def rows_of(value):
    rows = listed(value, None, lambda row: listed(row, None, number))
    need(rows and rows[0] and len({*map(len, rows)}) == 1, "no matrix")
    return rows
def integers(rows):  # over their common denominator: integers are quicker
    unit = math.lcm(*(x.denominator for row in rows for x in row))
    need(unit.bit_length() * len(rows) * len(rows[0]) <= SCALED, "too many numbers for one denominator as long")
    return [[x.numerator * (unit // x.denominator) for x in row] for row in rows], unit
def mixed(factors, matrices):
    (rows, unit), ((c,), share) = integers([row for rows in matrices for row in rows]), integers([factors])
    size = range(len(rows) // len(c))
    return [[Fraction(sum(map(operator.mul, c, x)), unit * share) for x in zip(*rows[i :: len(size)])] for i in size]
def product(a, b):
    return [[sum(map(operator.mul, row, column)) for column in zip(*b)] for row in a]

class Poly:
    """Sum of matrices of rationals times scalars that commute times a word of letters that do not.

    terms[scalars, word] is the matrix. Data need no letters and one scalar at most, the variable of a forall.
    In a universal statement every matrix is 1 x 1; a scalar is (name, kind) and a letter, a matrix of any size
    that fits, (name, kind, rows, columns) with named sizes, name' for a transpose; the empty word is the identity.
    """
    def __init__(self, terms, shape):
        self.terms, self.shape = {key: rows for key, rows in terms.items() if any(map(any, rows))}, shape
    def __add__(self, other):
        need(self.shape == other.shape, f"a sum of shapes {self.shape} and {other.shape}")
        both = {key: [p.terms[key] for p in (self, other) if key in p.terms] for key in self.terms | other.terms}
        return Poly({key: mixed([1] * len(found), found) for key, found in both.items()}, self.shape)
    def __sub__(self, other):
        return self + Poly({k: [[-x for x in row] for row in m] for k, m in other.terms.items()}, other.shape)
    def __mul__(self, other):
        scale, products = self.shape == (1, 1), {}
        if other.shape == (1, 1) and not scale:
            return other * self
        need(scale or self.shape[1] == other.shape[0], "a product of unlike shapes")
        need(len(self.terms) * len(other.terms) <= PRODUCTS, "a product of too many terms")
        for (s, v), a in self.terms.items():
            for (t, w), b in other.terms.items():
                need(not (v and w) or v[-1][3] == w[0][2], "a product of unlike sizes")
                (x, p), (y, q) = integers(a), integers(b)
                rows = mixed(a[0], [b]) if scale else mixed([Fraction(1, p * q)], [product(x, y)])
                products.setdefault(((*sorted(s + t),), v + w), []).append(rows)
        shape = other.shape if scale else (self.shape[0], other.shape[1])
        return Poly({key: mixed([1] * len(found), found) for key, found in products.items()}, shape)
    def transpose(self):
        def flip(name, kind, rows, columns):
            turned = name if kind in {"symmetric", *POSITIVE} else name[:-1] if name[-1] == "'" else name + "'"
            return turned, kind, columns, rows
        terms = {(s, (*(flip(*x) for x in w[::-1]),)): [*map(list, zip(*m))] for (s, w), m in self.terms.items()}
        return Poly(terms, self.shape[::-1])
    def diagonal(self):
        """A square matrix without what is off its diagonal; a column, put on the diagonal of one."""
        rows, column = self.rows(), self.shape[1] == 1
        need(column or self.shape[0] == self.shape[1], "a square matrix or a column is due")
        return matrix([[row[not column and i] * (i == j) for j in range(len(rows))] for i, row in enumerate(rows)])
    def rows(self):
        need({*self.terms} <= {((), ())}, "data are due here, no variable and no letter")
        return self.terms.get(((), ()), [[Fraction(0)] * self.shape[1]] * self.shape[0])
    def number(self):
        need(self.shape == (1, 1), "a number is due")
        return self.rows()[0][0]
def matrix(rows, key=((), ())):
    return Poly({key: rows}, (len(rows), len(rows[0])))
def constant(value):
    return matrix([[Fraction(value)]])

class Graph:
    """Undirected weighted graph with its components, or the Cartesian product of connected ones (factors)."""
    def __init__(self, data):
        need(type(data) is dict and {*data} - {"weights"} in ({"nodes", "edges"}, {"product"}), "keys of a graph")
        self.factors, self.parts = listed(data.get("product", []), None, Graph), []
        if "product" in data:
            connected = all(len(factor.parts) == 1 for factor in self.factors)
            need(connected and len(data) == 1 < len(self.factors), "a product of two or more connected graphs is due")
            self.n = math.prod(factor.n for factor in self.factors)
            return
        names, pairs = listed(data["nodes"]), listed(data["edges"], None, lambda pair: listed(pair, 2, whole))
        need({*map(type, names)} == {str} and len({*names}) == len(names), "node names")
        weights, self.n = listed(data.get("weights", [1] * len(pairs)), len(pairs), number), len(names)
        need(all(0 <= i < j < self.n for i, j in pairs) and len({*map(tuple, pairs)}) == len(pairs), "edges")
        need(min(weights, default=1) > 0, "a weight is not positive")
        self.near, self.home = [{} for _ in names], [None] * self.n
        for (i, j), w in zip(pairs, weights):
            self.near[i][j] = self.near[j][i] = w
        for start in range(self.n):  # parts: nodes in increasing order, and edges in the order given
            walk = [start] if self.home[start] is None else []
            for i in walk:
                if self.home[i] is None:
                    self.home[i] = len(self.parts)
                    walk += self.near[i]
            self.parts += [(sorted({*walk}), [])] if walk else []
        for (i, j), w in zip(pairs, weights):
            self.parts[self.home[i]][1].append((i, j, w))
    def dense(self, entry):
        need(not self.factors and self.n <= NODES, "a graph of at most some hundred nodes is due")
        return matrix([[Fraction(entry(i, j)) for j in range(self.n)] for i in range(self.n)])

class Cuts:
    """b k >= N and f (b k - N)^2 >= E p, for the cuts of one component of a graph, of n nodes.

    A cut S of s nodes has weight k of leaving edges, p = s (n - s)/n and N = (1 - s/n) gamma(S) + (s/n) gamma(not S).
    All is scaled to integers: b k becomes k, N the load (n - s) gamma(S) + s gamma(not S), and the second condition
    (k - load)^2 q >= r s (n - s). Nodes are numbered 0 .. n - 1 in increasing order, edges in the order of the graph.
    """
    def __init__(self, proof, part, gamma, b, f, e):
        nodes, edges = part
        self.proof, self.n, self.at = proof, len(nodes), {node: k for k, node in enumerate(nodes)}
        self.edges = [(self.at[i], self.at[j], w) for i, j, w in edges]
        gamma, x, self.b, f = pick(gamma, nodes), pick(e, nodes), b.number(), f.number()
        spread = e.number() if e.shape == (1, 1) and self.n > 1 else sum(v * v for v in x) - sum(x) ** 2 / self.n
        need(min(self.b, f, spread, *gamma) >= 0 and (f or not spread), "a negative or vacuous bound")
        self.grain = math.lcm(*(w.denominator for _, _, w in edges))
        self.unit = math.lcm(*(g.denominator for g in gamma)) * self.grain * self.b.denominator
        self.gamma = [int(g * self.unit) for g in gamma]
        self.total, self.near = sum(self.gamma), [{} for _ in nodes]
        self.even = min(self.gamma) == max(self.gamma)
        self.pushes = [1] * self.n if self.even else self.gamma  # that flows carry
        for i, j, w in self.edges:
            self.near[i][j] = self.near[j][i] = int(w * self.b * self.unit * self.n)
        self.q, self.r = (f / (spread * self.n * self.unit**2)).as_integer_ratio() if spread else (f > 0, 0)
    def load(self, s, inside):
        return (self.n - 2 * s) * inside + s * self.total
    def clear(self, k, load, s):
        return k >= load and (k - load) ** 2 * self.q >= self.r * s * (self.n - s)
    def tree(self):
        """A cut is no better than the worst of its connected parts: on a tree, one edge each."""
        need(len(self.edges) == self.n - 1, "no tree")
        walk, parent = [0], {0: None}
        for i in walk:
            walk += [j for j in self.near[i] if j != parent[i] and parent.setdefault(j, i) == i]
        below, inside = [1] * self.n, list(self.gamma)
        for i in reversed(walk[1:]):
            up = parent[i]
            need(self.clear(self.near[i][up], self.load(below[i], inside[i]), below[i]), f"edge at node {i}")
            below[up], inside[up] = below[up] + below[i], inside[up] + inside[i]
    def enumeration(self, order):
        """Every cut, node by node; a branch ends where even its worst completion is clear."""
        need(self.n <= NODES and sorted(listed(order, self.n, whole)) == [*range(self.n)], "no order of some nodes")
        at = {v: i for i, v in enumerate(map(whole, order))}
        near = [{at[u]: w for u, w in self.near[v].items()} for v in at]  # numbered as they are visited
        gamma, rank = [self.gamma[v] for v in at], sorted(self.gamma, reverse=True)
        worst = [self.load(s, sum(rank[:s] if 2 * s < self.n else rank[self.n - s :])) for s in range(self.n)]
        twin = [i and gamma[i] == gamma[i - 1] and near[i] | {i: 0, i - 1: 0} == near[i - 1] | {i: 0, i - 1: 0}
                for i in range(self.n)]  # with the node before: swapping the two changes nothing
        side, link = [0] * self.n, ([0] * self.n, [0] * self.n)
        bits = sum(x.bit_length() for x in (self.q, self.r, max(max(own.values(), default=0) for own in near) ** 2))
        fee = [1 + (self.n + 4 * len(own)) * (1 + bits // 4096) // 128 + bits // 1024 for own in [*near, {}]]
        def visit(i, count, inside, k):
            self.proof.steps += fee[i]
            need(self.proof.steps <= CUT_STEPS, "too many cuts to visit")
            if i == self.n:  # all nodes on one side is no cut
                clear = count == i or self.clear(k, self.load(count, inside), count)
                return need(clear, f"the cut {[v for v, s in zip(at, side) if s]} fails")
            extra, high = sum(map(min, link[0][i:], link[1][i:])), min(self.n - i + count, self.n - 1)
            if i and self.clear(k + extra, max(worst[count : high + 1]), min(max(self.n // 2, count), high)):
                return  # a node not yet visited will cut at least its lighter links
            for choice in (1, 0):  # the first node is inside, and of twins the first ones
                if (i or choice) and not (choice and twin[i] and not side[i - 1]):
                    side[i] = choice
                    for u, w in near[i].items():
                        link[choice][u] += w
                    visit(i + 1, count + choice, inside + choice * gamma[i], k + link[1 - choice][i])
                    for u, w in near[i].items():
                        link[choice][u] -= w
        visit(0, 0, 0, 0)
    def routing(self, unit, flows):
        """Flows that carry every disturbance: N/k is at most the largest load of an edge."""
        unit, loads = whole(unit), [0] * len(self.edges)
        need(unit > 0, "no unit")
        for source, flow in enumerate(listed(flows, self.n)):
            net = [unit - self.n * unit * (i == source) for i in range(self.n)]
            for edge, amount in listed(flow, None, lambda pair: listed(pair, 2, whole)):
                need(0 <= edge < len(loads), "a flow on no edge")
                i, j, _ = self.edges[edge]
                net[i], net[j] = net[i] + amount, net[j] - amount
                loads[edge] += self.pushes[source] * abs(amount)
            need(not any(net), f"the flow of node {source} leaks")
        self.settle(self.largest(loads, self.n * unit))
    def cells(self, scale, levels):
        """Carries the means of cells, then of the cells within each, down to single nodes: their loads add up."""
        scale, home, loads = whole(scale), [0] * self.n, [0] * len(self.edges)
        need(scale > 0, "no scale")
        for unit, cells, weights, sources in (listed(level, 4) for level in listed(levels)):
            inner = [(e, i, j, home[i]) for e, (i, j, _) in enumerate(self.edges) if home[i] == home[j]]
            self.proof.steps += 1 + (self.n + len(inner)) * len(listed(sources)) // 32
            need(self.proof.steps <= CUT_STEPS, "too many flows")
            for row, length in [([unit], 1), (cells, self.n), (weights, len(inner)), *((x, self.n) for x in sources)]:
                need(all(type(v) is int and abs(v) < 1 << 63 for v in listed(row, length)), "64 bits are due")
            need(unit > 0 <= min(cells) and max(cells) < len(sources), "no unit, or a cell without a source")
            up, links, place = {}, [], {(i, j): t for t, (_, i, j, _) in enumerate(inner)}
            for root in range(self.n):  # a tree in each cell so far, from its smallest node
                walk = [] if root in up else [root]
                for i in walk:
                    up.setdefault(root, root)
                    walk += [j for j in self.near[i] if home[j] == home[i] and up.setdefault(j, i) == i]
                links += [(i, up[i], place[min(i, up[i]), max(i, up[i])]) for i in walk[1:]]
            need(self.n - len(links) == len({*home}), "a cell is not connected")
            size, keys, parts = dict.fromkeys(home, 0), [*zip(home, cells)], {}
            for g, key in zip(self.pushes, keys):
                size[key[0]] += 1
                parts.setdefault(key, []).append(g)
            for k, steps in enumerate(sources):  # of potentials along the trees
                held = {h: parts.get((h, k), ()) for h in size}
                share = {h: -(-sum(of) * scale // (len(of) * size[h] * unit)) if of else 0 for h, of in held.items()}
                x, net = steps[:], [unit * (size[h] * (k == cell) - len(held[h])) for h, cell in keys]
                for i, j, _ in links:
                    x[i] += x[j]
                flow = [w * (x[i] - x[j]) >> 20 for w, (_, i, j, _) in zip(weights, inner)]
                for (_, i, j, _), amount in zip(inner, flow):
                    net[i], net[j] = net[i] - amount, net[j] + amount
                for i, j, t in reversed(links):  # what a flow leaves goes up the tree: at its root, all is zero
                    flow[t], net[j] = flow[t] + (net[i] if i < j else -net[i]), net[j] + net[i]
                for (e, _, _, h), amount in zip(inner, flow):
                    loads[e] += share[h] * abs(amount)
            place = {key: number for number, key in enumerate(parts)}
            home = [place[key] for key in keys]
        need(len({*home}) == self.n, "cells of several nodes are left")
        self.settle(self.largest(loads, scale))
    def gap(self, least, order, bits):
        """k >= lambda_2 p and N <= 2 p times the largest gamma: good where a network expands."""
        near, least = [{} for _ in range(self.n)], number(least)
        for i, j, w in self.edges:
            near[i][j] = near[j][i] = w
        need(least > 0, "a positive bound on lambda_2 is due")
        eliminate(self.proof, near, least, order, bits)
        self.settle(2 * max(self.pushes) / least)
    def largest(self, loads, scale):
        return max((x / w for x, (*_, w) in zip(loads, self.edges)), default=Fraction(1)) / scale
    def settle(self, top):
        """N/k is at most the largest load; with one gamma, a cut of s nodes has a weight of at least c grains."""
        if not self.even:
            return need(not self.r and top <= self.b * self.unit, f"the routing proves {top / self.unit} only")
        degrees, least, held, low = sorted(map(len, self.near)), Fraction(2 * self.grain, self.n) / top, 0, 0
        grain = int(self.b * self.unit * self.n / self.grain)  # scaled as weights are: unit holds both denominators
        few = 2 if all(d % 2 == 0 for d in degrees) else 1  # an even number of links leaves S if all nodes have one
        for s in range(1, self.n // 2 + 1):  # a node has at most s - 1 neighbours within
            held += degrees[s - 1]
            while low < s and degrees[low] < s:  # held: the sum of degrees[low:s], of those >= s among the first s
                held, low = held - degrees[low], low + 1
            c = max(few, held - (s - low) * (s - 1), -(-s * (self.n - s) * least.numerator // least.denominator))
            need(self.clear(c * grain, self.load(s, s * self.gamma[0]), s), f"a cut of {s} nodes may fail")

class Proof:
    """Evaluates the predicates of one statement and takes the witness items in order."""
    def __init__(self, env, witness, kinds):
        self.env, self.items, self.kinds = env, iter(listed(witness)), kinds
        self.range, self.proved, self.given, self.steps = None, [], [], 0
    def take(self, kinds):
        return fields(next(self.items, None), kinds)
    def expression(self, node):
        match node:
            case ast.Constant(value=value) if type(value) is int:
                return constant(value)
            case ast.Name(id=name) if name in self.env:
                return self.env[name]
            case ast.UnaryOp(op=ast.USub(), operand=inner):
                return constant(-1) * self.expression(inner)
            case ast.BinOp(left=left, op=ast.Pow(), right=ast.Constant(value=int(power))) if power in (2, 3, 4):
                need(not any(type(inner) is ast.Pow for inner in ast.walk(left)), "a power of a power")
                return math.prod([base := self.expression(left)] * (power - 1), start=base)
            case ast.BinOp(left=left, op=op, right=right) if type(op) in ARITHMETIC:
                return ARITHMETIC[type(op)](self.expression(left), self.expression(right))
            case ast.Call(func=ast.Name(id=name), args=args) if name in FUNCTIONS:
                return FUNCTIONS[name](*map(self.expression, args))
        raise Reject(f"not in the language: {ast.unparse(node)}")
    def read(self, text):
        need(type(text) is str and len(text) <= 5000, "an expression of at most 5000 characters is due")
        return self.expression(ast.parse(text, mode="eval").body)

    def holds(self, node):
        """Accept the predicate or raise Reject. forall(h, a, b, ...): h in (a, b], or [a, inf) if b is inf."""
        match node:
            case ast.Compare(left=left, ops=[ast.Eq() | ast.GtE() as op], comparators=[right]) if self.kinds:
                self.derive(self.expression(left) - self.expression(right), type(op) is ast.GtE, False)
            case ast.Compare(left=left, ops=[op], comparators=[right]) if type(op) in ORDER:
                need(ORDER[type(op)](self.expression(left) - self.expression(right)), f"not so: {ast.unparse(node)}")
            case ast.Call(func=ast.Name(id="forall"), args=[ast.Name(id=h), a, b, *bodies]):
                need(not self.kinds and self.range is None and h not in self.env, "one range at a time, of data")
                start, end = (None if ast.unparse(x) == "inf" else self.expression(x).number() for x in (a, b))
                need(end is None or start < end, "an empty interval")
                self.range, self.env[h] = (start, end), matrix([[Fraction(1)]], ((h,), ()))
                for body in bodies:
                    self.holds(body)
                del self.env[h]
                self.range = None
            case ast.Call(func=ast.Name(id="exists"), args=[ast.Name(id=name), *bodies]) if name not in self.env:
                self.env[name] = matrix(rows_of(self.take({"matrix": "rows"})["rows"]))
                for body in bodies:
                    self.holds(body)
            case ast.Call(func=ast.Name(id=name), args=args) if name in PREDICATES:
                PREDICATES[name](self, *map(self.expression, args))
            case _:
                raise Reject(f"not a predicate: {ast.unparse(node)}")
    def local(self, poly):
        """Coefficients in a basis that is >= 0 on the range: Bernstein's, or powers of h - a."""
        if self.range is None:
            return [poly.rows()]
        (a, b), powers = self.range, {0: [[Fraction(0)] * poly.shape[1]] * poly.shape[0]}
        powers |= {len(scalars): rows for (scalars, _), rows in poly.terms.items()}
        d = range(max(powers) + 1)
        if b is None:
            weights = [[math.comb(k, i) * a ** max(k - i, 0) for k in d] for i in d]
        else:  # of h^k: the mean product of k among i times b and d - i times a
            weights = [[sum(math.comb(i, j) * math.comb(d[-1] - i, k - j) * b**j * a ** (k - j) for j in range(k + 1))
                        / math.comb(d[-1], k) for k in d] for i in d]
        return [mixed([row[k] for k in powers], powers.values()) for row in weights]

    def positive(self, poly):
        """Positive definite on the whole range, by its coefficients in the basis of ``local``."""
        if self.kinds:
            return self.derive(poly, True, True)
        need(poly.terms == poly.transpose().terms, "a symmetric matrix is due")
        parts = self.local(poly)
        vital = 0 if self.range is None or self.range[1] is None else len(parts) - 1  # at the closed end
        for k, rows in enumerate(parts):  # the others may be zero
            if k == vital or any(map(any, rows)):
                self.definite(rows)
    def definite(self, rows):
        item, n = self.take({"congruence": "rows", "combination": "terms"}), len(rows)
        if item["kind"] == "combination":  # c >= 0, not all 0, of matrices proved before
            terms = [(whole(k), number(c)) for k, c in listed(item["terms"], None, lambda t: listed(t, 2))]
            need(all(0 <= k < len(self.proved) and c >= 0 for k, c in terms), "no proved matrix")
            need(any(c for _, c in terms) and {len(self.proved[k]) for k, _ in terms} == {n}, "no sum")
            total = mixed([c for _, c in terms], [self.proved[k] for k, _ in terms])
            need(total == rows, "the combination is another matrix")
        else:  # G E G' strictly diagonally dominant
            g = listed(item["rows"], n, lambda row: listed(row, n, whole))
            half = product(g, integers(rows)[0])
            for i, row in enumerate(product(half, [*zip(*g)])):
                need(2 * row[i] > sum(map(abs, row)), f"row {i} is not diagonally dominant")
        self.proved.append(rows)
    def derive(self, goal, sign, strict):
        """goal = sum of c X' P X (only if sign; c >= 0, P >= 0) + sum of left relation right."""
        item, rest, sure = self.take({"derivation": "squares relations"}), goal, not strict
        for factor, text, p in listed(item["squares"], None, lambda entry: listed(entry, 3)):
            c, x, kind = self.read(factor), self.read(text), self.kinds.get(p)
            signs = {kind for scalars, _ in c.terms for _, kind in scalars}
            need(sign and (p == "1" or kind in POSITIVE), "a square of unknown sign")
            positive = all(v[0][0] > 0 and not word for (_, word), v in c.terms.items())
            need(positive and signs <= {"positive", "nonnegative"}, "a factor of unknown sign")
            sure |= kind == "positive definite" and text == "1" and bool(c.terms) and signs <= {"positive"}
            rest -= c * x.transpose() * self.read(p) * x
        need(sure, "strictly positive is due")
        zero = {str(k): relation for k, relation in enumerate(self.given)}
        zero |= {f"{k}'": relation.transpose() for k, relation in zero.items()}
        for left, k, right in listed(item["relations"], None, lambda entry: listed(entry, 3)):
            need(k in zero, f"no relation {k}")
            rest -= self.read(left) * zero[k] * self.read(right)
        need(not rest.terms, f"the derivation leaves {[[letter[0] for letter in s + w] for s, w in rest.terms]}")

ARITHMETIC = {ast.Add: operator.add, ast.Sub: operator.sub, ast.Mult: operator.mul,
              ast.Div: lambda a, b: constant(1 / b.number()) * a}
ORDER = {ast.Eq: lambda d: not d.terms, ast.NotEq: lambda d: any(map(any, d.rows())),
         ast.Lt: lambda d: d.number() < 0, ast.LtE: lambda d: d.number() <= 0,
         ast.Gt: lambda d: d.number() > 0, ast.GtE: lambda d: d.number() >= 0}
FUNCTIONS = {"T": Poly.transpose, "nodes": lambda g: constant(g.n), "diag": Poly.diagonal,
             "trace": lambda a: constant(sum(map(sum, a.diagonal().rows()))),
             "eye": lambda g: g.dense(operator.eq), "ones": lambda g: g.dense(lambda i, j: 1),
             "laplacian": lambda g: g.dense(lambda i, j: sum(g.near[i].values()) if i == j else -g.near[i].get(j, 0))}
def dips(proof, poly):
    """Some x, not 0, has x' E x <= 0 on the whole range."""
    x = listed(proof.take({"vector": "x"})["x"], poly.shape[0], number)
    need(any(x) and poly.shape[0] == poly.shape[1], "the vector is zero")
    for rows in proof.local(poly):
        need(product(product([x], rows), [*zip(x)])[0][0] <= 0, "the form is positive at the vector")
def schur(proof, a2, a1, a0):
    """A2 x(k+2) + A1 x(k+1) + A0 x(k) = 0, symmetric matrices, tends to 0 (Jury)."""
    for poly in (a2 - a0, a2 + a0, a2 + a1 + a0, a2 - a1 + a0):
        proof.positive(poly)
def unstable(proof, a2, a1, a0):
    """The same recursion has a solution (-r)^k x with r >= 1 (intermediate value)."""
    need(all(a.terms == a.transpose().terms for a in (a1, a0)), "a symmetric matrix is due")
    proof.positive(a2)
    dips(proof, a2 - a1 + a0)
def pick(data, nodes):
    """Values at some nodes; one value stands for all."""
    return [data.number()] * len(nodes) if data.shape == (1, 1) else [x for x, in map(data.rows().__getitem__, nodes)]
def cuts_clear(proof, graph, *data):
    """Every cut of every component has b k >= N and f (b k - N)^2 >= E p; a vector e: E is its spread."""
    parts = graph.parts or [None]  # a product is connected
    for item, part in zip(listed(proof.take({"cuts": "parts"})["parts"], len(parts)), parts):
        clear_part(proof, item, graph, part, *data)
def clear_part(proof, item, graph, part, gamma, b, f, e):
    if graph.factors:  # route along one factor after the other
        need(e.number() == 0 <= gamma.number(), "a product bounds the threshold only")
        inner = listed(fields(item, {"product": "parts"})["parts"], len(graph.factors))
        for factor, entry in zip(graph.factors, inner):
            clear_part(proof, entry, factor, factor.parts[0], gamma, b, f, e)
    else:
        item = fields(item, {"tree": "", "enumeration": "order", "routing": "unit flows", "cells": "scale levels",
                             "gap": "least order bits"})
        getattr(Cuts(proof, part, gamma, b, f, e), item.pop("kind"))(**item)
def cut_reaches(proof, graph, gamma, b, f, e, strict=False):
    """Some cut has b k <= N or f (b k - N)^2 <= E p; if strict, N > b k."""
    item = proof.take({"cut": "factor nodes" if graph.factors else "nodes"})
    inside = listed(item["nodes"], None, whole)
    if graph.factors:  # the cut of all nodes whose coordinate in this factor is one of these
        need(e.number() == 0 <= gamma.number(), "a product bounds the threshold only")
        need(0 <= whole(item["factor"]) < len(graph.factors), "no such factor")
        graph = graph.factors[whole(item["factor"])]
    need(inside and 0 <= min(inside) and max(inside) < graph.n, "nodes of the graph are due")
    cut = Cuts(proof, graph.parts[graph.home[inside[0]]], gamma, b, f, e)
    s = {cut.at.get(i) for i in inside}
    need(None not in s and len(inside) == len(s) < cut.n, "nodes of one component, each once and not all, are due")
    k = sum(w for i in s for j, w in cut.near[i].items() if j not in s)
    load = cut.load(len(s), sum(cut.gamma[i] for i in s))
    low = load >= k or (k - load) ** 2 * cut.q <= cut.r * len(s) * (cut.n - len(s))
    need(load > k if strict else low, "the cut does not reach the bound")
def cut_drifts(proof, graph, gamma, b):
    """Some cut has N > b k: its disturbance drives its sides apart for ever."""
    cut_reaches(proof, graph, gamma, b, constant(1), constant(0), True)
def gap_above(proof, graph, s):
    """The second eigenvalue of the Laplacian is >= s; that of a product is the smallest one of its factors."""
    item = proof.take({"product": "parts"} if graph.factors else {"sparse_ldl": "order bits"})
    parts = listed(item["parts"], len(graph.factors)) if graph.factors else [item]
    for part, entry in zip(graph.factors or [graph], parts):
        eliminate(proof, part.near, s.number(), **fields(entry, {"sparse_ldl": "order bits"}))
def eliminate(proof, near, s, order, bits, **_):
    """L - s I, in units of 4^-bits and weights rounded down, is >= 0 on a hyperplane."""
    # It is the sum of sign(c) (|c|, q)(|c|, q)' over all columns, c < 0 once at most, and of a dominant matrix >= 0.
    # What is taken from later rows waits there as one integer a row, in digits of `wide` bytes around 0, one a place.
    order, bits, slack, load = listed(order, len(near), whole), whole(bits), [0] * len(near), [0] * len(near)
    need(0 <= bits <= DIGITS and sorted(order) == [*range(len(near))], "no order of the nodes")
    need(sum(map(len, near)) * bits <= LIVE, "too much to eliminate")
    at, unit, live, negative, waiting = {v: k for k, v in enumerate(order)}, 4**bits, 0, 0, [[] for _ in order]
    links = [{at[u]: w.numerator * unit // w.denominator for u, w in near[v].items()} for v in order]
    shift = math.ceil(s * unit)
    wide = (abs(shift) + max(sum(own.values()) for own in links)).bit_length() // 8 + bits // 8 + 4
    zero = (half := 1 << 8 * wide - 1).to_bytes(wide, "little")
    def digits(x, count):
        text = (x + int.from_bytes(zero * count, "little")).to_bytes(count * wide, "little")
        return [text[i : i + wide] for i in range(0, count * wide, wide)]
    for k, own in enumerate(links):
        spots = sorted({k, *(j for j in own if j > k)}.union(*(places for places, _ in waiting[k])))
        size, rows, spot = len(spots), [0] * len(spots), {j: i for i, j in enumerate(spots)}
        live += size**2 - sum(len(places) ** 2 for places, _ in waiting[k])
        moved = sum(len(places) for places, _ in waiting[k] if places != spots)
        proof.steps += (size * wide) ** 2 // 400_000 + moved * size * (64 + wide) // 130_000
        need(proof.steps <= CUT_STEPS and live * wide <= LIVE, "too much to eliminate")
        for places, packed in waiting[k]:
            to = [spot[j] for j in places]
            rows = [x + y for x, y in zip(rows, packed)] if places == spots else rows
            for i, x in enumerate(packed if places != spots else ()):  # to be moved to its places
                parts = [zero] * (size - to[i])
                for t, part in zip(to[i:], digits(x, len(to) - i)):
                    parts[t - to[i]] = part
                rows[to[i]] += int.from_bytes(b"".join(parts), "little") - int.from_bytes(zero * len(parts), "little")
        parts, waiting[k] = digits(rows[0], size), None
        column = [int.from_bytes(part, "little") - half - own.get(j, 0) for j, part in zip(spots, parts)]
        free, width = column[0] + sum(own.values()) - shift - slack[k], sum(map(bool, column[1:]))
        c = math.isqrt(max(free - (width * math.isqrt(max(free, 0)) + 1) // 2, 0))  # leaves width |c|/2
        c = c or -math.isqrt(max(-free, 0)) - 1 - (width + 1) // 2
        taken, negative, tail = [(2 * w + c) // (2 * c) for w in column], negative + (c < 0), 0
        for j, q, w in zip(spots[1:], taken[1:], column[1:]):
            left = abs(w - c * q)
            free, slack[j], load[j] = free - left, slack[j] + left, load[j] + q * q
            need(4 * load[j] < half, "digits run over")  # all sums of products of q are below half then
        need(free >= c * abs(c) and negative <= 1, "what rounding leaves is not dominant, or two pivots are negative")
        for i in range(size - 1, 0, -1):
            tail = (tail << 8 * wide) + taken[i]
            rows[i] -= (taken[i] if c > 0 else -taken[i]) * tail
        if size > 1:
            waiting[spots[1]].append((spots[1:], rows[1:]))
def gap_below(proof, graph, s):
    """The second eigenvalue is <= s: a vector of sum zero shows it, for a product on one of its factors."""
    item = proof.take({"vector": "factor x" if graph.factors else "x"})
    need(not graph.factors or 0 <= whole(item["factor"]) < len(graph.factors), "no such factor")
    graph = graph.factors[whole(item["factor"])] if graph.factors else graph
    x = listed(item["x"], graph.n, whole)
    energy = sum(w * (x[i] - x[j]) ** 2 for _, edges in graph.parts for i, j, w in edges)
    need(any(x) and not sum(x) and energy <= s.number() * sum(v * v for v in x), "no vector shows it")
def points(proof, graph, beta, bound, x, clock=Fraction(0)):
    """Times and errors where the straight pieces of a run of x' in -beta B SGN(B'x) + M u, |u| <= bound, end."""
    yield clock, x
    edges, beta = [edge for _, edges in graph.parts for edge in edges], beta.number()
    for piece in listed(proof.take({"trajectory": "pieces"})["pieces"]):
        need(type(piece) is dict and {*piece} == {"duration", "disturbance", "signs"}, "keys of a piece")
        span, u = number(piece["duration"]), listed(piece["disturbance"], graph.n, number)
        need(span > 0 and all(abs(a) <= g for a, g in zip(u, bound)), "disturbance above its bound")
        rate, signs = [a - mean for mean in [sum(u) / graph.n] for a in u], listed(piece["signs"], len(edges), number)
        for (i, j, w), sign in zip(edges, signs):
            rate[i], rate[j] = rate[i] - beta * w * sign, rate[j] + beta * w * sign
        bits = max(v.numerator.bit_length() + v.denominator.bit_length() for v in x + rate)
        proof.steps += (graph.n + len(edges)) * (bits >> 10) ** 2 // 2  # fractions are reduced in the square of that
        need(proof.steps <= CUT_STEPS, "a run of numbers too long")
        y = [a + span * v for a, v in zip(x, rate)]
        for (i, j, _), sign in zip(edges, signs):
            ends = x[i] - x[j], y[i] - y[j]  # and in between the difference is between
            need(abs(sign) <= 1 and all(sign * d == abs(d) for d in ends), "no selection of the edge signs")
        yield (clock := clock + span), (x := y)
def run(proof, graph, beta, gamma, x0, x1, t):
    """An admissible disturbance drives the error from x0, whose sum is zero, to x1 in the time t."""
    need(len(graph.parts) == 1, "a connected graph, no product, is due")
    x0, x1, bound = (pick(values, range(graph.n)) for values in (x0, x1, gamma))
    *_, end = points(proof, graph, beta, bound, x0)
    need(sum(x0) == 0 and end == (t.number(), x1), "the run ends elsewhere, or its error has a mean")
def agrees(proof, graph, beta, x0, t):
    """Without disturbance x0, less its mean in each component, becomes zero at the time t and not before."""
    need(graph.parts and beta.number() > 0, "no product, and a positive gain, are due")
    x = pick(x0, range(graph.n))
    means = [sum(x[i] for i in nodes) / len(nodes) for nodes, _ in graph.parts]
    *before, (clock, last) = points(proof, graph, beta, [0] * graph.n, [a - means[k] for a, k in zip(x, graph.home)])
    need(clock == t.number() and not any(last) and all(any(x) for _, x in before), "agreement is not at this time")

PREDICATES = {"pd": Proof.positive, "dips": dips, "schur": schur, "unstable": unstable, "run": run, "agrees": agrees,
              "cuts_clear": cuts_clear, "cut_reaches": cut_reaches, "cut_drifts": cut_drifts,
              "gap_above": gap_above, "gap_below": gap_below}
def digest_of(statement):
    return hashlib.sha256(json.dumps(statement, sort_keys=True, separators=(",", ":")).encode()).hexdigest()
def environment(statement, inputs):
    """Values of a statement's names: data, letters ("matrix: n m", "vector: n") and scalars ("positive")."""
    env, graph = {}, next((Graph(inputs[k]) for k, kind in statement["inputs"].items() if "graph" in kind), None)
    for name, kind, value in ((name, kind, inputs[name]) for name, kind in statement["inputs"].items()):
        graphs = (value, *value.get("product", ())) if kind == "unweighted graph" else ()
        need(not any("weights" in g for g in graphs), "a graph without weights is due")
        each = kind == "nodes" and not graph.factors  # then one number stands for all nodes
        rows = [[value]] if kind in ("number", "nodes") and not each else value
        rows = [[x] for x in (listed(rows, graph.n) if type(rows) is list else [rows] * graph.n)] if each else rows
        env[name] = graph if "graph" in kind else matrix(rows_of(rows))
    for name, text in statement["symbols"].items():
        kind, _, size = text.partition(": ")
        sizes = [*size.split(), "1" if kind == "vector" else size][:2]
        env[name] = matrix([[Fraction(1)]], ((), ((name, kind, *sizes),)) if size else (((name, kind),), ()))
    return env

def check_document(document, statements, kind_of_proof=Proof):
    """What a certificate proves, as an entry of ``--json``; Reject if it proves nothing."""
    need(type(document) is dict and document.get("format") == FORMAT, f"format is not {FORMAT}")
    ends = {end: document[end] for end in ("lower", "upper") if end in document}
    keys = "format system name digest inputs case verdict relies_on witness about".split()
    need({*document} == {*keys, *ends}, "missing or unknown keys")
    name, inputs = f"{document['system']}.{document['name']}", document["inputs"]
    need(name in statements, f"no statement {name}")
    statement = statements[name]
    need(document["digest"] == digest_of(statement), "the digest is that of another statement")
    need(document["case"] in [*statement["cases"]], "no such case")
    case = statement["cases"][document["case"]]
    need(document["verdict"] == case["verdict"], "the verdict is that of another case")
    need(document["relies_on"] == statement["relies_on"], "relies_on is that of another statement")
    need({*ends} == {*case["ends"]} and all(v in (None, ends[k]) for k, v in case["ends"].items()), "lower, upper")
    need(type(inputs) is dict and {*inputs} == {*statement["inputs"]}, "inputs missing or too many")
    text = json.dumps([inputs, ends, document["witness"]])
    digits = sum(map(len, {*re.findall("/([0-9]+)", text)}))  # of what sums are brought to
    scaled = digits + max(map(len, re.findall("[0-9]{100,}", text)), default=0)
    need(digits <= DENOMINATORS and scaled * text.count(",") <= SCALED, "denominators too many and too long")
    kinds = {name: text.partition(":")[0] for name, text in statement["symbols"].items()}
    need(not (kinds and inputs), "letters or data")
    env = {end: constant(number(ends[end])) for end, fixed in case["ends"].items() if fixed is None}
    proof = kind_of_proof(env | environment(statement, inputs), document["witness"], kinds)
    proof.given = [proof.read(text) for text in statement["given"]]
    for text in case["show"]:
        proof.holds(ast.parse(text, mode="eval").body)
    need(not [*proof.items], "a witness too many")
    relies = "".join(f"; given {text} == 0" for text in statement["given"])
    relies += "".join(f"; relies on {text}" for text in statement["relies_on"])
    entry = {key: document.get(key) for key in ("system", "name", "inputs", "lower", "upper", "verdict")}
    return entry | {"statement": f"{case['words']} [{'; '.join(case['show'])}]{relies}"}

def check_file(path, statements):
    """Entry of ``--json`` and exit status of one file."""
    entry, status = dict.fromkeys("system name statement inputs lower upper verdict".split()), 2
    try:
        document, status = read_json(path), 1
        return {"file": path, "valid": True, **check_document(document, statements), "reason": ""}, 0
    except Exception as error:  # whatever a hostile file provokes, it proves nothing
        reason = str(error) if isinstance(error, Reject) else f"{type(error).__name__}: {error}"
        return {"file": path, "valid": False, **entry, "reason": printable(reason)}, status
def printable(value):  # a page at most, that plays no tricks with a terminal: names are chosen by an author
    return ascii(str(value)[:5000])[1:-1]

def main(argv):
    words, path = [word for word in argv if word != "--json"], pathlib.Path(__file__).with_name("statements.json")
    if "--statements" in words[:-1]:
        _, path = words.pop(at := words.index("--statements")), words.pop(at)
    try:
        need(words and not any(word.startswith("-") for word in words), __doc__)
        statements = read_json(path)
    except (Reject, OSError, ValueError, RecursionError) as error:
        print(error if isinstance(error, Reject) else f"check.py: --statements: {printable(error)}", file=sys.stderr)
        return 0 if "--help" in words else 2
    results = [check_file(name, statements) for name in words]
    if "--json" in argv:
        print(json.dumps([entry for entry, _ in results], indent=1))
    for entry, _ in [] if "--json" in argv else results:
        print("VALID" if entry.pop("valid") else "INVALID", printable(entry.pop("file")))
        print(*(f"  {key}: {printable(value)}" for key, value in entry.items() if value), sep="\n")
    return max(status for _, status in results)
if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
