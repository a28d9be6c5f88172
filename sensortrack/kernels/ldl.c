/* Sparse L D L' of a symmetric matrix without pivoting, by supernodes, and solves with many columns.
 *
 * A supernode is a run of columns with the same rows below them, up to some zeros that are kept; its
 * columns lie in one dense panel. Elimination is multifrontal: what a supernode subtracts from later
 * columns is a dense lower triangle on its rows, which its parent takes over. Panels are stored by
 * columns, (columns + rows) x columns, with the unit diagonal of L left as whatever it is and D beside.
 *
 * dgemm and dtrsm are pointers to the BLAS routines, with Fortran's calling convention.
 *
 * J. W. H. Liu, "The multifrontal method for sparse matrix solution", SIAM Review 34 (1992).
 */
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

typedef void gemm(const char *, const char *, const int *, const int *, const int *, const double *,
                  const double *, const int *, const double *, const int *, const double *, double *,
                  const int *);
typedef void trsm(const char *, const char *, const char *, const char *, const int *, const int *,
                  const double *, const double *, const int *, double *, const int *);

enum { BLOCK = 64, TILE = 128, COLUMNS = 64 };

/* ---------------------------------------------------------------------------------- symbolic */

/* Parents in the elimination tree. Neighbours of column j: to[first[j]] .. to[first[j + 1] - 1]. */
void sensortrack_tree(int32_t n, const int64_t *first, const int32_t *to, int32_t *parent,
                      int32_t *ancestor)
{
    int32_t i, j, next;
    int64_t e;
    for (j = 0; j < n; j++) {
        parent[j] = ancestor[j] = -1;
        for (e = first[j]; e < first[j + 1]; e++)
            for (i = to[e]; i >= 0 && i < j; i = next) {
                next = ancestor[i];
                ancestor[i] = j;
                if (next < 0)
                    parent[i] = j;
            }
    }
}

/* Children before parents, subtrees together; stack and links are n long each. */
void sensortrack_postorder(int32_t n, const int32_t *parent, int32_t *order, int32_t *child,
                           int32_t *sibling, int32_t *stack)
{
    int32_t j, top, used = 0, root;
    for (j = 0; j < n; j++)
        child[j] = -1;
    for (j = n - 1; j >= 0; j--)
        if (parent[j] >= 0) {
            sibling[j] = child[parent[j]];
            child[parent[j]] = j;
        }
    for (root = 0; root < n; root++) {
        if (parent[root] >= 0)
            continue;
        top = 0;
        stack[0] = root;
        while (top >= 0) {
            j = stack[top];
            if (child[j] >= 0) {
                stack[++top] = child[j];
                child[j] = sibling[child[j]];
            } else {
                order[used++] = j;
                top--;
            }
        }
    }
}

struct pattern {
    int32_t supernodes;
    int64_t stored;    /* row numbers in all */
    int32_t *start;    /* supernodes + 1: first column */
    int64_t *at;       /* supernodes + 1: where its row numbers begin */
    int32_t *row;      /* rows below a supernode's columns, increasing */
};

void sensortrack_forget(struct pattern *p)
{
    free(p->start);
    free(p->at);
    free(p->row);
    free(p);
}

static int by_number(const void *a, const void *b)
{
    int32_t x = *(const int32_t *)a, y = *(const int32_t *)b;
    return (x > y) - (x < y);
}

/* Whether columns join their parent's although some zeros are stored then. */
static int worthwhile(int64_t columns, int64_t zeros, int64_t stored)
{
    return zeros * (columns <= 4 ? 2 : columns <= 16 ? 4 : 16) <= stored;
}

