// The inverse question in C, `dh_find`: the values of one number of a scene at which an amplitude is as wanted. The search is
// `find_places`; here its request is checked, and its places are written into the caller's arrays.
#include "denhartog/solve/find.hpp"

#include "denhartog/c/handles.hpp"

using namespace denhartog;
using namespace denhartog::c_interface;

static_assert(static_cast<int>(PlaceIs::crossing) == DH_CROSSING && static_cast<int>(PlaceIs::jump) == DH_JUMP &&
              static_cast<int>(PlaceIs::undecided) == DH_UNDECIDED && static_cast<int>(PlaceIs::extreme) == DH_EXTREME &&
              static_cast<int>(PlaceIs::end_of_range) == DH_END_OF_INTERVAL);

int dh_find(const dh_find_request* request, dh_places* places) noexcept {
    return guarded_without_effort([&] {
        need_struct(request, "request");
        need_struct(places, "places");
        need(request->scene, "scene");
        need(request->vary, "vary");
        need(request->so_that, "so_that");
        const FoundPlaces found =
            find_places({request->scene, request->scene_length}, {request->vary, request->from, request->to},
                        wanted_from(request->so_that), request->samples);
        std::vector<double> numbers;
        for (const FoundPlace& p : found.places)
            numbers.insert(numbers.end(), {p.at, p.from, p.to, p.amplitude.value, p.amplitude.error});
        need_finite(numbers);
        if (found.places.size() > places->room)
            throw CallError(DH_ERROR_SIZE, "room must be " + std::to_string(found.places.size()) + " or more, but is " +
                                               std::to_string(places->room));
        for (size_t n = 0; n < found.places.size(); ++n) {
            const FoundPlace& p = found.places[n];
            if (places->at != nullptr) places->at[n] = p.at;
            if (places->from != nullptr) places->from[n] = p.from;
            if (places->to != nullptr) places->to[n] = p.to;
            if (places->amplitude != nullptr) places->amplitude[n] = p.amplitude.value;
            if (places->error != nullptr) places->error[n] = p.amplitude.error;
            if (places->is != nullptr) places->is[n] = static_cast<int>(p.is);
        }
        places->count = found.places.size();
        places->unanswered = found.unanswered.size();
    });
}
