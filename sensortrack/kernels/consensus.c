/* One explicit step of sign consensus over a network:
 *
 *     w+_i = w_i - c * sum over neighbours j of a_ij sgn(x_i - x_j),    x+_i = w+_i + r_i,
 *
 * sgn(0) = 0, each component by itself. A comparison with a number that is not one is false, so
 * such a neighbour counts like an equal one. Without weights a sum is a whole number, hence exact in
 * whatever order; with weights it is taken neighbour by neighbour, in the order of the list.
 *
 * Nodes from .. to - 1 are written, so that a caller may share the nodes out among threads; x_out
 * must not be x. Node i reads the row place[i] of r, or row i without `place`.
 */
#include <stddef.h>
#include <stdint.h>

#ifdef __AVX512F__
#include <immintrin.h>
#endif

#define LANES 8
#define AHEAD 12 /* places by which rows are asked for that lie in no order */

static const double *row_of(const double *r, const int32_t *place, ptrdiff_t i, ptrdiff_t width)
{
    return r + width * (place ? place[i] : i);
}

static void fetch(const double *row)
{
#ifdef __GNUC__
    __builtin_prefetch(row);
#else
    (void)row;
#endif
}

#ifdef __AVX512F__

static __m512d raised(__m512d sum, __mmask8 where)
{
    return _mm512_mask_add_pd(sum, where, sum, _mm512_set1_pd(1.0));
}

/* Up to eight components of a node at once, two neighbours at a time: four independent sums. */
static void block(ptrdiff_t i, ptrdiff_t width, ptrdiff_t column, const int32_t *first,
                  const int32_t *index, const double *x, const double *w, const double *r,
                  const double *c, double *w_out, double *x_out)
{
    const int lanes = width - column < LANES ? (int)(width - column) : LANES;
    const __mmask8 in = (__mmask8)((1u << lanes) - 1u);
    const double *base = x + column;
    const ptrdiff_t at = width * i + column;
    const __m512d own = _mm512_maskz_loadu_pd(in, x + at);
    __m512d up = _mm512_setzero_pd(), down = up, up2 = up, down2 = up;
    int32_t j = first[i];
    const int32_t end = first[i + 1];
    for (; j + 1 < end; j += 2) {
        const __m512d a = _mm512_maskz_loadu_pd(in, base + width * index[j]);
        const __m512d b = _mm512_maskz_loadu_pd(in, base + width * index[j + 1]);
        up = raised(up, _mm512_cmp_pd_mask(own, a, _CMP_GT_OQ));
        down = raised(down, _mm512_cmp_pd_mask(own, a, _CMP_LT_OQ));
        up2 = raised(up2, _mm512_cmp_pd_mask(own, b, _CMP_GT_OQ));
        down2 = raised(down2, _mm512_cmp_pd_mask(own, b, _CMP_LT_OQ));
    }
    if (j < end) {
        const __m512d a = _mm512_maskz_loadu_pd(in, base + width * index[j]);
        up = raised(up, _mm512_cmp_pd_mask(own, a, _CMP_GT_OQ));
        down = raised(down, _mm512_cmp_pd_mask(own, a, _CMP_LT_OQ));
    }
    {
        const __m512d sum = _mm512_sub_pd(_mm512_add_pd(up, up2), _mm512_add_pd(down, down2));
        const __m512d move = _mm512_mul_pd(_mm512_maskz_loadu_pd(in, c + column), sum);
        const __m512d next = _mm512_sub_pd(_mm512_maskz_loadu_pd(in, w + at), move);
        _mm512_mask_storeu_pd(w_out + at, in, next);
        _mm512_mask_storeu_pd(x_out + at, in,
                              _mm512_add_pd(next, _mm512_maskz_loadu_pd(in, r + column)));
    }
}

#else

/* Up to eight components of a node at once, in a loop that a compiler makes lanes of. */
static void block(ptrdiff_t i, ptrdiff_t width, ptrdiff_t column, const int32_t *first,
                  const int32_t *index, const double *x, const double *w, const double *r,
                  const double *c, double *w_out, double *x_out)
{
    const int lanes = width - column < LANES ? (int)(width - column) : LANES;
    const ptrdiff_t at = width * i + column;
    double own[LANES], sum[LANES] = {0};
    int k;
    int32_t j;
    for (k = 0; k < lanes; k++)
        own[k] = x[at + k];
    for (j = first[i]; j < first[i + 1]; j++) {
        const double *other = x + column + width * index[j];
        for (k = 0; k < lanes; k++)
            sum[k] += (own[k] > other[k]) - (own[k] < other[k]);
    }
    for (k = 0; k < lanes; k++) {
        const double next = w[at + k] - c[column + k] * sum[k];
        w_out[at + k] = next;
        x_out[at + k] = next + r[column + k];
    }
}

#endif

