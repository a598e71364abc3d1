/// @file
/// @brief The library from Octave and MATLAB: one MEX function over the C interface.
///
/// Users call the .m files next to it. The first argument is a command, the second the text of a scene in JSON, then numbers:
///
///     version
///     natural_frequencies  scene
///     boundary             scene, r, mu
///     solve                scene, r, beta, mu, digits, proved
///     motion               scene, r, beta, mu, samples
///     map                  scene, r, beta, mu, masses, phases, from_ground
///     energies             scene, r, beta, mu, digits
///     place_of_rest        scene
///     free_decay           scene, r, beta, mu, x, v, until
///     history              scene, r, beta, mu, x, v, cycles, last, samples, load
///     quantity             scene, r, beta, mu, name, mass, tau, samples
///     find                 scene, vary, between, so_that, samples
///
/// Each but `version` returns a struct. Regimes and states of points are the numbers of the C interface.
#include <denhartog.h>
#include <math.h>
#include <string.h>

#include "mex.h"

// Memory that a call holds. An error leaves a call by a jump, and so does an allocation that fails: release() comes first,
// or at the latest with the next call.
static dh_system* held_system = NULL;
static dh_solution* held_solution = NULL;

static void release(void) {
    dh_solution_destroy(held_solution);
    dh_system_destroy(held_system);
    held_solution = NULL;
    held_system = NULL;
}

static void fail(const char* identifier, const char* message) {
    release();
    mexErrMsgIdAndTxt(identifier, "%s", message);
}

static void need(int status) {
    static const char* const identifiers[] = {
        [DH_ERROR_NULL] = "denhartog:null",           [DH_ERROR_SIZE] = "denhartog:size",
        [DH_ERROR_INPUT] = "denhartog:input",         [DH_ERROR_DOMAIN] = "denhartog:domain",
        [DH_ERROR_PRECISION] = "denhartog:precision", [DH_ERROR_MEMORY] = "denhartog:memory"};
    const int known = status > DH_OK && status <= DH_ERROR_MEMORY;
    if (status != DH_OK) fail(known ? identifiers[status] : "denhartog:internal", dh_last_message());
}

/// Numbers of an argument, which stay the caller's.
typedef struct Numbers {
    size_t count;
    const double* values;
} Numbers;

static Numbers numbers(const mxArray* argument, const char* fault) {
    Numbers found = {0, NULL};
    if (!mxIsDouble(argument) || mxIsComplex(argument) || mxIsSparse(argument)) fail("denhartog:input", fault);
    found.count = mxGetNumberOfElements(argument);
    found.values = (const double*)mxGetData(argument);
    return found;
}

static double number(const mxArray* argument, const char* fault) {
    const Numbers found = numbers(argument, fault);
    if (found.count != 1) fail("denhartog:input", fault);
    return found.values[0];
}

static int whole_number(double x, double least, double most) { return x >= least && x <= most && x == floor(x); }

/// A field of a struct, filled with zeros; gives where its values go, column by column.
static void* field(mxArray* result, const char* name, mxClassID type, size_t rows, size_t columns) {
    mxArray* values = mxCreateNumericMatrix(rows, columns, type, mxREAL);
    mxSetFieldByNumber(result, 0, mxAddField(result, name), values);
    return mxGetData(values);
}

static double* doubles(mxArray* result, const char* name, size_t rows, size_t columns) {
    return (double*)field(result, name, mxDOUBLE_CLASS, rows, columns);
}

static mxArray* empty_struct(void) { return mxCreateStructMatrix(1, 1, 0, NULL); }

/// Prepares the system of a scene. Gives its number of masses.
static size_t hold_system(const mxArray* scene) {
    size_t N = 0;
    int status;
    char* text = mxIsChar(scene) ? mxArrayToString(scene) : NULL;
    if (!text) fail("denhartog:input", "the scene must be text in JSON; denhartog_json makes it of a struct");
    if (strlen(text) < mxGetNumberOfElements(scene)) fail("denhartog:input", "the text of the scene has a zero character");
    status = dh_system_from_json(text, strlen(text), &held_system);
    mxFree(text);
    need(status);
    need(dh_system_masses(held_system, &N, NULL, NULL));
    return N;
}

