#include <algorithm>
#include <cmath>

#include "denhartog/evaluation/contact.hpp"
#include "denhartog/number/errors.hpp"
#include "denhartog/number/multiprecision.hpp"
#include "denhartog/sliding/steady_state.hpp"
#include "denhartog/solve/solve_task.hpp"

namespace denhartog {
namespace {

constexpr int most_digits_in_double = 15;
constexpr int most_digits_in_50 = 45;

// Amplitude and phase of the contact in T from rows of the mode shapes; the regime is known.
template <class T>
struct ContactMotion {
    T X_j, phi_j;
};

template <class T>
ContactMotion<T> motion_in(const PreparedSystem& p, const std::optional<ModalBasis<T>>& prepared, const SolvePoint& at) {
    const auto [r, beta] = point_in<T>(at);
    const std::vector<Mass> masses = contact_and_load(p.scene.system);
    const ModalBasis<T> own = prepared ? ModalBasis<T>{} : modal_basis_at(system_in<T>(p), masses);
    const ModalBasis<T>& basis = prepared ? *prepared : own;
    const ModeSums<T> s = mode_sums(basis, Mass{0}, Mass{masses.size() - 1}, r);
    return {evaluation::displacement_transmissibility_of_contact(s.V[0], s.U[0], s.G[0], beta),
            wrapped(evaluation::phase_of_contact(s.V[0], s.U[0], beta))};
}

// Twice the differences from the wider type, with a unit in the last place.
template <class T>
struct Measured {
    T amplitude, phase; // errors
    double relative;    // the largest that counts
};

template <class T, class Wide>
Measured<T> measured(const ContactMotion<T>& m, const ContactMotion<Wide>& wide, bool phases) {
    using std::abs;
    const T unit = std::numeric_limits<T>::epsilon();
    const Wide apart = abs(Wide(Wide(m.X_j) - wide.X_j)), turn = abs(wrapped(Wide(Wide(m.phi_j) - wide.phi_j)));
    Measured<T> error{static_cast<T>(2 * apart) + unit * m.X_j, static_cast<T>(2 * turn) + 4 * unit, 1};
    if (!(m.X_j > 0)) return error;
    error.relative = static_cast<double>(T(error.amplitude / m.X_j));
    if (phases) error.relative = std::max(error.relative, static_cast<double>(error.phase));
    return error;
}

template <class T>
void write(const PreparedSystem& p, const SolvePoint& at, const ContactMotion<T>& m, const Measured<T>& error,
           double slides_below, std::string why, Solution& s) {
    const auto [r, beta] = point_in<T>(at);
    Solved<T> numbers{r, beta, p.scene.system.contact};
    numbers.only = numbers.contact;
    numbers.slides_below = T(slides_below);
    numbers.masses.push_back({m.X_j, m.phi_j, error.amplitude, error.phase, std::nullopt});
    s.numbers = std::move(numbers);
    s.regime = {Regime::continuous, {}, false, certainly_slides};
    s.method = {"closed form", precision_of<T>(), std::move(why)};
    s.relative_error = error.relative;
}

Measured<double> bounds_of(const ContactSolution& found, bool phases) {
    const double relative = found.amplitude.e / found.amplitude.x;
    return {found.amplitude.e, found.phase.e, phases ? std::max(relative, found.phase.e) : relative};
}

// Where the bound known beforehand is too wide: errors measured in wider types.
bool answer_measured(const PreparedSystem& p, const SolvePoint& at, const Aim& aim, bool phases, const ContactSolution& found,
                     Solution& s) {
    const ContactMotion<Real50> in_50 = motion_in<Real50>(p, p.contact_in_50, at);
    if (aim.digits <= most_digits_in_double) {
        const ContactMotion<double> in_double{found.amplitude.x, found.phase.x};
        const Measured<double> error = measured(in_double, in_50, phases);
        if (error.relative <= aim.tolerance) {
            write(p, at, in_double, error, found.slides_below, "checked in 50 digits: it has the " + in_words(aim), s);
            return true;
        }
        count_precision_step();
    }
    const Measured<Real50> error = measured(in_50, motion_in<Real100>(p, p.contact_in_100, at), phases);
    if (!(error.relative <= aim.tolerance)) return false;
    write(p, at, in_50, error, found.slides_below, "checked in 100 digits: it has the " + in_words(aim), s);
    return true;
}

// The same from numbers in long double; a point given in double is exact.
std::optional<ContactSolution> sharp_solution(const PreparedSystem& p, const SolvePoint& at) {
    const auto [r, beta] = point_in<long double>(at);
    const auto solution = [r = as_input(r), beta = as_input(beta)](const ContactModes& modes) {
        return contact_solution(modes, r, beta);
    };
    if (p.contact_sharp) return solution(*p.contact_sharp);
    return solution(contact_modes(sharp_basis_at(system_in<long double>(p), contact_and_load(p.scene.system))));
}

} // namespace

bool answer_by_contact(const PreparedSystem& p, const SolvePoint& at, const Question& question, Solution& s) {
    const Aim aim = aim_of(question);
    if (!p.contact || !asks_for_contact(question, p.scene.system.contact) || aim.digits > most_digits_in_50) return false;
    const bool phases = question.asked == Asked::phase;
    const Bounded r = as_input(at.r), beta = as_input(at.beta);
    std::optional<ContactSolution> found = contact_solution(*p.contact, r, beta);
    const char* why = "";
    const auto has_digits = [&] {
        if (!found || !(bounds_of(*found, phases).relative <= aim.tolerance)) return false;
        write(p, at, ContactMotion<double>{found->amplitude.x, found->phase.x}, bounds_of(*found, phases), found->slides_below,
              std::string(why) + "the error bound known beforehand leaves the " + in_words(aim), s);
        return true;
    };
    if (has_digits()) return true;
    if (!found) return false;
    if (aim.digits <= most_digits_bounded_beforehand) {
        count_precision_step();
        const std::optional<ContactSolution> rough = found;
        found = sharp_solution(p, at);
        why = "with the modes of long double; ";
        if (has_digits()) return true;
        if (!found) found = rough;
        count_precision_step();
    }
    try {
        return answer_measured(p, at, aim, phases, *found, s);
    } catch (const DomainError&) {
        return false; // the next rung says where the pole is
    }
}

} // namespace denhartog
