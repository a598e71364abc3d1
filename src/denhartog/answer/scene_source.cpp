#include "denhartog/answer/scene_source.hpp"

#include "denhartog/answer/reference.hpp"

#include <utility>

#include "denhartog/model/coordinates.hpp"
#include "denhartog/number/ball_or_none.hpp"
#include "denhartog/scene/converted.hpp"
#if DENHARTOG_REFERENCE
#include "denhartog/reference/modes.hpp"
#endif

namespace denhartog {
namespace {

[[noreturn]] void fail_without_reference() {
    throw PrecisionError(has_reference() ? "this scene is not to be had by the reference" : built_without_reference);
}

// What a new system has of its modes in balls: nothing yet.
std::shared_ptr<reference::KeptModes> no_modes_yet() {
#if DENHARTOG_REFERENCE
    return std::make_shared<reference::KeptModes>();
#else
    return nullptr;
#endif
}

// A scene in double, or what is wrong with it, and a function that gives it in balls.
template <class Read>
struct ReadBy final : SceneReader {
    SceneOrError<double> narrow;
    Read read;
    ReadBy(SceneOrError<double> narrow_, Read read_, std::shared_ptr<reference::KeptModes> kept)
        : narrow(std::move(narrow_)), read(std::move(read_)) {
        kept_modes = std::move(kept);
    }
    [[nodiscard]] const Scene<double>& in_double() const override {
        if (narrow.error) throw InputError(*narrow.error);
        return *narrow.scene;
    }
    void in_balls([[maybe_unused]] Scene<Ball>& scene) const override {
#if DENHARTOG_REFERENCE
        read(scene);
#else
        fail_without_reference();
#endif
    }
};

// A scene of numbers in double, which this or somebody else keeps.
struct OfDoubles final : SceneReader {
    std::optional<Scene<double>> copy;
    std::unique_ptr<const Scene<double>> in_coordinates; // in its own coordinates, where these are others
    const Scene<double>*given, *scene;
    OfDoubles(const Scene<double>& scene_, bool keeps) : given(keeps ? &copy.emplace(scene_) : &scene_), scene(given) {
        kept_modes = no_modes_yet();
        if (is_of_papers_form(scene->system)) return;
        in_coordinates = std::make_unique<const Scene<double>>(in_own_coordinates(*given));
        scene = in_coordinates.get();
    }
    [[nodiscard]] const Scene<double>& in_double() const override { return *scene; }
    void in_balls([[maybe_unused]] Scene<Ball>& in_balls) const override {
#if DENHARTOG_REFERENCE
        in_balls = converted<Ball>(*given);
#else
        fail_without_reference();
#endif
    }
};

template <class Read>
SceneSource source_by(SceneOrError<double> narrow, Read read, std::shared_ptr<reference::KeptModes> kept) {
    return std::make_shared<const ReadBy<Read>>(std::move(narrow), std::move(read), std::move(kept));
}

// The number type of a scene.
template <class T>
T number_type(const Scene<T>&);

// The same source with something of its scene changed.
template <class Change>
SceneSource changed(const SceneSource& source, const Change& change) {
    SceneOrError<double> narrow;
    change(narrow.scene.emplace(source->in_double()));
    const auto read = [source, change](auto& scene) {
        source->in_balls(scene);
        change(scene);
    };
    return source_by(std::move(narrow), read, source->kept_modes);
}

} // namespace

void SceneReader::in_balls(Scene<Ball>&) const { fail_without_reference(); }

SceneSource scene_source(const SceneText& part) {
    SceneOrError<double> narrow = read_scene<double>(part);
    if (narrow.scene) narrow.scene = in_own_coordinates(*narrow.scene);
    return source_by(
        std::move(narrow),
        [text = std::string(part.text), line = part.line, alone = part.alone]<class T>(Scene<T>& scene) {
            SceneOrError<T> read = read_scene<T>(SceneText{text, line, alone});
            if (read.error) throw InputError(*read.error);
            scene = std::move(*read.scene);
        },
        no_modes_yet());
}

SceneSource scene_source(const Scene<double>& scene) { return std::make_shared<const OfDoubles>(scene, true); }

SceneSource source_of_kept(const Scene<double>& scene) { return std::make_shared<const OfDoubles>(scene, false); }

SceneSource at_point(const SceneSource& source, double r, double beta) {
    return changed(source, [r, beta](auto& scene) {
        using Number = decltype(number_type(scene));
        scene.r = Number(r);
        scene.beta = Number(beta);
    });
}

SceneSource at_frequency(const SceneSource& source, double r) {
    return changed(source, [r](auto& scene) {
        scene.r = decltype(number_type(scene))(r);
        scene.beta.reset();
    });
}

SceneSource with_static_friction(const SceneSource& source, double mu) {
    return changed(source, [mu](auto& scene) { scene.mu = decltype(number_type(scene))(mu); });
}

SceneSource with_damping_tolerance(const SceneSource& source, double tolerance) {
    return changed(source, [tolerance](auto& scene) { scene.system.damping_tolerance = tolerance; });
}

SceneSource without_point(const SceneSource& source) {
    return changed(source, [](auto& scene) {
        scene.mu = decltype(number_type(scene))(1);
        scene.r.reset();
        scene.beta.reset();
    });
}

SceneSource without_friction_ratio(const SceneSource& source) {
    return changed(source, [](auto& scene) { scene.beta.reset(); });
}

} // namespace denhartog