static mxArray* natural_frequencies(size_t N, const mxArray* const* arguments) {
    (void)arguments;
    mxArray* result = empty_struct();
    double* r_n = doubles(result, "r_n", 1, N);
    need(dh_natural_frequency_ratios(held_system, N, r_n, doubles(result, "zeta", 1, N)));
    r_n = doubles(result, "r_n_error", 1, N);
    need(dh_natural_frequency_ratio_errors(held_system, N, r_n, doubles(result, "zeta_error", 1, N)));
    return result;
}

/// One frequency ratio fails with its reason; of several each has a status.
static mxArray* boundary(size_t N, const mxArray* const* arguments) {
    const Numbers r = numbers(arguments[0], "r must be real, of class double");
    const double mu = number(arguments[1], "mu must be one number");
    mxArray* result = empty_struct();
    static const char* const names[] = {"exact",       "paper",       "approximate",       "sticking",
                                        "exact_error", "paper_error", "approximate_error", "sticking_error"};
    double* values[8];
    signed char* states = (signed char*)field(result, "status", mxINT8_CLASS, r.count, 1);
    size_t n, k;
    (void)N;
    for (k = 0; k < 8; ++k) values[k] = doubles(result, names[k], r.count, 1);
    for (n = 0; n < r.count; ++n) {
        dh_boundary at = {.size = sizeof at}, error = {.size = sizeof error};
        int status = dh_boundaries(held_system, r.values[n], mu, &at);
        if (status == DH_OK) status = dh_boundary_errors(held_system, r.values[n], mu, &error);
        if (r.count == 1 || (status != DH_ERROR_DOMAIN && status != DH_ERROR_PRECISION)) need(status);
        states[n] = status == DH_OK ? DH_POINT_ANSWERED : status == DH_ERROR_DOMAIN ? DH_POINT_AT_A_POLE : DH_POINT_FAILED;
        const double found[] = {at.exact,    at.paper,    at.approximate,    at.sticking,
                                error.exact, error.paper, error.approximate, error.sticking};
        for (k = 0; k < 8; ++k) values[k][n] = status == DH_OK && (k % 4 < 3 || at.sticking_exists) ? found[k] : mxGetNaN();
    }
    return result;
}

/// Where the numbers of `count` points of N masses go: a row a point, a column a mass.
static dh_points fields_of_points(mxArray* result, size_t count, size_t N) {
    dh_points points = {.size = sizeof points, .step = 1, .masses_step = 1, .mass_step = (ptrdiff_t)count};
    points.status = (signed char*)field(result, "status", mxINT8_CLASS, count, 1);
    points.regime = (signed char*)field(result, "regime", mxINT8_CLASS, count, 1);
    points.stops = (int*)field(result, "stops", mxINT32_CLASS, count, 1);
    points.periods = (int*)field(result, "periods", mxINT32_CLASS, count, 1);
    points.amplitude = doubles(result, "amplitude", count, N);
    points.error = doubles(result, "amplitude_error", count, N);
    points.phase = doubles(result, "phase", count, N);
    points.phase_error = doubles(result, "phase_error", count, N);
    return points;
}

/// Absolute displacements of the masses, where base or wall move; nothing else.
static void add_from_ground(mxArray* result, size_t N) {
    dh_mass mass = {.size = sizeof mass};
    static const char* const names[] = {"absolute_amplitude", "absolute_amplitude_error", "transmissibility", "transmissibility_error",
                                        "absolute_phase",     "absolute_phase_error"};
    double* values[6];
    size_t k, n;
    if (dh_solution_from_ground(held_solution, 1, &mass, NULL, NULL) == DH_ERROR_DOMAIN) return;
    for (n = 0; n < 6; ++n) values[n] = doubles(result, names[n], 1, N);
    for (k = 0; k < N; ++k) {
        need(dh_solution_from_ground(held_solution, k + 1, &mass, values[2] + k, values[3] + k));
        values[0][k] = mass.amplitude;
        values[1][k] = mass.error;
        values[4][k] = mass.moves ? mass.phase : mxGetNaN();
        values[5][k] = mass.moves ? mass.phase_error : mxGetNaN();
    }
}

