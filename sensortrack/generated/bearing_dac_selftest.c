/* Self-test: exit status 0 if every vector agrees but for two roundings of each sine and cosine. */
#include "bearing_dac.h"
#include "bearing_dac_vectors.h"

#include <stdio.h>
#include <string.h>

/* allowed: how far each result may be off, 0 where all libraries agree */
static unsigned long differ(const trk_real *a, const trk_real *b, size_t count)
{
    const trk_real *allowed = b + count;
    unsigned long wrong = 0UL;
    size_t k;
    for (k = 0; k < count; k++) {
        const int same = a[k] == b[k] || (isnan(a[k]) && isnan(b[k]));
        const trk_real off = a[k] > b[k] ? a[k] - b[k] : b[k] - a[k];
        if (!same && !(off <= allowed[k])) {
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
        trk_bearing_dac_context context;
        trk_bearing_dac_start start;
        trk_bearing_dac_state next;
        trk_real found[11];
        memcpy(&context, row + 0, 6 * sizeof *row);
        memcpy(&start, row + 6, 1 * sizeof *row);
        trk_bearing_dac_init(&context, &start, &next);
        memcpy(found, &next, 11 * sizeof *row);
        wrong += differ(found, row + 7, 11);
    }
    return wrong;
}

static unsigned long step_mismatches(void)
{
    unsigned long wrong = 0UL;
    size_t k;
    for (k = 0; k < sizeof step_vectors / sizeof step_vectors[0]; k++) {
        const trk_real *row = step_vectors[k];
        trk_bearing_dac_context context;
        trk_bearing_dac_state state;
        trk_bearing_dac_input input;
        trk_bearing_dac_state next;
        trk_real found[11];
        memcpy(&context, row + 0, 6 * sizeof *row);
        memcpy(&state, row + 6, 11 * sizeof *row);
        memcpy(&input, row + 17, 5 * sizeof *row);
        trk_bearing_dac_step(&context, &state, &input, &next);
        memcpy(found, &next, 11 * sizeof *row);
        wrong += differ(found, row + 22, 11);
        trk_bearing_dac_step(&context, &state, &input, &state);
        memcpy(found, &state, 11 * sizeof *row);
        wrong += differ(found, row + 22, 11);
    }
    return wrong;
}

static unsigned long link_mismatches(void)
{
    unsigned long wrong = 0UL;
    size_t k;
    for (k = 0; k < sizeof link_vectors / sizeof link_vectors[0]; k++) {
        const trk_real *row = link_vectors[k];
        trk_bearing_dac_own own;
        trk_bearing_dac_other other;
        trk_bearing_dac_signs next;
        trk_real found[4];
        memcpy(&own, row + 0, 4 * sizeof *row);
        memcpy(&other, row + 4, 4 * sizeof *row);
        trk_bearing_dac_link(&own, &other, &next);
        memcpy(found, &next, 4 * sizeof *row);
        wrong += differ(found, row + 8, 4);
    }
    return wrong;
}

static unsigned long link_isotropic_mismatches(void)
{
    unsigned long wrong = 0UL;
    size_t k;
    for (k = 0; k < sizeof link_isotropic_vectors / sizeof link_isotropic_vectors[0]; k++) {
        const trk_real *row = link_isotropic_vectors[k];
        trk_bearing_dac_own own;
        trk_bearing_dac_other other;
        trk_bearing_dac_signs next;
        trk_real found[4];
        memcpy(&own, row + 0, 4 * sizeof *row);
        memcpy(&other, row + 4, 4 * sizeof *row);
        trk_bearing_dac_link_isotropic(&own, &other, &next);
        memcpy(found, &next, 4 * sizeof *row);
        wrong += differ(found, row + 8, 4);
    }
    return wrong;
}

static unsigned long measure_mismatches(void)
{
    unsigned long wrong = 0UL;
    size_t k;
    for (k = 0; k < sizeof measure_vectors / sizeof measure_vectors[0]; k++) {
        const trk_real *row = measure_vectors[k];
        trk_bearing_dac_context context;
        trk_bearing_dac_start start;
        trk_bearing_dac_signal next;
        trk_real found[4];
        memcpy(&context, row + 0, 6 * sizeof *row);
        memcpy(&start, row + 6, 1 * sizeof *row);
        trk_bearing_dac_measure(&context, &start, &next);
        memcpy(found, &next, 4 * sizeof *row);
        wrong += differ(found, row + 7, 4);
    }
    return wrong;
}

static unsigned long position_mismatches(void)
{
    unsigned long wrong = 0UL;
    size_t k;
    for (k = 0; k < sizeof position_vectors / sizeof position_vectors[0]; k++) {
        const trk_real *row = position_vectors[k];
        trk_bearing_dac_context context;
        trk_bearing_dac_estimate estimate;
        trk_bearing_dac_fix next;
        trk_real found[3];
        memcpy(&context, row + 0, 6 * sizeof *row);
        memcpy(&estimate, row + 6, 4 * sizeof *row);
        trk_bearing_dac_position(&context, &estimate, &next);
        memcpy(found, &next, 3 * sizeof *row);
        wrong += differ(found, row + 10, 3);
    }
    return wrong;
}

int main(void)
{
    const unsigned long wrong = init_mismatches() + step_mismatches() + link_mismatches() + link_isotropic_mismatches() + measure_mismatches() + position_mismatches();
    printf("bearing_dac: 408 vectors, %lu mismatches\n", wrong);
    (void)trk_bearing_dac_digest;
    return wrong == 0UL ? 0 : 1;
}
