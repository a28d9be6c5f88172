/* The proximal map of total variation on a forest by dynamic programming.
 *
 * The derivative of what the places below a link cost, as a function of the value above it, is
 * piecewise linear and rises. Towards the root it is summed and clipped at the capacity of the link
 * to the parent; its kinks lie in two heaps at once, one with the lowest on top and one with the
 * highest, and those that a clip cuts off are struck out in both. Each clip adds two kinks, so all
 * takes n log n. A path needs no heap: what a clip adds lies at either end of a queue.
 *
 * Places are numbered by the moment of the visit, so that up[v] < v, or -1 for a root.
 */
#include <stdint.h>

enum { LOW = 0, HIGH = 1, NONE = -1 };

struct kink {
    double at;
    double bend;      /* by how much the slope rises, 0 if struck out */
    int32_t child[2]; /* in the two heaps */
    int32_t next[2];
};

struct tree {
    int32_t n;
    const int32_t *up;
    const double *y;
    const double *capacity; /* of the link to the parent */
    double *x;              /* n, result; first the lowest value of a place below another */
    double *high;           /* n: its highest */
    double *sum;            /* n: of the capacities towards the children */
    double *flow;           /* n, result: to the parent */
    int32_t *top;           /* 2 n: tops of the two heaps of a place */
    struct kink *kink;      /* 2 n */
};

static int32_t meld(struct kink *kink, int heap, int32_t a, int32_t b)
{
    int32_t above = a, under = b;
    if (a == NONE)
        return b;
    if (b == NONE)
        return a;
    if (heap == LOW ? kink[b].at < kink[a].at : kink[b].at > kink[a].at) {
        above = b;
        under = a;
    }
    kink[under].next[heap] = kink[above].child[heap];
    kink[above].child[heap] = under;
    return above;
}

/* The heap without its top: neighbours are melded in pairs, and the pairs from the last on. */
static int32_t without_top(struct kink *kink, int heap, int32_t top)
{
    int32_t one = kink[top].child[heap], pairs = NONE, all = NONE;
    while (one != NONE) {
        const int32_t two = kink[one].next[heap];
        const int32_t rest = two == NONE ? NONE : kink[two].next[heap];
        const int32_t pair = meld(kink, heap, one, two);
        kink[pair].next[heap] = pairs;
        pairs = pair;
        one = rest;
    }
    while (pairs != NONE) {
        const int32_t rest = kink[pairs].next[heap];
        all = meld(kink, heap, all, pairs);
        pairs = rest;
    }
    return all;
}

static void add(struct tree *t, int32_t v, int32_t number, double at, double bend)
{
    struct kink *kink = t->kink + number;
    int heap;
    kink->at = at;
    kink->bend = bend;
    for (heap = LOW; heap <= HIGH; heap++) {
        kink->child[heap] = kink->next[heap] = NONE;
        t->top[2 * v + heap] = meld(t->kink, heap, t->top[2 * v + heap], number);
    }
}

/* Where the function reaches `level`, seen from below or from above; kinks on the way are struck
 * out. The slope becomes that of the piece where it does. */
static double reach(struct tree *t, int32_t v, int heap, double level, double *slope)
{
    int32_t top = t->top[2 * v + heap];
    double offset = heap == LOW ? -t->y[v] - t->sum[v] : -t->y[v] + t->sum[v];
    *slope = 1;
    for (; top != NONE; top = without_top(t->kink, heap, top)) {
        const double at = t->kink[top].at, bend = t->kink[top].bend, value = *slope * at + offset;
        if (bend == 0)
            continue;
        if (heap == LOW ? value >= level : value <= level)
            break;
        *slope += heap == LOW ? bend : -bend;
        offset += heap == LOW ? -bend * at : bend * at;
        t->kink[top].bend = 0;
    }
    t->top[2 * v + heap] = top;
    return (level - offset) / *slope;
}

static void clip(struct tree *t, int32_t v)
{
    const double c = t->capacity[v];
    double rise, fall;
    const double low = reach(t, v, LOW, -c, &rise), high = reach(t, v, HIGH, c, &fall);
    t->x[v] = low;
    t->high[v] = high > low ? high : low;
    add(t, v, 2 * v, low, rise);
    add(t, v, 2 * v + 1, t->high[v], -fall);
}

static double between(double low, double value, double high)
{
    const double raised = value > low ? value : low;
    return raised < high ? raised : high;
}

/* Values from the roots on, then the flow that they ask for: saturated where a place and its parent
 * differ, short of that where they do not. */
static void settle(struct tree *t)
{
    int32_t v;
    for (v = 0; v < t->n; v++) {
        t->flow[v] = 0;
        if (t->up[v] >= 0)
            t->x[v] = between(t->x[v], t->x[t->up[v]], t->high[v]);
    }
    for (v = t->n - 1; v >= 0; v--) {
        const double rest = t->y[v] - t->x[v] + t->flow[v];
        t->flow[v] = 0;
        if (t->up[v] >= 0) {
            const double above = t->x[t->up[v]], c = t->capacity[v], most = c * (1 - 0x1p-52);
            const double inner = between(-most, rest, most), outer = t->x[v] > above ? c : -c;
            t->flow[v] = t->x[v] == above ? inner : outer;
            t->flow[t->up[v]] += t->flow[v];
        }
    }
}

void sensortrack_tree(struct tree *t)
{
    int32_t v, heap;
    double slope;
    for (v = 0; v < t->n; v++) {
        t->sum[v] = 0;
        t->top[2 * v] = t->top[2 * v + 1] = NONE;
    }
    for (v = t->n - 1; v >= 0; v--) {
        const int32_t up = t->up[v];
        if (up < 0) {
            t->x[v] = reach(t, v, LOW, 0, &slope);
            continue;
        }
        clip(t, v);
        t->sum[up] += t->capacity[v];
        for (heap = LOW; heap <= HIGH; heap++)
            t->top[2 * up + heap] = meld(t->kink, heap, t->top[2 * up + heap], t->top[2 * v + heap]);
    }
    settle(t);
}

/* The same where each place is the parent of the next: the kinks between `first` and `last` of a
 * queue are in order, and each place puts one at either end. */
void sensortrack_path(struct tree *t)
{
    struct {
        double at, bend;
    } *queue = (void *)t->kink;
    int64_t first = t->n, last = t->n;
    double slope = 1, offset = 0, slope2 = 1, offset2 = 0, c = 0;
    int32_t v;
    for (v = t->n - 1; v >= 0; v--) {
        /* what the child sends is -c below all kinks and c above them */
        slope = slope2 = 1;
        offset = -t->y[v] - c;
        offset2 = -t->y[v] + c;
        c = v ? t->capacity[v] : 0;
        while (first < last && slope * queue[first].at + offset < -c) {
            slope += queue[first].bend;
            offset -= queue[first].bend * queue[first].at;
            first++;
        }
        t->x[v] = (-c - offset) / slope;
        if (v == 0)
            break;
        while (first < last && slope2 * queue[last - 1].at + offset2 > c) {
            last--;
            slope2 -= queue[last].bend;
            offset2 += queue[last].bend * queue[last].at;
        }
        t->high[v] = (c - offset2) / slope2;
        if (t->high[v] < t->x[v])
            t->high[v] = t->x[v];
        first--;
        queue[first].at = t->x[v];
        queue[first].bend = slope;
        queue[last].at = t->high[v];
        queue[last].bend = -slope2;
        last++;
    }
    settle(t);
}
