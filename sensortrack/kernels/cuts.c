/* Depth-first search over the cuts of one connected graph, in integers.
 *
 * Nodes are decided in the order 0, 1, ..., n - 1: in the set S or out of it, node 0 in S. A cut S
 * of s nodes has the weight k of its leaving edges and the load (n - 2 s) g(S) + s g(all). It is
 * clear if D = b k - c load >= 0 and D^2 q >= d^2 s (n - s). A branch ends where even the least k,
 * the largest load and the largest s (n - s) that its completions can have are clear. What the
 * modes are for, and why the search is exhaustive, is said in verification/exact/cuts/cut_search.py.
 *
 * The caller makes sure that no product below leaves 127 bits.
 */
#include <stdint.h>

__extension__ typedef __int128 wide;

enum mode { STOP = 0, RAISE_RATIO = 1, LOWER_RATE = 2 };
enum outcome { DONE = 0, FAILED = 1, LIMIT = 2 };

struct search {
    int32_t n;
    const int32_t *first;  /* n + 1: later neighbours of node i are at first[i] .. first[i+1] - 1 */
    const int32_t *later;
    const int64_t *weight;
    const int64_t *gamma;
    const uint8_t *twin;   /* node i can be swapped with node i - 1 */
    const int64_t *worst;  /* (n + 1) x (n + 1): largest load of low <= s <= high */
    int64_t total;         /* sum of gamma */
    int32_t mode;
    int64_t limit;         /* nodes that may be visited */
    int64_t hurdle[4];     /* b, c, q, d */
    int64_t visits;
    double covered;        /* share of the search that is behind us, halved at each decision */
    uint8_t *side;
    uint8_t *best;         /* the last cut that was not clear */
    int64_t *link;         /* 2 n: weight of the links of node i to decided nodes out, in */
    int32_t found;
};

static int is_clear(const struct search *t, int64_t k, int64_t load, int32_t s)
{
    wide d = (wide)t->hurdle[0] * k - (wide)t->hurdle[1] * load;
    if (d < 0)
        return 0;
    if (t->hurdle[3] == 0)
        return 1;
    return d * d * t->hurdle[2] >= (wide)t->hurdle[3] * t->hurdle[3] * ((wide)s * (t->n - s));
}

static int64_t common(int64_t a, int64_t b)
{
    while (b != 0) {
        int64_t rest = a % b;
        a = b;
        b = rest;
    }
    return a;
}

/* Keep a cut that is not clear, and make it the mark that other cuts are measured against. */
static int keep(struct search *t, int64_t k, int64_t load, int32_t s)
{
    int32_t i;
    for (i = 0; i < t->n; i++)
        t->best[i] = t->side[i];
    t->found = 1;
    if (t->mode == RAISE_RATIO) {
        int64_t g = common(load, k);
        t->hurdle[0] = load / g;
        t->hurdle[1] = k / g;
        return DONE;
    }
    if (t->mode == LOWER_RATE) {
        wide d = (wide)t->hurdle[0] * k - (wide)t->hurdle[1] * load;
        if (d <= 0)
            return FAILED;
        t->hurdle[2] = (int64_t)s * (t->n - s);
        t->hurdle[3] = (int64_t)d;
        return DONE;
    }
    return FAILED;
}

static int32_t clamp(int32_t low, int32_t middle, int32_t high)
{
    return middle < low ? low : middle > high ? high : middle;
}

static int64_t lighter(const struct search *t, int32_t i)
{
    int64_t out = t->link[2 * i], in = t->link[2 * i + 1];
    return out < in ? out : in;
}

static int visit(struct search *t, int32_t i, int32_t count, int64_t inside, int64_t k,
                 int64_t extra, double share)
{
    int32_t n = t->n, high, j;
    int choice, status;

    if (t->visits >= t->limit)
        return LIMIT;
    t->visits++;
    if (i == n) {
        t->covered += share;
        if (count < n) {
            int64_t load = (n - 2 * (int64_t)count) * inside + count * t->total;
            if (!is_clear(t, k, load, count))
                return keep(t, k, load, count);
        }
        return DONE;
    }
    high = n - i + count < n - 1 ? n - i + count : n - 1;
    if (i > 0 && is_clear(t, k + extra, t->worst[(int64_t)count * (n + 1) + high],
                          clamp(count, n / 2, high))) {
        t->covered += share;
        return DONE;
    }
    {
        int may_in = i == 0 || !t->twin[i] || t->side[i - 1];
        int may_out = i > 0;
        if (may_in && may_out)
            share /= 2;
        for (choice = 1; choice >= 0; choice--) {
            int64_t more = extra - lighter(t, i);
            if (!(choice ? may_in : may_out))
                continue;
            t->side[i] = (uint8_t)choice;
            for (j = t->first[i]; j < t->first[i + 1]; j++) {
                int32_t u = t->later[j];
                more -= lighter(t, u);
                t->link[2 * u + choice] += t->weight[j];
                more += lighter(t, u);
            }
            status = visit(t, i + 1, count + choice, inside + (choice ? t->gamma[i] : 0),
                           k + t->link[2 * i + 1 - choice], more, share);
            for (j = t->first[i]; j < t->first[i + 1]; j++)
                t->link[2 * t->later[j] + choice] -= t->weight[j];
            if (status != DONE)
                return status;
        }
    }
    return DONE;
}

/* Run the search; results are left in the struct. */
int sensortrack_search_cuts(struct search *t)
{
    int32_t i;
    for (i = 0; i < 2 * t->n; i++)
        t->link[i] = 0;
    t->visits = 0;
    t->covered = 0.0;
    t->found = 0;
    return visit(t, 0, 0, 0, 0, 0, 1.0);
}
