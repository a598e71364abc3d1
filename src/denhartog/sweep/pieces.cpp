#include "denhartog/sweep/pieces.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

#include "denhartog/sweep/arrays.hpp"

namespace denhartog::sweep {
namespace {

std::string path_of(const Array& array, const std::vector<std::size_t>& place) {
    return std::string(result_folder) + "/" + array.name + "/" + chunk_name(place);
}

// The place and the size of a chunk of a reduction's array: the last axes, if they are none of the grid, are whole.
std::vector<std::size_t> of_left(const std::vector<std::size_t>& along_grid, const std::vector<std::size_t>& left,
                                 const Array& array, bool places) {
    std::vector<std::size_t> all;
    for (const std::size_t d : left) all.push_back(along_grid[d]);
    for (std::size_t m = all.size(); m < array.shape.size(); ++m) all.push_back(places ? 0 : array.shape[m]);
    return all;
}

std::vector<double> as_numbers(const std::vector<std::int32_t>& counts) {
    std::vector<double> numbers;
    for (const std::int32_t each : counts) numbers.push_back(each < 0 ? std::nan("") : each);
    return numbers;
}

class Fields {
public:
    Fields(const Plan& plan, const Points& points) : plan_(plan), points_(points) {}

    Field of(const Reduction& r) const {
        Field field{plan_.dimensions_of(r.of), {}};
        if (r.statistic == Statistic::share) {
            for (const std::int8_t each : points_.regime) field.values.push_back(each < 0 ? std::nan("") : each);
        } else if (const auto found = reduced_.find(r.of); found != reduced_.end()) {
            field.values = found->second;
        } else if (r.of == "stops_per_period") {
            field.values = as_numbers(points_.stops);
        } else if (r.of == "periods") {
            field.values = as_numbers(points_.periods);
        } else {
            for (std::size_t m = 0; m < plan_.study.masses.size(); ++m) {
                const std::string number = std::to_string(plan_.study.masses[m].index + 1);
                if (r.of == "amplitude_" + number) field.values = points_.amplitudes[m];
                if (r.of == "phase_" + number) field.values = points_.phases[m];
            }
        }
        return field;
    }

    void keep(const Reduction& r, const std::vector<double>& values) { reduced_[r.name] = values; }

private:
    const Plan& plan_;
    const Points& points_;
    std::map<std::string, std::vector<double>> reduced_;
};

} // namespace

std::string path_of_part(const Reduction& r, std::size_t K) { return "parts/" + r.name + "/" + std::to_string(K); }

std::vector<std::string> paths_of(const Plan& plan, std::size_t K) {
    const Box box = plan.box(K);
    std::vector<std::string> paths;
    for (const Array& array : arrays_of_points(plan)) paths.push_back(path_of(array, box.place));
    for (const Reduction& r : plan.study.reductions) {
        if (plan.splits(r)) {
            paths.push_back(path_of_part(r, K));
            continue;
        }
        for (const Array& array : arrays_of(plan, r))
            paths.push_back(path_of(array, of_left(box.place, plan.dimensions_of(r.name), array, true)));
    }
    return paths;
}

std::vector<Piece> pieces_of(const Plan& plan, const Reduction& r, const Box& box, const Partial& part) {
    std::vector<Piece> pieces;
    const std::vector<Array> arrays = arrays_of(plan, r);
    const std::vector<Reduced> results = finished(plan, r, part);
    for (std::size_t n = 0; n < arrays.size(); ++n) {
        const std::vector<std::size_t> left = plan.dimensions_of(r.name);
        const std::string bytes = results[n].whole_numbers ? stored(results[n].counts) : stored(results[n].values);
        pieces.push_back({path_of(arrays[n], of_left(box.place, left, arrays[n], true)),
                          chunk_content(arrays[n], of_left(box.count, left, arrays[n], false), bytes)});
    }
    return pieces;
}

std::vector<Piece> pieces_of(const Plan& plan, std::size_t K, const Points& points) {
    const Box box = plan.box(K);
    std::vector<Piece> pieces;
    for (const Array& array : arrays_of_points(plan)) {
        std::string bytes;
        if (array.name == "status") bytes = stored(points.status);
        if (array.name == "regime") bytes = stored(points.regime);
        if (array.name == "stops_per_period") bytes = stored(points.stops);
        if (array.name == "periods") bytes = stored(points.periods);
        for (std::size_t m = 0; m < plan.study.masses.size(); ++m) {
            const std::string number = std::to_string(plan.study.masses[m].index + 1);
            if (array.name == "amplitude_" + number) bytes = stored(points.amplitudes[m]);
            if (array.name == "phase_" + number) bytes = stored(points.phases[m]);
        }
        pieces.push_back({path_of(array, box.place), chunk_content(array, box.count, std::move(bytes))});
    }
    Fields fields(plan, points);
    for (const Reduction& r : plan.study.reductions) {
        const Partial part = reduced(plan, r, box, fields.of(r));
        fields.keep(r, part.values);
        if (plan.splits(r)) {
            pieces.push_back({path_of_part(r, K), to_bytes(part)});
            continue;
        }
        std::vector<Piece> of_reduction = pieces_of(plan, r, box, part);
        std::ranges::move(of_reduction, std::back_inserter(pieces));
    }
    return pieces;
}

double bytes_of_study(const Plan& plan) {
    double bytes = 0;
    const auto add = [&](const Array& array) {
        double of_array = static_cast<double>(bytes_of(array.type));
        const std::vector<std::size_t> boxes = array.boxes();
        for (std::size_t d = 0; d < boxes.size(); ++d) of_array *= static_cast<double>(boxes[d] * array.chunk[d]);
        bytes += of_array;
    };
    for (const Array& array : arrays_of_points(plan)) add(array);
    for (const Reduction& r : plan.study.reductions) {
        for (const Array& array : arrays_of(plan, r)) add(array);
        if (!plan.splits(r)) continue;
        Box box = plan.box(0);
        const Partial part = reduced(plan, r, box, {plan.dimensions_of(r.of), {}});
        bytes += static_cast<double>(to_bytes(part).size()) * static_cast<double>(plan.chunks);
    }
    return bytes;
}

} // namespace denhartog::sweep
