/// @file
/// @brief The library from C, and from any language that calls C: opaque handles, codes in place of exceptions, a stable ABI.
///
/// The header is C99 and C++. Masses and modes count from 1, and modes are in the order of ascending natural frequency.
/// Displacements are in units of P / k_1 and angles in radians. docs/c-interface.md has an example and the conventions.
///
/// Every function that can fail returns a status, #DH_OK or one of the others. dh_last_message() has the text of the calling
/// thread's last fault. A call that fails writes no output. No exception leaves a function, and every number that it returns is
/// finite. A handle does not change after it is made, so any number of threads may use it at the same time; one of them destroys
/// it when all are done. Each thread has its own last fault and its own limits from dh_set_effort(); the interface keeps nothing
/// else. No call runs without end, because its work is counted; see dh_set_effort().
///
/// Every number has a bound of its error: in a member beside it, or from a function of the same name that ends in `_error` or
/// `_errors`. Where no error can be bounded the bound is `DBL_MAX`. Bounds are estimates, unless you ask for a proof by
/// dh_solve_proved() or dh_boundaries_proved(). The numbers of dh_map() and dh_solution_motion() come without
/// bounds; the digits that they have stand there.
///
/// A struct that may grow has its size as its first member. The caller sets it to `sizeof` before the call, and the call writes
/// no more than that many bytes. As long as the number in the name of the shared library stays the same, names are added but
/// never changed or taken away.
#ifndef DENHARTOG_H
#define DENHARTOG_H

#include <stddef.h>

/// @brief Marks what the shared library exports.
#if defined(__GNUC__)
#define DH_EXPORT __attribute__((visibility("default")))
#else
#define DH_EXPORT
#endif

/// @brief Version of the ABI that this header describes; compare it with dh_abi_version().
#define DH_ABI_VERSION 0

/// @brief The largest number of masses in a system. The eigenproblem is dense: with that many masses a boundary takes about a
/// second and 60 megabytes in double. A motion with stops takes far longer.
#define DH_MOST_MASSES 1000

/// @brief The largest number of instants in one call for a motion.
#define DH_MOST_SAMPLES 10000000

/// @brief The largest number of displacements in one answer: instants times masses.
#define DH_MOST_DISPLACEMENTS 100000000

