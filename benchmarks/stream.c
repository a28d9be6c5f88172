/* What memory can do: the loops that other loops over memory are measured by. */
#include <stddef.h>

void stream_copy(size_t n, const double *a, double *out)
{
    size_t i;
    for (i = 0; i < n; i++)
        out[i] = a[i];
}

void stream_triad(size_t n, const double *a, const double *b, double *out)
{
    size_t i;
    for (i = 0; i < n; i++)
        out[i] = a[i] + 3.0 * b[i];
}
