// Fig. 6: amplitude and phase of a single mass over the frequency ratio at three damping ratios.
#include "response_statements.hpp"
#include "tests/support/paper_systems.hpp"

namespace denhartog::figures::fig06_single_mass_response {

const Mass mass{0};

Record make(Figure& figure) {
    const ResponseOverR shown{
        mass, {0.1, 0.2, 0.4, 0.6, 0.8}, 0.05, 2, 0.005, spaced(0.1, 2, 39), [](double) { return -pi<double>() / 2; }};
    std::vector<Damped> all;
    for (const double zeta : {0.001, 0.01, 0.1}) all.push_back(damped(figure, shown, zeta, single_mass(zeta)));
    Record record;
    record.title = "Amplitude and phase of a single mass over the frequency ratio";
    record.equations = {"38", "39", "52", "53", "69"};
    record.given = {"a single mass, friction and load on it", "mu = 1", "zeta = 0.001, 0.01, 0.1"};
    record.chosen = {"beta = 0, 0.1, 0.2, 0.4, 0.6, 0.8; beta = 0 without markers",
                     "r from 0.05 to 2, markers from 0.1 on in steps of 0.05",
                     "amplitudes on a logarithmic axis, for peaks between 1 and 500"};
    for (const Damped& d : all) compare(record, d, true);
    record.statements.push_back(regimes_as_predicted(all));
    peak_statements(record, all, mass, shown.betas);
    low_frequency_statements(record, all, 0.3);
    high_frequency_statements(record, all, mass, shown.betas);
    return record;
}

const Listed listed("fig06_single_mass_response", make);

} // namespace denhartog::figures::fig06_single_mass_response