/// One point fails with its reason, and has more to tell than one of many.
static mxArray* solve_point(double r, double beta, double mu, int digits, int proved, size_t N) {
    dh_summary motion = {.size = sizeof motion};
    size_t k;
    int from_rest;
    double* ends;
    char warning[512];
    mxArray* result = empty_struct();
    const dh_points point = fields_of_points(result, 1, N);
    need((proved ? dh_solve_proved : dh_solve)(held_system, r, beta, mu, digits, &held_solution));
    need(dh_solution_summary(held_solution, &motion));
    need(dh_solution_is_proved(held_solution, &proved));
    need(dh_solution_is_from_rest(held_solution, &from_rest));
    need(dh_solution_warning(held_solution, sizeof warning, warning));
    *point.status = motion.on_boundary ? DH_POINT_ON_BOUNDARY : DH_POINT_ANSWERED;
    *point.regime = (signed char)motion.regime;
    *point.stops = (int)motion.stops;
    *point.periods = motion.periods;
    for (k = 0; k < N; ++k) {
        dh_mass mass = {.size = sizeof mass};
        need(dh_solution_mass(held_solution, k + 1, &mass));
        point.amplitude[k] = mass.amplitude;
        point.error[k] = mass.error;
        point.phase[k] = mass.moves ? mass.phase : mxGetNaN();
        point.phase_error[k] = mass.moves ? mass.phase_error : mxGetNaN();
    }
    add_from_ground(result, N);
    ends = doubles(result, "stop_start", 1, motion.stops);
    need(dh_solution_stops(held_solution, motion.stops, ends, doubles(result, "stop_end", 1, motion.stops)));
    ends = doubles(result, "stop_start_error", 1, motion.stops);
    need(dh_solution_stop_errors(held_solution, motion.stops, ends, doubles(result, "stop_end_error", 1, motion.stops)));
    ends = doubles(result, "rest_interval", motion.rest_interval_exists ? 1 : 0, motion.rest_interval_exists ? 2 : 0);
    if (motion.rest_interval_exists) {
        ends[0] = motion.rest_from;
        ends[1] = motion.rest_to;
    }
    *doubles(result, "rest_error", 1, 1) = motion.rest_error;
    *doubles(result, "relative_error", 1, 1) = motion.relative_error;
    mxSetFieldByNumber(result, 0, mxAddField(result, "unique"), mxCreateLogicalScalar(motion.unique != 0));
    mxSetFieldByNumber(result, 0, mxAddField(result, "symmetric"), mxCreateLogicalScalar(motion.symmetric != 0));
    mxSetFieldByNumber(result, 0, mxAddField(result, "from_rest"), mxCreateLogicalScalar(from_rest != 0));
    mxSetFieldByNumber(result, 0, mxAddField(result, "proved"), mxCreateLogicalScalar(proved != 0));
    mxSetFieldByNumber(result, 0, mxAddField(result, "warning"), mxCreateString(warning));
    return result;
}

static mxArray* solve(size_t N, const mxArray* const* arguments) {
    const Numbers r = numbers(arguments[0], "r must be real, of class double"),
                  beta = numbers(arguments[1], "beta must be real, of class double");
    const double mu = number(arguments[2], "mu must be one number");
    const double digits = number(arguments[3], "digits must be one number");
    const int proved = number(arguments[4], "proved must be one number, 0 or 1") != 0;
    if (!whole_number(digits, 0, 15)) fail("denhartog:input", "digits must be a whole number from 0 to 15");
    if (r.count != beta.count && r.count != 1 && beta.count != 1)
        fail("denhartog:size", "r and beta must have the same size, or one of them must be one number");
    if (r.count == 1 && beta.count == 1) return solve_point(r.values[0], beta.values[0], mu, (int)digits, proved, N);
    if (proved) fail("denhartog:input", "proved must be false for many points: ask for a proof point by point");
    const dh_points_request request = {.size = sizeof request,
                                       .count = r.count == 1 ? beta.count : r.count,
                                       .r = r.values,
                                       .r_step = r.count != 1,
                                       .beta = beta.values,
                                       .beta_step = beta.count != 1,
                                       .mu = mu,
                                       .digits = (int)digits};
    mxArray* result = empty_struct();
    const dh_points points = fields_of_points(result, request.count, N);
    if (request.count > 0) need(dh_solve_points(held_system, &request, &points));
    return result;
}

