#include "bearing_dac.h"

#include <math.h>

const char *trk_bearing_dac_digest(void)
{
    return "eeb5a15f1c19aa05f4a37b86ec23fa19f314933e4e41e8c3b6ccb63e0769b32f";
}

void trk_bearing_dac_init(const trk_bearing_dac_context *context, const trk_bearing_dac_start *start, trk_bearing_dac_state *next)
{
    const trk_real s_0 = context->s[0];
    const trk_real s_1 = context->s[1];
    const trk_real det_min = context->det_min;
    const trk_real theta_start = start->theta_start;

    /* h, Proposition 1 */
    const trk_real h_0 = ((-TRK_R(1.0)) * TRK_SIN(theta_start));
    const trk_real h_1 = TRK_COS(theta_start);

    /* z, measurement */
    const trk_real z_0 = ((h_0 * s_0) + (h_1 * s_1));

    /* r_P, Algorithm 1, line 5, first row */
    const trk_real r_P_0 = (h_0 * h_0);
    const trk_real r_P_1 = (h_0 * h_1);

    /* r_q, Algorithm 1, line 6 */
    const trk_real r_q_0 = (z_0 * h_0);
    const trk_real r_q_1 = (z_0 * h_1);

    /* p_i, Algorithm 1, line 12 */
    const trk_real p_i_det_part0 = (TRK_R(1.0) - r_P_0);
    const trk_real p_i_det = ((r_P_0 * p_i_det_part0) - (r_P_1 * r_P_1));
    const trk_real p_i_safe = ((p_i_det > det_min) ? p_i_det : TRK_R(1.0));
    const trk_real p_i_raw0 = (((p_i_det_part0 * r_q_0) - (r_P_1 * r_q_1)) / p_i_safe);
    const trk_real p_i_raw1 = (((r_P_0 * r_q_1) - (r_P_1 * r_q_0)) / p_i_safe);
    const trk_real p_i_known = ((p_i_det > det_min) ? ((p_i_raw0 > (-TRK_R(1.2676506002282294e+30))) ? ((TRK_R(1.2676506002282294e+30) > p_i_raw0) ? ((p_i_raw1 > (-TRK_R(1.2676506002282294e+30))) ? ((TRK_R(1.2676506002282294e+30) > p_i_raw1) ? TRK_R(1.0) : TRK_R(0.0)) : TRK_R(0.0)) : TRK_R(0.0)) : TRK_R(0.0)) : TRK_R(0.0));
    const trk_real p_i_0 = ((p_i_known > TRK_R(0.0)) ? p_i_raw0 : TRK_R(0.0));
    const trk_real p_i_1 = ((p_i_known > TRK_R(0.0)) ? p_i_raw1 : TRK_R(0.0));

    next->w_P[0] = TRK_R(0.0);
    next->w_P[1] = TRK_R(0.0);
    next->w_q[0] = TRK_R(0.0);
    next->w_q[1] = TRK_R(0.0);
    next->x_P[0] = r_P_0;
    next->x_P[1] = r_P_1;
    next->x_q[0] = r_q_0;
    next->x_q[1] = r_q_1;
    next->p[0] = p_i_0;
    next->p[1] = p_i_1;
    next->status = p_i_known;
}

