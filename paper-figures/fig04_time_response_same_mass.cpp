// Fig. 4: steady motion of five masses with friction and load on the first, (46) against the paper's algorithm.
#include "time_response.hpp"

namespace denhartog::figures::fig04_time_response_same_mass {

Record make(Figure& figure) {
    const std::vector<TimeResponse> panels = time_responses(figure, 1);
    const TimeResponse &a = panels[0], &b = panels[1];
    Record record = record_of(panels, 1);
    const Departure departure = largest_departure(a, 1, 5);
    record.statements = {
        excellent_agreement(panels),
        steady_early(panels),
        {"With the load on the contact all masses move in phase or in phase-opposition, still so at modal damping ratios of "
         "0.01; "
         "here: to 15 degrees",
         "largest departure " + text(departure.degrees, "%.3g") + " degrees, mass " + std::to_string(departure.mass),
         departure.degrees < 15, "to 15 degrees"},
        every_phase_differs(b),
        damping_matters_late(a, b, 1),
    };
    return record;
}

const Listed listed("fig04_time_response_same_mass", make);

} // namespace denhartog::figures::fig04_time_response_same_mass
