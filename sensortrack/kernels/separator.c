/* A small set of nodes that splits a graph into two parts of similar size, by multilevel search.
 *
 * A separator is found on a coarse graph, made by merging neighbours pairwise, and improved on the
 * way back: a separating node moves to one side and draws its neighbours on the other side into the
 * separator, the best such move first, and moves after the best state are taken back.
 *
 * C. M. Fiduccia and R. M. Mattheyses, "A linear-time heuristic for improving network partitions",
 * Design Automation Conference (1982). B. Hendrickson and R. Leland, "A multilevel algorithm for
 * partitioning graphs", Supercomputing (1995).
 */
#include <setjmp.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

enum { COARSEST = 160, TRIALS = 20, PASSES = 6, NEAR = 1024, SEPARATOR = 2 };

struct block {  /* a header that lets everything be freed after a failed allocation */
    struct block *before, *after;
};

struct context {
    jmp_buf failed;
    struct block *blocks;
    uint64_t seed;
};

struct graph {  /* neighbours of node i: to[first[i]] .. to[first[i + 1] - 1] */
    int32_t n;
    int32_t *first, *to;
    int32_t *weight, *load;  /* of nodes, of links: how many of the finest graph they stand for */
};

struct heap {  /* nodes by key, the largest first */
    int32_t size, *item, *at, *key;
};

static void *take(struct context *c, int64_t count, size_t size)
{
    struct block *b = malloc(sizeof *b + (size_t)(count > 0 ? count : 1) * size);
    if (b == NULL)
        longjmp(c->failed, 1);
    b->before = NULL;
    b->after = c->blocks;
    if (c->blocks != NULL)
        c->blocks->before = b;
    c->blocks = b;
    return b + 1;
}

static int32_t *numbers(struct context *c, int64_t count, int32_t value)
{
    int32_t *list = take(c, count, sizeof *list);
    int64_t i;
    for (i = 0; i < count; i++)
        list[i] = value;
    return list;
}

static void give(struct context *c, void *place)
{
    struct block *b = (struct block *)place - 1;
    if (b->before != NULL)
        b->before->after = b->after;
    else
        c->blocks = b->after;
    if (b->after != NULL)
        b->after->before = b->before;
    free(b);
}

static void give_graph(struct context *c, struct graph *g)
{
    give(c, g->first);
    give(c, g->to);
    give(c, g->weight);
    give(c, g->load);
}

static uint32_t drawn(struct context *c, uint32_t below)
{
    c->seed ^= c->seed << 13;
    c->seed ^= c->seed >> 7;
    c->seed ^= c->seed << 17;
    return (uint32_t)((c->seed >> 32) % below);
}

static int64_t sum(const int32_t *list, int32_t n)
{
    int64_t total = 0;
    int32_t i;
    for (i = 0; i < n; i++)
        total += list[i];
    return total;
}

/* ---------------------------------------------------------------------------- coarser graphs */

/* Merge nodes in pairs along heavy links, and what is left along a common neighbour. */
static int32_t merge(struct context *c, const struct graph *g, int32_t *into)
{
    int32_t n = g->n, count = 0, i, e;
    int32_t *order = numbers(c, n, 0), *waiting;
    int64_t most = 3 * sum(g->weight, n) / (2 * COARSEST) + 1;
    for (i = 0; i < n; i++) {
        int32_t j = i - (int32_t)drawn(c, i < NEAR ? (uint32_t)i + 1 : NEAR);
        order[i] = order[j];
        order[j] = i;
        into[i] = -1;
    }
    for (i = 0; i < n; i++) {
        int32_t v = order[i], best = -1, heavy = 0;
        if (into[v] >= 0)
            continue;
        for (e = g->first[v]; e < g->first[v + 1]; e++) {
            int32_t u = g->to[e];
            if (into[u] < 0 && g->load[e] > heavy && g->weight[u] + g->weight[v] <= most) {
                heavy = g->load[e];
                best = u;
            }
        }
        if (best >= 0)
            into[v] = into[best] = count++;
    }
    waiting = numbers(c, n, -1);
    for (i = 0; i < n; i++) {
        int32_t v = order[i];
        for (e = g->first[v]; into[v] < 0 && e < g->first[v + 1]; e++) {
            int32_t w = waiting[g->to[e]];
            if (w >= 0 && into[w] < 0 && g->weight[w] + g->weight[v] <= most)
                into[v] = into[w] = count++;
        }
        for (e = g->first[v]; into[v] < 0 && e < g->first[v + 1]; e++)
            waiting[g->to[e]] = v;
    }
    for (i = 0; i < n; i++)
        if (into[i] < 0)
            into[i] = count++;
    give(c, waiting);
    give(c, order);
    return count;
}