/// @brief Tells C++ that no exception leaves a function.
#ifdef __cplusplus
#define DH_NOEXCEPT noexcept
extern "C" {
#else
#define DH_NOEXCEPT
#endif

/// @brief Status of a call.
enum dh_status {
    DH_OK = 0,              ///< done
    DH_ERROR_NULL = 1,      ///< a pointer that is needed is null
    DH_ERROR_SIZE = 2,      ///< an array or a struct has the wrong size, or a size beyond a limit
    DH_ERROR_INPUT = 3,     ///< a number or a text breaks a rule; the message names quantity, rule and value
    DH_ERROR_DOMAIN = 4,    ///< a formula was asked for where it does not hold, e.g. the sliding motion where the contact sticks
    DH_ERROR_PRECISION = 5, ///< the digits asked for were not reached, or a result is no finite double
    DH_ERROR_MEMORY = 6,    ///< there is not enough memory
    DH_ERROR_INTERNAL = 7   ///< anything else: a defect of the library
};

/// @brief Regime: the motion of the contact in the steady state.
enum dh_regime {
    DH_CONTINUOUS = 0,        ///< it slides throughout, except at its two turning points in each period
    DH_STICK_SLIP = 1,        ///< it moves, and rests for a part of every period
    DH_PERMANENT_STICKING = 2 ///< it rests
};

/// @brief A system prepared for many points: masses, springs, damping, contact and load.
typedef struct dh_system dh_system;

/// @brief The steady motion at one point.
typedef struct dh_solution dh_solution;

/// @brief The friction ratios between the regimes at one frequency ratio.
typedef struct dh_boundary {
    size_t size;         ///< sizeof(dh_boundary), set by the caller
    double exact;        ///< beta_lim, Eq. (69), with the maximum over tau of the sum over modes
    double paper;        ///< (69) with (56): the sum of the maxima of the modes; never above `exact`
    double approximate;  ///< (67); never below `exact`
    double sticking;     ///< smallest beta at which the contact never moves; 0 if there is none
    int sticking_exists; ///< 0 if no friction holds the contact, because the system with a held contact resonates
} dh_boundary;

/// @brief Motion of a mass while the contact slides throughout, by the closed form. tau = 0 is the maximum of the contact.
typedef struct dh_sliding_mass {
    size_t size;                   ///< sizeof(dh_sliding_mass), set by the caller
    double initial_displacement;   ///< x_k at tau = 0, Eq. (44) as corrected
    double initial_velocity;       ///< d x_k / d tau at tau = 0, Eq. (45) as corrected
    double amplitude;              ///< largest displacement; of the contact by Eq. (38)
    double phase;                  ///< its lag behind the force, Eqs. (39), (47), in (-pi, pi]
    double instant;                ///< tau in [0, pi] where the displacement is largest in size
    double amplitude_monoharmonic; ///< Eq. (52) as corrected
    double phase_monoharmonic;     ///< phi_j + phi_kj, Eq. (53), in (-pi, pi]
} dh_sliding_mass;

/// @brief A steady motion as a whole.
typedef struct dh_summary {
    size_t size;              ///< sizeof(dh_summary), set by the caller
    int regime;               ///< one of enum dh_regime
    int on_boundary;          ///< 1 if beta lies on a boundary to within its error, so that the neighbouring regime is possible
    int unique;               ///< 1 if the steady velocities are known not to depend on the start
    int symmetric;            ///< 1 if the motion mirrors itself after half its period, Eq. (25)
    int periods;              ///< period of the motion in periods of the force
    int rest_interval_exists; ///< 1 in permanent sticking
    size_t stops;             ///< rests of the contact of positive length within the period of the motion
    double rest_from;         ///< lower end of the interval in which the contact may rest for ever; 0 if there is none
    double rest_to;           ///< upper end
    double rest_error;        ///< bound of the error of the ends
    double relative_error;    ///< the largest error of the amplitudes, relative, and of the phases, before rounding to double
} dh_summary;

/// @brief Motion of a mass in the steady state, in any regime.
typedef struct dh_mass {
    size_t size;        ///< sizeof(dh_mass), set by the caller
    double amplitude;   ///< largest displacement; in permanent sticking with the contact at zero
    double error;       ///< bound of the error of the displacements
    double phase;       ///< lag of the largest displacement behind the force, in (-pi, pi]; 0 where the mass does not move
    double phase_error; ///< bound of the error of the phase
    int moves;          ///< 0 where the mass does not move and has no phase
} dh_mass;

/// @brief Energy that a steady motion dissipates in a period of the force, and the forces that it hands over. Where the contact
/// does not move the members from `equivalent_damping` on are 0.
typedef struct dh_energies {
    size_t size;                        ///< sizeof(dh_energies), set by the caller
    double contact;                     ///< energy that friction dissipates, units of P^2 / k_1
    double dampers;                     ///< energy that the dampers dissipate, units of P^2 / k_1
    double friction;                    ///< largest friction force, units of P
    double on_base;                     ///< largest force of springs and dampers on the base, without a constant load; units of P
    double equivalent_damping;          ///< c = W / (pi omega X^2) with the contact's energy W and amplitude X; units of sqrt(k_1 m_1)
    double equivalent_damping_ratio;    ///< c / (2 sqrt(k_1 m_1))
    double textbook_contact;            ///< 4 F X, units of P^2 / k_1
    double textbook_contact_off;        ///< by what part of `contact` it is off
    double textbook_amplitude;          ///< X by a dashpot 4 F / (pi omega X) in place of friction, units of P / k_1
    double textbook_amplitude_off;      ///< by what part of the amplitude it is off
    int contact_moves;                  ///< 0 where the contact does not move
    int textbook_amplitude_exists;      ///< 0 where friction is too large for that formula
} dh_energies;

/// @brief Version of the library. @return a text such as `0.2.0`, valid for ever
DH_EXPORT const char* dh_version(void) DH_NOEXCEPT;

/// @brief Version of the ABI that the library has. @return #DH_ABI_VERSION of the header it was built with
DH_EXPORT int dh_abi_version(void) DH_NOEXCEPT;

/// @brief A status in words. @param status what a function returned @return a text, valid for ever
DH_EXPORT const char* dh_status_text(int status) DH_NOEXCEPT;

/// @brief Last fault of the calling thread: quantity, rule and value.
/// @return a text, empty before any fault; it is valid until this thread's next fault
DH_EXPORT const char* dh_last_message(void) DH_NOEXCEPT;

/// @brief A chain of N masses from ratios. Each ratio is taken as exactly the double that you give, in every precision.
/// @param N                 number of masses, from 1 to #DH_MOST_MASSES
/// @param mass_ratios       m_i / m_1, Eq. (9), N values, positive, the first 1
/// @param stiffness_ratios  k_i / k_1, Eq. (73), N values, positive, the first 1
/// @param damping_ratios    zeta_i by ascending natural frequency, Eq. (18), N values, not negative
/// @param contact           the mass in contact, j, from 1 to N
/// @param load              the loaded mass, l, from 1 to N
/// @param system            receives the handle; to be destroyed by dh_system_destroy()
/// @return                  #DH_OK, #DH_ERROR_NULL, #DH_ERROR_SIZE, #DH_ERROR_INPUT, #DH_ERROR_PRECISION, #DH_ERROR_MEMORY
DH_EXPORT int dh_system_from_ratios(size_t N, const double* mass_ratios, const double* stiffness_ratios,
                                    const double* damping_ratios, size_t contact, size_t load, dh_system** system) DH_NOEXCEPT;

/// @brief A system from the text of a scene in JSON, see docs/scene.schema.json; matrices and dimensional scenes as well.
///
/// The scene's r, beta and mu are checked but not used, because every call has its own point.
/// @param text    UTF-8
/// @param length  its length in bytes, without an ending zero
/// @param system  receives the handle; to be destroyed by dh_system_destroy()
/// @return        the same as dh_system_from_ratios()
DH_EXPORT int dh_system_from_json(const char* text, size_t length, dh_system** system) DH_NOEXCEPT;

/// @brief Destroys a system. Solutions made from it stay valid. @param system a handle, or null
DH_EXPORT void dh_system_destroy(dh_system* system) DH_NOEXCEPT;

/// @brief Number of masses, contact and load.
/// @param system   a system
/// @param N        receives the number of masses
/// @param contact  receives j, from 1; if two masses rub against each other, the first of them; may be null
/// @param load     receives l, from 1; if several masses are loaded, one of them; may be null
/// @return         #DH_OK, #DH_ERROR_NULL
DH_EXPORT int dh_system_masses(const dh_system* system, size_t* N, size_t* contact, size_t* load) DH_NOEXCEPT;

/// @brief Natural frequency ratios omega_i sqrt(m_1 / k_1), ascending, and modal damping ratios; to at least 6 digits.
/// @param system  a system
/// @param count   N
/// @param r_n     receives N frequency ratios
/// @param zeta    receives N damping ratios; may be null
/// @return        #DH_OK, #DH_ERROR_NULL, #DH_ERROR_SIZE
DH_EXPORT int dh_natural_frequency_ratios(const dh_system* system, size_t count, double* r_n, double* zeta) DH_NOEXCEPT;

/// @brief Bounds of the errors of these numbers.
/// @param system,count  as for dh_natural_frequency_ratios()
/// @param r_n_error     receives N bounds, of the frequency ratios
/// @param zeta_error    receives N bounds, of the damping ratios; may be null
/// @return              as dh_natural_frequency_ratios()
DH_EXPORT int dh_natural_frequency_ratio_errors(const dh_system* system, size_t count, double* r_n_error,
                                                double* zeta_error) DH_NOEXCEPT;

/// @brief Mode shapes, normalised by (17) with the non-dimensional mass matrix, so that they are proportional to 1 / r; to at
/// least 6 digits of the largest entry of a shape.
/// @param system  a system
/// @param r       frequency ratio, Eq. (10), positive
/// @param count   N times N
/// @param psi     receives psi_ki at position (k - 1) N + i - 1
/// @return        #DH_OK, #DH_ERROR_NULL, #DH_ERROR_SIZE, #DH_ERROR_INPUT, #DH_ERROR_PRECISION
DH_EXPORT int dh_mode_shapes(const dh_system* system, double r, size_t count, double* psi) DH_NOEXCEPT;

/// @brief Bounds of the errors of these numbers; a shape and its negative are the same mode.
/// @param system,r,count  as for dh_mode_shapes()
/// @param psi_error       receives the bound of psi_ki at position (k - 1) N + i - 1
/// @return                as dh_mode_shapes()
DH_EXPORT int dh_mode_shape_errors(const dh_system* system, double r, size_t count, double* psi_error) DH_NOEXCEPT;

/// @brief Contribution of each mode: (22), (23), (28), (29); to at least 6 digits.
/// @param system  a system
/// @param r       frequency ratio, Eq. (10), positive
/// @param count   N
/// @param R       receives N modal frequency ratios, Eq. (22)
/// @param v       receives 2 N numbers: real and imaginary part of v_di, Eq. (23), mode after mode; may be null
/// @param u       receives N first damping functions u_di, Eq. (28); may be null
/// @param g       receives N second damping functions g_i, Eq. (29); may be null
/// @return        #DH_OK, #DH_ERROR_NULL, #DH_ERROR_SIZE, #DH_ERROR_INPUT, #DH_ERROR_DOMAIN at a pole of an undamped mode
///                where more than R is asked for, #DH_ERROR_PRECISION
DH_EXPORT int dh_modal_functions(const dh_system* system, double r, size_t count, double* R, double* v, double* u,
                                 double* g) DH_NOEXCEPT;

/// @brief Bounds of the errors of these numbers, in the same places.
/// @param system,r,count   as for dh_modal_functions()
/// @param R_error          receives N bounds
/// @param v_error          receives 2 N bounds: of real and imaginary part; may be null
/// @param u_error,g_error  receive N bounds; may be null
/// @return                 as dh_modal_functions()
DH_EXPORT int dh_modal_function_errors(const dh_system* system, double r, size_t count, double* R_error, double* v_error,
                                       double* u_error, double* g_error) DH_NOEXCEPT;

/// @brief Sums over the modes: (33)-(35), (64), and the largest sum of (57).
///
/// The sums have 10 digits. They are computed in double if it has these digits, and by the reference otherwise: far above the
/// natural frequencies the sums of a mass far from load or contact cancel. A sum below 1e-25 of the largest of its kind may come
/// out as zero.
/// @param system  a system
/// @param r       frequency ratio, Eq. (10), positive
/// @param count   N
/// @param V       receives 2 N numbers: real and imaginary part of V_dk, Eq. (33), mass after mass
/// @param U       receives N first damping functions U_dk, Eq. (34); may be null
/// @param G       receives N second damping functions G_k, Eq. (35); may be null
/// @param H_j     receives Eq. (64); may be null
/// @param S_j     receives the largest sum over the modes of (57) as corrected, over tau; may be null
/// @return        as dh_modal_functions()
DH_EXPORT int dh_sums(const dh_system* system, double r, size_t count, double* V, double* U, double* G, double* H_j,
                      double* S_j) DH_NOEXCEPT;

/// @brief Bounds of the errors of these numbers, in the same places.
/// @param system,r,count       as for dh_sums()
/// @param V_error              receives 2 N bounds: of real and imaginary part
/// @param U_error,G_error      receive N bounds; may be null
/// @param H_j_error,S_j_error  receive a bound each; may be null
/// @return                     as dh_sums()
DH_EXPORT int dh_sum_errors(const dh_system* system, double r, size_t count, double* V_error, double* U_error, double* G_error,
                            double* H_j_error, double* S_j_error) DH_NOEXCEPT;

/// @brief The friction ratios between the regimes, to 10 digits: (56), (57), (67), (69), and permanent sticking.
///
/// If (69) is below 1e-25, as at an antiresonance of the contact, it counts as zero, and the others may have fewer digits.
/// @param system    a system
/// @param r         frequency ratio, Eq. (10), positive
/// @param mu        static over kinetic friction, Eq. (3), at least 1
/// @param boundary  receives the result; the caller has set its size
/// @return          as dh_modal_functions()
DH_EXPORT int dh_boundaries(const dh_system* system, double r, double mu, dh_boundary* boundary) DH_NOEXCEPT;

/// @brief Bounds of the errors of these numbers.
/// @param system,r,mu  as for dh_boundaries()
/// @param errors       receives in each member the bound of the error of that number; the caller has set its size
/// @return             as dh_boundaries()
DH_EXPORT int dh_boundary_errors(const dh_system* system, double r, double mu, dh_boundary* errors) DH_NOEXCEPT;

/// @brief Friction ratios of dh_boundaries() with a proof: the reference computes them in ball arithmetic, see dh_solve_proved().
///
/// `sticking_exists` is 0 also where it is not proved that some friction holds the contact.
/// @param system,r,mu  as for dh_boundaries()
/// @param boundary     receives the result, to 10 digits; the caller has set its size
/// @param errors       receives in each member the proved bound of the error of that number; the caller has set its size; may be
///                     null
/// @return             #DH_OK, #DH_ERROR_NULL, #DH_ERROR_SIZE, #DH_ERROR_INPUT, #DH_ERROR_PRECISION if something is not proved or
///                     the library was built without the reference, #DH_ERROR_MEMORY
DH_EXPORT int dh_boundaries_proved(const dh_system* system, double r, double mu, dh_boundary* boundary,
                                   dh_boundary* errors) DH_NOEXCEPT;

/// @brief The limit of beta_lim for r to infinity, Eq. (86) as corrected. Of a load p on several masses, and of a contact with any
/// direction w, it is that of (86) times |w^T M^-1 p| / (w^T M^-1 w).
/// @param system    a system whose load reaches the contact by inertia, as where j = l, and is one at all frequencies
/// @param mu        static over kinetic friction, Eq. (3), at least 1
/// @param beta_lim  receives the limit
/// @return          #DH_OK, #DH_ERROR_NULL, #DH_ERROR_INPUT, #DH_ERROR_DOMAIN of another system
DH_EXPORT int dh_high_frequency_limit(const dh_system* system, double mu, double* beta_lim) DH_NOEXCEPT;

/// @brief Bound of the error of this number.
/// @param system,mu  as for dh_high_frequency_limit()
/// @param error      receives the bound
/// @return           as dh_high_frequency_limit()
DH_EXPORT int dh_high_frequency_limit_error(const dh_system* system, double mu, double* error) DH_NOEXCEPT;

/// @brief Motion of a mass while the contact slides throughout: (38), (39), (44), (45), (47), (52), (53) as corrected; to
/// 10 digits of its amplitude.
/// @param system  a system
/// @param r       frequency ratio, Eq. (10), positive
/// @param beta    friction ratio, Eq. (11), not negative
/// @param mu      static over kinetic friction, Eq. (3), at least 1
/// @param mass    k, from 1 to N
/// @param result  receives the result; the caller has set its size
/// @return        as dh_modal_functions(); #DH_ERROR_DOMAIN from the boundary (69) on
DH_EXPORT int dh_sliding_motion(const dh_system* system, double r, double beta, double mu, size_t mass,
                                dh_sliding_mass* result) DH_NOEXCEPT;

/// @brief Bounds of the errors of these numbers.
/// @param system,r,beta,mu,mass  as for dh_sliding_motion()
/// @param errors                 receives in each member the bound of the error of that number; the caller has set its size
/// @return                       as dh_sliding_motion()
DH_EXPORT int dh_sliding_motion_errors(const dh_system* system, double r, double beta, double mu, size_t mass,
                                       dh_sliding_mass* errors) DH_NOEXCEPT;

/// @brief Displacement of a mass while the contact slides throughout, Eq. (46) as corrected.
///
/// The displacement is accurate to 10 digits of the amplitude (52) of the mass. It is computed in double if that suffices, and
/// otherwise by the reference, which takes some ten microseconds for each mode and instant. A mass whose amplitude is below 1e-25
/// of the largest may come out at rest.
/// @param system  a system
/// @param r       frequency ratio, Eq. (10), positive
/// @param beta    friction ratio, Eq. (11), not negative
/// @param mu      static over kinetic friction, Eq. (3), at least 1
/// @param mass    k, from 1 to N
/// @param count   number of instants, at most #DH_MOST_SAMPLES, times N at most #DH_MOST_DISPLACEMENTS
/// @param tau     `count` instants, finite; zero at the maximum of the contact's displacement
/// @param x       receives `count` displacements x_k(tau); may be the array of tau
/// @return        as dh_sliding_motion()
DH_EXPORT int dh_displacement(const dh_system* system, double r, double beta, double mu, size_t mass, size_t count,
                              const double* tau, double* x) DH_NOEXCEPT;

/// @brief Bounds of the errors of these numbers.
/// @param system,r,beta,mu,mass,count,tau  as for dh_displacement()
/// @param x_error                          receives `count` bounds; may be the array of tau
/// @return                                 as dh_displacement()
DH_EXPORT int dh_displacement_errors(const dh_system* system, double r, double beta, double mu, size_t mass, size_t count,
                                     const double* tau, double* x_error) DH_NOEXCEPT;

/// @brief Your function, which the calling thread asks now and then whether to go on with a question.
/// @param context  as given to dh_set_effort()
/// @return         0 to go on, anything else to end the question
typedef int (*dh_cancelled)(void* context);

/// @brief Limits the work of each further call of the calling thread. A call that reaches the limit, or is cancelled, returns
/// #DH_ERROR_PRECISION, and its message says which.
/// @param operations  the limit, 1 to 1e18. An operation is the evaluation of a mode at an instant in double, about a tenth of a
///                    microsecond. 0 is the default: 1e7, and more if there are more than 12 masses, 4.5e8
///                    for 100
/// @param cancelled   your function, or null; it must return fast and throw no exception
/// @param context     passed on to `cancelled`
/// @return            #DH_OK, #DH_ERROR_INPUT
DH_EXPORT int dh_set_effort(double operations, dh_cancelled cancelled, void* context) DH_NOEXCEPT;

/// @brief The steady motion at a point, in any regime, by the cheapest model that is certain to have the digits.
/// @param system    a system
/// @param r         frequency ratio, Eq. (10), positive
/// @param beta      friction ratio, Eq. (11), not negative
/// @param mu        static over kinetic friction, Eq. (3), at least 1
/// @param digits    significant digits asked for, 1 to 15; 0 aims at 6
/// @param solution  receives the handle; to be destroyed by dh_solution_destroy()
/// @return          #DH_OK, #DH_ERROR_NULL, #DH_ERROR_INPUT, #DH_ERROR_DOMAIN at a pole of an undamped mode, #DH_ERROR_PRECISION
///                  if no model reaches the digits asked for or no steady motion is found, #DH_ERROR_MEMORY
DH_EXPORT int dh_solve(const dh_system* system, double r, double beta, double mu, int digits, dh_solution** solution) DH_NOEXCEPT;

/// @brief The steady motion at a point, every number and every bound of its error proved: by the reference, in ball arithmetic.
///
/// A proof covers the numbers of dh_solution_summary(), dh_solution_mass(), dh_solution_contact(), dh_solution_stops() and
/// dh_solution_stop_errors(), and the digits of the samples of dh_solution_motion(). If several motions
/// may be steady, as with mu above 1, the motion is proved, but that a start from rest leads to it is found in double; see
/// docs/promises.md.
/// @param system,r,beta,mu  as for dh_solve()
/// @param digits            significant digits, 1 to 15; 0 for 6, which are reached or the call fails
/// @param solution          receives the handle; to be destroyed by dh_solution_destroy()
/// @return                  #DH_OK, #DH_ERROR_NULL, #DH_ERROR_INPUT, #DH_ERROR_DOMAIN, #DH_ERROR_PRECISION if something is not
///                          proved, and the message says what, or if the library was built without the reference,
///                          #DH_ERROR_MEMORY
DH_EXPORT int dh_solve_proved(const dh_system* system, double r, double beta, double mu, int digits,
                              dh_solution** solution) DH_NOEXCEPT;

/// @brief Destroys a solution. @param solution a handle, or null
DH_EXPORT void dh_solution_destroy(dh_solution* solution) DH_NOEXCEPT;

/// @brief Regime, number of stops, interval of rest, errors.
/// @param solution  a solution
/// @param summary   receives the result; the caller has set its size
/// @return          #DH_OK, #DH_ERROR_NULL, #DH_ERROR_SIZE, #DH_ERROR_PRECISION
DH_EXPORT int dh_solution_summary(const dh_solution* solution, dh_summary* summary) DH_NOEXCEPT;

/// @brief Whether every number of a solution is proved; else the bounds of its errors are estimates, docs/promises.md.
/// @param solution  a solution
/// @param proved    receives 1 or 0; 1 from dh_solve_proved(), and from dh_solve() if only the reference had the digits
/// @return          #DH_OK, #DH_ERROR_NULL
DH_EXPORT int dh_solution_is_proved(const dh_solution* solution, int* proved) DH_NOEXCEPT;

/// @brief Whether a solution is known to be the motion that the start from rest leads to.
/// @param solution   a solution
/// @param from_rest  receives 1, or 0 where the motion is a steady one, and the start from rest is not known to lead to it
/// @return           #DH_OK, #DH_ERROR_NULL
DH_EXPORT int dh_solution_is_from_rest(const dh_solution* solution, int* from_rest) DH_NOEXCEPT;

/// @brief Warning, in words, of an input on which a solution depends too much: a mode next to its resonance and with next to no
/// damping, whose amplitude a unit in the last place of a number of the system changes by more than a thousandth.
/// @param solution  a solution
/// @param room      bytes that `text` has room for; 512 suffice
/// @param text      receives a sentence with an ending zero; an empty text where there is nothing to say
/// @return          #DH_OK, #DH_ERROR_NULL, #DH_ERROR_SIZE where the room does not suffice
DH_EXPORT int dh_solution_warning(const dh_solution* solution, size_t room, char* text) DH_NOEXCEPT;

/// @brief Amplitude and phase of a mass with their errors.
/// @param solution  a solution
/// @param mass      k, from 1 to N
/// @param result    receives the result; the caller has set its size
/// @return          #DH_OK, #DH_ERROR_NULL, #DH_ERROR_SIZE, #DH_ERROR_INPUT, #DH_ERROR_PRECISION
DH_EXPORT int dh_solution_mass(const dh_solution* solution, size_t mass, dh_mass* result) DH_NOEXCEPT;

/// @brief Absolute displacement of a mass where base or wall move: amplitude, phase behind base or wall, and transmissibility, which
/// is the amplitude over that of base or wall. The numbers are those of dh_solution_mass() if the base moves alone.
/// @param solution                a solution
/// @param mass                    k, from 1 to N
/// @param result                  receives amplitude and phase with their errors; the caller has set its size
/// @param transmissibility        receives it; may be null
/// @param transmissibility_error  receives the bound of its error; may be null
/// @return                        #DH_OK, #DH_ERROR_NULL, #DH_ERROR_SIZE, #DH_ERROR_INPUT, #DH_ERROR_DOMAIN if neither base nor wall
///                                moves, #DH_ERROR_PRECISION
DH_EXPORT int dh_solution_from_ground(const dh_solution* solution, size_t mass, dh_mass* result, double* transmissibility,
                                      double* transmissibility_error) DH_NOEXCEPT;

/// @brief Energy that the motion dissipates in a period of the force, friction as an equivalent dashpot, and the forces on wall
/// and base. The reference proves every number, in every regime; of a motion that is longer than a period the energies are means.
/// @param solution  a solution
/// @param digits    significant digits, 1 to 15; 0 for 6. Energies have them beside the largest work that the load could do
/// @param energies  receives the numbers; the caller has set its size
/// @param errors    receives in each member the proved bound of the error of that number; the caller has set its size; may be null
/// @return          #DH_OK, #DH_ERROR_NULL, #DH_ERROR_SIZE, #DH_ERROR_INPUT, #DH_ERROR_PRECISION if something is not proved or
///                  the library was built without the reference, #DH_ERROR_MEMORY
DH_EXPORT int dh_solution_energies(const dh_solution* solution, int digits, dh_energies* energies,
                                   dh_energies* errors) DH_NOEXCEPT;

/// @brief Amplitude and phase of the contact with their errors. If two masses rub against each other, the motion is that of the
/// first relative to the second; otherwise it is that of the mass in contact.
/// @param solution  a solution
/// @param result    receives the result; the caller has set its size
/// @return          #DH_OK, #DH_ERROR_NULL, #DH_ERROR_SIZE, #DH_ERROR_PRECISION
DH_EXPORT int dh_solution_contact(const dh_solution* solution, dh_mass* result) DH_NOEXCEPT;

/// @brief When the contact rests, within the period of the motion; tau from the maximum of the force.
/// @param solution  a solution
/// @param count     the number of stops, from dh_solution_summary()
/// @param start     receives `count` instants where a rest begins; may be null where count is 0
/// @param end       receives `count` instants where it ends; may be null where count is 0
/// @return          #DH_OK, #DH_ERROR_NULL, #DH_ERROR_SIZE, #DH_ERROR_PRECISION
DH_EXPORT int dh_solution_stops(const dh_solution* solution, size_t count, double* start, double* end) DH_NOEXCEPT;

/// @brief Bounds of the errors of these instants.
///
/// Where what ends a phase hardly changes at its end, as where the load only just reaches static friction, no error is bounded:
/// the bound is then half the period.
/// @param solution,count  as for dh_solution_stops()
/// @param start_error     receives `count` bounds for the instants where a rest begins; may be null where count is 0
/// @param end_error       receives `count` bounds for the instants where it ends; may be null where count is 0
/// @return                #DH_OK, #DH_ERROR_NULL, #DH_ERROR_SIZE, #DH_ERROR_PRECISION
DH_EXPORT int dh_solution_stop_errors(const dh_solution* solution, size_t count, double* start_error,
                                      double* end_error) DH_NOEXCEPT;

/// @brief The motion at equally spaced instants of its period, tau = 2 pi periods n / samples, **from the maximum of the force**.
///
/// If the contact slides throughout, the displacements have 10 digits, like those of dh_displacement(); their place relative to
/// the force comes from the solution's phase, which has the digits that dh_solve() was asked for. Otherwise a displacement is good
/// to 1e-6 of the amplitude of its mass beside the error of that amplitude, or there is #DH_ERROR_PRECISION. A contact that rests
/// for ever is taken to rest at zero. The samples of a proved solution are good to 1e-6 in every regime, proved.
/// @param solution  a solution
/// @param samples   instants, from 1 to #DH_MOST_SAMPLES, times N at most #DH_MOST_DISPLACEMENTS
/// @param count     samples times N
/// @param x         receives x_k at instant n at position n N + k - 1
/// @param x_prime   receives d x_k / d tau likewise; may be null
/// @return          #DH_OK, #DH_ERROR_NULL, #DH_ERROR_SIZE, #DH_ERROR_DOMAIN, #DH_ERROR_PRECISION, #DH_ERROR_MEMORY
DH_EXPORT int dh_solution_motion(const dh_solution* solution, size_t samples, size_t count, double* x,
                                 double* x_prime) DH_NOEXCEPT;

/// @brief Status of a point of dh_map(), dh_solve_points() or dh_solve_systems().
enum dh_point_status {
    DH_POINT_ANSWERED = 0,    ///< all numbers are there
    DH_POINT_ON_BOUNDARY = 1, ///< all are there; beta equals a boundary to rounding, so that the neighbouring regime is possible
    DH_POINT_NOT_CONVERGED = 2, ///< no steady motion is known to follow from the start
    DH_POINT_AT_A_POLE = 3,     ///< a mode without damping resonates
    DH_POINT_FAILED = 4         ///< no answer: digits or work are missing, or no motion is known to be the one asked for
};

/// @brief Your function, which is told how much of a call is done. One thread at a time calls it, not always the calling one.
/// @param done     columns or points that are done
/// @param all      of how many
/// @param context  as given to the call
/// @return         0 to go on; anything else ends the call, which returns #DH_ERROR_PRECISION and writes no output
typedef int (*dh_progress)(size_t done, size_t all, void* context);

/// @brief A grid of points of one system.
typedef struct dh_map_request {
    size_t size;          ///< sizeof(dh_map_request), set by the caller
    size_t r_count;       ///< number of frequency ratios
    const double* r;      ///< frequency ratios, Eq. (10), positive
    size_t beta_count;    ///< number of friction ratios
    const double* beta;   ///< friction ratios, Eq. (11), not negative; faster in ascending order
    double mu;            ///< static over kinetic friction, Eq. (3), at least 1
    int from_sliding;     ///< for mu > 1; 0: the motion that starts from rest; else the sliding motion as far as it exists
    size_t mass_count;    ///< masses whose amplitudes are wanted
    const size_t* masses; ///< these masses, from 1 to N; null for all N, whatever `mass_count` says
    unsigned threads;     ///< 0 for as many as the machine has; the numbers are the same for any
    dh_progress progress; ///< is told how many columns are done; may be null
    void* context;        ///< passed on to it
    int from_ground;      ///< 1 for absolute displacements, and phases behind base or wall; may be missing from the struct
} dh_map_request;

/// @brief Where the numbers of a map go. What is null is not asked for. Steps count elements, not bytes.
typedef struct dh_map_result {
    size_t size;                   ///< sizeof(dh_map_result), set by the caller
    ptrdiff_t r_step;              ///< from a frequency ratio to the next, in the first four arrays
    ptrdiff_t beta_step;           ///< from a friction ratio to the next, in the first four arrays
    signed char* status;           ///< receives enum dh_point_status
    signed char* regime;           ///< receives enum dh_regime; -1 where there are no numbers
    int* stops;                    ///< receives the stops in a period of the motion; -1 where there are no numbers
    int* periods;                  ///< receives that period, in periods of the force; -1 where there are no numbers
    ptrdiff_t amplitude_r_step;    ///< from a frequency ratio to the next
    ptrdiff_t amplitude_beta_step; ///< from a friction ratio to the next
    ptrdiff_t mass_step;           ///< from a mass asked for to the next
    double* amplitude;             ///< receives amplitudes in units of P / k_1; NaN where there are no numbers
    double* phase; ///< receives phases in (-pi, pi], with the steps of amplitudes; NaN where a mass does not move or there are no
                   ///< numbers; may be missing from the struct. Every point is then answered as dh_solve() does
} dh_map_result;

/// @brief Regime, amplitudes and stops over a grid: what `denhartog map` computes, to the last bit.
///
/// Every amplitude has 6 digits. A point costs a few nanoseconds if the contact slides or rests and only its amplitude is wanted,
/// and some ten microseconds if it sticks and slips. The limit of dh_set_effort() applies to each point; its `cancelled` is not
/// called.
/// @param system   a system
/// @param request  the grid; the caller has set its size
/// @param result   where the numbers go, written when all are there; the caller has set its size
/// @return         #DH_OK, #DH_ERROR_NULL, #DH_ERROR_SIZE, #DH_ERROR_INPUT, #DH_ERROR_PRECISION if `progress` ended it,
///                 #DH_ERROR_MEMORY
DH_EXPORT int dh_map(const dh_system* system, const dh_map_request* request, const dh_map_result* result) DH_NOEXCEPT;

/// @brief Any points of one system.
typedef struct dh_points_request {
    size_t size;          ///< sizeof(dh_points_request), set by the caller
    size_t count;         ///< number of points
    const double* r;      ///< frequency ratios, Eq. (10), positive
    ptrdiff_t r_step;     ///< elements from one to the next; 0 takes the first for all
    const double* beta;   ///< friction ratios, Eq. (11), not negative
    ptrdiff_t beta_step;  ///< elements from one to the next; 0 takes the first for all
    double mu;            ///< static over kinetic friction, Eq. (3), at least 1
    int digits;           ///< as in dh_solve()
    size_t mass_count;    ///< masses whose numbers are wanted
    const size_t* masses; ///< these masses, from 1 to N; null for all N, whatever `mass_count` says
    unsigned threads;     ///< 0 for as many as the machine has; the numbers are the same for any
    dh_progress progress; ///< is told how many points are done; may be null
    void* context;        ///< passed on to it
    int from_ground;      ///< 1 for absolute displacements, and phases behind base or wall; may be missing from the struct
} dh_points_request;

/// @brief Where the numbers of points go. What is null is not asked for, and what is not asked for may make a point cheaper.
typedef struct dh_points {
    size_t size;           ///< sizeof(dh_points), set by the caller
    ptrdiff_t step;        ///< elements from a point to the next, in the first four arrays
    signed char* status;   ///< receives enum dh_point_status
    signed char* regime;   ///< receives enum dh_regime; -1 where there are no numbers
    int* stops;            ///< receives the stops in a period of the motion; -1 where there are no numbers
    int* periods;          ///< receives that period, in periods of the force; -1 where there are no numbers
    ptrdiff_t masses_step; ///< elements from a point to the next, in the arrays over masses
    ptrdiff_t mass_step;   ///< from a mass asked for to the next
    double* amplitude;     ///< receives amplitudes in units of P / k_1; NaN where there are no numbers
    double* error;         ///< receives bounds of their errors
    double* phase;         ///< receives phases in (-pi, pi]; NaN where a mass does not move or there are no numbers
    double* phase_error;   ///< receives bounds of their errors
} dh_points;

/// @brief The steady motions at any points, the same as dh_solve() gives for each.
/// @param system   a system
/// @param request  the points; the caller has set its size
/// @param points   where the numbers go, written when all are there; the caller has set its size
/// @return         as dh_map()
DH_EXPORT int dh_solve_points(const dh_system* system, const dh_points_request* request, const dh_points* points) DH_NOEXCEPT;

/// @brief Points of many systems; a system may have any number of points.
typedef struct dh_systems_request {
    size_t size;                     ///< sizeof(dh_systems_request), set by the caller
    size_t count;                    ///< number of points
    const dh_system* const* systems; ///< the system of each point; a system may have any number of points
    ptrdiff_t system_step;           ///< elements from one to the next; 0 takes the first for all
    const double* r;                 ///< frequency ratios, Eq. (10), positive
    ptrdiff_t r_step;                ///< elements from one to the next; 0 takes the first for all
    const double* beta;              ///< friction ratios, Eq. (11), not negative
    ptrdiff_t beta_step;             ///< elements from one to the next; 0 takes the first for all
    const double* mu;                ///< static over kinetic friction, Eq. (3), at least 1
    ptrdiff_t mu_step;               ///< elements from one to the next; 0 takes the first for all
    int digits;                      ///< as in dh_solve()
    size_t mass_count;               ///< masses whose numbers are wanted
    const size_t* masses;            ///< these masses, which every system must have; null for all masses of each system
    unsigned threads;                ///< 0 for as many as the machine has; the numbers are the same for any
    dh_progress progress;            ///< is told how many points are done; may be null
    void* context;                   ///< passed on to it
    int from_ground;                 ///< 1 for absolute displacements, and phases behind base or wall; may be missing from the struct
} dh_systems_request;

/// @brief The steady motions of many systems, each at its own point, the same as dh_solve() gives for each.
///
/// If `masses` is null, the arrays over masses must have room for the masses of the largest system. NaN stands for a mass that a
/// system does not have.
/// @param request  systems and points; the caller has set its size
/// @param points   where the numbers go, written when all are there; the caller has set its size
/// @return         as dh_map()
DH_EXPORT int dh_solve_systems(const dh_systems_request* request, const dh_points* points) DH_NOEXCEPT;

/// @brief Kind of a place that dh_find() found.
enum dh_place_kind {
    DH_CROSSING = 0,       ///< the amplitude is certainly below the value at one end, and above it at the other
    DH_JUMP = 1,           ///< the same at neighbouring doubles or nearly so, and it does not come near the value
    DH_UNDECIDED = 2,      ///< it may reach the value or only come near; of an extreme: beside a place without an answer
    DH_EXTREME = 3,        ///< the extreme of all that were seen: the amplitude is certainly less, or more, at both ends
    DH_END_OF_INTERVAL = 4 ///< the same, at an end of the interval
};

/// @brief An inverse question: what a number of a scene has to be.
typedef struct dh_find_request {
    size_t size;         ///< sizeof(dh_find_request), set by the caller
    const char* scene;   ///< a scene in JSON, with r and beta, or frequency, force and friction
    size_t scene_length; ///< its length in bytes
    const char* vary;    ///< the key of the number that varies, such as `friction`; of a list with the place, `damping_ratios/2`
    double from;         ///< lower end of its interval
    double to;           ///< upper end
    const char* so_that; ///< e.g. `amplitude of mass 2 = 0.075`, as `denhartog find --so-that` has it
    int samples;         ///< parts into which the interval is divided at first, from 2 to 100000
} dh_find_request;

/// @brief Where the places go that dh_find() finds. An array that is null is not asked for.
typedef struct dh_places {
    size_t size;       ///< sizeof(dh_places), set by the caller
    size_t room;       ///< length of the arrays, set by the caller
    double* at;        ///< receives where each place most likely is, ascending
    double* from;      ///< receives the lower ends of the intervals that hold them
    double* to;        ///< receives the upper ends
    double* amplitude; ///< receives the amplitude at each, in the scene's unit of length, or in units of P / k_1
    double* error;     ///< receives the bounds of the amplitudes' errors
    int* is;           ///< receives enum dh_place_kind
    size_t count;      ///< receives how many there are
    size_t unanswered; ///< receives at how many values of the number no steady motion was certain
} dh_places;

/// @brief Values of a number of a scene for which an amplitude is as wanted, as `denhartog find` finds them.
///
/// A solution between two samples that shows at neither is not found. The limit of dh_set_effort() is not used.
/// @param request  the question; the caller has set its size
/// @param places   where the places go, written when all are there; the caller has set size, room and arrays
/// @return         #DH_OK, #DH_ERROR_NULL, #DH_ERROR_SIZE if there is too little room, #DH_ERROR_INPUT, #DH_ERROR_PRECISION,
///                 #DH_ERROR_MEMORY
DH_EXPORT int dh_find(const dh_find_request* request, dh_places* places) DH_NOEXCEPT;

/// @brief Where the constant load of a scene, `static_load`, holds the masses; displacements of every motion count from there.
/// @param system   a system
/// @param count    N
/// @param x        receives N places in units of P / k_1, proved; 0 without a constant load
/// @param x_error  receives the proved bounds of their errors; may be null
/// @return         #DH_OK, #DH_ERROR_NULL, #DH_ERROR_SIZE, #DH_ERROR_PRECISION, #DH_ERROR_MEMORY
DH_EXPORT int dh_place_of_rest(const dh_system* system, size_t count, double* x, double* x_error) DH_NOEXCEPT;

/// @brief Motion of the other masses while the contact rests for good.
enum dh_others {
    DH_COME_TO_REST = 0, ///< they tend to their places of rest
    DH_VIBRATE = 1,      ///< they vibrate about them for ever: nothing damps them
    DH_NOT_KNOWN = 2     ///< neither is proved, or the contact does not rest
};

/// @brief A motion without the harmonic load. P and the frequency are units and nothing more: with r = 1 and beta = F / k_1 times a
/// unit of length, displacements are in that unit, and tau is omega_1 t with omega_1 = sqrt(k_1 / m_1).
typedef struct dh_decay_request {
    size_t size;           ///< sizeof(dh_decay_request), set by the caller
    double r;              ///< frequency ratio, Eq. (10), positive
    double beta;           ///< friction ratio, Eq. (11), positive
    double mu;             ///< static over kinetic friction, Eq. (3), at least 1
    const double* x;       ///< N displacements at the start, units of P / k_1; null for 0
    const double* x_prime; ///< N velocities dx/dtau at the start; null for 0
    double until;          ///< tau up to which the motion is followed; 0 until the contact rests for good
} dh_decay_request;

/// @brief Where a free decay goes. An array that is null is not asked for; those of turns and stops have the length `room`.
typedef struct dh_decay {
    size_t size;          ///< sizeof(dh_decay), set by the caller
    size_t room;          ///< set by the caller
    double* turn;         ///< receives tau where the contact turns, or comes to rest for good
    double* turn_error;   ///< receives the bounds of their errors
    double* turn_x;       ///< receives its displacements there
    double* turn_x_error; ///< receives the bounds of their errors
    double* start;        ///< receives tau where it stops before it breaks away again
    double* start_error;  ///< receives the bounds of their errors
    double* end;          ///< receives tau where it breaks away
    double* end_error;    ///< receives the bounds of their errors
    double* stop_x;       ///< receives where it stops
    double* stop_x_error; ///< receives the bounds of their errors
    double* masses;       ///< receives N places of rest, if the contact rests for good
    double* masses_error; ///< receives the bounds of their errors
    double* rest;         ///< receives tau from which the contact rests for good, and its displacement; 0 where it does not
    double* rest_error;   ///< receives the bounds of both
    size_t turns;         ///< receives the number of turns
    size_t stops;         ///< receives the number of stops
    int at_rest;          ///< receives 1 if the contact rests for good
    int others;           ///< receives one of enum dh_others
    int on_limit;         ///< receives 1 if the springs pull on the contact at rest with static friction, to all digits
} dh_decay;

/// @brief The motion from a start without the harmonic load, until the contact rests for good. Every number is proved.
/// @param system   a system
/// @param request  the start; the caller has set its size
/// @param decay    where it goes, written when all is there; the caller has set size, room and arrays
/// @return         #DH_OK, #DH_ERROR_NULL, #DH_ERROR_SIZE if there is too little room, #DH_ERROR_INPUT, #DH_ERROR_PRECISION,
///                 #DH_ERROR_MEMORY
DH_EXPORT int dh_free_decay(const dh_system* system, const dh_decay_request* request, dh_decay* decay) DH_NOEXCEPT;

/// @brief A motion from a start at tau = 0, where the force is largest.
typedef struct dh_history_request {
    size_t size;           ///< sizeof(dh_history_request), set by the caller
    double r;              ///< frequency ratio, Eq. (10), positive
    double beta;           ///< friction ratio, Eq. (11), not negative
    double mu;             ///< static over kinetic friction, Eq. (3), at least 1
    const double* x;       ///< N displacements at the start, units of P / k_1; null for 0
    const double* x_prime; ///< N velocities dx/dtau at the start; null for 0
    int cycles;            ///< periods of the force, from 1 to 1000000
    int last;              ///< how many of them are wanted, at the end; 0 for all
    int samples;           ///< instants in a period at which the state is wanted; 0 for none
    int without_load;      ///< 1 if the harmonic load is taken away
} dh_history_request;

/// @brief Where a history goes. An array that is null is not asked for. Its errors are not known.
typedef struct dh_history {
    size_t size;            ///< sizeof(dh_history), set by the caller
    size_t stop_room;       ///< length of the arrays of stops, set by the caller
    size_t sample_room;     ///< instants that there is room for, set by the caller
    double* start;          ///< receives tau where the contact comes to rest
    double* end;            ///< receives tau where it breaks away; -1 of a rest that lasts to the end
    double* stop_x;         ///< receives where it rests, units of P / k_1
    double* tau;            ///< receives the instants, counted from the start of the motion
    double* x;              ///< receives N displacements an instant
    double* x_prime;        ///< receives N velocities dx/dtau an instant
    signed char* direction; ///< receives 1 or -1 as the contact slides, 0 while it sticks
    size_t stops;           ///< receives the number of stops
    size_t samples;         ///< receives the number of instants
    double from;            ///< receives tau at the start of what was wanted
} dh_history;

/// @brief The motion from a start, every stop of it, by the exact method of `denhartog integrate --history`.
/// @param system   a system
/// @param request  the start; the caller has set its size
/// @param history  where it goes, written when all is there; the caller has set size, room and arrays
/// @return         #DH_OK, #DH_ERROR_NULL, #DH_ERROR_SIZE if there is too little room, #DH_ERROR_INPUT, #DH_ERROR_PRECISION if the
///                 end is not reached, #DH_ERROR_MEMORY
DH_EXPORT int dh_follow(const dh_system* system, const dh_history_request* request, dh_history* history) DH_NOEXCEPT;

/// @brief Any quantity of docs/protocol.md by its name there, with the conventions of that page; the regime as enum dh_regime.
///
/// This function is for languages in which structs are hard to pass. Every call solves for the steady motion again, to 12 digits,
/// if the quantity needs it. If you want more than one number of a point, call dh_solve() once.
/// @param system  a system
/// @param name    e.g. `amplitude`
/// @param r       frequency ratio, Eq. (10), positive
/// @param beta    friction ratio, Eq. (11), not negative
/// @param mu      static over kinetic friction, Eq. (3), at least 1
/// @param mass    k, from 1 to N; ignored if the quantity belongs to no mass
/// @param tau     for `displacement`; ignored otherwise
/// @param size    length of `values`: at least as many as the quantity has, and for `motion_under_force` the number of samples,
///                with the limits of dh_solution_motion()
/// @param values  receives the numbers
/// @param count   receives how many there are; 0 only if there is no stop whose duration could be given
/// @return        #DH_OK, #DH_ERROR_NULL, #DH_ERROR_SIZE, #DH_ERROR_INPUT, #DH_ERROR_DOMAIN if the quantity does not exist,
///                such as the phase of a mass at rest, or if no quantity has this name, #DH_ERROR_PRECISION, #DH_ERROR_MEMORY
DH_EXPORT int dh_quantity(const dh_system* system, const char* name, double r, double beta, double mu, size_t mass, double tau,
                          size_t size, double* values, size_t* count) DH_NOEXCEPT;

/// @brief Bounds of the errors of these numbers. That of the regime is 1 where the neighbouring regime is possible, else 0.
/// @param system,name,r,beta,mu,mass,tau  as for dh_quantity()
/// @param size                            length of `errors`, as for dh_quantity()
/// @param errors                          receives the bounds
/// @param count                           receives how many there are
/// @return                                as dh_quantity()
DH_EXPORT int dh_quantity_errors(const dh_system* system, const char* name, double r, double beta, double mu, size_t mass,
                                 double tau, size_t size, double* errors, size_t* count) DH_NOEXCEPT;

#ifdef __cplusplus
}
#endif

#endif
