// Fig. 5: steady motion of five masses with friction on the third and load on the first, (46) against the paper's algorithm.
#include "time_response.hpp"

namespace denhartog::figures::fig05_time_response_other_mass {

Record make(Figure& figure) {
    const std::vector<TimeResponse> panels = time_responses(figure, 3);
    const TimeResponse &a = panels[0], &b = panels[1];
    Record record = record_of(panels, 3);
    const Departure beyond = largest_departure(a, 3, 5), first = largest_departure(a, 1, 1), second = largest_departure(a, 2, 2);
    record.statements = {
        excellent_agreement(panels),
        steady_early(panels),
        {"The masses from the contact on, 3 to 5, move in phase or in phase-opposition, still so at modal damping ratios of "
         "0.01; "
         "here: to 15 degrees",
         "largest departure " + text(beyond.degrees, "%.3g") + " degrees, mass " + std::to_string(beyond.mass),
         beyond.degrees < 15, "to 15 degrees"},
        {"The masses before the contact, 1 and 2, have other phases; here: each by more than 15 degrees at 0.01",
         "mass 1 departs by " + text(first.degrees, "%.3g") + " degrees, mass 2 by " + text(second.degrees, "%.3g"),
         first.degrees > 15 && second.degrees > 15, "by 15 degrees"},
        every_phase_differs(b),
        damping_matters_late(a, b, 3),
    };
    return record;
}

const Listed listed("fig05_time_response_other_mass", make);

} // namespace denhartog::figures::fig05_time_response_other_mass