/* The graph of the merged nodes. */
static struct graph coarser(struct context *c, const struct graph *g, const int32_t *into,
                            int32_t count)
{
    struct graph h;
    int32_t *member = numbers(c, 2 * (int64_t)count, -1), *slot = numbers(c, count, -1);
    int32_t i, e, k, used = 0;
    h.n = count;
    h.first = numbers(c, (int64_t)count + 1, 0);
    h.to = take(c, g->first[g->n], sizeof *h.to);
    h.load = take(c, g->first[g->n], sizeof *h.load);
    h.weight = numbers(c, count, 0);
    for (i = 0; i < g->n; i++) {
        k = into[i];
        member[2 * k + (member[2 * k] >= 0)] = i;
        h.weight[k] += g->weight[i];
    }
    for (k = 0; k < count; k++) {
        int32_t start = used;
        for (i = 2 * k; i < 2 * k + 2 && member[i] >= 0; i++)
            for (e = g->first[member[i]]; e < g->first[member[i] + 1]; e++) {
                int32_t d = into[g->to[e]];
                if (d == k)
                    continue;
                if (slot[d] < start) {
                    slot[d] = used;
                    h.to[used] = d;
                    h.load[used++] = 0;
                }
                h.load[slot[d]] += g->load[e];
            }
        h.first[k + 1] = used;
    }
    give(c, slot);
    give(c, member);
    return h;
}

/* ------------------------------------------------------------------------------------- heaps */

static void place(struct heap *h, int32_t spot, int32_t v)
{
    h->item[spot] = v;
    h->at[v] = spot;
}

static void rise(struct heap *h, int32_t spot)
{
    int32_t v = h->item[spot];
    while (spot > 0 && h->key[h->item[(spot - 1) / 2]] < h->key[v]) {
        place(h, spot, h->item[(spot - 1) / 2]);
        spot = (spot - 1) / 2;
    }
    place(h, spot, v);
}

static void sink(struct heap *h, int32_t spot)
{
    int32_t v = h->item[spot], child;
    while ((child = 2 * spot + 1) < h->size) {
        if (child + 1 < h->size && h->key[h->item[child + 1]] > h->key[h->item[child]])
            child++;
        if (h->key[h->item[child]] <= h->key[v])
            break;
        place(h, spot, h->item[child]);
        spot = child;
    }
    place(h, spot, v);
}

static void push(struct heap *h, int32_t v, int32_t key)
{
    h->key[v] = key;
    h->item[h->size] = v;
    rise(h, h->size++);
}

static void drop(struct heap *h, int32_t v)
{
    int32_t spot = h->at[v], last;
    if (spot < 0)
        return;
    h->at[v] = -1;
    last = h->item[--h->size];
    if (last != v) {
        place(h, spot, last);
        rise(h, spot);
        sink(h, h->at[last]);
    }
}

static void change(struct heap *h, int32_t v, int32_t by)
{
    if (h->at[v] < 0)
        return;
    h->key[v] += by;
    if (by > 0)
        rise(h, h->at[v]);
    else
        sink(h, h->at[v]);
}

/* -------------------------------------------------------------------------- better separators */

struct state {
    const struct graph *g;
    uint8_t *side;       /* 0, 1 or SEPARATOR */
    uint8_t *locked;     /* has left the separator in this pass */
    int64_t weight[3];
    int64_t most;        /* weight that a side may have */
    struct heap heap[2]; /* separating nodes by what a move to side 0 or 1 gains */
    int32_t *trail;      /* moved nodes and, after each, those it drew in */
};

/* Offer a separating node to both sides: it gains its weight less that of what it draws in. */
static void offer(struct state *t, int32_t v)
{
    int32_t pull[3] = {0, 0, 0}, e;
    for (e = t->g->first[v]; e < t->g->first[v + 1]; e++)
        pull[t->side[t->g->to[e]]] += t->g->weight[t->g->to[e]];
    push(&t->heap[0], v, t->g->weight[v] - pull[1]);
    push(&t->heap[1], v, t->g->weight[v] - pull[0]);
}

