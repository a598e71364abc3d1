#include "denhartog/sweep/arrays.hpp"

#include <algorithm>
#include <bit>
#include <cstring>
#include <limits>
#include <numeric>

#include "denhartog/sweep/points.hpp"

namespace denhartog::sweep {
namespace {

using nlohmann::ordered_json;

constexpr std::size_t most_samples_listed = std::size_t(1) << 20;

const char* dtype_of(Stored type) {
    switch (type) {
    case Stored::int8: return "|i1";
    case Stored::int32: return "<i4";
    case Stored::int64: return "<i8";
    case Stored::float64: break;
    }
    return "<f8";
}

// Of the axes of the grid that a field has.
Array array_over(const Plan& plan, const std::string& name, Stored type, const std::vector<std::size_t>& dimensions) {
    Array array{name, type, {}, {}, {}, ordered_json::object()};
    for (const std::size_t d : dimensions) {
        array.dimensions.push_back(plan.dimensions[d].name);
        array.shape.push_back(plan.dimensions[d].size);
        array.chunk.push_back(plan.chunk[d]);
    }
    return array;
}

void add_axis(Array& array, const std::string& name, std::size_t size) {
    array.dimensions.push_back(name);
    array.shape.push_back(size);
    array.chunk.push_back(size);
}

template <class T>
Coordinate coordinate(const std::string& name, const std::string& axis, Stored type, const std::vector<T>& values) {
    return {{name, type, {axis}, {values.size()}, {values.size()}, ordered_json::object()}, stored(values)};
}

template <class Names>
void add_meanings(Array& array, const std::vector<int>& values, const Names& names) {
    std::string meanings;
    for (const auto& each : names) meanings += (meanings.empty() ? "" : " ") + std::string(each);
    array.attributes["flag_values"] = values;
    array.attributes["flag_meanings"] = meanings;
}

const std::vector<std::string> regimes{"continuous", "stick_slip", "permanent_sticking"};

std::string unit_of_length(const Study& study) { return study.in_units() ? "unit of length of the scene" : "P / k_1"; }

} // namespace

template <class T>
std::string stored(const std::vector<T>& numbers) {
    static_assert(std::endian::native == std::endian::little, "numbers are stored as they are in memory");
    std::string bytes(sizeof(T) * numbers.size(), '\0');
    if (!numbers.empty()) std::memcpy(bytes.data(), numbers.data(), bytes.size());
    return bytes;
}
template std::string stored(const std::vector<double>&);
template std::string stored(const std::vector<std::int8_t>&);
template std::string stored(const std::vector<std::int32_t>&);
template std::string stored(const std::vector<std::int64_t>&);

std::size_t bytes_of(Stored type) {
    switch (type) {
    case Stored::int8: return 1;
    case Stored::int32: return 4;
    case Stored::int64:
    case Stored::float64: break;
    }
    return 8;
}

// Counts have no value that stands for none; xarray would take it for a missing one.
ordered_json Array::metadata() const {
    ordered_json fill = nullptr;
    if (type == Stored::float64) fill = "NaN";
    if (type == Stored::int8 || type == Stored::int32) fill = -1;
    return {{"zarr_format", 2},   {"shape", shape}, {"chunks", chunk},    {"dtype", dtype_of(type)},
            {"fill_value", fill}, {"order", "C"},   {"filters", nullptr}, {"compressor", nullptr}};
}

ordered_json Array::all_attributes() const {
    ordered_json all{{"_ARRAY_DIMENSIONS", dimensions}};
    all.update(attributes);
    return all;
}

std::vector<std::size_t> Array::boxes() const {
    std::vector<std::size_t> numbers;
    for (std::size_t d = 0; d < shape.size(); ++d) numbers.push_back((shape[d] + chunk[d] - 1) / chunk[d]);
    return numbers;
}

std::vector<Array> arrays_of_points(const Plan& plan) {
    const Study& study = plan.study;
    std::vector<Array> all;
    if (!study.answers.any()) return all;
    std::vector<std::size_t> dimensions(plan.dimensions.size());
    std::iota(dimensions.begin(), dimensions.end(), std::size_t(0));
    const auto add = [&](const std::string& name, Stored type) { all.push_back(array_over(plan, name, type, dimensions)); };
    add("status", Stored::int8);
    add_meanings(all.back(), {0, 1, 2, 3, 4, 5}, statuses);
    if (study.answers.regime) {
        add("regime", Stored::int8);
        add_meanings(all.back(), {0, 1, 2}, regimes);
    }
    if (study.answers.stops) {
        add("stops_per_period", Stored::int32);
        add("periods", Stored::int32);
    }
    const auto add_of_masses = [&](const std::string& kind, const std::string& units) {
        for (const Mass k : study.masses) {
            add(kind + std::to_string(k.index + 1), Stored::float64);
            all.back().attributes["units"] = units;
        }
    };
    if (study.answers.amplitudes) add_of_masses("amplitude_", unit_of_length(study));
    if (study.answers.phases) add_of_masses("phase_", "radians behind the force");
    return all;
}

std::vector<Array> arrays_of(const Plan& plan, const Reduction& r) {
    const std::vector<std::size_t> left = plan.dimensions_of(r.name);
    std::vector<Array> all{array_over(plan, r.name, r.statistic == Statistic::histogram ? Stored::int64 : Stored::float64, left)};
    switch (r.statistic) {
    case Statistic::share: add_axis(all[0], "regime_class", regimes.size() + 1); break;
    case Statistic::quantiles:
        add_axis(all[0], r.name + "_probability", r.probabilities.size());
        all[0].attributes["method"] = r.bins ? "from a histogram, linear within a bin" : "exact, linear between order statistics";
        break;
    case Statistic::histogram: add_axis(all[0], r.name + "_bin", r.bins->count + 2); break;
    case Statistic::maximum:
    case Statistic::minimum: {
        const std::vector<std::size_t> before = plan.dimensions_of(r.of);
        for (std::size_t m = before.size(); m-- > 0;)
            if (std::ranges::find(r.over, plan.dimensions[before[m]].name) != r.over.end())
                all.push_back(array_over(plan, r.name + "_" + plan.dimensions[before[m]].name, Stored::float64, left));
        break;
    }
    }
    if (r.statistic != Statistic::share) all[0].attributes["of"] = r.of;
    all[0].attributes["over"] = r.over;
    return all;
}

std::vector<Coordinate> coordinates_of(const Plan& plan) {
    std::vector<Coordinate> all;
    for (const Dimension& d : plan.dimensions) {
        if (!d.values.empty()) {
            all.push_back(coordinate(d.name, d.name, Stored::float64, d.values));
        } else if (d.size <= most_samples_listed) {
            std::vector<std::int64_t> index(d.size);
            std::iota(index.begin(), index.end(), std::int64_t(0));
            all.push_back(coordinate("sample", "sample", Stored::int64, index));
            const SceneAt scenes(plan);
            for (std::size_t v = 0; v < plan.study.samples->variables.size(); ++v) {
                std::vector<double> drawn(d.size);
                for (std::size_t n = 0; n < d.size; ++n) drawn[n] = scenes.drawn(n, v);
                all.push_back(coordinate(plan.study.samples->variables[v].target.name(), "sample", Stored::float64, drawn));
            }
        }
    }
    bool with_shares = false;
    for (const Reduction& r : plan.study.reductions) {
        with_shares = with_shares || r.statistic == Statistic::share;
        if (r.statistic == Statistic::quantiles) {
            const std::string name = r.name + "_probability";
            all.push_back(coordinate(name, name, Stored::float64, r.probabilities));
        }
        if (r.statistic != Statistic::histogram) continue;
        std::vector<double> from = r.bins->edges();
        from.insert(from.begin(), -std::numeric_limits<double>::infinity());
        all.push_back(coordinate(r.name + "_bin", r.name + "_bin", Stored::float64, from));
        all.back().array.attributes["long_name"] = "lower end of the bin; the first is open below, the last above";
    }
    if (with_shares) {
        all.push_back(coordinate("regime_class", "regime_class", Stored::int64, std::vector<std::int64_t>{0, 1, 2, 3}));
        std::vector<std::string> names = regimes;
        names.push_back("none");
        add_meanings(all.back().array, {0, 1, 2, 3}, names);
    }
    return all;
}

std::string chunk_name(const std::vector<std::size_t>& place) {
    std::string name;
    for (const std::size_t each : place) name += (name.empty() ? "" : ".") + std::to_string(each);
    return name.empty() ? "0" : name;
}

std::string chunk_content(const Array& array, const std::vector<std::size_t>& count, std::string bytes) {
    if (count == array.chunk || count.empty()) return bytes;
    const std::size_t size = bytes_of(array.type), row = count.back() * size;
    std::size_t all = size;
    for (const std::size_t each : array.chunk) all *= each;
    std::string content(all, '\0');
    std::vector<std::size_t> at(count.size(), 0);
    for (std::size_t from = 0; from < bytes.size(); from += row) {
        std::size_t to = 0;
        for (std::size_t d = 0; d < at.size(); ++d) to = to * array.chunk[d] + at[d];
        std::memcpy(content.data() + to * size, bytes.data() + from, row);
        for (std::size_t d = at.size() - 1; d-- > 0;) {
            if (++at[d] < count[d]) break;
            at[d] = 0;
        }
    }
    return content;
}

} // namespace denhartog::sweep