static mxArray* motion(size_t N, const mxArray* const* arguments) {
    const double r = number(arguments[0], "r must be one number"), beta = number(arguments[1], "beta must be one number");
    const double mu = number(arguments[2], "mu must be one number");
    const double samples = number(arguments[3], "samples must be one number");
    dh_summary summary = {.size = sizeof summary};
    if (!whole_number(samples, 1, DH_MOST_SAMPLES) || samples * (double)N > DH_MOST_DISPLACEMENTS)
        fail("denhartog:size", "samples must be a whole number from 1 to 10000000, and samples times masses at most 100000000");
    need(dh_solve(held_system, r, beta, mu, 0, &held_solution));
    need(dh_solution_summary(held_solution, &summary));
    mxArray* result = empty_struct();
    *doubles(result, "periods", 1, 1) = summary.periods;
    double* x = doubles(result, "x", N, (size_t)samples);
    need(dh_solution_motion(held_solution, (size_t)samples, (size_t)samples * N, x, doubles(result, "v", N, (size_t)samples)));
    return result;
}

static mxArray* map(size_t N, const mxArray* const* arguments) {
    const Numbers r = numbers(arguments[0], "r must be real, of class double"),
                  beta = numbers(arguments[1], "beta must be real, of class double");
    const double mu = number(arguments[2], "mu must be one number");
    const Numbers wanted = numbers(arguments[3], "masses must be real, of class double");
    const size_t points = r.count * beta.count, mass_count = wanted.count > 0 ? wanted.count : N;
    size_t* masses = wanted.count > 0 ? (size_t*)mxCalloc(mass_count, sizeof *masses) : NULL; // null asks for all
    size_t n;
    mxArray* result = empty_struct();
    for (n = 0; n < wanted.count; ++n) {
        if (!whole_number(wanted.values[n], 1, (double)N)) fail("denhartog:input", "masses must be whole numbers from 1 to N");
        masses[n] = (size_t)wanted.values[n];
    }
    const dh_map_request request = {.size = sizeof request,
                                    .r_count = r.count,
                                    .r = r.values,
                                    .beta_count = beta.count,
                                    .beta = beta.values,
                                    .mu = mu,
                                    .mass_count = mass_count,
                                    .masses = masses,
                                    .from_ground = number(arguments[5], "from_ground must be one number, 0 or 1") != 0};
    dh_map_result to = {.size = sizeof to, .beta_step = 1, .amplitude_beta_step = 1, .mass_step = (ptrdiff_t)points};
    to.r_step = to.amplitude_r_step = (ptrdiff_t)beta.count;
    to.status = (signed char*)field(result, "status", mxINT8_CLASS, beta.count, r.count);
    to.regime = (signed char*)field(result, "regime", mxINT8_CLASS, beta.count, r.count);
    to.stops = (int*)field(result, "stops", mxINT32_CLASS, beta.count, r.count);
    to.periods = (int*)field(result, "periods", mxINT32_CLASS, beta.count, r.count);
    to.amplitude = doubles(result, "amplitude", beta.count, r.count * mass_count);
    if (number(arguments[4], "phases must be one number, 0 or 1") != 0)
        to.phase = doubles(result, "phase", beta.count, r.count * mass_count);
    if (points > 0) need(dh_map(held_system, &request, &to));
    mxFree(masses);
    return result;
}

/// Text of an argument, which Octave frees at the end of the call.
static char* text_of(const mxArray* argument, const char* fault) {
    char* text = mxIsChar(argument) ? mxArrayToString(argument) : NULL;
    if (!text || strlen(text) < mxGetNumberOfElements(argument)) fail("denhartog:input", fault);
    return text;
}