/* Move a separating node to a side; returns how long the trail is then. */
static int32_t move(struct state *t, int32_t v, int a, int32_t used)
{
    const struct graph *g = t->g;
    int b = 1 - a;
    int32_t e, f;
    drop(&t->heap[0], v);
    drop(&t->heap[1], v);
    t->side[v] = (uint8_t)a;
    t->locked[v] = 1;
    t->weight[SEPARATOR] -= g->weight[v];
    t->weight[a] += g->weight[v];
    t->trail[used++] = v;
    for (e = g->first[v]; e < g->first[v + 1]; e++) {
        int32_t u = g->to[e];
        if (t->side[u] == SEPARATOR) {
            change(&t->heap[b], u, -g->weight[v]);
        } else if (t->side[u] == b) {
            t->side[u] = SEPARATOR;
            t->weight[b] -= g->weight[u];
            t->weight[SEPARATOR] += g->weight[u];
            t->trail[used++] = u;
            for (f = g->first[u]; f < g->first[u + 1]; f++)
                if (t->side[g->to[f]] == SEPARATOR)
                    change(&t->heap[a], g->to[f], g->weight[u]);
            if (!t->locked[u])
                offer(t, u);
        }
    }
    return used;
}

/* Take back all that the trail holds from a point on: a moved node is never on side SEPARATOR. */
static void take_back(struct state *t, int32_t from, int32_t used)
{
    while (used > from) {
        int32_t end = used, i;
        int a;
        do
            used--;
        while (t->trail[used] >= 0);
        a = -t->trail[used] - 1;
        for (i = used + 1; i < end; i++) {
            int32_t v = t->trail[i], w = t->g->weight[v];
            int old = i == used + 1 ? a : SEPARATOR, new = i == used + 1 ? SEPARATOR : 1 - a;
            t->side[v] = (uint8_t)new;
            t->weight[old] -= w;
            t->weight[new] += w;
        }
    }
}

static int64_t larger(const struct state *t)
{
    return t->weight[0] > t->weight[1] ? t->weight[0] : t->weight[1];
}

/* One round of moves; returns whether the separator or the balance got better. */
static int pass(struct state *t, int32_t room)
{
    int64_t best = t->weight[SEPARATOR], balance = larger(t);
    int32_t used = 0, kept = 0, idle = 0, count = 0, v;
    int better = 0;
    memset(t->locked, 0, (size_t)t->g->n);
    for (v = 0; v < t->g->n; v++) {
        t->heap[0].at[v] = t->heap[1].at[v] = -1;
        if (t->side[v] == SEPARATOR)
            count++;
    }
    t->heap[0].size = t->heap[1].size = 0;
    for (v = 0; v < t->g->n; v++)
        if (t->side[v] == SEPARATOR)
            offer(t, v);
    while (idle < 100 + count / 4) {
        int allowed[2], a;
        for (a = 0; a < 2; a++)
            allowed[a] = t->heap[a].size > 0
                && t->weight[a] + t->g->weight[t->heap[a].item[0]] <= t->most;
        if (!allowed[0] && !allowed[1])
            break;
        a = allowed[1] && (!allowed[0] || t->heap[1].key[t->heap[1].item[0]]
                                            > t->heap[0].key[t->heap[0].item[0]]);
        if (allowed[0] && allowed[1]
            && t->heap[1].key[t->heap[1].item[0]] == t->heap[0].key[t->heap[0].item[0]])
            a = t->weight[1] < t->weight[0];
        v = t->heap[a].item[0];
        if (used + 2 + t->g->first[v + 1] - t->g->first[v] > room)
            break;
        t->trail[used] = -a - 1;
        used = move(t, v, a, used + 1);
        idle++;
        if ((balance > t->most || larger(t) <= t->most)
            && (t->weight[SEPARATOR] < best
                || (t->weight[SEPARATOR] == best && larger(t) < balance)
                || (balance > t->most && larger(t) < balance))) {
            better = 1;
            best = t->weight[SEPARATOR];
            balance = larger(t);
            kept = used;
            idle = 0;
        }
    }
    take_back(t, kept, used);
    return better;
}

