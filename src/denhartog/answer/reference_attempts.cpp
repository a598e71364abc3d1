#if DENHARTOG_REFERENCE
#include "denhartog/answer/reference_attempts.hpp"

#include <algorithm>

#include "denhartog/number/why.hpp"
#include "denhartog/reference/series.hpp"

namespace denhartog {
namespace {

// Frees, at the end of a thread, the constants that Arb keeps for it.
struct ConstantsOfBalls {
    ~ConstantsOfBalls() { flint_cleanup(); }
};

} // namespace

void with_enough_bits(const SceneSource& source, slong first, slong most,
                      const std::function<bool(const SceneSource& paid, slong bits, bool last)>& attempt) {
    const ScenePaidFor scene(source);
    thread_local const ConstantsOfBalls freed_at_its_end;
    const auto N = static_cast<slong>(number_of_masses(source->in_double().system));
    Reasons why;
    for (slong bits = first;; bits = std::min(2 * bits, most)) {
        bool last = bits == most;
        pay(scene.source()->effort, N * N * (N + 8) * (bits / 64) / 4);
        try {
            const Bits all(bits);
            reference::bits_of_search = 64 * (bits / first);
            if (attempt(scene.source(), bits, last)) return;
            why = {Why::bits_too_few, bits};
        } catch (const reference::Unproved& e) {
            why = e.why;
            last = last || is_disproved(e);
        }
        if (last) throw PrecisionError(Reasons(Why::not_proved) + why);
    }
}

} // namespace denhartog
#endif