/// The inverse question; a row a place.
static mxArray* find(const mxArray* const* arguments) {
    static const char* const names[] = {"at", "from", "to", "amplitude", "error_bound"};
    const Numbers between = numbers(arguments[2], "between must be two numbers");
    const double samples = number(arguments[4], "samples must be one number");
    char* scene = text_of(arguments[0], "the scene must be text in JSON; denhartog_json makes it of a struct");
    dh_find_request request = {.size = sizeof request, .scene = scene, .scene_length = strlen(scene)};
    dh_places places = {.size = sizeof places};
    mxArray* result = empty_struct();
    size_t n, k;
    if (between.count != 2) fail("denhartog:input", "between must be two numbers");
    if (!whole_number(samples, 2, 100000)) fail("denhartog:input", "samples must be a whole number from 2 to 100000");
    request.vary = text_of(arguments[1], "vary must be text");
    request.so_that = text_of(arguments[3], "so_that must be text");
    request.from = between.values[0];
    request.to = between.values[1];
    request.samples = (int)samples;
    places.room = 4 * (size_t)samples + 64;
    double* found[5];
    for (k = 0; k < 5; ++k) found[k] = (double*)mxCalloc(places.room, sizeof(double));
    int* is = (int*)mxCalloc(places.room, sizeof(int));
    places.at = found[0];
    places.from = found[1];
    places.to = found[2];
    places.amplitude = found[3];
    places.error = found[4];
    places.is = is;
    need(dh_find(&request, &places));
    for (k = 0; k < 5; ++k) {
        double* to = doubles(result, names[k], places.count, 1);
        for (n = 0; n < places.count; ++n) to[n] = found[k][n];
        mxFree(found[k]);
    }
    int* kinds = (int*)field(result, "is", mxINT32_CLASS, places.count, 1);
    for (n = 0; n < places.count; ++n) kinds[n] = is[n];
    mxFree(is);
    *doubles(result, "unanswered", 1, 1) = (double)places.unanswered;
    return result;
}

/// Energy that the motion at a point dissipates, with the bounds of the errors.
static mxArray* energies(size_t N, const mxArray* const* arguments) {
    const double r = number(arguments[0], "r must be one number"), beta = number(arguments[1], "beta must be one number");
    const double mu = number(arguments[2], "mu must be one number"), digits = number(arguments[3], "digits must be one number");
    dh_energies found = {.size = sizeof found}, errors = {.size = sizeof errors};
    mxArray* result = empty_struct();
    size_t k;
    (void)N;
    if (!whole_number(digits, 0, 15)) fail("denhartog:input", "digits must be a whole number from 0 to 15");
    need(dh_solve(held_system, r, beta, mu, 0, &held_solution));
    need(dh_solution_energies(held_solution, (int)digits, &found, &errors));
    const struct {
        const char *name, *of_error;
        double value, error;
        int exists;
    } all[] = {
#define DH_NUMBER(member, exists) {#member, #member "_error", found.member, errors.member, exists}
        DH_NUMBER(contact, 1),
        DH_NUMBER(dampers, 1),
        DH_NUMBER(friction, 1),
        DH_NUMBER(on_base, 1),
        DH_NUMBER(equivalent_damping, found.contact_moves),
        DH_NUMBER(equivalent_damping_ratio, found.contact_moves),
        DH_NUMBER(textbook_contact, found.contact_moves),
        DH_NUMBER(textbook_contact_off, found.contact_moves),
        DH_NUMBER(textbook_amplitude, found.textbook_amplitude_exists),
        DH_NUMBER(textbook_amplitude_off, found.textbook_amplitude_exists),
#undef DH_NUMBER
    };
    for (k = 0; k < sizeof all / sizeof all[0]; ++k) {
        *doubles(result, all[k].name, 1, 1) = all[k].exists ? all[k].value : mxGetNaN();
        *doubles(result, all[k].of_error, 1, 1) = all[k].exists ? all[k].error : mxGetNaN();
    }
    return result;
}

static mxArray* place_of_rest(size_t N, const mxArray* const* arguments) {
    mxArray* result = empty_struct();
    double* x = doubles(result, "x", 1, N);
    (void)arguments;
    need(dh_place_of_rest(held_system, N, x, doubles(result, "x_error", 1, N)));
    return result;
}

/// A start: N numbers, or none for zeros.
static const double* start_of(const mxArray* argument, size_t N, const char* fault) {
    const Numbers found = numbers(argument, fault);
    if (found.count != 0 && found.count != N) fail("denhartog:size", fault);
    return found.count == 0 ? NULL : found.values;
}

/// A column of the first rows of an array, which is freed.
static void column(mxArray* result, const char* name, double* values, size_t count) {
    double* to = doubles(result, name, count, 1);
    size_t n;
    for (n = 0; n < count; ++n) to[n] = values[n];
    mxFree(values);
}

