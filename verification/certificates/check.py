#!/usr/bin/env python3
"""Re-validate SensorTrack certificates: this one file and the Python standard library.

    python -I -S check.py FILE... [--json] [--statements FILE]

A certificate holds data (rationals), the name and digest of a statement, and a witness. The statement stands
in statements.json beside this file and is printed; every matrix in it is computed here from the data, so a
witness can make the proof succeed or fail, but never change what is proved. Each kind of witness rests on
one elementary lemma, proved in docs/verification/lemmas.md.
Exit status: 0 all valid, 1 one is not, 2 one cannot be read.
"""
import argparse, ast, hashlib, itertools, json, math, operator, os, re, sys
from fractions import Fraction

FORMAT = "sensortrack-certificate/1"
FILE_BYTES, DIGITS, DENOMINATORS = 1 << 26, 4000, 100_000  # of a file; of a number; of all denominators together
NODES, CUT_STEPS, PRODUCTS, BITS = 600, 2_000_000, 10_000, 20_000  # of graphs; of expressions that a witness holds
NUMBER = re.compile(rf"-?[0-9]{{1,{DIGITS}}}(/[1-9][0-9]{{0,{DIGITS - 1}}})?")

class Reject(Exception):
    """The certificate does not prove its statement."""

def need(condition, message):
    if not condition:
        raise Reject(message)

# ------------------------------------------------------------------------------------- reading

def read_json(path):
    def refuse(text):
        raise ValueError(f"{text[:40]} is not accepted: integers and rationals, each key once")

    def once(pairs):
        return dict(pairs) if len({key for key, _ in pairs}) == len(pairs) else refuse("a key given twice")

    with open(path, encoding="utf-8") as file:
        text = file.read(FILE_BYTES + 1)
    return json.loads(text if len(text) <= FILE_BYTES else refuse("a file of this size"), object_pairs_hook=once,
                      parse_int=lambda digits: int(digits) if len(digits) <= DIGITS else refuse(digits),
                      parse_float=refuse, parse_constant=refuse)

def number(value):
    if type(value) is not int and not (type(value) is str and NUMBER.fullmatch(value)):
        raise Reject(f"{str(value)[:40]!r} is no rational")
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

# ------------------------------------------------------------------------------------- expressions

POSITIVE = {"positive definite", "positive semidefinite"}
SYMMETRIC = POSITIVE | {"symmetric"}

def summed(matrices):
    return [[sum(entries) for entries in zip(*rows)] for rows in zip(*matrices)]

def mixed(factors, matrices):
    return summed([[[c * entry for entry in row] for row in rows] for c, rows in zip(factors, matrices)])

