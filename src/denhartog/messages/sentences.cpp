#include <cstddef>
#include <string_view>

#include "denhartog/number/number_text.hpp"
#include "denhartog/number/why.hpp"

namespace denhartog {
namespace {

// {n} is number n as it can be read again, {ni} a whole number, {n.d} one rounded to d digits, {n~} and {n~m} one to the digits
// that are certain, number m being its error, and {n~m/k} to as many as tell it from number k; {n|..|..} chooses words by number
// n; {t} is what somebody else said.
std::string_view sentence(Why says) {
    using enum Why;
    struct Sentence {
        Why says;
        std::string_view text;
    };
    static constexpr Sentence sentences[] = {
        {as_told, "{t}"},
        {effort_spent, "the work allowed is spent, {0i} operations"},
        {work_is_spent, "the work allowed is spent"},
        {cancelled, "cancelled"},
        {but, ", but "},
        {namely, ": "},
        {certain, ". This much is certain: "},
        {as_double_sees, ". As double sees it: "},
        {in_double, "in double: "},
        {end_of_brackets, ")"},
        {modes_not_converged, "the natural frequencies of the system did not converge"},
        {chain_not_converged, "the natural frequencies of {0i} masses did not converge"},
        {lowest_frequency_lost, "the lowest natural frequency is too low beside the highest for the number type"},
        {mode_out_of_range, "mode {0i} is beyond the range of the number type"},
        {stuck_mode_out_of_range, "stuck mode {0i} is beyond the range of the number type"},
        {damping_lost, "damping_matrix: rounding does not leave the damping of mode {0i} a digit"},
        {frequencies_coincide, "natural frequencies coincide, as far as they are told apart"},
        {frequency_without_digits, "double does not have the digits of a natural frequency"},
        {masses_tied, "the two masses in contact are tied so stiffly that double does not tell their displacements apart"},
        {entries_differ, "masses or stiffnesses of the system differ by more than the number type has digits"},
        {rate_out_of_range, "a rate of the damped system is beyond the range of the number type"},
        {friction_without_digits, "the number type has too few digits to follow the motion under friction over half a period"},
        {motion_mirrors_itself, "a motion without damping mirrors itself every half-period: friction at this frequency ratio "
                                "has no steady motion"},
        {response_33_is_infinite, "the load excites a resonance without damping: the complex response (33) is infinite there"},
        {functions_out_of_range,
         "the functions (23), (28), (29) of mode {0i} at R = {1} are beyond the range of the number type"},
        {pole, "mode {0i} has no damping and R = {1}: its {2|complex response function (23) is infinite there, and so is the "
               "amplitude in the limit|first damping function (28) is infinite there, and the boundary (69) falls to zero in the "
               "limit}"},
        {pole_by_rounding, "mode {0i} has no damping and R = {1}{2|, which is 1 to the last digits of a double|}: its complex "
                           "response function (23) is infinite there, and so is the amplitude in the limit"},
        {largest_not_settled, "the search does not settle the largest value over the half-period: "},
        {too_many_oscillations, "the motion has too many oscillations, or its maximum is too flat for the digits of the number "
                                "type"},
        {slides, "beta = {0~/1} is below beta_lim = {1~2/0}, Eq. (69): the contact {3|slides|can slide} throughout"},
        {certainly_slides, "beta is below a lower bound of beta_lim, Eq. (69): the contact slides throughout"},
        {can_rest, "it can also rest for ever, because beta is not below {0~1}"},
        {no_closed_form,
         "the closed form does not hold: beta = {0~/1} is not below beta_lim = {1~2/0}, Eq. (69), where {3|the "
         "contact would turn back within the half-period, (54)a|static friction would hold the contact at the end of the "
         "half-period, (54)b|the contact would come to rest at the end of the half-period, (54)a and (54)b}"},
        {never_moves,
         "from beta = {0~1} on static friction outweighs all that the load brings to the contact, which never moves"},
        {rests_only_from, "only from beta = {0~1} on the contact never moves"},
        {nothing_holds, "no friction can hold the contact, because the system resonates with it held"},
        {near_boundary, "beta lies on a boundary to the accuracy computed"},
        {on_boundary, "beta lies within the error bound of a boundary"},
        {boundaries_unknown, "the boundaries are not known: "},
        {boundary_out_of_range, "the boundary is beyond the range of the number type, or has no bound in it"},
        {not_sliding, "the contact does not slide throughout: beta = {0} is not below beta_lim = {1}, Eq. (69)"},
        {beyond_sliding, "beta lies beyond the sliding regime: the amplitude (38) is not a positive number"},
        {stuck_mode_resonates, "the load excites the resonance of an undamped mode of the stuck configuration: no motion with "
                               "the contact held lasts"},
        {held_system_resonates, "the load excites a resonance of the system with the contact held"},
        {stuck_response_out_of_range, "the stuck response is beyond the range of the number type"},
        {grazes, "the contact grazes rest or break-away: which of two motions follows is decided by rounding"},
        {stays_at_rest, "the contact came to rest and stays there: the load on it never reaches mu beta again"},
        {rests_on_boundary, "the contact came to rest and the load on it equals mu beta to rounding: beta is on the boundary of "
                            "permanent sticking"},
        {tends_to_rest, "rest is steady, and with mu = 1 and damping the steady velocities are unique: the contact comes to "
                        "rest, or slips by less and less; the error bound covers where it rests"},
        {restless, "rounding keeps the motion from settling: "},
        {too_fast, "the motion changes faster than the number type can follow"},
        {chattering, "phases of zero length follow each other"},
        {not_periodic, "the motion comes to no periodic motion"},
        {within_periods, " within {0i} periods"},
        {still_grows, ". The motion still grows; its size is {0.3}"},
        {comes_nearest, ". After {0i} half-periods the motion comes nearest to repeating itself: it is {1.3} of its size away"},
        {another_orbit,
         ". A periodic motion of {0i} half-periods exists, which is {1|not certainly stable|stable} with a "
         "largest multiplier of {2.3}, but the motion from the start is {3.3} of its size away from it, and it is not known to "
         "lead there"},
        {fast_mode, ". The fastest mode has {0.2} times the frequency of the force and takes most of the work: leave out a mass "
                    "that is as light if it does not matter"},
        {from_the_start, "from the start from rest "},
        {from_rest_followed, "the start from rest was followed"},
        {from_rest_unproved, "the start from rest was followed without a proof"},
        {from_rest_elsewhere, "the start from rest is not known to lead here"},
        {none_from_rest, "no steady motion was found from the start from rest: "},
        {moves_too_little, "the contact moves too little for double precision to tell its motion from rest"},
        {rest_leads_to_sliding, "the motion from rest is the sliding motion"},
        {rest_leads_to_stops, "the motion from rest is another, which stops in every period"},
        {stops, "the contact stops in every period"},
        {does_not_stop, "the contact does not stop"},
        {slides_otherwise, "the contact does not stop, but the motion is not that of the closed form"},
        {no_stop_seen, "the motion shows no stop, and the bound of its error is {0.2}"},
        {stops_open, "double does not tell whether the contact stops"},
        {stop_proved, "double precision does not tell whether the contact stops, and the reference proves that it does"},
        {stability_open, "double does not tell whether the motion is stable"},
        {unique, "mu = 1 and {0|every mode is damped|the damping matrix is positive definite|friction damps every mode that "
                 "nothing else damps}: the velocities of any two motions under the same force become the same"},
        {share_kept, "no: a mode without damping keeps the share of the motion that the start leads to"},
        {may_depend,
         "not known: {0|the motion may depend on the start, and the one from rest is not known to lead here|with mu "
         "> 1 the motion may depend on the start; this motion is the one from rest|the damping matrix is not positive definite, "
         "and the motion may depend on the start|a mode has no damping, and the motion may depend on the start}"},
        {any_share, "mode {0i} has no damping and {1i} periods in one of the force; with any share of it the motion is steady "
                    "too, until the contact moves by {2.6}"},
        {may_last, "a free motion that nothing is known to damp may last"},
        {bound, "the error bound {0|does not guarantee|guarantees} the {1i} {2|digits|digit} {3|aimed at|asked for}"},
        {bound_by_residual, "its residual bounds the error: "},
        {bound_by_equations, "its residual in the equations of motion bounds the error: "},
        {of_number, " of {t}"},
        {digits_missing, "the {0i} {1|digits|digit} asked for are not reached: "},
        {so_many_certain, "only {0i} are certain ("},
        {regime_uncertain, "the regime is not certain ("},
        {zeros_given, "numbers below 1e-25 of the largest of their kind are given as zero"},
        {out_of_double, "{0|a number|permanent sticking by (88)|the interval of rest} is beyond the range of a double; 16 "
                        "digits and more are written as text"},
        {samples_uncertain, "the samples of the motion are not certain to 6 digits: "},
        {motion_at_boundary, "beta = {0} equals beta_lim to the digits of the answer, so that its motion is not known"},
        {no_amplitude, "the answer has no amplitude of mass {0i}{1||: the closed form does not hold, or the regime alone was "
                       "asked for}"},
        {no_reference, "this needs the reference, and the library was built without it (DENHARTOG_REFERENCE=OFF)"},
        {not_asked, "the reference is asked about no more than {0i} masses unless digits are asked for"},
        {proved, "every number is proved, with balls of {0i} bits"},
        {not_proved, "the reference does not prove it: "},
        {bits_too_few, "the digits are not certain with {0i} bits"},
        {no_guess, "double precision finds no motion with stops to start from"},
        {hold_disproved, "the reference disproves that static friction holds the contact"},
        {regime_disproved, "the reference disproves the regime: "},
        {may_be_boundary, "beta may lie on the boundary of {0|the sliding regime|permanent sticking}"},
        {may_resonate_held, "the system may resonate with the contact held"},
        {may_resonate, "the load may excite the resonance of a mode without damping"},
        {may_be_pole, "a mode without damping may be at a pole"},
        {may_be_half_period, "an instant is not told from a whole half-period"},
        {no_bound, "a number has no bound"},
        {modes_may_coincide, "modes are not told apart, and neither is the damping of each by itself"},
        {coupling_may_count, "{0|the coupling of modes by the damping matrix may equal damping_tolerance|whether the coupling "
                             "of modes counts in (56) takes more bits}"},
        {other_motion, "the motion that is proved {0|is not that of the answer|has another period}"},
        {does_not_slide, "the contact does not slide throughout"},
        {start_from_rest, "start from rest"},
        {sweep, "sweep of {0|r|beta} {1|upwards|downwards}"},
        {scaled_sliding, "sliding motion times {0|1.0|0.5|2.0}"},
        {displaced, "contact displaced, all at rest"},
        {random_start, "random start {0i}"},
        {newton, "Newton's method from: "},
    };
    constexpr auto in_order = [] {
        std::size_t n = 0;
        for (const Sentence& each : sentences) n += each.says == static_cast<Why>(n) ? 1 : 0;
        return n == std::size(sentences) && n == static_cast<std::size_t>(newton) + 1;
    };
    static_assert(in_order(), "a sentence stands at the place of what it says");
    return sentences[static_cast<std::size_t>(says)].text;
}

// The words of a field between braces.
std::string filled(std::string_view field, const Reason& reason) {
    if (field == "t") return reason.text;
    const double number = reason.numbers[static_cast<std::size_t>(field.front() - '0')];
    field.remove_prefix(1);
    if (field.empty()) return number_to_text(number);
    if (field == "i") return std::to_string(static_cast<long long>(number));
    if (field.front() == '.') return number_in_digits(number, field[1] - '0');
    if (field.front() == '~') {
        const auto at = [&](std::size_t place) { return reason.numbers[static_cast<std::size_t>(field[place] - '0')]; };
        const std::size_t slash = field.find('/');
        const double error = field.size() > 1 && slash != 1 ? at(1) : 0;
        return number_in_certain_digits(number, error, slash != field.npos ? at(slash + 1) : number);
    }
    for (auto n = static_cast<int>(number); n > 0; --n) field.remove_prefix(field.find('|', 1));
    return std::string(field.substr(1, field.find('|', 1) - 1));
}

} // namespace

std::string in_words(const Reasons& reasons) {
    std::string words;
    words.reserve(160); // at once: the everyday answer needs no more
    for (const Reason& reason : reasons) {
        std::string_view text = sentence(reason.says);
        const bool goes_on = words.empty() || words.back() == ' ' || words.back() == '(';
        if (!goes_on && text.find_first_of(" .,:)") != 0) words += "; ";
        for (std::size_t at = text.find('{'); at != text.npos; at = text.find('{')) {
            const std::size_t end = text.find('}');
            words.append(text.substr(0, at)).append(filled(text.substr(at + 1, end - at - 1), reason));
            text.remove_prefix(end + 1);
        }
        words.append(text);
    }
    return words;
}

} // namespace denhartog
