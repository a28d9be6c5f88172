/* Rounded elimination of L - s I in 128-bit integers: is it >= 0 on a hyperplane?
 *
 * All numbers are integers, multiples of 4^-bits. At column k, with the remaining diagonal entry v, the
 * remaining entries w below it and the sum `slack` of the sizes of what rounding left in its row, an
 * integer c, negative if v - slack is, and the integers q nearest to w/c are chosen so that
 * v - c|c| >= slack + sum |w - c q|; then sign(c) q q' is subtracted. What rounding leaves is diagonally
 * dominant with a diagonal >= 0, so that the matrix is >= sum of sign(c) (c, q)(c, q)'. If one c at most
 * is negative, this is >= 0 wherever that one product vanishes. The same choices are made in
 * verification/exact/laplacians/elimination.py and, for all to read, in
 * verification/certificates/check.py.
 *
 * Products stay below 2^126: the squares of the q of each row add up to less than 2^124, and Cauchy and
 * Schwarz bound all other sums. Supernodes and updates are as in ldl.c.
 */
#include <math.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

__extension__ typedef __int128 wide;
__extension__ typedef unsigned __int128 unsigned_wide;

enum { BLOCK = 32, NO_MEMORY = -1, TOO_LARGE = -2 };

struct shape {
    int32_t n, supernodes;
    const int32_t *start;
    const int64_t *at;
    const int32_t *row;
};

struct front {            /* of one supernode; row j holds its entries from column j on */
    int32_t columns, high;
    wide *pivotal, *rest; /* columns x high; (high - columns) squared */
    const int32_t *name;  /* column of the matrix that a row stands for */
};

struct run {
    wide *slack;          /* per column of the matrix */
    double *load;         /* sum of squares of q in each row, but for rounding */
    int32_t negative;
    int64_t *q;           /* by rows, BLOCK pivots each */
    int64_t sign[BLOCK];
};

static int64_t root(wide t)
{
    int64_t r = (int64_t)sqrt((double)t);
    if (r > 0)
        r = (int64_t)(((wide)r + t / r) / 2);
    while ((wide)r * r > t)
        r--;
    while ((wide)(r + 1) * (r + 1) <= t)
        r++;
    return r;
}

/* c of a column with `many` entries below the diagonal that are not zero; t is v - slack. */
static int64_t pivot(wide t, int64_t many)
{
    if (t > 0) {
        wide room = t - ((wide)many * root(t) + 1) / 2;
        if (room > 0)
            return root(room);
    }
    return -(root(t < 0 ? -t : 0) + 1 + (many + 1) / 2);
}

static wide size(wide x)
{
    return x < 0 ? -x : x;
}

/* Eliminate row p of a front within a block that began at `from`; returns 0 or TOO_LARGE. */
static int eliminate(struct run *t, const struct front *f, int32_t from, int32_t p)
{
    wide *row = f->pivotal + (int64_t)p * f->high, sum = 0, slack = t->slack[f->name[p]];
    int64_t *mine = t->q + (int64_t)p * BLOCK, many = 0, c;
    int32_t k = p - from, i, l;
    for (l = p; l < f->high; l++) {  /* what the pivots of this block took so far */
        const int64_t *q = t->q + (int64_t)l * BLOCK;
        wide taken = 0;
        for (i = 0; i < k; i++)
            taken += (wide)(t->sign[i] * mine[i]) * q[i];
        row[l] -= taken;
        many += l > p && row[l] != 0;
    }
    c = pivot(row[p] - slack, many);
    t->sign[k] = c < 0 ? -1 : 1;
    t->negative += c < 0;
    for (l = p + 1; l < f->high; l++) {
        wide w = row[l], left;
        double guess = (double)w / (double)c, square;
        int64_t q;
        if (!(fabs(guess) < 0x1p61))
            return TOO_LARGE;
        q = (int64_t)guess;
        left = w - (wide)c * q;
        q += (int64_t)((double)left / (double)c);
        left = w - (wide)c * q;
        for (; c > 0 ? 2 * left >= c : 2 * left <= c; left -= c)
            q++;
        for (; c > 0 ? 2 * left < -c : 2 * left > -c; left += c)
            q--;
        t->q[(int64_t)l * BLOCK + k] = q;
        t->slack[f->name[l]] += size(left);
        sum += size(left);
        square = (double)q * (double)q;
        t->load[f->name[l]] += square;
        if (!(t->load[f->name[l]] < 0x1p124))
            return TOO_LARGE;
    }
    /* holds by the choice of c; a proof does not lean on that */
    return row[p] - (wide)c * (c < 0 ? -c : c) >= slack + sum ? 0 : TOO_LARGE;
}

/* Subtract what the pivots from .. to - 1 of a front take from the later rows. */
static void subtract(const struct run *t, const struct front *f, int32_t from, int32_t to)
{
    int64_t mine[BLOCK];
    int32_t j, l, i, width = to - from;
    for (j = to; j < f->high; j++) {
        wide *row = j < f->columns ? f->pivotal + (int64_t)j * f->high
                                   : f->rest + (int64_t)(j - f->columns) * (f->high - f->columns)
                                         - f->columns;
        int64_t any = 0;
        for (i = 0; i < width; i++) {
            mine[i] = t->sign[i] * t->q[(int64_t)j * BLOCK + i];
            any |= mine[i];
        }
        if (any == 0)
            continue;
        for (l = j; l < f->high; l++) {
            const int64_t *q = t->q + (int64_t)l * BLOCK;
            wide taken = 0;
            for (i = 0; i < width; i++)
                taken += (wide)mine[i] * q[i];
            row[l] -= taken;
        }
    }
}

