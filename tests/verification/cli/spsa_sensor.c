/* The loop of a sensor that follows two targets in turn: measurements in, estimates out. */
#include "cyclic_spsa.h"
#include <stdio.h>

int main(void)
{
    trk_cyclic_spsa_context with = {{0.5, 0.0, 0.5}, 0.25, 2.0};
    trk_cyclic_spsa_state now[2];
    trk_cyclic_spsa_sender sender[2] = {{0.0, 0.0, 1.0}, {40.0, -3.0, 1.0}};
    trk_cyclic_spsa_cost early = {0.0}, late = {0.0};
    double delta[4];
    int sample;
    for (sample = 0; sample < 2; sample++)
        if (scanf("%lf %lf", &now[sample].theta_hat[0], &now[sample].theta_hat[1]) != 2)
            return 1;
    for (sample = 0;; sample++) {
        const int i = sample / 2 % 2;
        trk_cyclic_spsa_measurement seen;
        trk_cyclic_spsa_place place;
        if (sample % 4 == 0)
            if (scanf("%lf %lf %lf %lf", delta, delta + 1, delta + 2, delta + 3) != 4)
                return 0;
        if (scanf("%lf %lf", &seen.z_1, &seen.z_2) != 2)
            return 1;
        trk_cyclic_spsa_position(&sender[i], &seen, &place);
        if (sample % 2 == 0) {
            trk_cyclic_spsa_minus at = {{delta[2 * i], delta[2 * i + 1]}, {place.p_0, place.p_1}};
            trk_cyclic_spsa_first_cost(&with, &now[i], &at, &early);
        } else {
            trk_cyclic_spsa_plus at = {{delta[2 * i], delta[2 * i + 1]}, {place.p_0, place.p_1}};
            trk_cyclic_spsa_costs both = {{delta[2 * i], delta[2 * i + 1]}, 0.0, 0.0};
            trk_cyclic_spsa_second_cost(&with, &now[i], &at, &late);
            both.y_minus = early.y;
            both.y_plus = late.y;
            trk_cyclic_spsa_update(&with, &now[i], &both, &now[i]);
            printf("%.17g %.17g\n", now[i].theta_hat[0], now[i].theta_hat[1]);
        }
    }
}
