/* Self-test: exit status 0 if every vector agrees but for two roundings of each sine and cosine. */
#include "cyclic_spsa.h"
#include "cyclic_spsa_vectors.h"

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
        trk_cyclic_spsa_start start;
        trk_cyclic_spsa_state next;
        trk_real found[2];
        memcpy(&start, row + 0, 2 * sizeof *row);
        trk_cyclic_spsa_init(&start, &next);
        memcpy(found, &next, 2 * sizeof *row);
        wrong += differ(found, row + 2, 2);
    }
    return wrong;
}

static unsigned long step_mismatches(void)
{
    unsigned long wrong = 0UL;
    size_t k;
    for (k = 0; k < sizeof step_vectors / sizeof step_vectors[0]; k++) {
        const trk_real *row = step_vectors[k];
        trk_cyclic_spsa_context context;
        trk_cyclic_spsa_state state;
        trk_cyclic_spsa_input input;
        trk_cyclic_spsa_state next;
        trk_real found[2];
        memcpy(&context, row + 0, 5 * sizeof *row);
        memcpy(&state, row + 5, 2 * sizeof *row);
        memcpy(&input, row + 7, 6 * sizeof *row);
        trk_cyclic_spsa_step(&context, &state, &input, &next);
        memcpy(found, &next, 2 * sizeof *row);
        wrong += differ(found, row + 13, 2);
        trk_cyclic_spsa_step(&context, &state, &input, &state);
        memcpy(found, &state, 2 * sizeof *row);
        wrong += differ(found, row + 13, 2);
    }
    return wrong;
}

static unsigned long first_cost_mismatches(void)
{
    unsigned long wrong = 0UL;
    size_t k;
    for (k = 0; k < sizeof first_cost_vectors / sizeof first_cost_vectors[0]; k++) {
        const trk_real *row = first_cost_vectors[k];
        trk_cyclic_spsa_context context;
        trk_cyclic_spsa_state state;
        trk_cyclic_spsa_minus minus;
        trk_cyclic_spsa_cost next;
        trk_real found[1];
        memcpy(&context, row + 0, 5 * sizeof *row);
        memcpy(&state, row + 5, 2 * sizeof *row);
        memcpy(&minus, row + 7, 4 * sizeof *row);
        trk_cyclic_spsa_first_cost(&context, &state, &minus, &next);
        memcpy(found, &next, 1 * sizeof *row);
        wrong += differ(found, row + 11, 1);
    }
    return wrong;
}

static unsigned long second_cost_mismatches(void)
{
    unsigned long wrong = 0UL;
    size_t k;
    for (k = 0; k < sizeof second_cost_vectors / sizeof second_cost_vectors[0]; k++) {
        const trk_real *row = second_cost_vectors[k];
        trk_cyclic_spsa_context context;
        trk_cyclic_spsa_state state;
        trk_cyclic_spsa_plus plus;
        trk_cyclic_spsa_cost next;
        trk_real found[1];
        memcpy(&context, row + 0, 5 * sizeof *row);
        memcpy(&state, row + 5, 2 * sizeof *row);
        memcpy(&plus, row + 7, 4 * sizeof *row);
        trk_cyclic_spsa_second_cost(&context, &state, &plus, &next);
        memcpy(found, &next, 1 * sizeof *row);
        wrong += differ(found, row + 11, 1);
    }
    return wrong;
}

static unsigned long update_mismatches(void)
{
    unsigned long wrong = 0UL;
    size_t k;
    for (k = 0; k < sizeof update_vectors / sizeof update_vectors[0]; k++) {
        const trk_real *row = update_vectors[k];
        trk_cyclic_spsa_context context;
        trk_cyclic_spsa_state state;
        trk_cyclic_spsa_costs costs;
        trk_cyclic_spsa_state next;
        trk_real found[2];
        memcpy(&context, row + 0, 5 * sizeof *row);
        memcpy(&state, row + 5, 2 * sizeof *row);
        memcpy(&costs, row + 7, 4 * sizeof *row);
        trk_cyclic_spsa_update(&context, &state, &costs, &next);
        memcpy(found, &next, 2 * sizeof *row);
        wrong += differ(found, row + 11, 2);
        trk_cyclic_spsa_update(&context, &state, &costs, &state);
        memcpy(found, &state, 2 * sizeof *row);
        wrong += differ(found, row + 11, 2);
    }
    return wrong;
}

static unsigned long position_mismatches(void)
{
    unsigned long wrong = 0UL;
    size_t k;
    for (k = 0; k < sizeof position_vectors / sizeof position_vectors[0]; k++) {
        const trk_real *row = position_vectors[k];
        trk_cyclic_spsa_sender sender;
        trk_cyclic_spsa_measurement measurement;
        trk_cyclic_spsa_place next;
        trk_real found[2];
        memcpy(&sender, row + 0, 3 * sizeof *row);
        memcpy(&measurement, row + 3, 2 * sizeof *row);
        trk_cyclic_spsa_position(&sender, &measurement, &next);
        memcpy(found, &next, 2 * sizeof *row);
        wrong += differ(found, row + 5, 2);
    }
    return wrong;
}

int main(void)
{
    const unsigned long wrong = init_mismatches() + step_mismatches() + first_cost_mismatches() + second_cost_mismatches() + update_mismatches() + position_mismatches();
    printf("cyclic_spsa: 408 vectors, %lu mismatches\n", wrong);
    (void)trk_cyclic_spsa_digest;
    return wrong == 0UL ? 0 : 1;
}