class Poly:
    """Sum of matrices of rationals times scalars that commute times a word of letters that do not.

    terms[scalars, word] is the matrix. Data need no letters and one scalar at most, the variable of a forall.
    In a universal statement every matrix is 1 x 1 and the letters are matrices of any size that fits, a letter
    ending in ' is a transpose, the empty word the identity; kinds[letter] = (kind, rows, columns) names sizes.
    """

    def __init__(self, terms, shape, kinds):
        self.terms = {key: rows for key, rows in terms.items() if any(map(any, rows))}
        self.shape, self.kinds = shape, kinds

    def __add__(self, other):
        need(self.shape == other.shape, f"a sum of shapes {self.shape} and {other.shape}")
        both = {key: [p.terms[key] for p in (self, other) if key in p.terms] for key in self.terms | other.terms}
        return Poly({key: summed(found) for key, found in both.items()}, self.shape, self.kinds)

    def __mul__(self, other):
        scale, products = self.shape == (1, 1), {}
        if other.shape == (1, 1) and not scale:
            return other * self
        need(scale or self.shape[1] == other.shape[0], "a product of unlike shapes")
        need(len(self.terms) * len(other.terms) <= PRODUCTS, "a product of too many terms")
        for (s, v), a in self.terms.items():
            for (t, w), b in other.terms.items():
                need(not (v and w) or self.size(v[-1])[1] == self.size(w[0])[0], "a product of unlike sizes")
                rows = mixed(a[0], [b]) if scale else [[sum(map(operator.mul, x, y)) for y in zip(*b)] for x in a]
                products.setdefault(((*sorted(s + t),), v + w), []).append(rows)
        shape = other.shape if scale else (self.shape[0], other.shape[1])
        return Poly({key: summed(found) for key, found in products.items()}, shape, self.kinds)

    def __sub__(self, other):
        return self + constant(-1, self.kinds) * other

    def transpose(self):
        def flip(letter):
            plain = letter[-1] == "'" or self.kinds[letter][0] in SYMMETRIC
            return letter.rstrip("'") if plain else letter + "'"

        terms = {(s, (*map(flip, w[::-1]),)): [*map(list, zip(*m))] for (s, w), m in self.terms.items()}
        return Poly(terms, self.shape[::-1], self.kinds)

    def size(self, letter):
        return self.kinds[letter.rstrip("'")][1:][:: -1 if letter[-1] == "'" else 1]

    def powers(self):
        """Coefficients of the variable's powers, each a matrix of rationals."""
        need(not any(word for _, word in self.terms), "data are due, not letters")
        zero, found = [[Fraction(0)] * self.shape[1]] * self.shape[0], {len(s): m for (s, _), m in self.terms.items()}
        return [found.get(k, zero) for k in range(max(found, default=0) + 1)]

    def rows(self):
        need(len(self.powers()) == 1, "a free variable")
        return self.powers()[0]

    def number(self):
        need(self.shape == (1, 1), "a number is due")
        return self.rows()[0][0]

def matrix(rows, kinds=None, key=((), ())):
    return Poly({key: rows}, (len(rows), len(rows[0])), kinds or {})

def constant(value, kinds=None):
    return matrix([[Fraction(value)]], kinds)

# ------------------------------------------------------------------------------------- graphs and cuts

class Graph:
    """Undirected weighted graph with its components, or the Cartesian product of connected ones (factors)."""

    def __init__(self, data):
        need(type(data) is dict and {*data} - {"weights"} in ({"nodes", "edges"}, {"product"}), "keys of a graph")
        self.factors, self.parts = listed(data.get("product", []), None, Graph), []
        if "product" in data:
            need(len(data) == 1 < len(self.factors), "a product has two factors or more")
            need(all(len(factor.parts) == 1 for factor in self.factors), "a factor is connected and no product")
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

    def square(self, entry):
        need(not self.factors and self.n <= NODES, "a graph of at most some hundred nodes is due")
        return matrix([[Fraction(entry(i, j)) for j in range(self.n)] for i in range(self.n)])

