/* The proximal map of total variation on a network, exactly, by maximum flows in whole numbers.
 *
 * A set of places is asked whether its mean can be reached by all: whether a flow within the
 * capacities brings what some have above the mean to those that lack it. If so it is a group. If
 * not, what cannot be sent on is kept by the source side of a least cut: these places end above the
 * others, the links between are saturated, and the two sides are asked in turn.
 *
 * Everything is multiplied by the size of the set, so that no division occurs before a group is
 * done. The caller scales y to less than 2^60 and sees to it that there are less than 2^20 places.
 */
#include <math.h>
#include <stdint.h>

__extension__ typedef __int128 wide;

struct split {
    int32_t n;
    const int32_t *first; /* neighbour lists: index and link from first[i] on, increasing */
    const int32_t *index;
    const int32_t *link;
    const double *y;
    const double *capacity; /* of each link */
    int32_t exponent;       /* numbers are multiplied by 2^exponent and rounded */
    double *x;              /* n, result */
    double *flow;           /* m, result, from the smaller place to the larger */
    wide *limit;            /* m */
    wide *sent;             /* m */
    wide *own;              /* n, what each place has */
    wide *rest;             /* n, above or below the mean, times the size */
    int32_t *node;          /* n, sets one after another */
    int32_t *set;           /* n, start of the set of each place */
    int32_t *stop;          /* n, end of the set that starts here */
    int32_t *level;         /* n */
    int32_t *arc;           /* n */
    int32_t *queue;         /* n */
};

/* What the link e can still take from place i towards place j. */
static wide room(const struct split *t, int32_t i, int32_t j, int32_t e, wide size)
{
    const wide most = t->limit[e] * size;
    return i < j ? most - t->sent[e] : most + t->sent[e];
}

/* Levels of the places of a set, breadth first from those with too much; 1 if one lacks and is
 * reached. */
static int levels(struct split *t, int32_t from, int32_t to)
{
    int32_t done = 0, last = 0, k, place;
    int reached = 0;
    for (place = from; place < to; place++) {
        const int32_t i = t->node[place];
        t->arc[i] = t->first[i];
        t->level[i] = t->rest[i] > 0 ? 0 : -1;
        if (t->rest[i] > 0)
            t->queue[last++] = i;
    }
    while (done < last) {
        const int32_t i = t->queue[done++];
        if (t->rest[i] < 0)
            reached = 1;
        for (k = t->first[i]; k < t->first[i + 1]; k++) {
            const int32_t j = t->index[k];
            if (t->set[j] != from || t->level[j] >= 0 || room(t, i, j, t->link[k], to - from) <= 0)
                continue;
            t->level[j] = t->level[i] + 1;
            t->queue[last++] = j;
        }
    }
    return reached;
}

/* Send from place s along rising levels until it has nothing left or no way is left. */
static void send(struct split *t, int32_t s, int32_t from, wide size)
{
    int32_t depth = 0, k;
    int32_t *path = t->queue; /* the place at each depth; the way goes over its current arc */
    path[0] = s;
    while (t->rest[s] > 0) {
        const int32_t i = path[depth];
        if (t->rest[i] < 0) {
            wide most = t->rest[s] < -t->rest[i] ? t->rest[s] : -t->rest[i];
            for (k = 0; k < depth; k++) {
                const int32_t at = t->arc[path[k]];
                const wide here = room(t, path[k], path[k + 1], t->link[at], size);
                most = here < most ? here : most;
            }
            for (k = 0; k < depth; k++)
                t->sent[t->link[t->arc[path[k]]]] += path[k] < path[k + 1] ? most : -most;
            t->rest[s] -= most;
            t->rest[i] += most;
            depth = 0;
            continue;
        }
        for (k = t->arc[i]; k < t->first[i + 1]; k++) {
            const int32_t j = t->index[k];
            if (t->set[j] == from && t->level[j] == t->level[i] + 1 &&
                room(t, i, j, t->link[k], size) > 0)
                break;
        }
        t->arc[i] = k;
        if (k < t->first[i + 1]) {
            path[++depth] = t->index[k];
        } else if (depth == 0) {
            return;
        } else {
            t->arc[path[--depth]]++;
        }
    }
}

/* Give the places of a group their mean, and its links what was sent. */
static void finish(struct split *t, int32_t from, int32_t to, wide total)
{
    const wide size = to - from;
    int32_t place, k;
    for (place = from; place < to; place++) {
        const int32_t i = t->node[place];
        t->x[i] = ldexp((double)total / (double)size, -t->exponent);
        for (k = t->first[i]; k < t->first[i + 1]; k++)
            if (t->index[k] > i && t->set[t->index[k]] == from)
                t->flow[t->link[k]] =
                    ldexp((double)t->sent[t->link[k]] / (double)size, -t->exponent);
    }
}

/* The reached places first: they are above the others, and the links between are saturated. */
static int32_t divide(struct split *t, int32_t from, int32_t to)
{
    int32_t place, k, middle = from;
    for (place = from; place < to; place++) {
        const int32_t i = t->node[place];
        if (t->level[i] < 0)
            continue;
        for (k = t->first[i]; k < t->first[i + 1]; k++) {
            const int32_t j = t->index[k], e = t->link[k];
            if (t->set[j] != from || t->level[j] >= 0)
                continue;
            t->own[i] -= t->limit[e];
            t->own[j] += t->limit[e];
            t->flow[e] = i < j ? t->capacity[e] : -t->capacity[e];
        }
    }
    for (place = from; place < to; place++) {
        const int32_t i = t->node[place];
        if (t->level[i] >= 0) {
            t->node[place] = t->node[middle];
            t->node[middle++] = i;
        }
    }
    for (place = middle; place < to; place++)
        t->set[t->node[place]] = middle;
    t->stop[from] = middle;
    t->stop[middle] = to;
    return middle;
}

void sensortrack_split(struct split *t)
{
    const wide highest = (wide)t->n << 61;
    int32_t from = 0, i, k;
    for (i = 0; i < t->n; i++) {
        t->node[i] = i;
        t->set[i] = 0;
        t->own[i] = (wide)rint(ldexp(t->y[i], t->exponent));
        for (k = t->first[i]; k < t->first[i + 1]; k++) {
            const double scaled = ldexp(t->capacity[t->link[k]], t->exponent);
            t->limit[t->link[k]] = scaled < (double)highest ? (wide)rint(scaled) : highest;
        }
    }
    t->stop[0] = t->n;
    while (from < t->n) {
        const int32_t to = t->stop[from];
        const wide size = to - from;
        wide total = 0;
        int32_t place;
        for (place = from; place < to; place++)
            total += t->own[t->node[place]];
        for (place = from; place < to; place++) {
            i = t->node[place];
            t->rest[i] = size * t->own[i] - total;
            for (k = t->first[i]; k < t->first[i + 1]; k++)
                if (t->set[t->index[k]] == from)
                    t->sent[t->link[k]] = 0;
        }
        while (levels(t, from, to))
            for (place = from; place < to; place++)
                if (t->level[t->node[place]] == 0)
                    send(t, t->node[place], from, size);
        for (place = from; place < to; place++)
            if (t->level[t->node[place]] >= 0)
                break;
        if (place == to) {
            finish(t, from, to, total);
            from = to;
        } else {
            divide(t, from, to);
        }
    }
}
