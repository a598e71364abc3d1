#include "denhartog/answer/scene_source.hpp"

#include <memory>
#include <utility>

#include "denhartog/model/coordinates.hpp"

namespace denhartog {
namespace {

template <class Convert>
SceneSource source_of(const Convert& convert) {
    return {[convert] { return convert(double()); }, [convert] { return convert(Real50()); },
            [convert] { return convert(Real100()); }};
}

// The same source with something of its scene changed.
template <class Change>
SceneSource changed(const SceneSource& source, const Change& change) {
    const auto then = [change](const auto& read) {
        return [read, change] {
            auto scene = read();
            change(scene);
            return scene;
        };
    };
    return {then(source.in_double), then(source.in_50_digits), then(source.in_100_digits)};
}

} // namespace

SceneSource scene_source(const SceneText& part) {
    SceneSource source = source_of([text = std::string(part.text), line = part.line, alone = part.alone]<class T>(T) {
        SceneOrError<T> read = read_scene<T>(SceneText{text, line, alone});
        if (read.error) throw InputError(*read.error);
        return in_own_coordinates(*read.scene);
    });
    // In double it is asked for more than once: it is read once.
    SceneOrError<double> read = read_scene<double>(part);
    if (read.scene) read.scene = in_own_coordinates(*read.scene);
    source.in_double = [read = std::make_shared<const SceneOrError<double>>(std::move(read))] {
        if (read->error) throw InputError(*read->error);
        return *read->scene;
    };
    return source;
}

SceneSource scene_source(const Scene<double>& scene) {
    return source_of([shared = std::make_shared<const Scene<double>>(scene)]<class T>(T) { // by all copies of the source
        if constexpr (std::same_as<T, double>)
            return in_own_coordinates(*shared);
        else
            return in_own_coordinates(converted<T>(*shared));
    });
}

SceneSource at_point(const SceneSource& source, double r, double beta) {
    return changed(source, [r, beta](auto& scene) {
        scene.r = r;
        scene.beta = beta;
    });
}

SceneSource with_static_friction(const SceneSource& source, double mu) {
    return changed(source, [mu](auto& scene) { scene.mu = mu; });
}

SceneSource with_damping_tolerance(const SceneSource& source, double tolerance) {
    return changed(source, [tolerance](auto& scene) { scene.system.damping_tolerance = tolerance; });
}

SceneSource without_friction_ratio(const SceneSource& source) {
    return changed(source, [](auto& scene) { scene.beta.reset(); });
}

} // namespace denhartog
