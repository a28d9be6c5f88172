#include "variational.h"

const char *trk_variational_digest(void)
{
    return "d0976dba3a9db0b6ec4f2c9af658aef9eb692732539ad8ef2d25f3d6887c19b8";
}

void trk_variational_init(const trk_variational_start *start, const trk_variational_input *input, trk_variational_state *next)
{
    const trk_real b_start_0 = start->b_start[0];
    const trk_real b_start_1 = start->b_start[1];
    const trk_real b_start_2 = start->b_start[2];
    const trk_real u_start_0 = start->u_start[0];
    const trk_real u_start_1 = start->u_start[1];
    const trk_real u_start_2 = start->u_start[2];
    const trk_real v_bar_0 = input->v_bar[0];
    const trk_real v_bar_1 = input->v_bar[1];
    const trk_real v_bar_2 = input->v_bar[2];

    /* first(v_hat), (7) */
    const trk_real v_hat_first_0 = (u_start_0 + v_bar_0);
    const trk_real v_hat_first_1 = (u_start_1 + v_bar_1);
    const trk_real v_hat_first_2 = (u_start_2 + v_bar_2);

    next->b_hat[0] = b_start_0;
    next->b_hat[1] = b_start_1;
    next->b_hat[2] = b_start_2;
    next->v_hat[0] = v_hat_first_0;
    next->v_hat[1] = v_hat_first_1;
    next->v_hat[2] = v_hat_first_2;
    next->u[0] = u_start_0;
    next->u[1] = u_start_1;
    next->u[2] = u_start_2;
}

void trk_variational_step(const trk_variational_context *context, const trk_variational_state *state, const trk_variational_input *input, trk_variational_state *next)
{
    const trk_real M_00 = context->M[0];
    const trk_real M_01 = context->M[1];
    const trk_real M_02 = context->M[2];
    const trk_real M_11 = context->M[3];
    const trk_real M_12 = context->M[4];
    const trk_real M_22 = context->M[5];
    const trk_real K_00 = context->K[0];
    const trk_real K_01 = context->K[1];
    const trk_real K_02 = context->K[2];
    const trk_real K_11 = context->K[3];
    const trk_real K_12 = context->K[4];
    const trk_real K_22 = context->K[5];
    const trk_real C_00 = context->C[0];
    const trk_real C_01 = context->C[1];
    const trk_real C_02 = context->C[2];
    const trk_real C_11 = context->C[3];
    const trk_real C_12 = context->C[4];
    const trk_real C_22 = context->C[5];
    const trk_real h = context->h;
    const trk_real b_hat_0 = state->b_hat[0];
    const trk_real b_hat_1 = state->b_hat[1];
    const trk_real b_hat_2 = state->b_hat[2];
    const trk_real v_hat_0 = state->v_hat[0];
    const trk_real v_hat_1 = state->v_hat[1];
    const trk_real v_hat_2 = state->v_hat[2];
    const trk_real u_0 = state->u[0];
    const trk_real u_1 = state->u[1];
    const trk_real u_2 = state->u[2];
    const trk_real b_bar_0 = input->b_bar[0];
    const trk_real b_bar_1 = input->b_bar[1];
    const trk_real b_bar_2 = input->b_bar[2];
    const trk_real v_bar_0 = input->v_bar[0];
    const trk_real v_bar_1 = input->v_bar[1];
    const trk_real v_bar_2 = input->v_bar[2];

    /* next(b_hat), (20), first line */
    const trk_real b_hat_next_0 = (b_hat_0 + (h * v_hat_0));
    const trk_real b_hat_next_1 = (b_hat_1 + (h * v_hat_1));
    const trk_real b_hat_next_2 = (b_hat_2 + (h * v_hat_2));

    /* next(x), (6) at the new sample */
    const trk_real x_next_0 = (b_hat_next_0 - b_bar_0);
    const trk_real x_next_1 = (b_hat_next_1 - b_bar_1);
    const trk_real x_next_2 = (b_hat_next_2 - b_bar_2);

    /* next(u), (20), last line */
    const trk_real u_next_d0 = (M_00 + (h * C_00));
    const trk_real u_next_w10 = (M_01 + (h * C_01));
    const trk_real u_next_l10 = (u_next_w10 / u_next_d0);
    const trk_real u_next_d1 = ((M_11 + (h * C_11)) - (u_next_w10 * u_next_l10));
    const trk_real u_next_w20 = (M_02 + (h * C_02));
    const trk_real u_next_l20 = (u_next_w20 / u_next_d0);
    const trk_real u_next_w21 = ((M_12 + (h * C_12)) - (u_next_w20 * u_next_l10));
    const trk_real u_next_l21 = (u_next_w21 / u_next_d1);
    const trk_real u_next_d2 = (((M_22 + (h * C_22)) - (u_next_w20 * u_next_l20)) - (u_next_w21 * u_next_l21));
    const trk_real u_next_y0_part0 = (h * K_01);
    const trk_real u_next_y0_part1 = (h * K_02);
    const trk_real u_next_y0 = ((((M_00 * u_0) + (M_01 * u_1)) + (M_02 * u_2)) - ((((h * K_00) * x_next_0) + (u_next_y0_part0 * x_next_1)) + (u_next_y0_part1 * x_next_2)));
    const trk_real u_next_y1_part0 = (h * K_12);
    const trk_real u_next_y1 = (((((M_01 * u_0) + (M_11 * u_1)) + (M_12 * u_2)) - (((u_next_y0_part0 * x_next_0) + ((h * K_11) * x_next_1)) + (u_next_y1_part0 * x_next_2))) - (u_next_l10 * u_next_y0));
    const trk_real u_next_y2 = ((((((M_02 * u_0) + (M_12 * u_1)) + (M_22 * u_2)) - (((u_next_y0_part1 * x_next_0) + (u_next_y1_part0 * x_next_1)) + ((h * K_22) * x_next_2))) - (u_next_l20 * u_next_y0)) - (u_next_l21 * u_next_y1));
    const trk_real u_next_2 = (u_next_y2 / u_next_d2);
    const trk_real u_next_1 = ((u_next_y1 / u_next_d1) - (u_next_l21 * u_next_2));
    const trk_real u_next_0 = (((u_next_y0 / u_next_d0) - (u_next_l10 * u_next_1)) - (u_next_l20 * u_next_2));

    /* next(v_hat), (7) at the new sample */
    const trk_real v_hat_next_0 = (u_next_0 + v_bar_0);
    const trk_real v_hat_next_1 = (u_next_1 + v_bar_1);
    const trk_real v_hat_next_2 = (u_next_2 + v_bar_2);

    next->b_hat[0] = b_hat_next_0;
    next->b_hat[1] = b_hat_next_1;
    next->b_hat[2] = b_hat_next_2;
    next->v_hat[0] = v_hat_next_0;
    next->v_hat[1] = v_hat_next_1;
    next->v_hat[2] = v_hat_next_2;
    next->u[0] = u_next_0;
    next->u[1] = u_next_1;
    next->u[2] = u_next_2;
}

