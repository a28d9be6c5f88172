/* Many runs of simultaneous perturbation on a quadratic cost, from random numbers by counter.
 *
 * A run's error e = theta_hat - theta is that at the second of the two instants of a step, just
 * before the update. Per update, with Delta of signs and noise xi = root times independent numbers
 * of mean 0 and variance 1, fresh at each instant:
 *
 *     y- = d'H d / 2 with d = e + eta - beta Delta - xi      (two instants: eta and a noise of its own)
 *     y+ = d'H d / 2 with d = e + beta Delta - xi'           (one instant: no eta, xi = xi')
 *     e  = e - alpha Delta (y+ - y-)/(2 beta)                this is what is counted
 *     e  = e - 2k eta
 *
 * LANES runs go side by side, so that a compiler makes vectors of the inner loops. Every sum is
 * taken in the order of its index and nothing is contracted, so that the same lines on arrays of
 * NumPy give the same bits (sensortrack/kernels/spsa.py).
 *
 * Words of run r at update u are those of Philox4x64 with ten rounds at the counters
 * (r B + b, u, 0, 0), b < B, and the given key. Gaussian noise takes the upper 52 bits of a word for a
 * number, first instant first, and the sign of Delta_i is the lowest bit of word i, 1 for +1. For
 * two-point noise the signs of Delta are the bits of the first ceil(D/64) words, from the lowest on,
 * and those of the noise the bits of the words after them.
 */
#include <math.h>
#include <stdint.h>
#include <string.h>

#define LANES 32
#define MOST 256
#define ROUNDS 10

static uint64_t high(uint64_t a, uint64_t b)
{
#ifdef __SIZEOF_INT128__
    return (uint64_t)(((unsigned __int128)a * b) >> 64);
#else
    const uint64_t low = 0xFFFFFFFFu;
    const uint64_t cross = (a >> 32) * (b & low) + (((a & low) * (b & low)) >> 32);
    const uint64_t other = (a & low) * (b >> 32) + (cross & low);
    return (a >> 32) * (b >> 32) + (cross >> 32) + (other >> 32);
#endif
}

/* J. Salmon et al., Parallel Random Numbers: As Easy as 1, 2, 3 (2011). Its twenty products of 128
 * bits are what it takes: blocks side by side are not quicker. */
static void philox(const uint64_t counter[4], const uint64_t key[2], uint64_t out[4])
{
    uint64_t a = counter[0], b = counter[1], c = counter[2], d = counter[3];
    uint64_t left = key[0], right = key[1];
    int round;
    for (round = 0; round < ROUNDS; round++) {
        const uint64_t m = 0xD2E7470EE14C6C93u, n = 0xCA5A826395121157u;
        const uint64_t one = m * a, other = n * c;
        const uint64_t next = high(n, c) ^ b ^ left, far = high(m, a) ^ d ^ right;
        a = next;
        b = other;
        c = far;
        d = one;
        left += 0x9E3779B97F4A7C15u;
        right += 0xBB67AE8584CAA73Bu;
    }
    out[0] = a;
    out[1] = b;
    out[2] = c;
    out[3] = d;
}

/* A middle of one of 2^52 equal parts of the unit interval, less a half: never 0. */
static double centred(uint64_t word)
{
    const uint64_t bits = (word >> 12) | 0x3FF0000000000000u;
    double value;
    memcpy(&value, &bits, sizeof value);
    return (value - 1.5) + 0x1p-53;
}

/* Logarithm of a number between 2^-53 and 1 by plain arithmetic, the same in every library. */
static double plain_log(double x)
{
    uint64_t bits, scale;
    double m, power, s, z, sum = 1.0 / 21.0;
    int term;
    memcpy(&bits, &x, sizeof bits);
    scale = (bits >> 52) | 0x4330000000000000u; /* 2^52 and the exponent */
    bits = (bits & 0xFFFFFFFFFFFFFu) | 0x3FE0000000000000u;
    memcpy(&power, &scale, sizeof power);
    memcpy(&m, &bits, sizeof m);
    power = power - (0x1p52 + 1022.0);
    power = m < 0.70710678118654752 ? power - 1.0 : power;
    m = m < 0.70710678118654752 ? m * 2.0 : m;
    s = (m - 1.0) / (m + 1.0);
    z = s * s;
    for (term = 19; term > 0; term -= 2)
        sum = sum * z + 1.0 / (double)term;
    return power * 0.69314718055994531 + (2.0 * s) * sum;
}

