/* Self-test: exit status 0 if every vector agrees bit by bit. */
#include "variational.h"
#include "variational_vectors.h"

#include <stdio.h>
#include <string.h>

static unsigned long differ(const trk_real *a, const trk_real *b, size_t count)
{
    unsigned long wrong = 0UL;
    size_t k;
    for (k = 0; k < count; k++) {
        const int unknown = isnan(a[k]) && isnan(b[k]);
        if (!unknown && memcmp(&a[k], &b[k], sizeof a[k]) != 0) {
            wrong++;
        }
    }
    return wrong;
}

static unsigned long init_mismatches(void)
{
    unsigned long wrong = 0UL;
    size_t k;
    for (k = 0; k < sizeof init_vectors / sizeof init_vectors[0]; k++) {
        const trk_real *row = init_vectors[k];
        trk_variational_start start;
        trk_variational_input input;
        trk_variational_state next;
        trk_real found[9];
        memcpy(&start, row + 0, 6 * sizeof *row);
        memcpy(&input, row + 6, 6 * sizeof *row);
        trk_variational_init(&start, &input, &next);
        memcpy(found, &next, 9 * sizeof *row);
        wrong += differ(found, row + 12, 9);
    }
    return wrong;
}

static unsigned long step_mismatches(void)
{
    unsigned long wrong = 0UL;
    size_t k;
    for (k = 0; k < sizeof step_vectors / sizeof step_vectors[0]; k++) {
        const trk_real *row = step_vectors[k];
        trk_variational_context context;
        trk_variational_state state;
        trk_variational_input input;
        trk_variational_state next;
        trk_real found[9];
        memcpy(&context, row + 0, 19 * sizeof *row);
        memcpy(&state, row + 19, 9 * sizeof *row);
        memcpy(&input, row + 28, 6 * sizeof *row);
        trk_variational_step(&context, &state, &input, &next);
        memcpy(found, &next, 9 * sizeof *row);
        wrong += differ(found, row + 34, 9);
        trk_variational_step(&context, &state, &input, &state);
        memcpy(found, &state, 9 * sizeof *row);
        wrong += differ(found, row + 34, 9);
    }
    return wrong;
}

static unsigned long leapfrog_step_mismatches(void)
{
    unsigned long wrong = 0UL;
    size_t k;
    for (k = 0; k < sizeof leapfrog_step_vectors / sizeof leapfrog_step_vectors[0]; k++) {
        const trk_real *row = leapfrog_step_vectors[k];
        trk_variational_context context;
        trk_variational_state state;
        trk_variational_input input;
        trk_variational_state next;
        trk_real found[9];
        memcpy(&context, row + 0, 19 * sizeof *row);
        memcpy(&state, row + 19, 9 * sizeof *row);
        memcpy(&input, row + 28, 6 * sizeof *row);
        trk_variational_leapfrog_step(&context, &state, &input, &next);
        memcpy(found, &next, 9 * sizeof *row);
        wrong += differ(found, row + 34, 9);
        trk_variational_leapfrog_step(&context, &state, &input, &state);
        memcpy(found, &state, 9 * sizeof *row);
        wrong += differ(found, row + 34, 9);
    }
    return wrong;
}

int main(void)
{
    const unsigned long wrong = init_mismatches() + step_mismatches() + leapfrog_step_mismatches();
    printf("variational: 204 vectors, %lu mismatches\n", wrong);
    (void)trk_variational_digest;
    return wrong == 0UL ? 0 : 1;
}
