/* Three loops behind cuts of large graphs: pairing of nodes, minimum cuts, annealing.
 *
 * Graphs are given by rows: the neighbours of node v are head[first[v]] .. head[first[v+1] - 1].
 * Every result is a proposal that the caller measures. What the loops are for is said in
 * verification/exact/cuts/cut_graph.py, band_cuts.py and cut_annealing.py, whose roads in Python do the
 * same steps in the same order.
 */
#include <math.h>
#include <stdint.h>

/* Pair each node with the free neighbour of the heaviest link relative to both sizes. */
void sensortrack_pair(int32_t n, const int64_t *first, const int32_t *head, const double *weight,
                      const double *size, const int32_t *order, double largest, int32_t *mate)
{
    int32_t i;
    for (i = 0; i < n; i++)
        mate[i] = -1;
    for (i = 0; i < n; i++) {
        int32_t v = order[i], best = v;
        double top = 0.0;
        int64_t a;
        if (mate[v] >= 0)
            continue;
        for (a = first[v]; a < first[v + 1]; a++) {
            int32_t u = head[a];
            if (mate[u] < 0 && size[u] + size[v] <= largest) {
                double value = weight[a] / (size[u] * size[v]);
                if (value > top) {
                    top = value;
                    best = u;
                }
            }
        }
        mate[v] = best;
        mate[best] = v;
    }
}

/* Levels: 1 where flow may end, one more for each arc with room towards there. */
static int label(int32_t n, const int64_t *first, const int32_t *head, const int32_t *twin,
                 const int64_t *room, const int64_t *excess, int32_t *level, int32_t *queue)
{
    int32_t begin = 0, end = 0, v;
    int reached = 0;
    for (v = 0; v < n; v++) {
        level[v] = 0;
        if (excess[v] < 0) {
            level[v] = 1;
            queue[end++] = v;
        }
    }
    while (begin < end) {
        int64_t a;
        v = queue[begin++];
        for (a = first[v]; a < first[v + 1]; a++) {
            int32_t u = head[a];
            if (level[u] == 0 && room[twin[a]] > 0) {
                level[u] = level[v] + 1;
                reached |= excess[u] > 0;
                queue[end++] = u;
            }
        }
    }
    return reached;
}

/* Send what a node has in excess along arcs that descend, until none is left open. */
static void drain(int32_t source, const int64_t *first, const int32_t *head, const int32_t *twin,
                  int64_t *room, int64_t *excess, int32_t *level, int64_t *next, int64_t *path)
{
    int64_t depth = 0, i;
    int32_t v = source;
    while (excess[source] > 0 && level[source] > 0) {
        int64_t a;
        if (excess[v] < 0) {
            int64_t amount = excess[source] < -excess[v] ? excess[source] : -excess[v];
            for (i = 0; i < depth; i++)
                if (room[path[i]] < amount)
                    amount = room[path[i]];
            for (i = 0; i < depth; i++) {
                room[path[i]] -= amount;
                room[twin[path[i]]] += amount;
            }
            excess[source] -= amount;
            excess[v] += amount;
            /* go on from the tail of the first arc that is full */
            for (i = 0; i < depth && room[path[i]] > 0; i++)
                ;
            depth = i;
            v = depth == 0 ? source : head[path[depth - 1]];
            continue;
        }
        for (a = next[v]; a < first[v + 1]; a++)
            if (room[a] > 0 && level[head[a]] == level[v] - 1 && level[v] > 1)
                break;
        next[v] = a;
        if (a < first[v + 1]) {
            path[depth++] = a;
            v = head[a];
        } else {
            level[v] = 0;
            if (depth > 0) {
                depth--;
                v = depth == 0 ? source : head[path[depth - 1]];
            }
        }
    }
}

/* Maximum flow from nodes with positive to nodes with negative excess (Dinic). In the end side is 1
 * where excess is left or can be moved to, 2 where it could still end, 0 in between. */
void sensortrack_min_cut(int32_t n, const int64_t *first, const int32_t *head, const int32_t *twin,
                         int64_t *room, int64_t *excess, int32_t *level, int32_t *queue,
                         int64_t *next, int64_t *path, uint8_t *side)
{
    int32_t v, begin = 0, end = 0;
    while (label(n, first, head, twin, room, excess, level, queue)) {
        for (v = 0; v < n; v++)
            next[v] = first[v];
        for (v = 0; v < n; v++)
            if (excess[v] > 0)
                drain(v, first, head, twin, room, excess, level, next, path);
    }
    for (v = 0; v < n; v++) {
        side[v] = level[v] > 0 ? 2 : 0;
        if (excess[v] > 0) {
            side[v] = 1;
            queue[end++] = v;
        }
    }
    while (begin < end) {
        int64_t a;
        v = queue[begin++];
        for (a = first[v]; a < first[v + 1]; a++)
            if (room[a] > 0 && side[head[a]] == 0) {
                side[head[a]] = 1;
                queue[end++] = head[a];
            }
    }
}