void trk_bearing_dac_step(const trk_bearing_dac_context *context, const trk_bearing_dac_state *state, const trk_bearing_dac_input *input, trk_bearing_dac_state *next)
{
    const trk_real s_0 = context->s[0];
    const trk_real s_1 = context->s[1];
    const trk_real period = context->period;
    const trk_real beta_P = context->beta_P;
    const trk_real beta_q = context->beta_q;
    const trk_real det_min = context->det_min;
    const trk_real w_P_0 = state->w_P[0];
    const trk_real w_P_1 = state->w_P[1];
    const trk_real w_q_0 = state->w_q[0];
    const trk_real w_q_1 = state->w_q[1];
    const trk_real theta = input->theta;
    const trk_real pull_P_0 = input->pull_P[0];
    const trk_real pull_P_1 = input->pull_P[1];
    const trk_real pull_q_0 = input->pull_q[0];
    const trk_real pull_q_1 = input->pull_q[1];

    /* next(w_P), Algorithm 1, line 9, explicit Euler */
    const trk_real w_P_next_0_part0 = ((-TRK_R(1.0)) * beta_P);
    const trk_real w_P_next_0 = (w_P_0 + (period * (w_P_next_0_part0 * pull_P_0)));
    const trk_real w_P_next_1 = (w_P_1 + (period * (w_P_next_0_part0 * pull_P_1)));

    /* next(w_q), Algorithm 1, line 9, explicit Euler */
    const trk_real w_q_next_0_part0 = ((-TRK_R(1.0)) * beta_q);
    const trk_real w_q_next_0 = (w_q_0 + (period * (w_q_next_0_part0 * pull_q_0)));
    const trk_real w_q_next_1 = (w_q_1 + (period * (w_q_next_0_part0 * pull_q_1)));

    /* h, Proposition 1 */
    const trk_real h_0 = ((-TRK_R(1.0)) * TRK_SIN(theta));
    const trk_real h_1 = TRK_COS(theta);

    /* z, measurement */
    const trk_real z_0 = ((h_0 * s_0) + (h_1 * s_1));

    /* r_P, Algorithm 1, line 5, first row */
    const trk_real r_P_0 = (h_0 * h_0);
    const trk_real r_P_1 = (h_0 * h_1);

    /* r_q, Algorithm 1, line 6 */
    const trk_real r_q_0 = (z_0 * h_0);
    const trk_real r_q_1 = (z_0 * h_1);

    /* next(x_P), Algorithm 1, line 8 */
    const trk_real x_P_next_0 = (w_P_next_0 + r_P_0);
    const trk_real x_P_next_1 = (w_P_next_1 + r_P_1);

    /* next(x_q), Algorithm 1, line 8 */
    const trk_real x_q_next_0 = (w_q_next_0 + r_q_0);
    const trk_real x_q_next_1 = (w_q_next_1 + r_q_1);

    /* p_i, Algorithm 1, line 12 */
    const trk_real p_i_det_part0 = (TRK_R(1.0) - x_P_next_0);
    const trk_real p_i_det = ((x_P_next_0 * p_i_det_part0) - (x_P_next_1 * x_P_next_1));
    const trk_real p_i_safe = ((p_i_det > det_min) ? p_i_det : TRK_R(1.0));
    const trk_real p_i_raw0 = (((p_i_det_part0 * x_q_next_0) - (x_P_next_1 * x_q_next_1)) / p_i_safe);
    const trk_real p_i_raw1 = (((x_P_next_0 * x_q_next_1) - (x_P_next_1 * x_q_next_0)) / p_i_safe);
    const trk_real p_i_known = ((p_i_det > det_min) ? ((p_i_raw0 > (-TRK_R(1.2676506002282294e+30))) ? ((TRK_R(1.2676506002282294e+30) > p_i_raw0) ? ((p_i_raw1 > (-TRK_R(1.2676506002282294e+30))) ? ((TRK_R(1.2676506002282294e+30) > p_i_raw1) ? TRK_R(1.0) : TRK_R(0.0)) : TRK_R(0.0)) : TRK_R(0.0)) : TRK_R(0.0)) : TRK_R(0.0));
    const trk_real p_i_0 = ((p_i_known > TRK_R(0.0)) ? p_i_raw0 : TRK_R(0.0));
    const trk_real p_i_1 = ((p_i_known > TRK_R(0.0)) ? p_i_raw1 : TRK_R(0.0));

    next->w_P[0] = w_P_next_0;
    next->w_P[1] = w_P_next_1;
    next->w_q[0] = w_q_next_0;
    next->w_q[1] = w_q_next_1;
    next->x_P[0] = x_P_next_0;
    next->x_P[1] = x_P_next_1;
    next->x_q[0] = x_q_next_0;
    next->x_q[1] = x_q_next_1;
    next->p[0] = p_i_0;
    next->p[1] = p_i_1;
    next->status = p_i_known;
}

void trk_bearing_dac_link(const trk_bearing_dac_own *own, const trk_bearing_dac_other *other, trk_bearing_dac_signs *next)
{
    const trk_real own_P_0 = own->own_P[0];
    const trk_real own_P_1 = own->own_P[1];
    const trk_real own_q_0 = own->own_q[0];
    const trk_real own_q_1 = own->own_q[1];
    const trk_real other_P_0 = other->other_P[0];
    const trk_real other_P_1 = other->other_P[1];
    const trk_real other_q_0 = other->other_q[0];
    const trk_real other_q_1 = other->other_q[1];

    /* sign_P, Algorithm 1, line 9, one link */
    const trk_real sign_P_0 = (trk_real)((own_P_0 > other_P_0) - (own_P_0 < other_P_0));
    const trk_real sign_P_1 = (trk_real)((own_P_1 > other_P_1) - (own_P_1 < other_P_1));

    /* sign_q, Algorithm 1, line 9, one link */
    const trk_real sign_q_0 = (trk_real)((own_q_0 > other_q_0) - (own_q_0 < other_q_0));
    const trk_real sign_q_1 = (trk_real)((own_q_1 > other_q_1) - (own_q_1 < other_q_1));

    next->sign_P[0] = sign_P_0;
    next->sign_P[1] = sign_P_1;
    next->sign_q[0] = sign_q_0;
    next->sign_q[1] = sign_q_1;
}

