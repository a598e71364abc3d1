// Motions from a start in C: the places at which a constant load holds the masses, how a free motion decays, both proved, and the
// motion over many periods. Read `dh_free_decay` first; results reach the caller's arrays only when all numbers are known.
#include <algorithm>
#include <iterator>

#include "denhartog/answer/from_a_start.hpp"
#include "denhartog/c/handles.hpp"
#include "denhartog/number/number_text.hpp"

using namespace denhartog;
using namespace denhartog::c_interface;

namespace {

void need_room(std::size_t needed, std::size_t room, const char* name) {
    if (needed > room)
        throw CallError(DH_ERROR_SIZE,
                        std::string(name) + " must be " + std::to_string(needed) + " or more, but is " + std::to_string(room));
}

// A start of N masses: at rest at zero where both are null.
State start_of(const double* x, const double* x_prime, std::size_t N) {
    State start = at_rest(N);
    if (x != nullptr) std::copy_n(x, N, start.x.begin());
    if (x_prime != nullptr) std::copy_n(x_prime, N, start.x_prime.begin());
    return start;
}

// Numbers with their bounds, and where both go.
struct TwoOutputs {
    Numbers numbers;
    double *to, *errors_to;
};

void hand_out_both(const std::vector<TwoOutputs>& columns) {
    for (const ValueOrError part : {ValueOrError::value, ValueOrError::error}) {
        std::vector<Output> all;
        for (const TwoOutputs& each : columns)
            all.push_back({each.numbers, part == ValueOrError::value ? each.to : each.errors_to});
        hand_out(part, all);
    }
}

// A number of each of several, with its bound.
template <class Each, class Part>
Numbers numbers_of(const std::vector<Each>& all, const Part& part) {
    Numbers numbers;
    for (const Each& each : all) numbers.push_back(bounded(part(each)));
    return numbers;
}

} // namespace

extern "C" {

int dh_place_of_rest(const dh_system* system, size_t count, double* x, double* x_error) noexcept {
    return guarded([&] {
        need_count(count, masses_of(system));
        need(x, "x");
        std::vector<Certified> places = place_of_rest(paid(system->prepared.source));
        places.resize(count); // zero without a constant load
        hand_out_both({{numbers_of(places, [](const Certified& place) { return place; }), x, x_error}});
    });
}

int dh_free_decay(const dh_system* system, const dh_decay_request* request, dh_decay* decay) noexcept {
    return guarded([&] {
        need_struct(request, "request");
        need_struct(decay, "decay");
        const std::size_t N = masses_of(system);
        const SceneSource source = paid(point_of(system, request->r, request->beta, request->mu));
        if (!(request->until >= 0)) throw InputError("until", "must be zero or positive", number_to_text(request->until));
        const FreeDecay found = free_decay(source, start_of(request->x, request->x_prime, N),
                                           request->until > 0 ? std::optional(request->until) : std::nullopt);
        need_room(std::max(found.turns.size(), found.stops.size()), decay->room, "room");
        const Certified none{};
        hand_out_both({{numbers_of(found.turns, [](const DecayTurn& t) { return t.tau; }), decay->turn, decay->turn_error},
                       {numbers_of(found.turns, [](const DecayTurn& t) { return t.x; }), decay->turn_x, decay->turn_x_error},
                       {numbers_of(found.stops, [](const SolvedStop& s) { return s.start; }), decay->start, decay->start_error},
                       {numbers_of(found.stops, [](const SolvedStop& s) { return s.end; }), decay->end, decay->end_error},
                       {numbers_of(found.stops, [](const SolvedStop& s) { return s.x; }), decay->stop_x, decay->stop_x_error},
                       {numbers_of(found.masses, [](const Certified& x) { return x; }), decay->masses, decay->masses_error},
                       {{bounded(found.at_rest ? found.rest_from : none), bounded(found.at_rest ? found.rest_at : none)},
                        decay->rest,
                        decay->rest_error}});
        decay->turns = found.turns.size();
        decay->stops = found.stops.size();
        decay->at_rest = found.at_rest;
        decay->on_limit = found.at_rest && found.on_limit;
        decay->others = !found.at_rest || !found.others_come_to_rest ? DH_NOT_KNOWN
                        : *found.others_come_to_rest                 ? DH_COME_TO_REST
                                                                     : DH_VIBRATE;
    });
}

int dh_follow(const dh_system* system, const dh_history_request* request, dh_history* history) noexcept {
    return guarded([&] {
        need_struct(request, "request");
        need_struct(history, "history");
        const std::size_t N = masses_of(system);
        HistorySettings settings;
        settings.cycles = request->cycles;
        if (request->last != 0) settings.last = request->last;
        settings.start = start_of(request->x, request->x_prime, N);
        settings.samples = request->samples;
        settings.without_load = request->without_load != 0;
        const MotionHistory found = motion_history(paid(point_of(system, request->r, request->beta, request->mu)), settings);
        if (found.status != IntegrationStatus::complete) throw PrecisionError(found.reason, Outcome::not_converged);
        const std::size_t stops = found.stops.size(), samples = found.times.size();
        need_room(stops, history->stop_room, "stop_room");
        need_room(samples, history->sample_room, "sample_room");
        std::vector<double> start, end, at, x, x_prime;
        for (const HistoryStop& stop : found.stops) {
            start.push_back(stop.start);
            end.push_back(stop.end.value_or(-1));
            at.push_back(stop.x);
        }
        for (const State& state : found.states) {
            std::ranges::copy(state.x, std::back_inserter(x));
            std::ranges::copy(state.x_prime, std::back_inserter(x_prime));
        }
        const std::pair<const std::vector<double>*, double*> all[] = {{&start, history->start}, {&end, history->end},
                                                                      {&at, history->stop_x},   {&found.times, history->tau},
                                                                      {&x, history->x},         {&x_prime, history->x_prime}};
        for (const auto& [numbers, to] : all) need_finite(*numbers);
        for (const auto& [numbers, to] : all)
            if (to != nullptr) std::ranges::copy(*numbers, to);
        for (std::size_t n = 0; n < samples && history->direction != nullptr; ++n)
            history->direction[n] = static_cast<signed char>(found.directions[n]);
        history->stops = stops;
        history->samples = samples;
        history->from = found.from;
    });
}

} // extern "C"