struct anneal {
    int32_t n;
    int32_t by_rate;      /* whether (A k - c N)/sqrt(p) is to be small, else N/k large */
    const int64_t *first;
    const int32_t *head;
    const double *weight;
    const double *size;
    const double *gamma;
    uint8_t *side;
    uint8_t *best;
    double *pull;         /* of each node: links to its own side less links to the other */
    double whole, total;  /* sums of size and gamma */
    double k, s, inside;  /* of the cut at hand */
    double a, c, r;       /* A k - c N - r sqrt(p) is lowered */
    double hot, cool;     /* temperature at first, and its factor after each sweep */
    int64_t sweeps;
    uint64_t seed;
    double mark;          /* how bad the worst cut at the end of a sweep was */
    int32_t found;
};

static uint64_t draw(uint64_t *state)
{
    uint64_t z = (*state += UINT64_C(0x9E3779B97F4A7C15));
    z = (z ^ (z >> 30)) * UINT64_C(0xBF58476D1CE4E5B9);
    z = (z ^ (z >> 27)) * UINT64_C(0x94D049BB133111EB);
    return z ^ (z >> 31);
}

static double price(const struct anneal *t, double k, double s, double inside)
{
    double load = inside + s / t->whole * (t->total - 2.0 * inside);
    double root = t->r == 0.0 ? 0.0 : t->r * sqrt(s * (t->whole - s) / t->whole);
    return t->a * k - t->c * load - root;
}

static void remember(struct anneal *t)
{
    double load = t->inside + t->s / t->whole * (t->total - 2.0 * t->inside), value;
    int32_t i;
    if (t->by_rate) {
        double gap = t->a * t->k - t->c * load;
        value = gap > 0.0 ? sqrt(t->s * (t->whole - t->s) / t->whole) / gap : HUGE_VAL;
    } else {
        value = load / t->k;
    }
    if (!(value > t->mark))
        return;
    t->mark = value;
    t->found = 1;
    if (t->by_rate)
        t->r = 1.0 / value;
    else
        t->c = 1.0 / value;
    for (i = 0; i < t->n; i++)
        t->best[i] = t->side[i];
}

/* Flip single nodes at a falling temperature; keep the worst cut at the end of a sweep. */
void sensortrack_anneal(struct anneal *t)
{
    double heat = t->hot;
    int64_t sweep;
    int32_t step;
    uint64_t state = t->seed;
    for (sweep = 0; sweep < t->sweeps; sweep++) {
        double now = price(t, t->k, t->s, t->inside);
        for (step = 0; step < t->n; step++) {
            int32_t v = (int32_t)(((draw(&state) >> 32) * (uint64_t)t->n) >> 32);
            double way = t->side[v] ? -1.0 : 1.0;
            double s = t->s + way * t->size[v], k = t->k + t->pull[v];
            double inside = t->inside + way * t->gamma[v], then, rise;
            int64_t a;
            if (s <= 0.0 || s >= t->whole)
                continue;
            then = price(t, k, s, inside);
            rise = then - now;
            if (rise > 0.0) {
                /* 1/(1 + x + ... + x^4/24) stands for exp(-x) */
                double x = rise / heat, y = 1.0 + x * (1.0 + x / 2.0 * (1.0 + x / 3.0 * (1.0 + x / 4.0)));
                if (x > 20.0 || (double)(draw(&state) >> 11) * 0x1p-53 * y >= 1.0)
                    continue;
            }
            t->side[v] ^= 1;
            t->k = k;
            t->s = s;
            t->inside = inside;
            t->pull[v] = -t->pull[v];
            now = then;
            for (a = t->first[v]; a < t->first[v + 1]; a++) {
                int32_t u = t->head[a];
                t->pull[u] += t->side[u] == t->side[v] ? 2.0 * t->weight[a] : -2.0 * t->weight[a];
            }
        }
        remember(t);
        heat *= t->cool;
    }
    if (!t->found)
        for (step = 0; step < t->n; step++)
            t->best[step] = t->side[step];
}
