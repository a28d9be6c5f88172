#include "cyclic_spsa.h"

#include <math.h>

const char *trk_cyclic_spsa_digest(void)
{
    return "a633aa5ff54af93a8f614e59dff249164ca1b18b61035220713174af4e44f224";
}

void trk_cyclic_spsa_init(const trk_cyclic_spsa_start *start, trk_cyclic_spsa_state *next)
{
    const trk_real theta_start_0 = start->theta_start[0];
    const trk_real theta_start_1 = start->theta_start[1];

    next->theta_hat[0] = theta_start_0;
    next->theta_hat[1] = theta_start_1;
}

void trk_cyclic_spsa_step(const trk_cyclic_spsa_context *context, const trk_cyclic_spsa_state *state, const trk_cyclic_spsa_input *input, trk_cyclic_spsa_state *next)
{
    const trk_real H_00 = context->H[0];
    const trk_real H_01 = context->H[1];
    const trk_real H_11 = context->H[2];
    const trk_real alpha = context->alpha;
    const trk_real beta = context->beta;
    const trk_real theta_hat_0 = state->theta_hat[0];
    const trk_real theta_hat_1 = state->theta_hat[1];
    const trk_real Delta_0 = input->Delta[0];
    const trk_real Delta_1 = input->Delta[1];
    const trk_real q_minus_0 = input->q_minus[0];
    const trk_real q_minus_1 = input->q_minus[1];
    const trk_real q_plus_0 = input->q_plus[0];
    const trk_real q_plus_1 = input->q_plus[1];

    /* x_minus, Algorithm 1, step 3.2 */
    const trk_real x_minus_0_part0 = (beta * Delta_0);
    const trk_real x_minus_0 = (theta_hat_0 - x_minus_0_part0);
    const trk_real x_minus_1_part0 = (beta * Delta_1);
    const trk_real x_minus_1 = (theta_hat_1 - x_minus_1_part0);

    /* y_minus, (20), first point */
    const trk_real y_minus_0_part0 = (x_minus_0 - q_minus_0);
    const trk_real y_minus_0_part1 = (x_minus_1 - q_minus_1);
    const trk_real y_minus_0 = (((((y_minus_0_part0 * H_00) + (y_minus_0_part1 * H_01)) * y_minus_0_part0) + (((y_minus_0_part0 * H_01) + (y_minus_0_part1 * H_11)) * y_minus_0_part1)) / TRK_R(2.0));

    /* x_plus, Algorithm 1, step 3.5 */
    const trk_real x_plus_0 = (theta_hat_0 + x_minus_0_part0);
    const trk_real x_plus_1 = (theta_hat_1 + x_minus_1_part0);

    /* y_plus, (20), second point */
    const trk_real y_plus_0_part0 = (x_plus_0 - q_plus_0);
    const trk_real y_plus_0_part1 = (x_plus_1 - q_plus_1);
    const trk_real y_plus_0 = (((((y_plus_0_part0 * H_00) + (y_plus_0_part1 * H_01)) * y_plus_0_part0) + (((y_plus_0_part0 * H_01) + (y_plus_0_part1 * H_11)) * y_plus_0_part1)) / TRK_R(2.0));

    /* g, Algorithm 1, step 3.8 */
    const trk_real g_0_part0 = (y_plus_0 - y_minus_0);
    const trk_real g_0_part1 = (TRK_R(2.0) * beta);
    const trk_real g_0 = ((g_0_part0 * Delta_0) / g_0_part1);
    const trk_real g_1 = ((g_0_part0 * Delta_1) / g_0_part1);

    /* next(theta_hat), Algorithm 1, step 3.9 */
    const trk_real theta_hat_next_0 = (theta_hat_0 - (alpha * g_0));
    const trk_real theta_hat_next_1 = (theta_hat_1 - (alpha * g_1));

    next->theta_hat[0] = theta_hat_next_0;
    next->theta_hat[1] = theta_hat_next_1;
}

void trk_cyclic_spsa_first_cost(const trk_cyclic_spsa_context *context, const trk_cyclic_spsa_state *state, const trk_cyclic_spsa_minus *minus, trk_cyclic_spsa_cost *next)
{
    const trk_real H_00 = context->H[0];
    const trk_real H_01 = context->H[1];
    const trk_real H_11 = context->H[2];
    const trk_real beta = context->beta;
    const trk_real theta_hat_0 = state->theta_hat[0];
    const trk_real theta_hat_1 = state->theta_hat[1];
    const trk_real Delta_0 = minus->Delta[0];
    const trk_real Delta_1 = minus->Delta[1];
    const trk_real q_minus_0 = minus->q_minus[0];
    const trk_real q_minus_1 = minus->q_minus[1];

    /* x_minus, Algorithm 1, step 3.2 */
    const trk_real x_minus_0 = (theta_hat_0 - (beta * Delta_0));
    const trk_real x_minus_1 = (theta_hat_1 - (beta * Delta_1));

    /* y_minus, (20), first point */
    const trk_real y_minus_0_part0 = (x_minus_0 - q_minus_0);
    const trk_real y_minus_0_part1 = (x_minus_1 - q_minus_1);
    const trk_real y_minus_0 = (((((y_minus_0_part0 * H_00) + (y_minus_0_part1 * H_01)) * y_minus_0_part0) + (((y_minus_0_part0 * H_01) + (y_minus_0_part1 * H_11)) * y_minus_0_part1)) / TRK_R(2.0));

    next->y = y_minus_0;
}