static mxArray* free_decay(size_t N, const mxArray* const* arguments) {
    enum { room = 100000, columns = 10 };
    static const char* const names[columns] = {"turn", "turn_error", "turn_x", "turn_x_error", "stop_start",
                                               "stop_start_error", "stop_end", "stop_end_error", "stop_x", "stop_x_error"};
    dh_decay_request request = {.size = sizeof request};
    dh_decay decay = {.size = sizeof decay, .room = room};
    double** const to[columns] = {&decay.turn, &decay.turn_error, &decay.turn_x, &decay.turn_x_error, &decay.start,
                                  &decay.start_error, &decay.end, &decay.end_error, &decay.stop_x, &decay.stop_x_error};
    double rest[2], rest_error[2];
    mxArray* result = empty_struct();
    size_t k;
    request.r = number(arguments[0], "r must be one number");
    request.beta = number(arguments[1], "beta must be one number");
    request.mu = number(arguments[2], "mu must be one number");
    request.x = start_of(arguments[3], N, "x must be real, of class double, one number for each mass");
    request.x_prime = start_of(arguments[4], N, "v must be real, of class double, one number for each mass");
    request.until = number(arguments[5], "until must be one number");
    for (k = 0; k < columns; ++k) *to[k] = (double*)mxCalloc(room, sizeof(double));
    decay.rest = rest;
    decay.rest_error = rest_error;
    decay.masses = doubles(result, "masses", 1, N);
    decay.masses_error = doubles(result, "masses_error", 1, N);
    need(dh_free_decay(held_system, &request, &decay));
    for (k = 0; k < columns; ++k) column(result, names[k], *to[k], k < 4 ? decay.turns : decay.stops);
    *doubles(result, "rest_from", 1, 1) = decay.at_rest ? rest[0] : mxGetNaN();
    *doubles(result, "rest_at", 1, 1) = decay.at_rest ? rest[1] : mxGetNaN();
    *doubles(result, "rest_from_error", 1, 1) = decay.at_rest ? rest_error[0] : mxGetNaN();
    *doubles(result, "rest_at_error", 1, 1) = decay.at_rest ? rest_error[1] : mxGetNaN();
    for (k = 0; k < N && !decay.at_rest; ++k) decay.masses[k] = decay.masses_error[k] = mxGetNaN();
    *doubles(result, "others", 1, 1) = decay.others;
    mxSetFieldByNumber(result, 0, mxAddField(result, "at_rest"), mxCreateLogicalScalar(decay.at_rest != 0));
    mxSetFieldByNumber(result, 0, mxAddField(result, "on_limit"), mxCreateLogicalScalar(decay.on_limit != 0));
    return result;
}

static mxArray* history(size_t N, const mxArray* const* arguments) {
    dh_history_request request = {.size = sizeof request};
    dh_history found = {.size = sizeof found};
    const double cycles = number(arguments[5], "cycles must be one number"), last = number(arguments[6], "last must be one number"),
                 samples = number(arguments[7], "samples must be one number");
    mxArray* result = empty_struct();
    request.r = number(arguments[0], "r must be one number");
    request.beta = number(arguments[1], "beta must be one number");
    request.mu = number(arguments[2], "mu must be one number");
    request.x = start_of(arguments[3], N, "x must be real, of class double, one number for each mass");
    request.x_prime = start_of(arguments[4], N, "v must be real, of class double, one number for each mass");
    request.without_load = number(arguments[8], "load must be one number") == 0;
    if (!whole_number(cycles, 1, 1000000) || !whole_number(last, 0, cycles) || !whole_number(samples, 0, DH_MOST_SAMPLES) ||
        cycles * samples * (double)N > DH_MOST_DISPLACEMENTS)
        fail("denhartog:size", "cycles, last and samples must be whole numbers, cycles from 1 to 1000000 and last up to it, and "
                               "cycles times samples times masses at most 100000000");
    request.cycles = (int)cycles;
    request.last = (int)last;
    request.samples = (int)samples;
    found.sample_room = (size_t)((last > 0 ? last : cycles) * samples);
    found.stop_room = 1000 + 100 * (size_t)(last > 0 ? last : cycles);
    found.start = (double*)mxCalloc(found.stop_room, sizeof(double));
    found.end = (double*)mxCalloc(found.stop_room, sizeof(double));
    found.stop_x = (double*)mxCalloc(found.stop_room, sizeof(double));
    found.tau = doubles(result, "tau", found.sample_room, 1);
    found.x = doubles(result, "x", N, found.sample_room);
    found.x_prime = doubles(result, "v", N, found.sample_room);
    found.direction = (signed char*)field(result, "direction", mxINT8_CLASS, found.sample_room, 1);
    need(dh_follow(held_system, &request, &found));
    column(result, "stop_start", found.start, found.stops);
    column(result, "stop_end", found.end, found.stops);
    column(result, "stop_x", found.stop_x, found.stops);
    return result;
}