class Cuts:
    """b k >= N and f (b k - N)^2 >= E p, for the cuts of one component of a graph, of n nodes.

    A cut S of s nodes has weight k of leaving edges, p = s (n - s)/n and the load N = (1 - s/n) gamma(S)
    + (s/n) gamma(not S). All is scaled to integers: b k becomes k, N becomes (n - s) gamma(S) +
    s gamma(not S), and the second condition (k - N)^2 q >= r s (n - s). Nodes are numbered 0 .. n - 1 in
    increasing order and edges in the order of the graph. The methods are the ways to show that all are clear.
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
        self.gamma, self.near = [int(g * self.unit) for g in gamma], [{} for _ in nodes]
        for i, j, w in self.edges:
            self.near[i][j] = self.near[j][i] = int(w * self.b * self.unit * self.n)
        self.q, self.r = (f / (spread * self.n * self.unit**2)).as_integer_ratio() if spread else (1, 0)
        self.total = sum(self.gamma)

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
        side, link, order = [None] * self.n, [[0] * self.n, [0] * self.n], listed(order, self.n, whole)
        need(sorted(order) == [*range(self.n)] and self.n <= NODES, "the order is no permutation of a few nodes")
        heavy = [0, *itertools.accumulate(sorted(self.gamma, reverse=True))]  # of the s largest gammas
        worst = [self.load(s, heavy[s] if 2 * s < self.n else self.total - heavy[self.n - s]) for s in range(self.n)]
        links = [{(u, w) for u, w in row.items()} for row in self.near]
        twin = [i > 0 and self.gamma[order[i - 1]] == self.gamma[v] and not any(u != v and u != order[i - 1]
                for u, _ in links[order[i - 1]] ^ links[v]) for i, v in enumerate(order)]

        def visit(i, count, inside, k, extra):
            self.proof.steps += 1
            need(self.proof.steps <= CUT_STEPS, "too many cuts to visit")
            if i == self.n:  # all nodes on one side is no cut
                if count < i and not self.clear(k, self.load(count, inside), count):
                    raise Reject(f"the cut {[v for v in range(i) if side[v]]} fails")
                return
            high = min(self.n - i + count, self.n - 1)
            if i and self.clear(k + extra, max(worst[count : high + 1]), min(max(self.n // 2, count), high)):
                return
            v = order[i]
            for choice in (1, 0):  # twins can be swapped: inside comes first; so does the first node
                if (not choice and i == 0) or (choice and twin[i] and not side[order[i - 1]]):
                    continue
                side[v], more = choice, extra - min(link[0][v], link[1][v])
                free = [(u, w) for u, w in self.near[v].items() if side[u] is None]
                for u, w in free:  # an unassigned node will cut at least its lighter links
                    more -= min(link[0][u], link[1][u])
                    link[choice][u] += w
                    more += min(link[0][u], link[1][u])
                visit(i + 1, count + choice, inside + choice * self.gamma[v], k + link[1 - choice][v], more)
                for u, w in free:
                    link[choice][u] -= w
                side[v] = None

        visit(0, 0, 0, 0, 0)

    def routing(self, unit, flows):
        """Flows that carry every disturbance: N/k is at most the largest load of an edge."""
        unit, loads = whole(unit), [0] * len(self.edges)
        need(unit > 0 and not self.r, "a routing bounds the threshold only")
        for source, flow in enumerate(listed(flows, self.n)):
            net = [unit - self.n * unit * (i == source) for i in range(self.n)]
            for edge, amount in listed(flow, None, lambda pair: listed(pair, 2, whole)):
                need(0 <= edge < len(loads), "a flow on no edge")
                i, j, _ = self.edges[edge]
                net[i], net[j] = net[i] + amount, net[j] - amount
                loads[edge] += self.gamma[source] * abs(amount)
            need(not any(net), f"the flow of node {source} leaks")
        loads = [load / (self.n * unit * self.unit * w) for load, (_, _, w) in zip(loads, self.edges)]
        bound = max(loads, default=self.b)
        if bound > self.b:  # then no value that N/k can take may lie above b, up to the bound
            need(self.b > 0 and min(self.gamma) == max(self.gamma), f"the routing proves {bound} only")
            for s in range(1, self.n // 2 + 1):
                top = Fraction(2 * self.gamma[0] * s * (self.n - s) * self.grain, self.n * self.unit)
                need(math.ceil(top / bound) >= top / self.b, f"a cut of {s} nodes may lie in the gap")

# ------------------------------------------------------------------------------------- proofs

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
                return constant(value, self.kinds)
            case ast.Name(id=name) if name in self.env:
                return self.env[name]
            case ast.UnaryOp(op=ast.USub(), operand=inner):
                return constant(-1, self.kinds) * self.expression(inner)
            case ast.BinOp(left=left, op=ast.Pow(), right=ast.Constant(value=int(power))) if power in (2, 3, 4):
                return math.prod([base := self.modest(left)] * (power - 1), start=base)
            case ast.BinOp(left=left, op=op, right=right) if type(op) in ARITHMETIC:
                return ARITHMETIC[type(op)](self.modest(left), self.modest(right))
            case ast.Call(func=ast.Name(id=name), args=args) if name in FUNCTIONS:
                return FUNCTIONS[name](*map(self.expression, args))
        raise Reject(f"not in the language: {ast.unparse(node)}")

    def modest(self, node):
        value = self.expression(node)
        for rows in value.terms.values() if self.kinds else []:  # a witness may hold a tower of powers
            need(rows[0][0].numerator.bit_length() + rows[0][0].denominator.bit_length() <= BITS, "a huge number")
        return value

    def read(self, text):
        return self.expression(parse(text))

    def holds(self, node):
        """Accept the predicate or raise Reject. forall(h, a, b, ...): h in (a, b], or [a, inf) if b is inf."""
        match node:
            case ast.Compare(left=left, ops=[op], comparators=[right]) if type(op) in ORDER:
                difference = self.expression(left) - self.expression(right)
                if self.kinds:
                    need(type(op) in (ast.Eq, ast.GtE), "a derivation shows == or >=")
                    return self.derive(difference, type(op) is ast.GtE, False)
                need(ORDER[type(op)](difference), f"not so: {ast.unparse(node)}")
            case ast.Call(func=ast.Name(id="forall"), args=[ast.Name(id=h), a, b, *bodies]):
                end = None if ast.unparse(b) == "inf" else self.expression(b).number()
                start, outer = self.expression(a).number(), self.range
                need(outer is None and h not in self.env and (end is None or start < end), "no new interval")
                self.range, self.env[h] = (start, end), matrix([[Fraction(1)]], None, ((h,), ()))
                for body in bodies:
                    self.holds(body)
                self.range = None
                del self.env[h]
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
        (a, b), coefs = self.range, poly.powers()
        d = len(coefs) - 1

        def weight(i, k):  # of h^k in the basis function i
            if b is None:
                return math.comb(k, i) * a ** max(k - i, 0)
            ways = (math.comb(i, j) * math.comb(d - i, k - j) * b**j * a ** (k - j) for j in range(k + 1))
            return sum(ways) / math.comb(d, k)

        return [mixed([weight(i, k) for k in range(d + 1)], coefs) for i in range(d + 1)]

    def positive(self, poly):
        """Positive definite on the whole range, by its coefficients in the basis of ``local``."""
        if self.kinds:
            return self.derive(poly, True, True)
        need(not (poly - poly.transpose()).terms, "a symmetric matrix is due")
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
            unit = math.lcm(*(entry.denominator for row in rows for entry in row))
            scaled = [[int(entry * unit) for entry in row] for row in rows]
            g = listed(item["rows"], n, lambda row: listed(row, n, whole))
            for i, x in enumerate([[sum(map(operator.mul, x, y)) for y in scaled] for x in g]):
                w = [sum(map(operator.mul, x, y)) for y in g]
                need(2 * w[i] > sum(map(abs, w)), f"row {i} is not diagonally dominant")
        self.proved.append(rows)

    def derive(self, goal, sign, strict):
        """goal = sum of c X' P X (only if sign; c >= 0, P >= 0) + sum of left relation right."""
        item, rest, sure = self.take({"derivation": "squares relations"}), goal, not strict
        for factor, text, p in listed(item["squares"], None, lambda entry: listed(entry, 3)):
            need(sign and (p == "1" or p in self.kinds and self.kinds[p][0] in POSITIVE), "of unknown sign")
            c, x = self.read(factor), self.read(text)
            scalars = {self.kinds[name][0] for names, _ in c.terms for name in names}
            need(scalars <= {"positive", "nonnegative"}, "a factor of unknown sign")
            need(all(v[0][0] > 0 and not word for (_, word), v in c.terms.items()), "a negative factor")
            sure |= p != "1" and self.kinds[p][0] == "positive definite" and text == "1" and bool(
                c.terms) and scalars <= {"positive"}
            rest -= c * x.transpose() * self.read(p) * x
        need(sure, "strictly positive is due")
        for left, k, right in listed(item["relations"], None, lambda entry: listed(entry, 3)):
            need(type(k) is str and k.rstrip("'") in map(str, range(len(self.given))), f"no relation {k}")
            relation = self.given[int(k.rstrip("'"))]
            rest -= self.read(left) * (relation.transpose() if k[-1] == "'" else relation) * self.read(right)
        need(not rest.terms, f"the derivation leaves {[*rest.terms][:2]}")

