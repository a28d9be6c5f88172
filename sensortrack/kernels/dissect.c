/* Fill-reducing order of a sparse symmetric matrix by nested dissection of its graph.
 *
 * Nodes of degree one or zero come first, as often as there are any: they cause no fill. What is
 * left is split by a small set of nodes into two parts, each part is ordered in the same way, and the
 * separating nodes come last. Parts of a few nodes are ordered by minimum degree.
 *
 * A. George, "Nested dissection of a regular finite element mesh", SIAM Journal on Numerical
 * Analysis 10 (1973).
 */
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

enum { LEAF = 64, SEPARATOR = 2 };

struct graph {  /* neighbours of node i: to[first[i]] .. to[first[i + 1] - 1] */
    int32_t n;
    int32_t *first, *to;
};

/* Marks each node by its side, 0 or 1, or as SEPARATOR; returns 0, or 1 without memory. */
typedef int separate(int32_t n, int32_t *first, int32_t *to, uint8_t *side);

static int32_t *numbers(int32_t count)
{
    return malloc(((size_t)count + 1) * sizeof(int32_t));
}

static void forget(struct graph *g)
{
    free(g->first);
    free(g->to);
}

static int32_t ones(uint64_t word)
{
    int32_t count = 0;
    for (; word; word &= word - 1)
        count++;
    return count;
}

/* Minimum degree with the links as bits. */
static void order_leaf(const struct graph *g, const int32_t *names, int32_t *order)
{
    uint64_t link[LEAF] = {0};
    int32_t degree[LEAF], k, v, u, e;
    for (v = 0; v < g->n; v++) {
        for (e = g->first[v]; e < g->first[v + 1]; e++)
            link[v] |= (uint64_t)1 << g->to[e];
        degree[v] = ones(link[v]);
    }
    for (k = 0; k < g->n; k++) {
        int32_t best = -1;
        for (v = 0; v < g->n; v++)
            if (degree[v] >= 0 && (best < 0 || degree[v] < degree[best]))
                best = v;
        order[k] = names[best];
        degree[best] = -1;
        for (u = 0; u < g->n; u++)
            if (link[best] >> u & 1) {
                link[u] = (link[u] | link[best]) & ~((uint64_t)1 << u | (uint64_t)1 << best);
                degree[u] = ones(link[u]);
            }
    }
}

/* The graph of listed nodes; at[] says where in the list a node is and is negative elsewhere.
 * Without memory, one of its lists is missing. */
static struct graph part(const struct graph *g, const int32_t *list, const int32_t *at,
                         int32_t count)
{
    struct graph h;
    int32_t k, e, links = 0;
    for (k = 0; k < count; k++)
        for (e = g->first[list[k]]; e < g->first[list[k] + 1]; e++)
            links += at[g->to[e]] >= 0;
    h.n = count;
    h.first = numbers(count);
    h.to = numbers(links);
    if (h.first == NULL || h.to == NULL)
        return h;
    for (k = links = 0; k < count; k++) {
        h.first[k] = links;
        for (e = g->first[list[k]]; e < g->first[list[k] + 1]; e++)
            if (at[g->to[e]] >= 0)
                h.to[links++] = at[g->to[e]];
    }
    h.first[count] = links;
    return h;
}

/* Order a graph, which is freed on the way, together with the names of its nodes. */
static int dissect(struct graph g, int32_t *names, int32_t *order, separate *separator)
{
    int32_t count[3] = {0, 0, 0}, n = g.n, v, k;
    int32_t *inner[2] = {NULL, NULL}, *at = numbers(n);
    struct graph h[2] = {{0, NULL, NULL}, {0, NULL, NULL}};
    uint8_t *side = malloc((size_t)n + 1);
    int failed = !(names && g.first && g.to && at && side);
    if (!failed && n > LEAF)
        failed = separator(n, g.first, g.to, side);
    else if (!failed)
        order_leaf(&g, names, order);
    if (!failed && n > LEAF) {
        for (v = 0; v < n; v++)
            count[side[v]]++;
        for (v = 0, k = n - count[SEPARATOR]; v < n; v++)
            if (side[v] == SEPARATOR)
                order[k++] = names[v];
        for (k = 0; k < 2 && !failed; k++) {
            int32_t used = 0;
            inner[k] = numbers(count[k]);
            failed = inner[k] == NULL;
            for (v = 0; v < n && !failed; v++) {
                at[v] = side[v] == k ? used : -1;
                if (side[v] == k)
                    inner[k][used++] = v;
            }
            if (!failed)
                h[k] = part(&g, inner[k], at, count[k]);
            for (v = 0; v < count[k] && !failed; v++)
                inner[k][v] = names[inner[k][v]];
        }
    }
    free(at);
    free(side);
    free(names);
    forget(&g);
    for (k = 0; k < 2; k++) {
        int32_t *spot = order + (k ? count[0] : 0);
        if (failed || count[k] == 0 || count[k] == n) {  /* or nothing separates these */
            if (!failed && count[k])
                memcpy(spot, inner[k], (size_t)n * sizeof *order);
            forget(&h[k]);
            free(inner[k]);
        } else {
            failed = dissect(h[k], inner[k], spot, separator);
        }
    }
    return failed;
}

/* Take off leaves again and again, in turn; at[] is 0 for the nodes that are left, else negative. */
static int32_t strip(const struct graph *g, int32_t *at, int32_t *degree, int32_t *order)
{
    int32_t head, tail = 0, v, e;
    for (v = 0; v < g->n; v++) {
        degree[v] = g->first[v + 1] - g->first[v];
        at[v] = degree[v] <= 1 ? -1 : 0;
        if (at[v] < 0)
            order[tail++] = v;
    }
    for (head = 0; head < tail; head++)
        for (e = g->first[order[head]]; e < g->first[order[head] + 1]; e++)
            if (at[g->to[e]] >= 0 && --degree[g->to[e]] == 1) {
                at[g->to[e]] = -1;
                order[tail++] = g->to[e];
            }
    return tail;
}

/* List the nodes that are left breadth first, so that neighbours lie close in memory. */
static void walk(const struct graph *g, int32_t *at, int32_t *list)
{
    int32_t v, e, head = 0, tail = 0;
    for (v = 0; v < g->n; v++) {
        if (at[v] != 0)
            continue;
        at[v] = 1;
        list[tail++] = v;
        for (; head < tail; head++)
            for (e = g->first[list[head]]; e < g->first[list[head] + 1]; e++)
                if (at[g->to[e]] == 0) {
                    at[g->to[e]] = 1;
                    list[tail++] = g->to[e];
                }
    }
    for (v = 0; v < tail; v++)
        at[list[v]] = v;
}

/* Order the nodes 0 .. n - 1 of a simple graph; returns 0, or 1 without memory. */
int sensortrack_dissect(int32_t n, int32_t *first, int32_t *to, int32_t *order, separate *separator)
{
    struct graph whole = {n, first, to};
    int32_t *at = numbers(n), *names = numbers(n), stripped, failed = at == NULL || names == NULL;
    if (failed) {
        free(names);
    } else {
        stripped = strip(&whole, at, names, order);
        walk(&whole, at, names);
        failed = dissect(part(&whole, names, at, n - stripped), names, order + stripped, separator);
    }
    free(at);
    return failed;
}