static mxArray* quantity(size_t N, const mxArray* const* arguments) {
    const double r = number(arguments[0], "r must be one number"), beta = number(arguments[1], "beta must be one number");
    const double mu = number(arguments[2], "mu must be one number"), mass = number(arguments[4], "mass must be one number"),
                 tau = number(arguments[5], "tau must be one number"), samples = number(arguments[6], "samples must be one number");
    char name[64] = "";
    size_t count, k, room;
    mxArray* result = empty_struct();
    if (!mxIsChar(arguments[3]) || mxGetString(arguments[3], name, sizeof name) != 0)
        fail("denhartog:input", "name must be the name of a quantity");
    if (!whole_number(mass, 0, (double)N)) fail("denhartog:input", "mass must be a whole number from 1 to N");
    if (!whole_number(samples, 1, DH_MOST_SAMPLES)) fail("denhartog:size", "samples must be a whole number from 1 to 10000000");
    room = strcmp(name, "motion_under_force") == 0 ? (size_t)samples : 1000 + 2 * N;
    double* found[2] = {(double*)mxCalloc(room, sizeof(double)), (double*)mxCalloc(room, sizeof(double))};
    need(dh_quantity(held_system, name, r, beta, mu, (size_t)mass, tau, room, found[0], &count));
    need(dh_quantity_errors(held_system, name, r, beta, mu, (size_t)mass, tau, room, found[1], &count));
    for (k = 0; k < 2; ++k) {
        memcpy(doubles(result, k == 0 ? "values" : "errors", 1, count), found[k], count * sizeof(double));
        mxFree(found[k]);
    }
    return result;
}

typedef struct Command {
    const char* name;
    int arguments; // after the command
    mxArray* (*answer)(size_t N, const mxArray* const* after_the_scene);
} Command;

void mexFunction(int nlhs, mxArray* plhs[], int nrhs, const mxArray* prhs[]) {
    static const Command commands[] = {{"natural_frequencies", 1, natural_frequencies},
                                       {"boundary", 3, boundary},
                                       {"solve", 6, solve},
                                       {"motion", 5, motion},
                                       {"energies", 5, energies},
                                       {"place_of_rest", 1, place_of_rest},
                                       {"free_decay", 7, free_decay},
                                       {"history", 10, history},
                                       {"quantity", 8, quantity},
                                       {"map", 7, map}};
    char name[32] = "";
    size_t n;
    release();
    mexAtExit(release);
    if (nlhs > 1) fail("denhartog:input", "there is one result");
    if (dh_abi_version() != DH_ABI_VERSION) fail("denhartog:internal", "library and header differ in version: build anew");
    if (nrhs < 1 || !mxIsChar(prhs[0]) || mxGetString(prhs[0], name, sizeof name) != 0) name[0] = '\0';
    if (strcmp(name, "version") == 0 && nrhs == 1) {
        plhs[0] = mxCreateString(dh_version());
        return;
    }
    if (strcmp(name, "find") == 0 && nrhs == 6) {
        plhs[0] = find(prhs + 1);
        return;
    }
    for (n = 0; n < sizeof commands / sizeof commands[0]; ++n)
        if (strcmp(name, commands[n].name) == 0 && nrhs == commands[n].arguments + 1) {
            plhs[0] = commands[n].answer(hold_system(prhs[1]), prhs + 2);
            release();
            return;
        }
    fail("denhartog:input", "the first argument must be version, natural_frequencies, boundary, solve, motion, energies, "
                            "place_of_rest, free_decay, history, quantity, map or find, and as many arguments must follow as it takes");
}