ARITHMETIC = {ast.Add: operator.add, ast.Sub: operator.sub, ast.Mult: operator.mul,
              ast.Div: lambda a, b: constant(1 / b.number(), a.kinds) * a}
ORDER = {ast.Eq: lambda d: not d.terms, ast.NotEq: lambda d: any(map(any, d.rows())),
         ast.Lt: lambda d: d.number() < 0, ast.LtE: lambda d: d.number() <= 0,
         ast.Gt: lambda d: d.number() > 0, ast.GtE: lambda d: d.number() >= 0}
FUNCTIONS = {"T": Poly.transpose, "nodes": lambda graph: constant(graph.n),
             "eye": lambda graph: graph.square(operator.eq), "ones": lambda graph: graph.square(lambda i, j: 1),
             "laplacian": lambda graph: graph.square(
                 lambda i, j: sum(graph.near[i].values()) if i == j else -graph.near[i].get(j, 0))}

# ------------------------------------------------------------------------------------- predicates

def dips(proof, poly):
    """Some x, not 0, has x' E x <= 0 on the whole range."""
    x = listed(proof.take({"vector": "x"})["x"], poly.shape[0], number)
    need(any(x) and poly.shape[0] == poly.shape[1], "the vector is zero")
    for rows in proof.local(poly):
        form = sum(a * sum(map(operator.mul, row, x)) for a, row in zip(x, rows))
        need(form <= 0, "the form is positive at the vector")

