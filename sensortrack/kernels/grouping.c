/* Round a nearly optimal flow of a total-variation problem to groups of equal value.
 *
 * Places joined by links that are not saturated are a group; its value is what the saturated links
 * leave it, shared equally. Linked groups whose values differ by rounding only are made one. What is
 * then missing inside a group is sent along a spanning tree. The result is optimal if the flow stays
 * within the capacities and runs downhill between groups.
 */
#include <math.h>
#include <stdint.h>

struct groups {
    int32_t n;
    const int32_t *below;  /* links with first end i: below[i] .. below[i + 1] - 1 */
    const int32_t *second; /* second end of each link */
    const int32_t *first;  /* neighbour lists: index and link from first[i] on */
    const int32_t *index;
    const int32_t *link;
    const double *y;
    const double *capacity;
    const double *flow;
    double slack;          /* what passes for rounding */
    double *x;             /* n, result */
    double *sent;          /* m, result */
    double *rest;          /* n */
    double *mean;          /* n, by group */
    double *more;          /* n, by group */
    int32_t *size;         /* n, by group */
    int32_t *group;        /* n */
    int32_t *order;        /* n, the visit */
    int32_t *up;           /* n, parent of a place or -1 */
    int32_t *over;         /* n, link to the parent */
    uint8_t *inner;        /* m, whether the link joins its ends to a group */
};

/* Breadth first over the inner links, from the lowest place of each group. */
static int32_t visit(struct groups *t)
{
    int32_t i, k, done = 0, last = 0, count = 0;
    for (i = 0; i < t->n; i++)
        t->group[i] = -1;
    for (i = 0; i < t->n; i++) {
        const int32_t start = last;
        if (t->group[i] >= 0)
            continue;
        t->group[i] = count;
        t->up[i] = -1;
        t->order[last++] = i;
        while (done < last) {
            const int32_t at = t->order[done++];
            for (k = t->first[at]; k < t->first[at + 1]; k++) {
                const int32_t next = t->index[k], e = t->link[k];
                if (t->group[next] >= 0 || !t->inner[e])
                    continue;
                t->group[next] = count;
                t->up[next] = at;
                t->over[next] = e;
                t->order[last++] = next;
            }
        }
        t->size[count++] = last - start;
    }
    return count;
}

/* y less what the links between groups carry away. */
static void leave_between(struct groups *t)
{
    int32_t i, e;
    for (i = 0; i < t->n; i++)
        t->rest[i] = 0;
    for (i = 0; i < t->n; i++) {
        double sum = t->rest[i];
        for (e = t->below[i]; e < t->below[i + 1]; e++) {
            const int32_t j = t->second[e];
            const double sent = t->group[i] == t->group[j] ? 0 : t->flow[e];
            sum += sent;
            t->rest[j] -= sent;
        }
        t->rest[i] = t->y[i] - sum;
    }
}

/* y - x less what all links carry away; more[] is free for the sums. */
static void leave_missing(struct groups *t)
{
    int32_t i, e;
    for (i = 0; i < t->n; i++)
        t->more[i] = 0;
    for (i = 0; i < t->n; i++) {
        double sum = t->more[i];
        for (e = t->below[i]; e < t->below[i + 1]; e++) {
            sum += t->flow[e];
            t->more[t->second[e]] -= t->flow[e];
        }
        t->rest[i] = t->y[i] - t->x[i] - sum;
    }
}

/* Means of the groups, taken twice: the second time of what the first mean leaves. */
static void set_values(struct groups *t, int32_t count)
{
    int32_t i, g;
    for (g = 0; g < count; g++)
        t->mean[g] = t->more[g] = 0;
    for (i = 0; i < t->n; i++)
        t->mean[t->group[i]] += t->rest[i];
    for (g = 0; g < count; g++)
        t->mean[g] /= t->size[g];
    for (i = 0; i < t->n; i++)
        t->more[t->group[i]] += t->rest[i] - t->mean[t->group[i]];
    for (g = 0; g < count; g++)
        t->mean[g] += t->more[g] / t->size[g];
    for (i = 0; i < t->n; i++)
        t->x[i] = t->mean[t->group[i]];
}

/* Send what each place is missing towards the root of its group. */
static void send(struct groups *t)
{
    int32_t e, k;
    for (e = 0; e < t->below[t->n]; e++)
        t->sent[e] = t->flow[e];
    for (k = t->n - 1; k >= 0; k--) {
        const int32_t i = t->order[k], parent = t->up[i];
        if (parent < 0)
            continue;
        t->rest[parent] += t->rest[i];
        t->sent[t->over[i]] += parent > i ? t->rest[i] : -t->rest[i];
    }
}

/* Make links inner whose ends differ by no more than rounding; how many were not. */
static int32_t join_equal(struct groups *t)
{
    int32_t i, e, found = 0;
    for (i = 0; i < t->n; i++)
        for (e = t->below[i]; e < t->below[i + 1]; e++)
            if (t->group[i] != t->group[t->second[e]] && t->capacity[e] > 0 &&
                fabs(t->x[i] - t->x[t->second[e]]) <= t->slack) {
                t->inner[e] = 1;
                found++;
            }
    return found;
}

/* 1 if x is optimal up to rounding and `sent` proves it, else 0. */
static int agreed(struct groups *t)
{
    const int32_t m = t->below[t->n];
    int32_t i, e, count;

    for (e = 0; e < m; e++)
        t->inner[e] = fabs(t->flow[e]) < t->capacity[e];
    do {
        count = visit(t);
        leave_between(t);
        set_values(t, count);
    } while (join_equal(t));
    leave_missing(t);
    send(t);
    for (i = 0; i < t->n; i++)
        for (e = t->below[i]; e < t->below[i + 1]; e++) {
            const double c = t->capacity[e], fall = t->x[i] - t->x[t->second[e]];
            if (fabs(t->sent[e]) > c + t->slack || t->flow[e] * fall < -t->slack * c)
                return 0;
            t->sent[e] = t->sent[e] > c ? c : t->sent[e] < -c ? -c : t->sent[e];
        }
    return 1;
}

/* The same for `count` rows of y, x (n each), capacity, flow and sent (m each). */
void sensortrack_agreed_groups(struct groups *t, int32_t count, const double *slack, uint8_t *ok)
{
    const int32_t n = t->n, m = t->below[t->n];
    int32_t k;
    for (k = 0; k < count; k++) {
        t->slack = slack[k];
        ok[k] = (uint8_t)agreed(t);
        t->y += n;
        t->x += n;
        t->capacity += m;
        t->flow += m;
        t->sent += m;
    }
}