void trk_cyclic_spsa_second_cost(const trk_cyclic_spsa_context *context, const trk_cyclic_spsa_state *state, const trk_cyclic_spsa_plus *plus, trk_cyclic_spsa_cost *next)
{
    const trk_real H_00 = context->H[0];
    const trk_real H_01 = context->H[1];
    const trk_real H_11 = context->H[2];
    const trk_real beta = context->beta;
    const trk_real theta_hat_0 = state->theta_hat[0];
    const trk_real theta_hat_1 = state->theta_hat[1];
    const trk_real Delta_0 = plus->Delta[0];
    const trk_real Delta_1 = plus->Delta[1];
    const trk_real q_plus_0 = plus->q_plus[0];
    const trk_real q_plus_1 = plus->q_plus[1];

    /* x_plus, Algorithm 1, step 3.5 */
    const trk_real x_plus_0 = (theta_hat_0 + (beta * Delta_0));
    const trk_real x_plus_1 = (theta_hat_1 + (beta * Delta_1));

    /* y_plus, (20), second point */
    const trk_real y_plus_0_part0 = (x_plus_0 - q_plus_0);
    const trk_real y_plus_0_part1 = (x_plus_1 - q_plus_1);
    const trk_real y_plus_0 = (((((y_plus_0_part0 * H_00) + (y_plus_0_part1 * H_01)) * y_plus_0_part0) + (((y_plus_0_part0 * H_01) + (y_plus_0_part1 * H_11)) * y_plus_0_part1)) / TRK_R(2.0));

    next->y = y_plus_0;
}

void trk_cyclic_spsa_update(const trk_cyclic_spsa_context *context, const trk_cyclic_spsa_state *state, const trk_cyclic_spsa_costs *costs, trk_cyclic_spsa_state *next)
{
    const trk_real alpha = context->alpha;
    const trk_real beta = context->beta;
    const trk_real theta_hat_0 = state->theta_hat[0];
    const trk_real theta_hat_1 = state->theta_hat[1];
    const trk_real Delta_0 = costs->Delta[0];
    const trk_real Delta_1 = costs->Delta[1];
    const trk_real y_minus = costs->y_minus;
    const trk_real y_plus = costs->y_plus;

    /* g, Algorithm 1, step 3.8 */
    const trk_real g_0_part0 = (y_plus - y_minus);
    const trk_real g_0_part1 = (TRK_R(2.0) * beta);
    const trk_real g_0 = ((g_0_part0 * Delta_0) / g_0_part1);
    const trk_real g_1 = ((g_0_part0 * Delta_1) / g_0_part1);

    /* next(theta_hat), Algorithm 1, step 3.9 */
    const trk_real theta_hat_next_0 = (theta_hat_0 - (alpha * g_0));
    const trk_real theta_hat_next_1 = (theta_hat_1 - (alpha * g_1));

    next->theta_hat[0] = theta_hat_next_0;
    next->theta_hat[1] = theta_hat_next_1;
}

void trk_cyclic_spsa_position(const trk_cyclic_spsa_sender *sender, const trk_cyclic_spsa_measurement *measurement, trk_cyclic_spsa_place *next)
{
    const trk_real s_0 = sender->s_0;
    const trk_real s_1 = sender->s_1;
    const trk_real growth = sender->growth;
    const trk_real z_1 = measurement->z_1;
    const trk_real z_2 = measurement->z_2;

    /* position_0, (13), first axis */
    const trk_real position_0_0 = (s_0 + (growth * (z_2 * TRK_SIN(z_1))));

    /* position_1, (13), second axis */
    const trk_real position_1_0 = (s_1 + (growth * (z_2 * TRK_COS(z_1))));

    next->p_0 = position_0_0;
    next->p_1 = position_1_0;
}

void trk_cyclic_spsa_run(const trk_cyclic_spsa_context *context, trk_cyclic_spsa_state *state, const trk_cyclic_spsa_input *input, size_t count, trk_cyclic_spsa_state *out)
{
    size_t k;
    for (k = 0; k < count; k++) {
        trk_cyclic_spsa_step(context, state, &input[k], state);
        if (out != NULL) {
            out[k] = *state;
        }
    }
}