def schur(proof, a2, a1, a0):
    """A2 x(k+2) + A1 x(k+1) + A0 x(k) = 0, symmetric matrices, tends to 0 (Jury)."""
    for poly in (a2 - a0, a2 + a0, a2 + a1 + a0, a2 - a1 + a0):
        proof.positive(poly)

def unstable(proof, a2, a1, a0):
    """The same recursion has a solution (-r)^k x with r >= 1 (intermediate value)."""
    need(not (a1 - a1.transpose()).terms and not (a0 - a0.transpose()).terms, "a symmetric matrix is due")
    proof.positive(a2)
    dips(proof, a2 - a1 + a0)

def pick(values, nodes):
    """Values at some nodes; one value stands for all."""
    rows = values.rows()
    return [rows[0][0]] * len(nodes) if values.shape == (1, 1) else [rows[i][0] for i in nodes]

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
        item = fields(item, {"tree": "", "enumeration": "order", "routing": "unit flows"})
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
    need({*inside} <= {*cut.at}, "nodes of one component are due")
    s = {cut.at[i] for i in inside}
    need(len(inside) == len(s) < cut.n, "each node once, and not all")
    k = sum(w for i in s for j, w in cut.near[i].items() if j not in s)
    load = cut.load(len(s), sum(cut.gamma[i] for i in s))
    low = load >= k or (k - load) ** 2 * cut.q <= cut.r * len(s) * (cut.n - len(s))
    need(load > k if strict else low, "the cut does not reach the bound")

def cut_drifts(proof, graph, gamma, b):
    """Some cut has N > b k: its disturbance drives its sides apart for ever."""
    cut_reaches(proof, graph, gamma, b, constant(1), constant(0), True)

