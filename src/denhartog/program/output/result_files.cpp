// Motions, maps and boundary curves as CSV or as arrays of NumPy: a table of typed columns is written by `csv` or `npy`. Read
// `map_table` and `curves_table`, which make such tables.
#include "denhartog/program/output/result_files.hpp"

#include <CLI/CLI.hpp>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <functional>

#include "denhartog/number/errors.hpp"
#include "denhartog/number/number_text.hpp"
#include "denhartog/scene/point_rules.hpp"

namespace denhartog::program {
namespace {

// Appends a number to the records, least significant byte first.
template <class T>
void append(std::string& records, T x) {
    const auto bytes = std::bit_cast<std::array<char, sizeof(T)>>(x);
    if constexpr (std::endian::native == std::endian::little)
        records.append(bytes.begin(), bytes.end());
    else
        records.append(bytes.rbegin(), bytes.rend());
}

// The beginning of an array of records in NumPy's file format, version 1.0: magic string, version, length and a dictionary padded to a
// multiple of 64 bytes. The last of the axes runs fastest.
std::string npy_header(const ResultTable& table) {
    std::string dictionary = "{'descr': [";
    for (const Column& c : table.columns)
        dictionary += "('" + c.name + "', '" + (c.type.back() == '1' ? "|" : "<") + c.type + "'), ";
    dictionary += "], 'fortran_order': False, 'shape': (";
    for (const std::size_t length : table.shape) dictionary += std::to_string(length) + ", ";
    dictionary += "), }";
    const std::size_t before = 10; // magic string, version, length
    dictionary.append(63 - (before + dictionary.size()) % 64, ' ');
    dictionary += '\n';
    std::string header = "\x93NUMPY";
    append(header, std::uint16_t(1)); // 1 before the point of the version, 0 after it
    append(header, static_cast<std::uint16_t>(dictionary.size()));
    return header + dictionary;
}

std::size_t rows_of(const ResultTable& table) {
    std::size_t rows = 1;
    for (const std::size_t length : table.shape) rows *= length;
    return rows;
}

std::string csv_cell(const Column& c, double x) {
    if (c.type == "f8") return std::isnan(x) ? "nan" : number_to_text(x == 0 ? 0.0 : x);
    if (x == -1) return c.unknown;
    return c.words.empty() ? std::to_string(static_cast<int>(x)) : c.words.at(static_cast<std::size_t>(x));
}

// A column with a value for each row.
Column column(std::string name, std::string type, std::size_t rows, const std::function<double(std::size_t)>& value) {
    Column c{std::move(name), std::move(type), std::vector<double>(rows)};
    for (std::size_t n = 0; n < rows; ++n) c.values[n] = value(n);
    return c;
}

Column status_column(std::size_t rows, const std::function<PointStatus(std::size_t)>& status) {
    Column c = column("status", "i1", rows, [&](std::size_t n) { return static_cast<int>(status(n)); });
    for (int n = 0; n <= static_cast<int>(PointStatus::failed); ++n) c.words.push_back(name(static_cast<PointStatus>(n)));
    return c;
}

} // namespace

std::string csv(const ResultTable& table) {
    std::string text;
    std::vector<std::vector<std::string>> axes; // the cells of columns that repeat: each number is made text once
    const std::size_t rows = rows_of(table);
    for (const Column& c : table.columns) {
        text += (text.empty() ? "" : ",") + c.name;
        axes.emplace_back();
        for (std::size_t n = 0; n < c.values.size() && c.values.size() < rows; ++n)
            axes.back().push_back(csv_cell(c, c.values[n]));
    }
    text += '\n';
    for (std::size_t n = 0; n < rows; ++n)
        for (std::size_t k = 0; k < axes.size(); ++k) {
            const Column& c = table.columns[k];
            const std::size_t place = n / c.each % c.values.size();
            text.append(axes[k].empty() ? csv_cell(c, c.values[place]) : axes[k][place]).append(k + 1 < axes.size() ? "," : "\n");
        }
    return text;
}

std::string npy(const ResultTable& table) {
    std::string bytes = npy_header(table);
    const std::size_t rows = rows_of(table);
    for (std::size_t n = 0; n < rows; ++n)
        for (const Column& c : table.columns) {
            const double x = c.values[n / c.each % c.values.size()];
            if (c.type == "f8")
                append(bytes, x);
            else if (c.type == "i4")
                append(bytes, static_cast<std::int32_t>(x));
            else
                append(bytes, static_cast<std::int8_t>(x));
        }
    return bytes;
}

ResultTable map_table(const MapGrid& grid, const RegimeMap& map) {
    const std::size_t columns = grid.frequency.values.size(), rows = grid.rows.values.size(), masses = grid.masses.size();
    ResultTable table{{{grid.frequency.name, "f8", grid.frequency.values, rows}, {grid.rows.name, "f8", grid.rows.values}},
                      {columns, rows}};
    const auto add = [&](const std::string& name, const char* type, const auto& value) -> Column& {
        return table.columns.emplace_back(column(name, type, map.points.size(), value));
    };
    const auto add_known = [&](const std::string& name, const char* type, const auto& value) -> Column& {
        return add(name, type, [&](std::size_t n) { return has_numbers(map.points[n].status) ? value(map.points[n]) : -1; });
    };
    Column& regime = add_known("regime", "i1", [](const MapPoint& p) { return static_cast<int>(p.regime); });
    regime.unknown = "";
    for (const Regime each : {Regime::continuous, Regime::stick_slip, Regime::permanent_sticking})
        regime.words.push_back(name(each));
    add_known("stops_per_period", "i4", [](const MapPoint& p) { return p.stops; }).unknown = "nan";
    add_known("periods", "i4", [](const MapPoint& p) { return p.periods; }).unknown = "nan";
    const auto add_masses = [&](const std::string& name, const std::vector<double>& numbers) {
        for (std::size_t k = 0; k < masses && !numbers.empty(); ++k)
            add(name + std::to_string(grid.masses[k].index + 1), "f8", [&](std::size_t n) { return numbers[n * masses + k]; });
    };
    add_masses("amplitude_", map.amplitudes);
    add_masses("phase_", map.phases);
    table.columns.push_back(status_column(map.points.size(), [&](std::size_t n) { return map.points[n].status; }));
    return table;
}

ResultTable curves_table(const MapAxis& axis, const std::vector<BoundaryPoint>& curves) {
    ResultTable table{{{axis.name, "f8", axis.values}}, {curves.size()}};
    const auto add = [&](const char* name, const auto& limit) {
        table.columns.push_back(column(name, "f8", curves.size(), [&](std::size_t n) {
            return has_numbers(curves[n].status) ? limit(curves[n]) : std::nan("");
        }));
    };
    add("exact", [](const BoundaryPoint& b) { return b.exact; });
    add("paper", [](const BoundaryPoint& b) { return b.paper; });
    add("approximate", [](const BoundaryPoint& b) { return b.approximate; });
    add("sticking", [](const BoundaryPoint& b) { return b.sticking.value_or(std::nan("")); });
    table.columns.push_back(status_column(curves.size(), [&](std::size_t n) { return curves[n].status; }));
    return table;
}

ResultTable motion_table(const SampledSolution& motion, const std::optional<MotionUnits>& units,
                         const std::vector<int>& directions) {
    const double time = units ? 1 / units->omega : 1, length = units ? units->length : 1;
    const double velocity = units ? units->length * units->omega : 1;
    const std::size_t instants = motion.tau.size(), N = motion.x.size() / instants;
    ResultTable table{{}, {instants}};
    const auto add = [&](const std::string& name, double unit, const std::vector<double>& numbers, std::size_t first,
                         std::size_t step) {
        table.columns.push_back(column(name, "f8", instants, [&](std::size_t n) {
            const double x = unit * numbers[n * step + first];
            if (!std::isfinite(x))
                throw PrecisionError("the motion holds a number beyond the range of a double", Outcome::out_of_range);
            return x == 0 ? 0.0 : x;
        }));
    };
    add(units ? "t" : "tau", time, motion.tau, 0, 1);
    for (std::size_t k = 0; k < N; ++k) add("x_" + std::to_string(k + 1), length, motion.x, k, N);
    for (std::size_t k = 0; k < N; ++k) add("v_" + std::to_string(k + 1), velocity, motion.x_prime, k, N);
    if (!directions.empty()) table.columns.push_back({"direction", "i1", {directions.begin(), directions.end()}});
    return table;
}

void add_units_option(CLI::App& command, std::string& units) {
    command
        .add_option(
            "--units", units,
            "units of the motion: ratios, or scene for those of its masses, stiffnesses and force, with t from the\nsame instant "
            "instead of tau")
        ->check(CLI::IsMember({in_ratios, in_scene}))
        ->capture_default_str();
}

std::optional<MotionUnits> motion_units(const Scene<double>& scene, const std::string& units) {
    if (units == in_ratios) return std::nullopt;
    if (!scene.units) throw InputError("units", "must be ratios where the scene has no masses and stiffnesses", units);
    const double omega = angular_frequency(*scene.units, frequency_ratio_of(scene));
    const std::optional<double> P = scene.units->force_at(omega);
    if (!P) throw InputError("units", "must be ratios where the scene has no force", units);
    return MotionUnits{omega, displacement_unit(*scene.units, *P)};
}

bool as_npy(const std::string& output) {
    if (output.empty() || output.ends_with(".csv")) return false;
    if (output.ends_with(".npy")) return true;
    throw InputError("output", "must end in .csv or .npy", output);
}

} // namespace denhartog::program
