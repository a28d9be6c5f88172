/* Accelerated ascent of the dual of a total-variation problem on a network.
 *
 *     z = f + factor (f - former f),   f+ = clip(z + pace B'(y - B z), -c, c),
 *
 * with a restart of the momentum where the step turns against it. Links are in lexicographic order:
 * those whose first end is place i are below[i] .. below[i + 1] - 1, and second[] their other ends.
 */
#include <math.h>
#include <stdint.h>

static double ahead(const double *flow, const double *former, double factor, int32_t e)
{
    return flow[e] + factor * (flow[e] - former[e]);
}

/* x = y - B z. The links towards smaller places have added to sum[i] before place i is reached. */
static void shortened(int32_t n, const int32_t *below, const int32_t *second, const double *y,
                      const double *flow, const double *former, double factor, double *x)
{
    int32_t i, e;
    for (i = 0; i < n; i++)
        x[i] = 0;
    for (i = 0; i < n; i++) {
        double sum = x[i];
        for (e = below[i]; e < below[i + 1]; e++) {
            const double z = ahead(flow, former, factor, e);
            sum += z;
            x[second[e]] -= z;
        }
        x[i] = y[i] - sum;
    }
}

/* `count` steps; speed[0] is the momentum and speed[1] the factor of the extrapolation. The flow and
 * its former value are kept in both[0] and both[1], and change places with every step. */
void sensortrack_ascend(int32_t n, const int32_t *below, const int32_t *second, const double *y,
                        const double *capacity, const double *pace, double *both, double *x,
                        double *speed, int32_t count)
{
    const int32_t m = below[n];
    double *flow = both, *former = both + m;
    int32_t i, e, k;
    for (k = 0; k < count; k++) {
        const double factor = speed[1];
        double turn = 0, *swap = former;
        shortened(n, below, second, y, flow, former, factor, x);
        for (i = 0; i < n; i++) {
            double part = 0;
            for (e = below[i]; e < below[i + 1]; e++) {
                const double fall = x[i] - x[second[e]];
                const double goal = ahead(flow, former, factor, e) + pace[e] * fall;
                const double high = goal < capacity[e] ? goal : capacity[e];
                const double next = high > -capacity[e] ? high : -capacity[e];
                part += fall * (next - flow[e]);
                former[e] = next;
            }
            turn += part;
        }
        former = flow;
        flow = swap;
        if (turn < 0) {
            speed[0] = 1;
            speed[1] = 0;
        } else {
            const double later = (1 + sqrt(1 + 4 * speed[0] * speed[0])) / 2;
            speed[1] = (speed[0] - 1) / later;
            speed[0] = later;
        }
    }
    if (count % 2)
        for (e = 0; e < m; e++) {
            const double kept = both[e];
            both[e] = both[m + e];
            both[m + e] = kept;
        }
}

/* Duality gap: sum of c |d| - f d with d = B'x, x = y - B f; the sum of c |d| goes to size. */
double sensortrack_gap(int32_t n, const int32_t *below, const int32_t *second, const double *y,
                       const double *capacity, const double *flow, double *x, double *size)
{
    double lost = 0, all = 0;
    int32_t i, e;
    shortened(n, below, second, y, flow, flow, 0, x);
    for (i = 0; i < n; i++)
        for (e = below[i]; e < below[i + 1]; e++) {
            const double fall = x[i] - x[second[e]];
            const double most = capacity[e] * fabs(fall);
            lost += most - flow[e] * fall;
            all += most;
        }
    *size = all;
    return lost;
}