def run(proof, graph, beta, gamma, x0, x1, t):
    """An admissible disturbance drives the error of x' in -beta B SGN(B'x) + M u from x0 to x1."""
    need(len(graph.parts) == 1, "a connected graph, no product, is due")
    x, bound, clock = pick(x0, range(graph.n)), pick(gamma, range(graph.n)), Fraction(0)
    need(sum(x) == 0, "an error has the sum zero")
    edges, beta = graph.parts[0][1], beta.number()
    for piece in listed(proof.take({"trajectory": "pieces"})["pieces"]):
        need(type(piece) is dict and {*piece} == {"duration", "disturbance", "signs"}, "keys of a piece")
        span, u = number(piece["duration"]), listed(piece["disturbance"], graph.n, number)
        need(span > 0 and all(abs(a) <= g for a, g in zip(u, bound)), "disturbance above its bound")
        rate, signs = [a - sum(u) / graph.n for a in u], listed(piece["signs"], len(edges), number)
        for (i, j, w), sign in zip(edges, signs):
            rate[i], rate[j] = rate[i] - beta * w * sign, rate[j] + beta * w * sign
        y = [a + span * v for a, v in zip(x, rate)]
        for (i, j, _), sign in zip(edges, signs):
            ends = x[i] - x[j], y[i] - y[j]
            moves = (sign == 1 and min(ends) >= 0) or (sign == -1 and max(ends) <= 0)
            need(moves or (not any(ends) and abs(sign) <= 1), "no selection of the edge signs")
        x, clock = y, clock + span
    need(x == pick(x1, range(graph.n)) and clock == t.number(), "the run ends elsewhere")

PREDICATES = {"pd": Proof.positive, "dips": dips, "schur": schur, "unstable": unstable, "run": run,
              "cuts_clear": cuts_clear, "cut_reaches": cut_reaches, "cut_drifts": cut_drifts}

# ------------------------------------------------------------------------------------- certificates

KEYS = {"format", "system", "name", "digest", "inputs", "case", "verdict", "relies_on", "witness", "about"}

def parse(text):
    need(type(text) is str and len(text) <= 5000, "an expression of at most 5000 characters is due")
    return ast.parse(text, mode="eval").body

def digest_of(statement):
    return hashlib.sha256(json.dumps(statement, sort_keys=True, separators=(",", ":")).encode()).hexdigest()

def read_input(kind, value, graph):
    if kind in ("graph", "matrix"):
        return graph if kind == "graph" else matrix(rows_of(value))
    if kind == "number" or graph.factors:
        return constant(number(value))
    values = listed(value, graph.n) if type(value) is list else [value] * graph.n  # one stands for all nodes
    return matrix([[number(entry)] for entry in values])

def symbols(statement):
    """Letters of a universal statement, declared like "matrix: n m", "vector: n" or "positive"."""
    kinds = {}
    for letter, text in statement["symbols"].items():
        kind, _, size = text.partition(": ")
        kinds[letter] = kind, *(size.split() + ["1" if kind == "vector" else size] * 2)[:2]
    keys = {k: ((), (k,)) if v[1] else ((k,), ()) for k, v in kinds.items()}
    return kinds, {k: matrix([[Fraction(1)]], kinds, keys[k]) for k in kinds}

