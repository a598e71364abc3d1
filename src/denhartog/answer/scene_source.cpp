// A scene kept for double and for the reference, and changed copies of it: another point, mu or damping tolerance. A
// text is read twice, so that the reference has exactly the decimals that were written. Read `scene_source`, then `changed`.
#include "denhartog/answer/scene_source.hpp"

#include <utility>

#include "denhartog/number/ball_or_none.hpp"
#include "denhartog/scene/converted.hpp"
#include "denhartog/sliding/bounded_modes.hpp"
#if DENHARTOG_REFERENCE
#include "denhartog/reference/modes.hpp"
#endif

namespace denhartog {
namespace {

// The modes in balls of a new system: none yet.
std::shared_ptr<reference::KeptModes> no_modes_yet() {
#if DENHARTOG_REFERENCE
    return std::make_shared<reference::KeptModes>();
#else
    return nullptr;
#endif
}

// A function template on scenes as one of balls.
template <class Read>
std::function<void(Scene<Ball>&)> for_balls([[maybe_unused]] Read read) {
#if DENHARTOG_REFERENCE
    return [read = std::move(read)](Scene<Ball>& scene) { read(scene); };
#else
    return {};
#endif
}

SceneSource source_of_doubles(const std::shared_ptr<const Scene<double>>& given) {
    const auto read = [given]<class T>(Scene<T>& scene) { scene = converted<T>(*given); };
    return std::make_shared<const SceneReader>(SceneReader{given, {}, for_balls(read), no_modes_yet()});
}

// Gives a scene the load that its base or wall makes at its frequency, where that depends on it.
void set_load_of_base(Scene<double>& scene) {
    if (scene.r && load_depends_on_frequency(scene.system)) scene.system = with_load_at(scene.system, *scene.r);
}

template <class Change>
SceneSource changed(const SceneSource& source, const Change& change) {
    auto scene = std::make_shared<Scene<double>>(source->in_double());
    change(*scene);
    set_load_of_base(*scene);
    const auto read = [source, change](auto& in_balls) {
        source->in_balls(in_balls);
        change(in_balls);
    };
    return std::make_shared<const SceneReader>(
        SceneReader{std::move(scene), {}, for_balls(read), source->kept_modes, source->effort});
}

} // namespace

const Scene<double>& SceneReader::in_double() const {
    if (!scene) throw InputError(*error);
    return *scene;
}

SceneSource scene_source(const SceneText& part) {
    SceneOrError<double> narrow = read_scene<double>(part);
    std::shared_ptr<const Scene<double>> scene;
    if (narrow.scene) {
        set_load_of_base(*narrow.scene);
        scene = std::make_shared<const Scene<double>>(*narrow.scene);
    }
    const auto read = [text = std::string(part.text), line = part.line, alone = part.alone]<class T>(Scene<T>& out) {
        SceneOrError<T> found = read_scene<T>(SceneText{text, line, alone});
        if (found.error) throw InputError(*found.error);
        out = std::move(*found.scene);
    };
    return std::make_shared<const SceneReader>(SceneReader{std::move(scene), narrow.error, for_balls(read), no_modes_yet()});
}

SceneSource scene_source(const Scene<double>& scene) {
    auto copy = std::make_shared<Scene<double>>(scene);
    set_load_of_base(*copy);
    return source_of_doubles(std::move(copy));
}

SceneSource source_of_kept(const Scene<double>& scene) {
    if (load_depends_on_frequency(scene.system)) return scene_source(scene);
    return source_of_doubles(std::shared_ptr<const Scene<double>>(std::shared_ptr<void>(), &scene)); // which nobody deletes
}

SceneSource at_point(const SceneSource& source, double r, double beta) {
    return changed(source, [r, beta](auto& scene) {
        scene.r.emplace(r);
        scene.beta.emplace(beta);
    });
}

SceneSource at_frequency(const SceneSource& source, double r) {
    return changed(source, [r](auto& scene) {
        scene.r.emplace(r);
        scene.beta.reset();
    });
}

SceneSource with_static_friction(const SceneSource& source, double mu) {
    return changed(source, [mu](auto& scene) { scene.mu = decltype(scene.mu)(mu); });
}

SceneSource with_damping_tolerance(const SceneSource& source, double tolerance) {
    return changed(source, [tolerance](auto& scene) { scene.system.damping_tolerance = tolerance; });
}

SceneSource without_point(const SceneSource& source) {
    return changed(source, [](auto& scene) {
        scene.mu = decltype(scene.mu)(1);
        scene.r.reset();
        scene.beta.reset();
    });
}

SceneSource without_friction_ratio(const SceneSource& source) {
    return changed(source, [](auto& scene) { scene.beta.reset(); });
}

SceneSource with_effort(const SceneSource& source, Effort* effort) {
    if (source->effort == effort) return source;
    SceneReader paid = *source;
    paid.effort = effort;
    return std::make_shared<const SceneReader>(std::move(paid));
}

ScenePaidFor::ScenePaidFor(const SceneSource& source)
    : effort_(source->effort, source->scene ? number_of_masses(source->scene->system) : 0),
      source_(with_effort(source, effort_.get())) {}

} // namespace denhartog