/* Supernodes of a postordered matrix, parents given; NULL without memory. */
struct pattern *sensortrack_pattern(int32_t n, const int64_t *first, const int32_t *to,
                                    const int32_t *parent)
{
    struct pattern *p = calloc(1, sizeof *p);
    int32_t **list = calloc((size_t)n + 1, sizeof *list);  /* rows below, by the last column */
    int32_t *size = calloc((size_t)n + 1, sizeof *size);
    int32_t *head = malloc(((size_t)n + 1) * sizeof *head);  /* by the last column: first column */
    int32_t *mark = malloc(((size_t)n + 1) * sizeof *mark), *found = malloc(((size_t)n + 1) * 4);
    int32_t *child = malloc(((size_t)n + 1) * 4), *sibling = malloc(((size_t)n + 1) * 4);
    int64_t *zeros = calloc((size_t)n + 1, sizeof *zeros), e, total = 0;
    int32_t j, k, i, count = 0;
    int failed = !(p && list && size && head && mark && found && child && sibling && zeros);
    for (j = 0; !failed && j < n; j++)
        mark[j] = child[j] = -1;
    for (j = n - 1; !failed && j >= 0; j--)
        if (parent[j] >= 0) {
            sibling[j] = child[parent[j]];
            child[parent[j]] = j;
        }
    for (j = 0; !failed && j < n; j++) {
        int32_t got = 0, last = j - 1;
        int alone = child[j] == j - 1 && j > 0 && sibling[j - 1] < 0;
        if (alone) {  /* the same rows as the column before, but for itself? */
            for (k = 0; k < size[last]; k++)
                mark[list[last][k]] = j;
            for (e = first[j]; e < first[j + 1] && alone; e++)
                alone = to[e] < j || mark[to[e]] == j;
        }
        if (alone) {
            list[j] = list[last];
            size[j] = size[last] - 1;
            memmove(list[j], list[j] + 1, (size_t)size[j] * sizeof *list[j]);
            head[j] = head[last];
            zeros[j] = zeros[last];
            list[last] = NULL;
            continue;
        }
        mark[j] = j + n;
        for (e = first[j]; e < first[j + 1]; e++)
            if (to[e] > j && mark[to[e]] != j + n) {
                mark[to[e]] = j + n;
                found[got++] = to[e];
            }
        for (k = child[j]; k >= 0; k = sibling[k])
            for (i = 0; i < size[k]; i++)
                if (mark[list[k][i]] != j + n) {
                    mark[list[k][i]] = j + n;
                    found[got++] = list[k][i];
                }
        qsort(found, (size_t)got, sizeof *found, by_number);
        list[j] = malloc((size_t)(got ? got : 1) * sizeof *list[j]);
        failed = list[j] == NULL;
        if (!failed)
            memcpy(list[j], found, (size_t)got * sizeof *list[j]);
        size[j] = got;
        head[j] = j;
    }
    /* join, the last child first */
    for (j = 0; !failed && j < n; j++) {
        int64_t wide, below = size[j];
        if (list[j] == NULL)
            continue;
        while (head[j] > 0 && parent[head[j] - 1] >= head[j] && parent[head[j] - 1] <= j) {
            int32_t last = head[j] - 1;
            int64_t more = last - head[last] + 1, fill;
            wide = j - head[j] + 1;
            fill = zeros[j] + zeros[last] + more * (wide + below - size[last]);
            if (!worthwhile(more, fill, (more + wide) * ((more + wide) / 2 + below)))
                break;
            zeros[j] = fill;
            head[j] = head[last];
            free(list[last]);
            list[last] = NULL;
        }
    }
    for (j = 0; !failed && j < n; j++)
        if (list[j] != NULL) {
            count++;
            total += size[j];
        }
    if (!failed) {
        p->supernodes = count;
        p->stored = total;
        p->start = malloc(((size_t)count + 1) * sizeof *p->start);
        p->at = malloc(((size_t)count + 1) * sizeof *p->at);
        p->row = malloc((size_t)(total + 1) * sizeof *p->row);
        failed = !(p->start && p->at && p->row);
    }
    count = 0;
    total = 0;
    for (j = 0; !failed && j < n; j++)
        if (list[j] != NULL) {
            p->start[count] = head[j];
            p->at[count++] = total;
            memcpy(p->row + total, list[j], (size_t)size[j] * sizeof *p->row);
            total += size[j];
        }
    if (!failed) {
        p->start[count] = n;
        p->at[count] = total;
    }
    for (j = 0; list && j < n; j++)
        free(list[j]);
    free(list);
    free(size);
    free(head);
    free(mark);
    free(found);
    free(child);
    free(sibling);
    free(zeros);
    if (failed && p)
        sensortrack_forget(p);
    return failed ? NULL : p;
}

/* ----------------------------------------------------------------------------------- numeric */

struct shape {  /* as in struct pattern, with where each panel begins */
    int32_t n, supernodes;
    const int32_t *start;
    const int64_t *at;
    const int32_t *row;
    const int64_t *panel;
};

/* L D L' of the square on top of a panel of `high` rows, from column `from` on; 1 for a zero pivot. */
static int eliminate(double *p, int64_t high, int from, int to, double *d)
{
    int i, j, k;
    for (j = from; j < to; j++) {
        double *pj = p + j * high;
        for (k = from; k < j; k++) {
            const double *pk = p + k * high;
            double factor = pk[j] * d[k];
            for (i = j; i < to; i++)
                pj[i] -= factor * pk[i];
        }
        d[j] = pj[j];
        if (!(d[j] < 0.0 || d[j] > 0.0))
            return 1;
        for (i = j + 1; i < to; i++)
            pj[i] /= d[j];
    }
    return 0;
}