def check_document(document, statements, kind_of_proof=Proof):
    """What a certificate proves, as an entry of ``--json``; Reject if it proves nothing."""
    need(type(document) is dict and document.get("format") == FORMAT, f"format is not {FORMAT}")
    ends = {end: document[end] for end in ("lower", "upper") if end in document}
    need({*document} == KEYS | {*ends}, "missing or unknown keys")
    name, inputs = f"{document['system']}.{document['name']}", document["inputs"]
    need(name in statements, f"no statement {name}")
    statement = statements[name]
    need(document["digest"] == digest_of(statement), "the digest is that of another statement")
    need(document["relies_on"] == statement["relies_on"], "relies_on is another list")
    need(document["case"] in [*statement["cases"]], "no such case")
    case = statement["cases"][document["case"]]
    need(document["verdict"] == case["verdict"], "the verdict is that of another case")
    need({*ends} == {*case["ends"]} and all(v in (None, ends[k]) for k, v in case["ends"].items()), "lower, upper")
    need(type(inputs) is dict and {*inputs} == {*statement["inputs"]}, "inputs missing or too many")
    denominators = {*re.findall("/([0-9]+)", json.dumps([inputs, ends, document["witness"]]))}
    need(sum(map(len, denominators)) <= DENOMINATORS, "denominators too many and too long to be added")
    kinds, env = symbols(statement)
    need(not (kinds and inputs), "letters or data")
    graph = next((Graph(inputs[k]) for k, kind in statement["inputs"].items() if kind == "graph"), None)
    env |= {k: read_input(kind, inputs[k], graph) for k, kind in statement["inputs"].items()}
    env |= {end: constant(number(ends[end])) for end, fixed in case["ends"].items() if fixed is None}
    proof = kind_of_proof(env, document["witness"], kinds)
    proof.given = [proof.read(text) for text in statement["given"]]
    for text in case["show"]:
        proof.holds(parse(text))
    need(next(proof.items, None) is None, "a witness too many")
    return {**{key: document[key] for key in ("system", "name", "inputs", "verdict")}, "lower": ends.get("lower"),
            "upper": ends.get("upper"), "statement": f"{case['words']} [{'; '.join(case['show'])}]"}

def printable(text):
    """Text that cannot play tricks with a terminal: names in a certificate are chosen by its author."""
    return "".join(c if c.isprintable() else "?" for c in text).encode("ascii", "backslashreplace").decode()

def check_file(path, statements):
    """Entry of ``--json`` and exit status of one file."""
    entry = {"file": path, "valid": False, "system": None, "name": None, "statement": None, "inputs": None,
             "lower": None, "upper": None, "verdict": None, "reason": ""}
    status = 2
    try:
        document, status = read_json(path), 1
        return {**entry, **check_document(document, statements), "valid": True}, 0
    except Exception as error:  # whatever a hostile file provokes, it proves nothing
        reason = str(error) if isinstance(error, Reject) else f"{type(error).__name__}: {error}"
        return {**entry, "reason": printable(reason[:300])}, status

def main(argv):
    parser = argparse.ArgumentParser(prog="check.py", description=__doc__.splitlines()[0])
    parser.add_argument("files", nargs="+", metavar="FILE")
    parser.add_argument("--json", action="store_true", help="print one JSON document and nothing else")
    here = os.path.dirname(os.path.abspath(__file__))
    parser.add_argument("--statements", default=os.path.join(here, "statements.json"), metavar="FILE")
    options = parser.parse_args(argv)
    try:
        statements = read_json(options.statements)
    except (OSError, ValueError, RecursionError) as error:
        parser.error(printable(f"--statements: {error}"))
    results = [check_file(path, statements) for path in options.files]
    if options.json:
        print(json.dumps([entry for entry, _ in results], indent=1))
    for entry, _ in [] if options.json else results:
        print(printable(f"{'VALID' if entry['valid'] else 'INVALID'}  {entry['file']}  {entry['reason']}").rstrip())
        if entry["valid"]:
            name, inputs = f"{entry['system']}.{entry['name']}", json.dumps(entry["inputs"])
            print(printable(f"  {entry['verdict']}  {name}: {entry['statement']}"))
            for key in ("lower", "upper"):
                print(f"  {key} = {entry[key]}" if entry[key] is not None else "", end="")
            print(f"  inputs = {inputs if len(inputs) < 400 else inputs[:400] + ' ... (all: --json)'}")
            print(*(printable(f"  relies on: {text}") for text in statements[name]["relies_on"]), sep="\n")
    return max(status for _, status in results)

if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
