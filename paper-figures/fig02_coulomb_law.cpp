// Fig. 2: friction force over relative velocity by Coulomb's law, (3).
#include "figure.hpp"

namespace denhartog::figures::fig02_coulomb_law {

Record make(Figure& figure) {
    const double mu = 1.5;
    figure.add({"slides to the left", {"velocity", "force over F"}, {{-1, -1}, {0, -1}}});
    figure.add({"sticks", {"velocity", "force over F"}, {{0, -mu}, {0, mu}}});
    figure.add({"slides to the right", {"velocity", "force over F"}, {{0, 1}, {1, 1}}});
    Record record;
    record.title = "Friction force over the relative velocity in the contact, by Coulomb's law (3)";
    record.equations = {"3"};
    record.chosen = {"mu = 1.5, so that static and kinetic friction can be told apart; every other figure has mu = 1"};
    return record;
}

const Listed listed("fig02_coulomb_law", make);

} // namespace denhartog::figures::fig02_coulomb_law
