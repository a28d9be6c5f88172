/* Cells of a graph, and flows between them.
 *
 * A graph of n nodes is given by rows: the neighbours of node i are near[start[i]] ..
 * near[start[i + 1] - 1], in the order in which their edges are listed. Each node has a home; walks
 * stay within the home in which they begin. What the functions are for, and the same in Python, is
 * in verification/exact/cells/wiring.py and cell_routing.py.
 */
#include <math.h>
#include <stdint.h>

/* Trees from the smallest node of each connected part of each home, level by level: up[i] is the
 * node before i (i itself at a root), rank[i] where the edge between them stands in the rows, and
 * order lists all nodes as they are reached. Returns the number of trees. */
int64_t forest(int64_t n, const int64_t *start, const int32_t *near, const int32_t *home,
               int32_t *up, int64_t *rank, int32_t *order)
{
    int64_t trees = 0, end = 0;
    for (int64_t i = 0; i < n; i++)
        up[i] = -1;
    for (int64_t root = 0; root < n; root++) {
        if (up[root] >= 0)
            continue;
        int64_t at = end;
        up[root] = (int32_t)root;
        rank[root] = -1;
        order[end++] = (int32_t)root;
        trees++;
        for (; at < end; at++) {
            int32_t i = order[at];
            for (int64_t t = start[i]; t < start[i + 1]; t++) {
                int32_t j = near[t];
                if (up[j] < 0 && home[j] == home[i]) {
                    up[j] = i;
                    rank[j] = t;
                    order[end++] = j;
                }
            }
        }
    }
    return trees;
}

/* Nodes without a label (-1) take that of the node of their home from which they are reached first.
 * Returns how many have one in the end. */
int64_t grow(int64_t n, const int64_t *start, const int32_t *near, const int32_t *home,
             int32_t *label, int32_t *order)
{
    int64_t end = 0;
    for (int64_t i = 0; i < n; i++)
        if (label[i] >= 0)
            order[end++] = (int32_t)i;
    for (int64_t at = 0; at < end; at++) {
        int32_t i = order[at];
        for (int64_t t = start[i]; t < start[i + 1]; t++) {
            int32_t j = near[t];
            if (label[j] < 0 && home[j] == home[i]) {
                label[j] = label[i];
                order[end++] = j;
            }
        }
    }
    return end;
}

static int32_t last_reached(const int64_t *start, const int32_t *near, const int32_t *label,
                            int32_t from, int32_t mark, int32_t *seen, int32_t *up, int32_t *order)
{
    int64_t end = 0;
    order[end++] = from;
    seen[from] = mark;
    up[from] = from;
    for (int64_t at = 0; at < end; at++) {
        int32_t i = order[at];
        for (int64_t t = start[i]; t < start[i + 1]; t++) {
            int32_t j = near[t];
            if (seen[j] != mark && label[j] == label[i]) {
                seen[j] = mark;
                up[j] = i;
                order[end++] = j;
            }
        }
    }
    return order[end - 1];
}

/* Moves each seed to the middle of a long path of its cell: to a farthest node, and from there to a
 * farthest node. The entries of seen must be negative. */
void recentre(int64_t cells, const int64_t *start, const int32_t *near, const int32_t *label,
              int32_t *seeds, int32_t *seen, int32_t *up, int32_t *order)
{
    for (int64_t c = 0; c < cells; c++) {
        int32_t mark = (int32_t)(2 * c);
        int32_t a = last_reached(start, near, label, seeds[c], mark, seen, up, order);
        int32_t b = last_reached(start, near, label, a, mark + 1, seen, up, order);
        int64_t length = 0;
        for (int32_t i = b; i != a; i = up[i])
            length++;
        for (int64_t half = length / 2; half > 0; half--)
            b = up[b];
        seeds[c] = b;
    }
}

/* One node after the other takes the label that most of its neighbours at home have, if more have
 * it than its own. The entries of tally, one a label, must be zero. Returns the number of moves. */
