#ifndef DENHARTOG_H
#define DENHARTOG_H
#include <stddef.h>
#if defined(__GNUC__)
#define DH_EXPORT __attribute__((visibility("default")))
#else
#define DH_EXPORT
#endif
#define DH_ABI_VERSION 0
#define DH_MOST_MASSES 1000
#define DH_MOST_SAMPLES 10000000
#define DH_MOST_DISPLACEMENTS 100000000
#ifdef __cplusplus
#define DH_NOEXCEPT noexcept
extern "C" {
#else
#define DH_NOEXCEPT
#endif
enum dh_status {
    DH_OK = 0,
    DH_ERROR_NULL = 1,
    DH_ERROR_SIZE = 2,
    DH_ERROR_INPUT = 3,
    DH_ERROR_DOMAIN = 4,
    DH_ERROR_PRECISION = 5,
    DH_ERROR_MEMORY = 6,
    DH_ERROR_INTERNAL = 7
};
enum dh_regime {
    DH_CONTINUOUS = 0,
    DH_STICK_SLIP = 1,
    DH_PERMANENT_STICKING = 2
};
typedef struct dh_system dh_system;
typedef struct dh_solution dh_solution;
typedef struct dh_boundary {
    size_t size;
    double exact;
    double paper;
    double approximate;
    double sticking;
    int sticking_exists;
} dh_boundary;
typedef struct dh_sliding_mass {
    size_t size;
    double initial_displacement;
    double initial_velocity;
    double amplitude;
    double phase;
    double instant;
    double amplitude_monoharmonic;
    double phase_monoharmonic;
} dh_sliding_mass;
typedef struct dh_summary {
    size_t size;
    int regime;
    int on_boundary;
    int unique;
    int symmetric;
    int periods;
    int rest_interval_exists;
    size_t stops;
    double rest_from;
    double rest_to;
    double rest_error;
    double relative_error;
} dh_summary;
typedef struct dh_mass {
    size_t size;
    double amplitude;
    double error;
    double phase;
    double phase_error;
    int moves;
} dh_mass;
typedef struct dh_energies {
    size_t size;
    double contact;
    double dampers;
    double friction;
    double on_base;
    double equivalent_damping;
    double equivalent_damping_ratio;
    double textbook_contact;
    double textbook_contact_off;
    double textbook_amplitude;
    double textbook_amplitude_off;
    int contact_moves;
    int textbook_amplitude_exists;
} dh_energies;
DH_EXPORT const char* dh_version(void) DH_NOEXCEPT;
DH_EXPORT int dh_abi_version(void) DH_NOEXCEPT;
DH_EXPORT const char* dh_status_text(int status) DH_NOEXCEPT;
DH_EXPORT const char* dh_last_message(void) DH_NOEXCEPT;
DH_EXPORT int dh_system_from_ratios(size_t N, const double* mass_ratios, const double* stiffness_ratios,
                                    const double* damping_ratios, size_t contact, size_t load, dh_system** system) DH_NOEXCEPT;
DH_EXPORT int dh_system_from_json(const char* text, size_t length, dh_system** system) DH_NOEXCEPT;
DH_EXPORT void dh_system_destroy(dh_system* system) DH_NOEXCEPT;
DH_EXPORT int dh_system_masses(const dh_system* system, size_t* N, size_t* contact, size_t* load) DH_NOEXCEPT;
DH_EXPORT int dh_natural_frequency_ratios(const dh_system* system, size_t count, double* r_n, double* zeta) DH_NOEXCEPT;
DH_EXPORT int dh_natural_frequency_ratio_errors(const dh_system* system, size_t count, double* r_n_error,
                                                double* zeta_error) DH_NOEXCEPT;
DH_EXPORT int dh_mode_shapes(const dh_system* system, double r, size_t count, double* psi) DH_NOEXCEPT;
DH_EXPORT int dh_mode_shape_errors(const dh_system* system, double r, size_t count, double* psi_error) DH_NOEXCEPT;
DH_EXPORT int dh_modal_functions(const dh_system* system, double r, size_t count, double* R, double* v, double* u,
                                 double* g) DH_NOEXCEPT;
DH_EXPORT int dh_modal_function_errors(const dh_system* system, double r, size_t count, double* R_error, double* v_error,
                                       double* u_error, double* g_error) DH_NOEXCEPT;
DH_EXPORT int dh_sums(const dh_system* system, double r, size_t count, double* V, double* U, double* G, double* H_j,
                      double* S_j) DH_NOEXCEPT;
DH_EXPORT int dh_sum_errors(const dh_system* system, double r, size_t count, double* V_error, double* U_error, double* G_error,
                            double* H_j_error, double* S_j_error) DH_NOEXCEPT;
DH_EXPORT int dh_boundaries(const dh_system* system, double r, double mu, dh_boundary* boundary) DH_NOEXCEPT;
DH_EXPORT int dh_boundary_errors(const dh_system* system, double r, double mu, dh_boundary* errors) DH_NOEXCEPT;
DH_EXPORT int dh_boundaries_proved(const dh_system* system, double r, double mu, dh_boundary* boundary,
                                   dh_boundary* errors) DH_NOEXCEPT;
DH_EXPORT int dh_high_frequency_limit(const dh_system* system, double mu, double* beta_lim) DH_NOEXCEPT;
DH_EXPORT int dh_high_frequency_limit_error(const dh_system* system, double mu, double* error) DH_NOEXCEPT;
DH_EXPORT int dh_sliding_motion(const dh_system* system, double r, double beta, double mu, size_t mass,
                                dh_sliding_mass* result) DH_NOEXCEPT;
DH_EXPORT int dh_sliding_motion_errors(const dh_system* system, double r, double beta, double mu, size_t mass,
                                       dh_sliding_mass* errors) DH_NOEXCEPT;
DH_EXPORT int dh_displacement(const dh_system* system, double r, double beta, double mu, size_t mass, size_t count,
                              const double* tau, double* x) DH_NOEXCEPT;
DH_EXPORT int dh_displacement_errors(const dh_system* system, double r, double beta, double mu, size_t mass, size_t count,
                                     const double* tau, double* x_error) DH_NOEXCEPT;
typedef int (*dh_cancelled)(void* context);
DH_EXPORT int dh_set_effort(double operations, dh_cancelled cancelled, void* context) DH_NOEXCEPT;
DH_EXPORT int dh_solve(const dh_system* system, double r, double beta, double mu, int digits, dh_solution** solution) DH_NOEXCEPT;
DH_EXPORT int dh_solve_proved(const dh_system* system, double r, double beta, double mu, int digits,
                              dh_solution** solution) DH_NOEXCEPT;
DH_EXPORT void dh_solution_destroy(dh_solution* solution) DH_NOEXCEPT;
DH_EXPORT int dh_solution_summary(const dh_solution* solution, dh_summary* summary) DH_NOEXCEPT;
DH_EXPORT int dh_solution_is_proved(const dh_solution* solution, int* proved) DH_NOEXCEPT;
DH_EXPORT int dh_solution_is_from_rest(const dh_solution* solution, int* from_rest) DH_NOEXCEPT;
DH_EXPORT int dh_solution_warning(const dh_solution* solution, size_t room, char* text) DH_NOEXCEPT;
DH_EXPORT int dh_solution_mass(const dh_solution* solution, size_t mass, dh_mass* result) DH_NOEXCEPT;
DH_EXPORT int dh_solution_from_ground(const dh_solution* solution, size_t mass, dh_mass* result, double* transmissibility,
                                      double* transmissibility_error) DH_NOEXCEPT;
DH_EXPORT int dh_solution_energies(const dh_solution* solution, int digits, dh_energies* energies,
                                   dh_energies* errors) DH_NOEXCEPT;
DH_EXPORT int dh_solution_contact(const dh_solution* solution, dh_mass* result) DH_NOEXCEPT;
DH_EXPORT int dh_solution_stops(const dh_solution* solution, size_t count, double* start, double* end) DH_NOEXCEPT;
DH_EXPORT int dh_solution_stop_errors(const dh_solution* solution, size_t count, double* start_error,
                                      double* end_error) DH_NOEXCEPT;
DH_EXPORT int dh_solution_motion(const dh_solution* solution, size_t samples, size_t count, double* x,
                                 double* x_prime) DH_NOEXCEPT;
enum dh_point_status {
    DH_POINT_ANSWERED = 0,
    DH_POINT_ON_BOUNDARY = 1,
    DH_POINT_NOT_CONVERGED = 2,
    DH_POINT_AT_A_POLE = 3,
    DH_POINT_FAILED = 4
};
typedef int (*dh_progress)(size_t done, size_t all, void* context);
typedef struct dh_map_request {
    size_t size;
    size_t r_count;
    const double* r;
    size_t beta_count;
    const double* beta;
    double mu;
    int from_sliding;
    size_t mass_count;
    const size_t* masses;
    unsigned threads;
    dh_progress progress;
    void* context;
    int from_ground;
} dh_map_request;
typedef struct dh_map_result {
    size_t size;
    ptrdiff_t r_step;
    ptrdiff_t beta_step;
    signed char* status;
    signed char* regime;
    int* stops;
    int* periods;
    ptrdiff_t amplitude_r_step;
    ptrdiff_t amplitude_beta_step;
    ptrdiff_t mass_step;
    double* amplitude;
    double* phase;
} dh_map_result;
DH_EXPORT int dh_map(const dh_system* system, const dh_map_request* request, const dh_map_result* result) DH_NOEXCEPT;
typedef struct dh_points_request {
    size_t size;
    size_t count;
    const double* r;
    ptrdiff_t r_step;
    const double* beta;
    ptrdiff_t beta_step;
    double mu;
    int digits;
    size_t mass_count;
    const size_t* masses;
    unsigned threads;
    dh_progress progress;
    void* context;
    int from_ground;
} dh_points_request;
typedef struct dh_points {
    size_t size;
    ptrdiff_t step;
    signed char* status;
    signed char* regime;
    int* stops;
    int* periods;
    ptrdiff_t masses_step;
    ptrdiff_t mass_step;
    double* amplitude;
    double* error;
    double* phase;
    double* phase_error;
} dh_points;
DH_EXPORT int dh_solve_points(const dh_system* system, const dh_points_request* request, const dh_points* points) DH_NOEXCEPT;
typedef struct dh_systems_request {
    size_t size;
    size_t count;
    const dh_system* const* systems;
    ptrdiff_t system_step;
    const double* r;
    ptrdiff_t r_step;
    const double* beta;
    ptrdiff_t beta_step;
    const double* mu;
    ptrdiff_t mu_step;
    int digits;
    size_t mass_count;
    const size_t* masses;
    unsigned threads;
    dh_progress progress;
    void* context;
    int from_ground;
} dh_systems_request;
DH_EXPORT int dh_solve_systems(const dh_systems_request* request, const dh_points* points) DH_NOEXCEPT;
enum dh_place_kind {
    DH_CROSSING = 0,
    DH_JUMP = 1,
    DH_UNDECIDED = 2,
    DH_EXTREME = 3,
    DH_END_OF_INTERVAL = 4
};
typedef struct dh_find_request {
    size_t size;
    const char* scene;
    size_t scene_length;
    const char* vary;
    double from;
    double to;
    const char* so_that;
    int samples;
} dh_find_request;
typedef struct dh_places {
    size_t size;
    size_t room;
    double* at;
    double* from;
    double* to;
    double* amplitude;
    double* error;
    int* is;
    size_t count;
    size_t unanswered;
} dh_places;
DH_EXPORT int dh_find(const dh_find_request* request, dh_places* places) DH_NOEXCEPT;
DH_EXPORT int dh_place_of_rest(const dh_system* system, size_t count, double* x, double* x_error) DH_NOEXCEPT;
enum dh_others {
    DH_COME_TO_REST = 0,
    DH_VIBRATE = 1,
    DH_NOT_KNOWN = 2
};
typedef struct dh_decay_request {
    size_t size;
    double r;
    double beta;
    double mu;
    const double* x;
    const double* x_prime;
    double until;
} dh_decay_request;
typedef struct dh_decay {
    size_t size;
    size_t room;
    double* turn;
    double* turn_error;
    double* turn_x;
    double* turn_x_error;
    double* start;
    double* start_error;
    double* end;
    double* end_error;
    double* stop_x;
    double* stop_x_error;
    double* masses;
    double* masses_error;
    double* rest;
    double* rest_error;
    size_t turns;
    size_t stops;
    int at_rest;
    int others;
    int on_limit;
} dh_decay;
DH_EXPORT int dh_free_decay(const dh_system* system, const dh_decay_request* request, dh_decay* decay) DH_NOEXCEPT;
typedef struct dh_history_request {
    size_t size;
    double r;
    double beta;
    double mu;
    const double* x;
    const double* x_prime;
    int cycles;
    int last;
    int samples;
    int without_load;
} dh_history_request;
typedef struct dh_history {
    size_t size;
    size_t stop_room;
    size_t sample_room;
    double* start;
    double* end;
    double* stop_x;
    double* tau;
    double* x;
    double* x_prime;
    signed char* direction;
    size_t stops;
    size_t samples;
    double from;
} dh_history;
DH_EXPORT int dh_follow(const dh_system* system, const dh_history_request* request, dh_history* history) DH_NOEXCEPT;
DH_EXPORT int dh_quantity(const dh_system* system, const char* name, double r, double beta, double mu, size_t mass, double tau,
                          size_t size, double* values, size_t* count) DH_NOEXCEPT;
DH_EXPORT int dh_quantity_errors(const dh_system* system, const char* name, double r, double beta, double mu, size_t mass,
                                 double tau, size_t size, double* errors, size_t* count) DH_NOEXCEPT;
#ifdef __cplusplus
}
#endif
#endif
