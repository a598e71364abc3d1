#if DENHARTOG_REFERENCE
#include "denhartog/answer/reference_point.hpp"

#include "denhartog/number/errors.hpp"

namespace denhartog {

using namespace reference;

namespace {

// The damping that counts: `damping_tolerance` of 2 asks for the nearest damping that each mode has by itself.
SceneInBalls scene_of(const SceneSource& source) {
    Scene<Ball> scene;
    source->in_balls(scene);
    SceneInBalls s = in_matrices(scene);
    const double tolerance = scene.system.damping_tolerance;
    if (s.zeta.empty() && tolerance > 0) {
        if (tolerance < 2)
            throw PrecisionError("the reference takes a damping matrix as it is: damping_tolerance must be 0, or 2");
        const ModesInBalls m = modes_in_balls(s);
        BallMatrix Psi(s.N(), s.N());
        for (slong k = 0; k < s.N(); ++k)
            for (slong i = 0; i < s.N(); ++i) Psi(k, i) = m.psi[static_cast<std::size_t>(k)][static_cast<std::size_t>(i)];
        const BallMatrix D = transposed(Psi) * s.C * Psi;
        for (slong i = 0; i < s.N(); ++i) s.zeta.push_back(D(i, i) * s.r * m.R[static_cast<std::size_t>(i)] / 2); // (18)
        s.C = BallMatrix();
    }
    return s;
}

} // namespace

SceneInBalls damped_scene_in_balls(const SceneSource& source) {
    SceneInBalls s = scene_of(source);
    if (!s.zeta.empty()) s.C = damping_matrix_in_balls(s, modes_in_balls(s));
    return s;
}

PointInBalls point_in_balls(const SceneSource& source, bool needs_boundary) {
    PointInBalls p{scene_of(source)};
    ModesInBalls modes;
    if (!p.scene.zeta.empty()) {
        modes = modes_in_balls(p.scene);
        p.scene.C = damping_matrix_in_balls(p.scene, modes);
    }
    const bool modal = !p.scene.zeta.empty() && are_of_papers_form(modes);
    p.stuck = stuck_in_balls(p.scene);
    if (p.stuck) p.sticking = sticking_limit_in_balls(p.scene, *p.stuck);
    try {
        ResponsesInBalls r = modal ? responses_of_modes(p.scene, std::move(modes)) : responses_of_state(p.scene);
        const Complex<Ball>& V = r.V[r.contact()];
        if (!(V.re.finite() && V.im.finite())) throw Unproved("the load may excite the resonance of a mode without damping");
        p.boundary = boundary_in_balls(p.scene, r);
        p.responses = std::move(r);
    } catch (const Unproved&) {
        if (needs_boundary) throw;
    }
    return p;
}

} // namespace denhartog
#endif