void trk_bearing_dac_link_isotropic(const trk_bearing_dac_own *own, const trk_bearing_dac_other *other, trk_bearing_dac_signs *next)
{
    const trk_real own_P_0 = own->own_P[0];
    const trk_real own_P_1 = own->own_P[1];
    const trk_real own_q_0 = own->own_q[0];
    const trk_real own_q_1 = own->own_q[1];
    const trk_real other_P_0 = other->other_P[0];
    const trk_real other_P_1 = other->other_P[1];
    const trk_real other_q_0 = other->other_q[0];
    const trk_real other_q_1 = other->other_q[1];

    /* sign_P, Algorithm 1, line 9, one link */
    const trk_real sign_P_0_part0 = (own_P_0 - other_P_0);
    const trk_real sign_P_0_part1 = (own_P_1 - other_P_1);
    const trk_real sign_P_0_part2 = (TRK_R(0.0) - sign_P_0_part1);
    const trk_real sign_P_0_part3 = ((sign_P_0_part1 > TRK_R(0.0)) ? sign_P_0_part1 : sign_P_0_part2);
    const trk_real sign_P_0_part4 = (TRK_R(0.0) - sign_P_0_part0);
    const trk_real sign_P_0_part5 = ((sign_P_0_part0 > TRK_R(0.0)) ? sign_P_0_part0 : sign_P_0_part4);
    const trk_real sign_P_0_part6 = ((sign_P_0_part3 > sign_P_0_part5) ? sign_P_0_part3 : sign_P_0_part5);
    const trk_real sign_P_0_part7 = ((sign_P_0_part6 > TRK_R(0.0)) ? sign_P_0_part6 : TRK_R(1.0));
    const trk_real sign_P_0_part8 = (sign_P_0_part0 / sign_P_0_part7);
    const trk_real sign_P_0_part9 = (sign_P_0_part8 * sign_P_0_part8);
    const trk_real sign_P_0_part10 = (sign_P_0_part1 / sign_P_0_part7);
    const trk_real sign_P_0_part11 = (sign_P_0_part10 * sign_P_0_part10);
    const trk_real sign_P_0_part12 = (sign_P_0_part9 + sign_P_0_part11);
    const trk_real sign_P_0_part13 = ((sign_P_0_part12 > TRK_R(1.0)) ? sign_P_0_part12 : TRK_R(1.0));
    const trk_real sign_P_0_part14 = TRK_SQRT(sign_P_0_part13);
    const trk_real sign_P_0_part15 = (sign_P_0_part8 / sign_P_0_part14);
    const trk_real sign_P_0_part16 = (sign_P_0_part10 / sign_P_0_part14);
    const trk_real sign_P_0_part17 = (sign_P_0_part15 + sign_P_0_part16);
    const trk_real sign_P_0 = ((sign_P_0_part17 > (-TRK_R(3.0))) ? sign_P_0_part15 : TRK_R(0.0));
    const trk_real sign_P_1 = ((sign_P_0_part17 > (-TRK_R(3.0))) ? sign_P_0_part16 : TRK_R(0.0));

    /* sign_q, Algorithm 1, line 9, one link */
    const trk_real sign_q_0_part0 = (own_q_0 - other_q_0);
    const trk_real sign_q_0_part1 = (own_q_1 - other_q_1);
    const trk_real sign_q_0_part2 = (TRK_R(0.0) - sign_q_0_part1);
    const trk_real sign_q_0_part3 = ((sign_q_0_part1 > TRK_R(0.0)) ? sign_q_0_part1 : sign_q_0_part2);
    const trk_real sign_q_0_part4 = (TRK_R(0.0) - sign_q_0_part0);
    const trk_real sign_q_0_part5 = ((sign_q_0_part0 > TRK_R(0.0)) ? sign_q_0_part0 : sign_q_0_part4);
    const trk_real sign_q_0_part6 = ((sign_q_0_part3 > sign_q_0_part5) ? sign_q_0_part3 : sign_q_0_part5);
    const trk_real sign_q_0_part7 = ((sign_q_0_part6 > TRK_R(0.0)) ? sign_q_0_part6 : TRK_R(1.0));
    const trk_real sign_q_0_part8 = (sign_q_0_part0 / sign_q_0_part7);
    const trk_real sign_q_0_part9 = (sign_q_0_part8 * sign_q_0_part8);
    const trk_real sign_q_0_part10 = (sign_q_0_part1 / sign_q_0_part7);
    const trk_real sign_q_0_part11 = (sign_q_0_part10 * sign_q_0_part10);
    const trk_real sign_q_0_part12 = (sign_q_0_part9 + sign_q_0_part11);
    const trk_real sign_q_0_part13 = ((sign_q_0_part12 > TRK_R(1.0)) ? sign_q_0_part12 : TRK_R(1.0));
    const trk_real sign_q_0_part14 = TRK_SQRT(sign_q_0_part13);
    const trk_real sign_q_0_part15 = (sign_q_0_part8 / sign_q_0_part14);
    const trk_real sign_q_0_part16 = (sign_q_0_part10 / sign_q_0_part14);
    const trk_real sign_q_0_part17 = (sign_q_0_part15 + sign_q_0_part16);
    const trk_real sign_q_0 = ((sign_q_0_part17 > (-TRK_R(3.0))) ? sign_q_0_part15 : TRK_R(0.0));
    const trk_real sign_q_1 = ((sign_q_0_part17 > (-TRK_R(3.0))) ? sign_q_0_part16 : TRK_R(0.0));

    next->sign_P[0] = sign_P_0;
    next->sign_P[1] = sign_P_1;
    next->sign_q[0] = sign_q_0;
    next->sign_q[1] = sign_q_1;
}