/* Subtract what the columns from .. to - 1 of a panel take from the later ones and from the update. */
static void subtract(double *p, int columns, int rows, int from, int to, const double *d,
                     double *scaled, double *update, gemm *dgemm, trsm *dtrsm)
{
    const double one = 1.0, minus = -1.0;
    int high = columns + rows, rest = high - to, width = to - from, i, j;
    double *below = p + (int64_t)from * high + to;
    if (rest == 0)
        return;
    dtrsm("R", "L", "T", "U", &rest, &width, &one, p + (int64_t)from * high + from, &high, below,
          &high);
    for (j = 0; j < width; j++) {
        double *column = below + (int64_t)j * high;
        double factor = 1.0 / d[from + j];
        memcpy(scaled + (int64_t)j * rest, column, (size_t)rest * sizeof *column);
        for (i = 0; i < rest; i++)
            column[i] *= factor;
    }
    for (j = to; j < high; j += TILE) {  /* a tile never straddles the end of the panel */
        int inside = j < columns, end = inside ? columns : high;
        int wide = end - j < TILE ? end - j : TILE, tall = high - j;
        double *target = inside ? p + (int64_t)j * high + j
                                : update + (int64_t)(j - columns) * rows + (j - columns);
        dgemm("N", "T", &tall, &wide, &width, &minus, below + (j - to), &high, scaled + (j - to),
              &rest, &one, target, inside ? &high : &rows);
        j -= TILE - wide;
    }
}

/* Add a child's update to the panel and the update of its parent. */
static void add(const double *update, int rows, const int32_t *row, const int32_t *place,
                double *p, int columns, int high, double *target)
{
    int i, j, below = high - columns;
    for (j = 0; j < rows; j++) {
        int32_t to = place[row[j]];
        const double *source = update + (int64_t)j * rows;
        double *column = to < columns ? p + (int64_t)to * high
                                      : target + (int64_t)(to - columns) * below - columns;
        for (i = j; i < rows; i++)
            column[place[row[i]]] += source[i];
    }
}

/* Factor. Column j has the entries value[e] in the rows entry[e], first[j] <= e < first[j + 1], below
 * its diagonal. Returns 0, -1 without memory, or 1 more than the column of a pivot that is zero. */
int32_t sensortrack_factor(const struct shape *s, const int64_t *first, const int32_t *entry,
                           const double *value, const double *diagonal, double *panels, double *d,
                           gemm *dgemm, trsm *dtrsm)
{
    double **update = calloc((size_t)s->supernodes + 1, sizeof *update), *scaled;
    int32_t *child = malloc(((size_t)s->supernodes + 1) * sizeof *child);
    int32_t *sibling = malloc(((size_t)s->supernodes + 1) * sizeof *sibling);
    int32_t *home = malloc(((size_t)s->n + 1) * sizeof *home);
    int32_t *place = malloc(((size_t)s->n + 1) * sizeof *place), k, c, j, status;
    int64_t most = 1, e;
    for (k = 0; k < s->supernodes; k++) {
        int64_t high = s->start[k + 1] - s->start[k] + s->at[k + 1] - s->at[k];
        most = high > most ? high : most;
    }
    scaled = malloc((size_t)most * BLOCK * sizeof *scaled);
    status = update && child && sibling && home && place && scaled ? 0 : -1;
    for (k = 0; status == 0 && k < s->supernodes; k++) {
        child[k] = -1;
        for (j = s->start[k]; j < s->start[k + 1]; j++)
            home[j] = k;
    }
    for (k = 0; status == 0 && k < s->supernodes; k++) {
        int columns = s->start[k + 1] - s->start[k], rows = (int)(s->at[k + 1] - s->at[k]), from;
        int high = columns + rows;
        const int32_t *row = s->row + s->at[k];
        double *p = panels + s->panel[k];
        memset(p, 0, (size_t)columns * (size_t)high * sizeof *p);
        if (rows) {
            update[k] = calloc((size_t)rows * (size_t)rows, sizeof **update);
            if (update[k] == NULL) {
                status = -1;
                break;
            }
            sibling[k] = child[home[row[0]]];
            child[home[row[0]]] = k;
        }
        for (j = 0; j < columns; j++)
            place[s->start[k] + j] = j;
        for (j = 0; j < rows; j++)
            place[row[j]] = columns + j;
        for (j = 0; j < columns; j++) {
            int32_t column = s->start[k] + j;
            p[(int64_t)j * high + j] = diagonal[column];
            for (e = first[column]; e < first[column + 1]; e++)
                p[(int64_t)j * high + place[entry[e]]] += value[e];
        }
        for (c = child[k]; c >= 0; c = sibling[c]) {
            add(update[c], (int)(s->at[c + 1] - s->at[c]), s->row + s->at[c], place, p, columns,
                high, update[k]);
            free(update[c]);
            update[c] = NULL;
        }
        for (from = 0; from < columns && status == 0; from += BLOCK) {
            int to = from + BLOCK < columns ? from + BLOCK : columns;
            if (eliminate(p, high, from, to, d + s->start[k]))
                status = s->start[k] + from + 1;
            else
                subtract(p, columns, rows, from, to, d + s->start[k], scaled, update[k], dgemm,
                         dtrsm);
        }
    }
    for (k = 0; update && k < s->supernodes; k++)
        free(update[k]);
    free(update);
    free(child);
    free(sibling);
    free(home);
    free(place);
    free(scaled);
    return status;
}