int64_t smooth(int64_t n, const int64_t *start, const int32_t *near, const int32_t *home,
               int32_t *label, int32_t *tally)
{
    int64_t moves = 0;
    for (int64_t i = 0; i < n; i++) {
        for (int64_t t = start[i]; t < start[i + 1]; t++)
            if (home[near[t]] == home[i])
                tally[label[near[t]]]++;
        int32_t best = label[i];
        for (int64_t t = start[i]; t < start[i + 1]; t++)
            if (home[near[t]] == home[i] && tally[label[near[t]]] > tally[best])
                best = label[near[t]];
        moves += best != label[i];
        for (int64_t t = start[i]; t < start[i + 1]; t++)
            tally[label[near[t]]] = 0;
        label[i] = best;
    }
    return moves;
}

/* load[e] += weight[e] times the sum over columns of |x_i - x_j|, x having rows of some columns. */
void add_loads(int64_t m, int64_t columns, const int32_t *first, const int32_t *second,
               const double *weight, const double *x, double *load)
{
    for (int64_t e = 0; e < m; e++) {
        const double *a = x + first[e] * columns, *b = x + second[e] * columns;
        double sum[4] = {0, 0, 0, 0}; /* side by side, for speed */
        int64_t k = 0;
        for (; k + 4 <= columns; k += 4)
            for (int64_t l = 0; l < 4; l++)
                sum[l] += fabs(a[k + l] - b[k + l]);
        for (int64_t l = 0; k < columns; k++, l++)
            sum[l] += fabs(a[k] - b[k]);
        load[e] += weight[e] * ((sum[0] + sum[1]) + (sum[2] + sum[3]));
    }
}

static int64_t scaled_down(int64_t a) /* floor of a / 2^20 */
{
    return a >= 0 ? a >> 20 : -((-a + ((INT64_C(1) << 20) - 1)) >> 20);
}

static int beyond(int64_t a, int64_t limit)
{
    return a > limit || a < -limit;
}

/* The flow floor(weight (x_i - x_j)/2^20) of one source, what it leaves at the nodes sent up the
 * trees, and its loads added. net holds the due outflow of each node, and zero at the roots in the
 * end; sign is 1 where going up leaves the first end of an edge, else -1. Returns 1 if a number is so large that another might not fit, else 0.
 *
 * The caller keeps |x| below 2^61, what is due below 2^50, weights at most 2^20 and a node's
 * neighbours below 2^20. A product is at most 2^62, so a flow at most 2^42, and a repair at most
 * 2^40: no sum leaves 63 bits. */
int32_t add_exact(int64_t n, int64_t m, const int32_t *first, const int32_t *second,
                  const int64_t *weight, const int64_t *x, const int32_t *up, const int32_t *via,
                  const int32_t *sign, const int32_t *order, const int32_t *home,
                  const int64_t *share, int64_t largest, int64_t *net, int64_t *flow, int64_t *load)
{
    for (int64_t e = 0; e < m; e++) {
        int32_t i = first[e], j = second[e];
        int64_t d = x[i] - x[j];
        if (beyond(d, (INT64_C(1) << 62) / weight[e]))
            return 1;
        flow[e] = scaled_down(weight[e] * d);
        net[i] -= flow[e];
        net[j] += flow[e];
    }
    for (int64_t at = n - 1; at >= 0; at--) {
        int32_t i = order[at], j = up[i];
        if (i == j)
            continue;
        if (beyond(net[i], INT64_C(1) << 40))
            return 1;
        flow[via[i]] += sign[i] * net[i];
        net[j] += net[i];
    }
    for (int64_t e = 0; e < m; e++) {
        if (beyond(flow[e], largest))
            return 1;
        load[e] += share[home[first[e]]] * (flow[e] < 0 ? -flow[e] : flow[e]);
    }
    return 0;
}
