// The reasons of answers and refusals; messages/sentences.cpp has the sentence of each.
#pragma once

#include "denhartog/number/errors.hpp"

namespace denhartog {

enum class Why : std::uint8_t {
    as_told, effort_spent, work_is_spent, cancelled, but, namely, certain, as_double_sees, in_double, end_of_brackets,
    modes_not_converged, chain_not_converged, lowest_frequency_lost, mode_out_of_range, stuck_mode_out_of_range, damping_lost,
    frequencies_coincide, frequency_without_digits, masses_tied, entries_differ, rate_out_of_range, friction_without_digits,
    motion_mirrors_itself, response_33_is_infinite, functions_out_of_range, pole, pole_by_rounding, largest_not_settled,
    too_many_oscillations, slides, certainly_slides, can_rest, no_closed_form, never_moves, rests_only_from, nothing_holds,
    near_boundary, on_boundary, boundaries_unknown, boundary_out_of_range, not_sliding, beyond_sliding, stuck_mode_resonates,
    held_system_resonates, stuck_response_out_of_range, grazes, stays_at_rest, rests_on_boundary, tends_to_rest, restless,
    too_fast, chattering, not_periodic, within_periods, still_grows, comes_nearest, another_orbit, fast_mode, from_the_start,
    from_rest_followed, from_rest_unproved, from_rest_elsewhere, none_from_rest, moves_too_little, rest_leads_to_sliding,
    rest_leads_to_stops, stops, does_not_stop, slides_otherwise, no_stop_seen, stops_open, stop_proved, stability_open, unique,
    share_kept, may_depend, any_share, may_last, bound, bound_by_residual, bound_by_equations, of_number, digits_missing,
    so_many_certain, regime_uncertain, zeros_given, out_of_double, samples_uncertain, motion_at_boundary, no_amplitude,
    no_reference, not_asked, proved, not_proved, bits_too_few, no_guess, hold_disproved, regime_disproved, may_be_boundary,
    may_resonate_held, may_resonate, may_be_pole, may_be_half_period, no_bound, modes_may_coincide, coupling_may_count,
    other_motion, does_not_slide, start_from_rest, sweep, scaled_sliding, displaced, random_start, newton
};

} // namespace denhartog