static double horner(const double *c, double r)
{
    double sum = c[7];
    int i;
    for (i = 6; i >= 0; i--)
        sum = sum * r + c[i];
    return sum;
}

/* M. Wichura, Algorithm AS 241: The Percentage Points of the Normal Distribution (1988): numerator
 * and denominator for the middle, the tails, the far tails. The table comes from the caller. */
static double ratio(const double *c, double r)
{
    return horner(c, r) / horner(c + 8, r);
}

/* The tails, one number in seven, are brought together first, so that they too are vectors. */
static void normals(const double *table, const uint64_t *words, int count, double *out)
{
    double q[MOST], r[MOST], x[MOST];
    int place[MOST], i, tails = 0;
    for (i = 0; i < count; i++)
        q[i] = centred(words[i]);
    for (i = 0; i < count; i++) {
        const double s = 0.180625 - q[i] * q[i];
        out[i] = (q[i] * horner(table, s)) / horner(table + 8, s);
    }
    for (i = 0; i < count; i++) {
        place[tails] = i;
        x[tails] = q[i];
        tails += (q[i] > 0.425) | (q[i] < -0.425);
    }
    for (i = 0; i < tails; i++)
        r[i] = -plain_log(0.5 - fabs(x[i]));
    for (i = 0; i < tails; i++)
        r[i] = sqrt(r[i]); /* alone: it may set errno, so no compiler makes vectors of it */
    for (i = 0; i < tails; i++)
        x[i] = ratio(table + 16, r[i] - 1.6);
    for (i = 0; i < tails; i++) {
        const double far = r[i] <= 5.0 ? x[i] : ratio(table + 32, r[i] - 5.0);
        out[place[i]] = q[place[i]] < 0 ? -far : far;
    }
}

static void many_normals(const double *table, const uint64_t *words, int64_t count, double *out)
{
    int64_t i;
    for (i = 0; i < count; i += MOST)
        normals(table, words + i, count - i < MOST ? (int)(count - i) : MOST, out + i);
}

void sensortrack_spsa_words(const uint64_t *counter, const uint64_t *key, uint64_t *out)
{
    philox(counter, key, out);
}

void sensortrack_spsa_normals(const double *table, const uint64_t *words, int64_t count,
                              double *out)
{
    many_normals(table, words, count, out);
}

static double sign_of(const uint64_t *words, int64_t index, int lane)
{
    const uint64_t word = words[(index / 64) * LANES + lane];
    return (word >> (index % 64)) & 1u ? 1.0 : -1.0;
}

/* d'H d / 2 in each lane */
static void cost(int64_t size, int64_t full, const double *hessian, const double *d, double *y)
{
    int64_t i, j;
    int lane;
    for (lane = 0; lane < LANES; lane++)
        y[lane] = 0.0;
    for (i = 0; i < size; i++) {
        double row[LANES];
        if (full) {
            for (lane = 0; lane < LANES; lane++)
                row[lane] = 0.0;
            for (j = 0; j < size; j++)
                for (lane = 0; lane < LANES; lane++)
                    row[lane] += hessian[i * size + j] * d[j * LANES + lane];
        } else {
            for (lane = 0; lane < LANES; lane++)
                row[lane] = hessian[i] * d[i * LANES + lane];
        }
        for (lane = 0; lane < LANES; lane++)
            y[lane] += row[lane] * d[i * LANES + lane];
    }
    for (lane = 0; lane < LANES; lane++)
        y[lane] = y[lane] / 2.0;
}

/* noise of one instant: root times numbers; `at` is the instant */
static void noise(int64_t size, int64_t full, const double *root, int64_t gaussian,
                  const double *table, const uint64_t *words, int64_t at, double *free,
                  double *xi)
{
    int64_t i, j;
    int lane;
    if (gaussian)
        many_normals(table, words + at * size * LANES, size * LANES, free);
    else
        for (i = 0; i < size; i++)
            for (lane = 0; lane < LANES; lane++)
                free[i * LANES + lane] = sign_of(words, at * size + i, lane);
    for (i = 0; i < size; i++) {
        double *row = xi + i * LANES;
        if (full) {
            for (lane = 0; lane < LANES; lane++)
                row[lane] = 0.0;
            for (j = 0; j < size; j++)
                for (lane = 0; lane < LANES; lane++)
                    row[lane] += root[i * size + j] * free[j * LANES + lane];
        } else {
            for (lane = 0; lane < LANES; lane++)
                row[lane] = root[i] * free[i * LANES + lane];
        }
    }
}