/* Improve the separator that `side` describes; returns its weight, the more the worse balanced. */
static int64_t improve(struct context *c, const struct graph *g, uint8_t *side)
{
    struct state t;
    int32_t room = 2 * g->first[g->n] + 3 * g->n + 4, v, k;
    int64_t total = sum(g->weight, g->n);
    t.g = g;
    t.side = side;
    t.most = 4 * total / 7;
    memset(t.weight, 0, sizeof t.weight);
    for (v = 0; v < g->n; v++)
        t.weight[side[v]] += g->weight[v];
    t.locked = take(c, g->n, 1);
    t.trail = take(c, room, sizeof *t.trail);
    for (k = 0; k < 2; k++) {
        t.heap[k].item = take(c, g->n, sizeof(int32_t));
        t.heap[k].at = take(c, g->n, sizeof(int32_t));
        t.heap[k].key = take(c, g->n, sizeof(int32_t));
    }
    for (k = 0; k < PASSES && pass(&t, room); k++)
        ;
    for (k = 0; k < 2; k++) {
        give(c, t.heap[k].item);
        give(c, t.heap[k].at);
        give(c, t.heap[k].key);
    }
    give(c, t.trail);
    give(c, t.locked);
    return t.weight[SEPARATOR] + (larger(&t) > t.most ? total : 0);
}

/* Grow one side from a node, breadth first, to half of the weight; its rim separates. */
static void grow(struct context *c, const struct graph *g, uint8_t *side)
{
    int32_t *queue = take(c, g->n, sizeof *queue), head = 0, tail = 0, v, e;
    int64_t half = sum(g->weight, g->n) / 2, weight = 0;
    uint8_t *seen = take(c, g->n, 1);
    for (v = 0; v < g->n; v++) {
        side[v] = 1;
        seen[v] = 0;
    }
    while (weight < half) {
        if (head == tail) {  /* another component */
            v = (int32_t)drawn(c, (uint32_t)g->n);
            while (seen[v])
                v = (v + 1) % g->n;
            seen[v] = 1;
            queue[tail++] = v;
        }
        v = queue[head++];
        side[v] = 0;
        weight += g->weight[v];
        for (e = g->first[v]; e < g->first[v + 1]; e++)
            if (!seen[g->to[e]]) {
                seen[g->to[e]] = 1;
                queue[tail++] = g->to[e];
            }
    }
    for (v = 0; v < g->n; v++)
        for (e = g->first[v]; side[v] == 1 && e < g->first[v + 1]; e++)
            if (side[g->to[e]] == 0)
                side[v] = SEPARATOR;
    give(c, seen);
    give(c, queue);
}

static void split(struct context *c, const struct graph *g, uint8_t *side)
{
    int32_t *into = take(c, g->n, sizeof *into), count = g->n, v, k;
    if (g->n > COARSEST)
        count = merge(c, g, into);
    if (count > g->n - g->n / 20) {
        uint8_t *trial = take(c, g->n, 1);
        int64_t best = INT64_MAX;
        for (k = 0; k < TRIALS; k++) {
            int64_t found;
            grow(c, g, trial);
            found = improve(c, g, trial);
            if (found < best) {
                best = found;
                memcpy(side, trial, (size_t)g->n);
            }
        }
        give(c, trial);
    } else {
        struct graph h = coarser(c, g, into, count);
        uint8_t *coarse = take(c, count, 1);
        split(c, &h, coarse);
        for (v = 0; v < g->n; v++)
            side[v] = coarse[into[v]];
        give(c, coarse);
        give_graph(c, &h);
        improve(c, g, side);
    }
    give(c, into);
}

/* Mark each node of a simple graph: on side 0, on side 1, or 2 for those that separate the sides.
 * Neighbours of node i: to[first[i]] .. to[first[i + 1] - 1]. Returns 0, or 1 without memory. */
int sensortrack_separate(int32_t n, int32_t *first, int32_t *to, uint8_t *side)
{
    struct context c;
    struct graph g;
    c.blocks = NULL;
    c.seed = 88172645463325252u;
    if (setjmp(c.failed)) {
        while (c.blocks != NULL)
            give(&c, c.blocks + 1);
        return 1;
    }
    g.n = n;
    g.first = first;
    g.to = to;
    g.load = numbers(&c, first[n], 1);
    g.weight = numbers(&c, n, 1);
    split(&c, &g, side);
    give(&c, g.load);
    give(&c, g.weight);
    return 0;
}