/* Add a child's rest to the front of its parent. */
static void add(const wide *rest, int32_t rows, const int32_t *row, const int32_t *place,
                const struct front *f)
{
    int32_t i, j;
    for (j = 0; j < rows; j++) {
        int32_t to = place[row[j]];
        const wide *source = rest + (int64_t)j * rows;
        wide *target = to < f->columns ? f->pivotal + (int64_t)to * f->high
                                       : f->rest + (int64_t)(to - f->columns)
                                             * (f->high - f->columns) - f->columns;
        for (i = j; i < rows; i++)
            target[place[row[i]]] += source[i];
    }
}

static wide whole(const uint64_t *halves)
{
    return (wide)(((unsigned_wide)halves[1] << 64) | halves[0]);
}

/* Eliminate. Numbers are given as two halves each, the lower one first. Column j has the entries -value[e] in the rows entry[e] below its diagonal,
 * first[j] <= e < first[j + 1], and diagonal[j]; all in absolute value below 2^124. Returns how many
 * c were negative, stopping at 2, or NO_MEMORY, or TOO_LARGE. */
int32_t sensortrack_eliminate(const struct shape *s, const int64_t *first, const int32_t *entry,
                              const uint64_t *value, const uint64_t *diagonal)
{
    size_t many = (size_t)s->supernodes + 1, n = (size_t)s->n + 1;
    wide **rest = calloc(many, sizeof *rest), *pivotal = NULL;
    int32_t *child = malloc(many * sizeof *child), *sibling = malloc(many * sizeof *sibling);
    int32_t *home = malloc(n * sizeof *home), *place = malloc(n * sizeof *place), *name = NULL;
    int32_t k, c, j, status, most = 1;
    int64_t e, largest = 1;
    struct run t = {calloc(n, sizeof(wide)), calloc(n, sizeof(double)), 0, NULL, {0}};
    for (k = 0; k < s->supernodes; k++) {
        int64_t high = s->start[k + 1] - s->start[k] + s->at[k + 1] - s->at[k];
        most = high > most ? (int32_t)high : most;
        high *= s->start[k + 1] - s->start[k];
        largest = high > largest ? high : largest;
    }
    t.q = malloc((size_t)most * BLOCK * sizeof *t.q);
    name = malloc((size_t)most * sizeof *name);
    pivotal = malloc((size_t)largest * sizeof *pivotal);
    status = rest && child && sibling && home && place && t.slack && t.load && t.q && name && pivotal
                 ? 0 : NO_MEMORY;
    for (k = 0; status == 0 && k < s->supernodes; k++) {
        child[k] = -1;
        for (j = s->start[k]; j < s->start[k + 1]; j++)
            home[j] = k;
    }
    for (k = 0; status == 0 && k < s->supernodes && t.negative < 2; k++) {
        int32_t columns = s->start[k + 1] - s->start[k], rows = (int32_t)(s->at[k + 1] - s->at[k]);
        const int32_t *row = s->row + s->at[k];
        struct front f = {columns, columns + rows, pivotal, NULL, name};
        int32_t from, p;
        memset(pivotal, 0, (size_t)columns * (size_t)f.high * sizeof *pivotal);
        if (rows) {
            f.rest = rest[k] = calloc((size_t)rows * (size_t)rows, sizeof **rest);
            if (f.rest == NULL) {
                status = NO_MEMORY;
                break;
            }
            sibling[k] = child[home[row[0]]];
            child[home[row[0]]] = k;
        }
        for (j = 0; j < f.high; j++) {
            name[j] = j < columns ? s->start[k] + j : row[j - columns];
            place[name[j]] = j;
        }
        for (j = 0; j < columns; j++) {
            pivotal[(int64_t)j * f.high + j] = whole(diagonal + 2 * name[j]);
            for (e = first[name[j]]; e < first[name[j] + 1]; e++)
                pivotal[(int64_t)j * f.high + place[entry[e]]] -= whole(value + 2 * e);
        }
        for (c = child[k]; c >= 0; c = sibling[c]) {
            add(rest[c], (int32_t)(s->at[c + 1] - s->at[c]), s->row + s->at[c], place, &f);
            free(rest[c]);
            rest[c] = NULL;
        }
        for (from = 0; from < columns && status == 0; from += BLOCK) {
            int32_t to = from + BLOCK < columns ? from + BLOCK : columns;
            for (p = from; p < to && status == 0; p++)
                status = eliminate(&t, &f, from, p);
            if (status == 0)
                subtract(&t, &f, from, to);
        }
    }
    for (k = 0; rest && k < s->supernodes; k++)
        free(rest[k]);
    free(rest);
    free(child);
    free(sibling);
    free(home);
    free(place);
    free(t.slack);
    free(t.load);
    free(t.q);
    free(name);
    free(pivotal);
    return status ? status : t.negative < 2 ? t.negative : 2;
}
