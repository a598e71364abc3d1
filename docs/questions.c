/* Four questions: a quarter car, an isolator seen from the ground, a free decay test, and a damper for a given amplitude. */
#include <denhartog.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static void need(int status) {
    if (status == DH_OK) return;
    fprintf(stderr, "%s: %s\n", dh_status_text(status), dh_last_message());
    exit(EXIT_FAILURE);
}

static dh_system* system_of(const char* scene) {
    dh_system* system;
    need(dh_system_from_json(scene, strlen(scene), &system));
    return system;
}

/* How far a mass moves over what the ground does, at omega and with friction F for a load P. */
static double transmissibility(const char* scene, double m_1, double k_1, double omega, double F, double P, size_t mass) {
    dh_system* system = system_of(scene);
    dh_solution* solution;
    dh_mass of = {.size = sizeof of};
    double T;
    need(dh_solve(system, omega * sqrt(m_1 / k_1), F / P, 1, 0, &solution));
    need(dh_solution_from_ground(solution, mass, &of, &T, NULL));
    dh_solution_destroy(solution);
    dh_system_destroy(system);
    return T;
}

int main(void) {
    const double pi = 3.14159265358979323846;
    const char* car = "{\"masses\": [40, 320], \"stiffnesses\": [200000, 20000], \"contact\": [2, 1], \"base_motion\": \"alone\","
                      " \"damping_matrix\": [[1500, -1500], [-1500, 1500]]}";
    printf("the body moves %.4f times as far as the road\n", transmissibility(car, 40, 200000, 2 * pi * 1.5, 60, 200000 * 0.01, 2));

    const char* isolator = "{\"masses\": [80], \"stiffnesses\": [31000], \"damping_ratios\": 0.08, \"contact\": 1,"
                           " \"base_motion\": \"with_wall\"}";
    printf("the machine moves %.4f times as far as the floor\n", transmissibility(isolator, 80, 31000, 2 * pi * 8, 6, 80 * 0.5, 1));

    /* Displacements in metres: P is k_1 times one metre. Two half-cycles give damping and friction of the carriage. */
    dh_system* carriage = system_of("{\"masses\": [12.5], \"stiffnesses\": [4500], \"damping_ratios\": 0.02, \"contact\": 1, \"load\": 1}");
    const double start = 0.02;
    double turn[16];
    const dh_decay_request request = {.size = sizeof request, .r = 1, .beta = 3.5 / 4500, .mu = 1, .x = &start};
    dh_decay decay = {.size = sizeof decay, .room = 16, .turn_x = turn};
    need(dh_free_decay(carriage, &request, &decay));
    const double a = start, b = fabs(turn[0]), c = fabs(turn[1]), q = (b - c) / (a - b), log_q = log(1 / q) / pi;
    printf("damping ratio %.4f, friction %.4f N\n", log_q / sqrt(1 + log_q * log_q), 4500 * (q * a - b) / (1 + q));
    dh_system_destroy(carriage);

    const char* tower = "{\"masses\": [10, 5], \"stiffnesses\": [4000, 3000], \"damping_ratios\": [0.02, 0.03], \"contact\": 1,"
                        " \"load\": 2, \"force\": 100, \"friction\": 20, \"frequency_hz\": 2.5}";
    double at[4];
    const dh_find_request wanted = {.size = sizeof wanted, .scene = tower, .scene_length = strlen(tower), .vary = "friction",
                                    .from = 0, .to = 100, .so_that = "amplitude of mass 2 = 0.3", .samples = 128};
    dh_places places = {.size = sizeof places, .room = 4, .at = at};
    need(dh_find(&wanted, &places));
    for (size_t n = 0; n < places.count; ++n) printf("mass 2 moves by 300 mm with a damper of %.4f N\n", at[n]);
    return 0;
}