/* ------------------------------------------------------------------------------------- solve */

/* Solve for `width` columns held by rows in y, in elimination order; spare holds the largest rows. */
static void substitute(const struct shape *s, const double *panels, const double *d, double *y,
                       int width, double *spare, gemm *dgemm, trsm *dtrsm)
{
    const double one = 1.0, minus = -1.0, zero = 0.0;
    int32_t k, j;
    int i;
    for (k = 0; k < s->supernodes; k++) {
        int columns = s->start[k + 1] - s->start[k], rows = (int)(s->at[k + 1] - s->at[k]);
        int high = columns + rows;
        const int32_t *row = s->row + s->at[k];
        const double *p = panels + s->panel[k];
        double *top = y + (int64_t)s->start[k] * width;
        dtrsm("R", "L", "T", "U", &width, &columns, &one, p, &high, top, &width);
        if (rows)
            dgemm("N", "T", &width, &rows, &columns, &one, top, &width, p + columns, &high, &zero,
                  spare, &width);
        for (j = 0; j < rows; j++)
            for (i = 0; i < width; i++)
                y[(int64_t)row[j] * width + i] -= spare[(int64_t)j * width + i];
    }
    for (j = 0; j < s->n; j++)
        for (i = 0; i < width; i++)
            y[(int64_t)j * width + i] /= d[j];
    for (k = s->supernodes - 1; k >= 0; k--) {
        int columns = s->start[k + 1] - s->start[k], rows = (int)(s->at[k + 1] - s->at[k]);
        int high = columns + rows;
        const int32_t *row = s->row + s->at[k];
        const double *p = panels + s->panel[k];
        double *top = y + (int64_t)s->start[k] * width;
        for (j = 0; j < rows; j++)
            memcpy(spare + (int64_t)j * width, y + (int64_t)row[j] * width,
                   (size_t)width * sizeof *y);
        if (rows)
            dgemm("N", "N", &width, &columns, &rows, &minus, spare, &width, p + columns, &high,
                  &one, top, &width);
        dtrsm("R", "L", "N", "U", &width, &columns, &one, p, &high, top, &width);
    }
}

/* Solve with n x `width` right-hand sides by rows, in place; order[j] is the row of column j.
 * Returns 0, or -1 without memory. */
int32_t sensortrack_solve(const struct shape *s, const double *panels, const double *d,
                          const int32_t *order, double *x, int64_t width, gemm *dgemm, trsm *dtrsm)
{
    int64_t most = 1, from, j;
    int32_t k;
    int columns = width < COLUMNS ? (int)width : COLUMNS;
    double *y = malloc((size_t)s->n * (size_t)columns * sizeof *y), *spare;
    for (k = 0; k < s->supernodes; k++)
        most = s->at[k + 1] - s->at[k] > most ? s->at[k + 1] - s->at[k] : most;
    spare = malloc((size_t)most * (size_t)columns * sizeof *spare);
    for (from = 0; y && spare && from < width; from += columns) {
        int taken = width - from < columns ? (int)(width - from) : columns;
        for (j = 0; j < s->n; j++)
            memcpy(y + j * taken, x + order[j] * width + from, (size_t)taken * sizeof *y);
        substitute(s, panels, d, y, taken, spare, dgemm, dtrsm);
        for (j = 0; j < s->n; j++)
            memcpy(x + order[j] * width + from, y + j * taken, (size_t)taken * sizeof *y);
    }
    k = y && spare ? 0 : -1;
    free(y);
    free(spare);
    return k;
}
