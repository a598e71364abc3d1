#include "denhartog/solve/prepared_system.hpp"

#include "denhartog/answer/modes_in_double.hpp"
#include "denhartog/model/contact_and_load.hpp"
#include "denhartog/number/tried.hpp"
#include "denhartog/scene/point_rules.hpp"
#include "denhartog/sliding/bounded_modes.hpp"

namespace denhartog {

void check(const Question& question, std::size_t N) {
    (void)aim_of(question.digits);
    if (question.mass) check_mass(*question.mass, N, "mass");
}

bool asks_for_contact(const Question& question, const System<double>& s) {
    return question.mass == contact_row(s) && !question.all &&
           (question.asked == Asked::amplitude || question.asked == Asked::phase);
}

namespace {

// The modes of a system as its contact has them.
ContactModes modes_of_contact(const System<double>& s) {
    const bool same = contact_row(s) == load_row(s);
    const std::vector<Mass> rows = same ? std::vector<Mass>{s.contact} : std::vector<Mass>{s.contact, load_row(s)};
    return contact_modes(std::make_shared<const ModalBasis<Bounded<double>>>(bounded_basis_at(s, rows)), Mass{0},
                         Mass{same ? 0U : 1U});
}

} // namespace

PreparedSystem prepare(const SceneSource& source, const Question& question, Prepared points) {
    PreparedSystem p{source};
    check(p.scene());
    const System<double>& s = p.scene().system;
    check(question, number_of_masses(s));
    const bool in_phase = s.load_phases.empty() && !load_depends_on_frequency(s);
    if (s.damping_matrix.size() == 0 && p.scene().mu == 1 && in_phase && asks_for_contact(question, s))
        p.contact = tried([&] { return modes_of_contact(s); }).value; // without, another model answers
    if (points == Prepared::every_regime) {
        const ModesInDouble modes = modes_in_double(source);
        p.bounded = modes.basis;
        p.moving = moving_in_double(source, modes);
    }
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

} // namespace denhartog