/* whole: D, full hessian, full root, gaussian, instants, k, first run, runs, updates, those of them
 * that are not counted. Matrices that are not full are their diagonals. Errors (runs by D)
 * go in and come out, as do sums of errors (runs by D) and of their squares (runs), and of each
 * update the sum over the runs of the square and of its square (updates by 2).
 * words: LANES times the words of an update; work: LANES times 5 D. */
void sensortrack_spsa_run(const int64_t *whole, const double *hessian, const double *root,
                          const double *eta, double alpha, double beta, const uint64_t *key,
                          const double *table, double *errors, double *sums, double *squares,
                          double *trajectory, uint64_t *words, double *work)
{
    const int64_t size = whole[0], gaussian = whole[3], instants = whole[4];
    const double lag = 2.0 * (double)whole[5];
    const int64_t runs = whole[7], numbers = instants * size;
    const int64_t signs = gaussian ? 0 : (size + 63) / 64;
    const int64_t total = gaussian ? numbers : signs + (numbers + 63) / 64;
    const int64_t blocks = (total + 3) / 4;
    double *e = work, *delta = e + size * LANES, *free = delta + size * LANES;
    double *xi = free + size * LANES, *d = xi + size * LANES;
    int64_t run, update, i, b;
    int lane;
    for (run = 0; run < runs; run += LANES) {
        const int live = runs - run < LANES ? (int)(runs - run) : LANES;
        for (i = 0; i < size; i++)
            for (lane = 0; lane < LANES; lane++)
                e[i * LANES + lane] = lane < live ? errors[(run + lane) * size + i] : 0.0;
        for (update = 0; update < whole[8]; update++) {
            double before[LANES], after[LANES], square[LANES];
            const uint64_t *rest = words + signs * LANES;
            for (b = 0; b < blocks; b++)
                for (lane = 0; lane < LANES; lane++) {
                    uint64_t counter[4] = {0, 0, 0, 0}, out[4];
                    counter[0] = (uint64_t)(whole[6] + run + lane) * (uint64_t)blocks + (uint64_t)b;
                    counter[1] = (uint64_t)update;
                    philox(counter, key, out);
                    for (i = 0; i < 4; i++)
                        words[(4 * b + i) * LANES + lane] = out[i];
                }
            noise(size, whole[2], root, gaussian, table, rest, 0, free, xi);
            for (i = 0; i < size; i++) {
                const double drift = instants == 2 ? eta[i] : 0.0;
                double *in = d + i * LANES, *sign = delta + i * LANES;
                const double *from = e + i * LANES, *by = xi + i * LANES;
                for (lane = 0; lane < LANES; lane++)
                    sign[lane] = sign_of(words, gaussian ? 64 * i : i, lane);
                for (lane = 0; lane < LANES; lane++)
                    in[lane] = ((from[lane] + drift) - beta * sign[lane]) - by[lane];
            }
            cost(size, whole[1], hessian, d, before);
            if (instants == 2)
                noise(size, whole[2], root, gaussian, table, rest, 1, free, xi);
            for (i = 0; i < size * LANES; i++)
                d[i] = (e[i] + beta * delta[i]) - xi[i];
            cost(size, whole[1], hessian, d, after);
            for (lane = 0; lane < LANES; lane++) {
                after[lane] = alpha * ((after[lane] - before[lane]) / (2.0 * beta));
                square[lane] = 0.0;
            }
            for (i = 0; i < size; i++) {
                double *at = e + i * LANES;
                const double *sign = delta + i * LANES;
                for (lane = 0; lane < LANES; lane++) {
                    at[lane] = at[lane] - sign[lane] * after[lane];
                    square[lane] += at[lane] * at[lane];
                }
                if (update >= whole[9])
                    for (lane = 0; lane < live; lane++)
                        sums[(run + lane) * size + i] += at[lane];
                for (lane = 0; lane < LANES; lane++)
                    at[lane] = at[lane] - lag * eta[i];
            }
            for (lane = 0; lane < live; lane++) {
                if (update >= whole[9])
                    squares[run + lane] += square[lane];
                trajectory[2 * update] += square[lane];
                trajectory[2 * update + 1] += square[lane] * square[lane];
            }
        }
        for (i = 0; i < size; i++)
            for (lane = 0; lane < live; lane++)
                errors[(run + lane) * size + i] = e[i * LANES + lane];
    }
}
