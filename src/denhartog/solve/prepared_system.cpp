#include "denhartog/solve/prepared_system.hpp"

#include <cmath>

#include "denhartog/number/errors.hpp"

namespace denhartog {
namespace {

constexpr int most_digits_solved_in_double = 10; // of a contact; beyond, the modes of long double may be needed

bool has_damping_ratios(const System<double>& s) { return !s.damping_ratios.empty(); }

void prepare_contact(PreparedSystem& p, int digits) {
    const System<double>& s = p.scene.system;
    const std::vector<Mass> masses = contact_and_load(s);
    p.contact = contact_modes(basis_with_errors_at(s, masses));
    if (digits > most_digits_solved_in_double && digits <= most_digits_bounded_beforehand)
        p.contact_sharp = contact_modes(sharp_basis_at(p.source.in_long_double().system, masses));
    if (digits <= most_digits_bounded_beforehand) return;
    p.contact_in_50 = modal_basis_at(p.source.in_50_digits().system, masses);
    p.contact_in_100 = modal_basis_at(p.source.in_100_digits().system, masses);
}

void prepare_every_regime(PreparedSystem& p) {
    const System<double>& s = p.scene.system;
    auto moving = std::make_shared<ContactSystem<double>>(contact_system(s));
    p.basis = moving->basis;
    if (has_damping_ratios(s)) p.bounded = std::make_shared<const ModalBasis<Bounded>>(with_errors(s, *p.basis));
    p.moving = std::move(moving);
}

} // namespace

Aim aim_of(const Question& question) {
    const int digits = question.digits.value_or(digits_by_default);
    return {digits, question.digits.has_value(), std::pow(10.0, -digits)};
}

std::string in_words(const Aim& aim) {
    return std::to_string(aim.digits) + (aim.digits == 1 ? " digit" : " digits") + (aim.asked_for ? " asked for" : " aimed at");
}

void check(const Question& question, std::size_t N) {
    const int digits = aim_of(question).digits;
    if (digits < 1 || digits > most_digits)
        throw InputError("digits", "must be from 1 to " + std::to_string(most_digits), std::to_string(digits));
    if (question.mass && question.mass->index >= N)
        throw InputError("mass", "must be a mass from 1 to " + std::to_string(N), std::to_string(question.mass->index + 1));
}

bool asks_for_contact(const Question& question, Mass contact) {
    return question.mass == contact && !question.all && (question.asked == Asked::amplitude || question.asked == Asked::phase);
}

template <class T>
std::vector<Mass> contact_and_load(const System<T>& s) {
    return s.contact == s.load ? std::vector<Mass>{s.contact} : std::vector<Mass>{s.contact, s.load};
}

PreparedSystem prepare(const SceneSource& source, const Question& question, Prepared points) {
    PreparedSystem p{source, source.in_double()};
    check(p.scene);
    const System<double>& s = p.scene.system;
    check(question, number_of_masses(s));
    if (has_damping_ratios(s) && p.scene.mu == 1 && asks_for_contact(question, s.contact))
        prepare_contact(p, aim_of(question).digits);
    if (points == Prepared::every_regime) prepare_every_regime(p);
    return p;
}

PreparedSystem prepare(const System<double>& system, const Question& question, Prepared points) {
    Scene<double> scene;
    scene.system = system;
    return prepare(scene_source(scene), question, points);
}

PreparedSystem with_static_friction(PreparedSystem system, double mu) {
    system.scene.mu = mu;
    system.source = with_static_friction(system.source, mu);
    return system;
}

template std::vector<Mass> contact_and_load(const System<double>&);

} // namespace denhartog