static void weighted(ptrdiff_t i, ptrdiff_t width, const int32_t *first, const int32_t *index,
                     const double *weight, const double *x, const double *w, const double *r,
                     const double *c, double *w_out, double *x_out)
{
    ptrdiff_t k;
    int32_t j;
    for (k = 0; k < width; k++) {
        const double own = x[width * i + k];
        double next, sum = 0;
        for (j = first[i]; j < first[i + 1]; j++) {
            const double other = x[width * index[j] + k];
            sum += weight[j] * ((own > other) - (own < other));
        }
        next = w[width * i + k] - c[k] * sum;
        w_out[width * i + k] = next;
        x_out[width * i + k] = next + r[k];
    }
}

/* Rows of `width` components; first and index list the neighbours, weight (or NULL) beside them. */
void sensortrack_sign_rows(int32_t from, int32_t to, int32_t width, const int32_t *first,
                           const int32_t *index, const double *weight, const double *x,
                           const double *w, const double *r, const int32_t *place, const double *c,
                           double *w_out, double *x_out)
{
    ptrdiff_t i, column;
    for (i = from; i < to; i++) {
        const double *given = row_of(r, place, i, width);
        if (place && i + AHEAD < to)
            fetch(row_of(r, place, i + AHEAD, width));
        if (weight) {
            weighted(i, width, first, index, weight, x, w, given, c, w_out, x_out);
            continue;
        }
        for (column = 0; column < width; column += LANES)
            block(i, width, column, first, index, x, w, given, c, w_out, x_out);
    }
}

#ifdef __AVX512F__

static __m128d pair(const double *x, const int32_t *at)
{
    return _mm_loadh_pd(_mm_load_sd(x + at[0]), x + at[1]);
}

/* Eight numbers from eight places: single loads are quicker than the instruction that gathers. */
static __m512d gathered(const double *x, const int32_t *at)
{
    const __m256d low = _mm256_insertf128_pd(_mm256_castpd128_pd256(pair(x, at)),
                                             pair(x, at + 2), 1);
    const __m256d high = _mm256_insertf128_pd(_mm256_castpd128_pd256(pair(x, at + 4)),
                                              pair(x, at + 6), 1);
    return _mm512_insertf64x4(_mm512_castpd256_pd512(low), high, 1);
}

#endif

/* One component without weights. Eight nodes make a slice: slice[s] .. slice[s + 1] - 1 are its
 * columns of eight neighbours, a node with fewer filled up with itself, for sgn(0) = 0. */
void sensortrack_sign_slices(int32_t from, int32_t to, int32_t n, const int32_t *slice,
                             const int32_t *index, const double *x, const double *w,
                             const double *r, const int32_t *place, double c, double *w_out,
                             double *x_out)
{
    ptrdiff_t s;
    for (s = from; s < to; s++) {
        const ptrdiff_t start = LANES * s;
        const int lanes = n - start < LANES ? (int)(n - start) : LANES;
        double sum[LANES];
        int32_t j;
        int k;
#ifdef __AVX512F__
        const __mmask8 in = (__mmask8)((1u << lanes) - 1u);
        const __m512d own = _mm512_maskz_loadu_pd(in, x + start);
        __m512d up = _mm512_setzero_pd(), down = up;
        for (j = slice[s]; j < slice[s + 1]; j++) {
            const __m512d other = gathered(x, index + LANES * (ptrdiff_t)j);
            up = raised(up, _mm512_cmp_pd_mask(own, other, _CMP_GT_OQ));
            down = raised(down, _mm512_cmp_pd_mask(own, other, _CMP_LT_OQ));
        }
        if (!place) {
            const __m512d move = _mm512_mul_pd(_mm512_set1_pd(c), _mm512_sub_pd(up, down));
            const __m512d next = _mm512_sub_pd(_mm512_maskz_loadu_pd(in, w + start), move);
            const __m512d given = _mm512_maskz_loadu_pd(in, r + start);
            _mm512_mask_storeu_pd(w_out + start, in, next);
            _mm512_mask_storeu_pd(x_out + start, in, _mm512_add_pd(next, given));
            continue;
        }
        _mm512_storeu_pd(sum, _mm512_sub_pd(up, down));
#else
        for (k = 0; k < LANES; k++)
            sum[k] = 0;
        for (j = slice[s]; j < slice[s + 1]; j++) {
            const int32_t *at = index + LANES * (ptrdiff_t)j;
            for (k = 0; k < lanes; k++)
                sum[k] += (x[start + k] > x[at[k]]) - (x[start + k] < x[at[k]]);
        }
#endif
        for (k = 0; k < lanes; k++) {
            const double next = w[start + k] - c * sum[k];
            w_out[start + k] = next;
            x_out[start + k] = next + *row_of(r, place, start + k, 1);
        }
    }
}