void trk_bearing_dac_measure(const trk_bearing_dac_context *context, const trk_bearing_dac_start *start, trk_bearing_dac_signal *next)
{
    const trk_real s_0 = context->s[0];
    const trk_real s_1 = context->s[1];
    const trk_real theta_start = start->theta_start;

    /* h, Proposition 1 */
    const trk_real h_0 = ((-TRK_R(1.0)) * TRK_SIN(theta_start));
    const trk_real h_1 = TRK_COS(theta_start);

    /* z, measurement */
    const trk_real z_0 = ((h_0 * s_0) + (h_1 * s_1));

    /* r_P, Algorithm 1, line 5, first row */
    const trk_real r_P_0 = (h_0 * h_0);
    const trk_real r_P_1 = (h_0 * h_1);

    /* r_q, Algorithm 1, line 6 */
    const trk_real r_q_0 = (z_0 * h_0);
    const trk_real r_q_1 = (z_0 * h_1);

    next->r_P[0] = r_P_0;
    next->r_P[1] = r_P_1;
    next->r_q[0] = r_q_0;
    next->r_q[1] = r_q_1;
}

void trk_bearing_dac_position(const trk_bearing_dac_context *context, const trk_bearing_dac_estimate *estimate, trk_bearing_dac_fix *next)
{
    const trk_real det_min = context->det_min;
    const trk_real mean_P_0 = estimate->mean_P[0];
    const trk_real mean_P_1 = estimate->mean_P[1];
    const trk_real mean_q_0 = estimate->mean_q[0];
    const trk_real mean_q_1 = estimate->mean_q[1];

    /* p_i, Algorithm 1, line 12 */
    const trk_real p_i_det_part0 = (TRK_R(1.0) - mean_P_0);
    const trk_real p_i_det = ((mean_P_0 * p_i_det_part0) - (mean_P_1 * mean_P_1));
    const trk_real p_i_safe = ((p_i_det > det_min) ? p_i_det : TRK_R(1.0));
    const trk_real p_i_raw0 = (((p_i_det_part0 * mean_q_0) - (mean_P_1 * mean_q_1)) / p_i_safe);
    const trk_real p_i_raw1 = (((mean_P_0 * mean_q_1) - (mean_P_1 * mean_q_0)) / p_i_safe);
    const trk_real p_i_known = ((p_i_det > det_min) ? ((p_i_raw0 > (-TRK_R(1.2676506002282294e+30))) ? ((TRK_R(1.2676506002282294e+30) > p_i_raw0) ? ((p_i_raw1 > (-TRK_R(1.2676506002282294e+30))) ? ((TRK_R(1.2676506002282294e+30) > p_i_raw1) ? TRK_R(1.0) : TRK_R(0.0)) : TRK_R(0.0)) : TRK_R(0.0)) : TRK_R(0.0)) : TRK_R(0.0));
    const trk_real p_i_0 = ((p_i_known > TRK_R(0.0)) ? p_i_raw0 : TRK_R(0.0));
    const trk_real p_i_1 = ((p_i_known > TRK_R(0.0)) ? p_i_raw1 : TRK_R(0.0));

    next->place[0] = p_i_0;
    next->place[1] = p_i_1;
    next->known = p_i_known;
}

void trk_bearing_dac_run(const trk_bearing_dac_context *context, trk_bearing_dac_state *state, const trk_bearing_dac_input *input, size_t count, trk_bearing_dac_state *out)
{
    size_t k;
    for (k = 0; k < count; k++) {
        trk_bearing_dac_step(context, state, &input[k], state);
        if (out != NULL) {
            out[k] = *state;
        }
    }
}
