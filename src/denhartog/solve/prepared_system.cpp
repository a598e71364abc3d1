#include "denhartog/solve/prepared_system.hpp"

#include "denhartog/answer/sliding_point.hpp"
#include "denhartog/model/coordinates.hpp"
#include "denhartog/number/errors.hpp"
#include "denhartog/scene/mass_rules.hpp"
#include "denhartog/stick_slip/rounded_system.hpp"

namespace denhartog {
namespace {

constexpr int most_digits_of_contact_in_double = 11; // beyond, the modes of 50 digits may be needed

void prepare_every_regime(PreparedSystem& p) {
    const System<double>& s = p.scene().system;
    try {
        const ModalBasis<double> basis = modal_basis(s);
        p.moving = std::make_shared<const ContactSystem<double>>(contact_system(s, basis));
        p.bounded = std::make_shared<const ModalBasis<Bounded<double>>>(with_errors(s, basis));
    } catch (const PrecisionError& e) {
        const SceneIn<Real50> in = scene_with_modes<Real50>(p.source);
        p.moving = std::make_shared<const ContactSystem<double>>(
            rounded(contact_system(in.scene.system, values_of(*in.basis)), e.what()));
        p.bounded = std::make_shared<const ModalBasis<Bounded<double>>>(in_double(*in.basis));
    }
}

} // namespace

void check(const Question& question, std::size_t N) {
    (void)aim_of(question.digits);
    if (question.mass) check_mass(*question.mass, N, "mass");
}

Question of_displacements(Question question, const System<double>& s) {
    if (question.mass) question.mass = displacement_of(s, *question.mass);
    return question;
}

bool asks_for_contact(const Question& question, Mass contact) {
    return question.mass == contact && !question.all && (question.asked == Asked::amplitude || question.asked == Asked::phase);
}

template <class T>
ContactModes<T> contact_modes_of(const SceneSource& source) {
    const Scene<T>& scene = scene_in<T>(source);
    const System<T>& s = scene.system;
    const bool same = s.contact == s.load;
    const std::vector<Mass> rows = same ? std::vector<Mass>{s.contact} : std::vector<Mass>{s.contact, s.load};
    return contact_modes(std::make_shared<const ModalBasis<Bounded<T>>>(bounded_basis_at(s, rows)), Mass{0},
                         Mass{same ? 0U : 1U});
}

std::shared_ptr<const ModalBasis<Bounded<double>>> modes_in_double(const SceneSource& source) {
    try {
        return modes_with_errors(source->in_double().system);
    } catch (const PrecisionError&) {
        return std::make_shared<const ModalBasis<Bounded<double>>>(in_double(*scene_with_modes<Real50>(source).basis));
    }
}

PreparedSystem prepare(const SceneSource& source, const Question& question, Prepared points) {
    PreparedSystem p{source};
    check(p.scene());
    const System<double>& s = p.scene().system;
    check(question, number_of_masses(s));
    if (s.damping_matrix.size() == 0 && p.scene().mu == 1 && asks_for_contact(of_displacements(question, s), s.contact)) {
        try {
            p.contact = contact_modes_of<double>(source);
            if (aim_of(question.digits).digits > most_digits_of_contact_in_double)
                p.contact_in_50 = std::make_shared<const ContactModes<Real50>>(contact_modes_of<Real50>(source));
        } catch (const PrecisionError&) {
            p.contact.reset(); // another model answers
        }
    }
    if (points == Prepared::every_regime) prepare_every_regime(p);
    return p;
}

PreparedSystem prepare(const System<double>& system, const Question& question, Prepared points) {
    Scene<double> scene;
    scene.system = system;
    return prepare(scene_source(scene), question, points);
}

PreparedSystem with_static_friction(PreparedSystem system, double mu) {
    system.source = with_static_friction(system.source, mu);
    return system;
}

template ContactModes<Real50> contact_modes_of(const SceneSource&);
template ContactModes<Real100> contact_modes_of(const SceneSource&);

} // namespace denhartog