void trk_variational_leapfrog_step(const trk_variational_context *context, const trk_variational_state *state, const trk_variational_input *input, trk_variational_state *next)
{
    const trk_real M_00 = context->M[0];
    const trk_real M_01 = context->M[1];
    const trk_real M_02 = context->M[2];
    const trk_real M_11 = context->M[3];
    const trk_real M_12 = context->M[4];
    const trk_real M_22 = context->M[5];
    const trk_real K_00 = context->K[0];
    const trk_real K_01 = context->K[1];
    const trk_real K_02 = context->K[2];
    const trk_real K_11 = context->K[3];
    const trk_real K_12 = context->K[4];
    const trk_real K_22 = context->K[5];
    const trk_real C_00 = context->C[0];
    const trk_real C_01 = context->C[1];
    const trk_real C_02 = context->C[2];
    const trk_real C_11 = context->C[3];
    const trk_real C_12 = context->C[4];
    const trk_real C_22 = context->C[5];
    const trk_real h = context->h;
    const trk_real b_hat_0 = state->b_hat[0];
    const trk_real b_hat_1 = state->b_hat[1];
    const trk_real b_hat_2 = state->b_hat[2];
    const trk_real v_hat_0 = state->v_hat[0];
    const trk_real v_hat_1 = state->v_hat[1];
    const trk_real v_hat_2 = state->v_hat[2];
    const trk_real u_0 = state->u[0];
    const trk_real u_1 = state->u[1];
    const trk_real u_2 = state->u[2];
    const trk_real b_bar_0 = input->b_bar[0];
    const trk_real b_bar_1 = input->b_bar[1];
    const trk_real b_bar_2 = input->b_bar[2];
    const trk_real v_bar_0 = input->v_bar[0];
    const trk_real v_bar_1 = input->v_bar[1];
    const trk_real v_bar_2 = input->v_bar[2];

    /* next(b_hat), (20), first line */
    const trk_real b_hat_next_0 = (b_hat_0 + (h * v_hat_0));
    const trk_real b_hat_next_1 = (b_hat_1 + (h * v_hat_1));
    const trk_real b_hat_next_2 = (b_hat_2 + (h * v_hat_2));

    /* next(x), (6) at the new sample */
    const trk_real x_next_0 = (b_hat_next_0 - b_bar_0);
    const trk_real x_next_1 = (b_hat_next_1 - b_bar_1);
    const trk_real x_next_2 = (b_hat_next_2 - b_bar_2);

    /* next(u), second-order form of (20) */
    const trk_real u_next_d0_part0 = (TRK_R(0.5) * h);
    const trk_real u_next_d0_part1 = (u_next_d0_part0 * C_00);
    const trk_real u_next_d0 = (M_00 + u_next_d0_part1);
    const trk_real u_next_w10_part0 = (u_next_d0_part0 * C_01);
    const trk_real u_next_w10 = (M_01 + u_next_w10_part0);
    const trk_real u_next_l10 = (u_next_w10 / u_next_d0);
    const trk_real u_next_d1_part0 = (u_next_d0_part0 * C_11);
    const trk_real u_next_d1 = ((M_11 + u_next_d1_part0) - (u_next_w10 * u_next_l10));
    const trk_real u_next_w20_part0 = (u_next_d0_part0 * C_02);
    const trk_real u_next_w20 = (M_02 + u_next_w20_part0);
    const trk_real u_next_l20 = (u_next_w20 / u_next_d0);
    const trk_real u_next_w21_part0 = (u_next_d0_part0 * C_12);
    const trk_real u_next_w21 = ((M_12 + u_next_w21_part0) - (u_next_w20 * u_next_l10));
    const trk_real u_next_l21 = (u_next_w21 / u_next_d1);
    const trk_real u_next_d2_part0 = (u_next_d0_part0 * C_22);
    const trk_real u_next_d2 = (((M_22 + u_next_d2_part0) - (u_next_w20 * u_next_l20)) - (u_next_w21 * u_next_l21));
    const trk_real u_next_y0_part0 = (M_01 - u_next_w10_part0);
    const trk_real u_next_y0_part1 = (M_02 - u_next_w20_part0);
    const trk_real u_next_y0_part2 = (h * K_01);
    const trk_real u_next_y0_part3 = (h * K_02);
    const trk_real u_next_y0 = (((((M_00 - u_next_d0_part1) * u_0) + (u_next_y0_part0 * u_1)) + (u_next_y0_part1 * u_2)) - ((((h * K_00) * x_next_0) + (u_next_y0_part2 * x_next_1)) + (u_next_y0_part3 * x_next_2)));
    const trk_real u_next_y1_part0 = (M_12 - u_next_w21_part0);
    const trk_real u_next_y1_part1 = (h * K_12);
    const trk_real u_next_y1 = (((((u_next_y0_part0 * u_0) + ((M_11 - u_next_d1_part0) * u_1)) + (u_next_y1_part0 * u_2)) - (((u_next_y0_part2 * x_next_0) + ((h * K_11) * x_next_1)) + (u_next_y1_part1 * x_next_2))) - (u_next_l10 * u_next_y0));
    const trk_real u_next_y2 = ((((((u_next_y0_part1 * u_0) + (u_next_y1_part0 * u_1)) + ((M_22 - u_next_d2_part0) * u_2)) - (((u_next_y0_part3 * x_next_0) + (u_next_y1_part1 * x_next_1)) + ((h * K_22) * x_next_2))) - (u_next_l20 * u_next_y0)) - (u_next_l21 * u_next_y1));
    const trk_real u_next_2 = (u_next_y2 / u_next_d2);
    const trk_real u_next_1 = ((u_next_y1 / u_next_d1) - (u_next_l21 * u_next_2));
    const trk_real u_next_0 = (((u_next_y0 / u_next_d0) - (u_next_l10 * u_next_1)) - (u_next_l20 * u_next_2));

    /* next(v_hat), (7) at the new sample */
    const trk_real v_hat_next_0 = (u_next_0 + v_bar_0);
    const trk_real v_hat_next_1 = (u_next_1 + v_bar_1);
    const trk_real v_hat_next_2 = (u_next_2 + v_bar_2);

    next->b_hat[0] = b_hat_next_0;
    next->b_hat[1] = b_hat_next_1;
    next->b_hat[2] = b_hat_next_2;
    next->v_hat[0] = v_hat_next_0;
    next->v_hat[1] = v_hat_next_1;
    next->v_hat[2] = v_hat_next_2;
    next->u[0] = u_next_0;
    next->u[1] = u_next_1;
    next->u[2] = u_next_2;
}

void trk_variational_run(const trk_variational_context *context, trk_variational_state *state, const trk_variational_input *input, size_t count, trk_variational_state *out)
{
    size_t k;
    for (k = 0; k < count; k++) {
        trk_variational_step(context, state, &input[k], state);
        if (out != NULL) {
            out[k] = *state;
        }
    }
}
