#include "denhartog/program/output/result_files.hpp"

#include <CLI/CLI.hpp>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>

#include "denhartog/number/errors.hpp"
#include "denhartog/number/number_text.hpp"
#include "denhartog/scene/point_rules.hpp"

namespace denhartog::program {
namespace {

// A field of a record: its name, and its type without byte order, `f8`, `i4` or `i1`.
struct NpyField {
    std::string name, type;
};

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
std::string npy_header(const std::vector<NpyField>& fields, const std::vector<std::size_t>& shape) {
    std::string dictionary = "{'descr': [";
    for (const NpyField& field : fields)
        dictionary += "('" + field.name + "', '" + (field.type.back() == '1' ? "|" : "<") + field.type + "'), ";
    dictionary += "], 'fortran_order': False, 'shape': (";
    for (const std::size_t length : shape) dictionary += std::to_string(length) + ", ";
    dictionary += "), }";
    const std::size_t before = 10; // magic string, version, length
    dictionary.append(63 - (before + dictionary.size()) % 64, ' ');
    dictionary += '\n';
    std::string header = "\x93NUMPY";
    append(header, std::uint16_t(1)); // 1 before the point of the version, 0 after it
    append(header, static_cast<std::uint16_t>(dictionary.size()));
    return header + dictionary;
}

std::string csv_cell(double x) { return std::isnan(x) ? "nan" : number_to_text(x == 0 ? 0.0 : x); }

std::string csv_cell(std::int32_t n, bool known) { return known ? std::to_string(n) : "nan"; }

double number(double x, bool known) { return known ? x : std::nan(""); }

} // namespace

std::string map_csv(const MapGrid& grid, const RegimeMap& map) {
    const std::vector<double>&columns = grid.frequency.values, &rows = grid.rows.values;
    std::string csv = grid.frequency.name + "," + grid.rows.name + ",regime,stops_per_period,periods";
    for (const Mass k : grid.masses) csv += ",amplitude_" + std::to_string(k.index + 1);
    if (!map.phases.empty())
        for (const Mass k : grid.masses) csv += ",phase_" + std::to_string(k.index + 1);
    csv += ",status\n";
    const std::size_t masses = grid.masses.size();
    std::vector<std::string> beta, regimes, statuses;
    for (const double each : rows) beta.push_back("," + csv_cell(each) + ",");
    for (const Regime each : {Regime::continuous, Regime::stick_slip, Regime::permanent_sticking})
        regimes.push_back(denhartog::name(each) + ",");
    for (int n = 0; n <= static_cast<int>(PointStatus::failed); ++n)
        statuses.push_back("," + denhartog::name(static_cast<PointStatus>(n)) + "\n");
    const std::string none = ",";
    for (std::size_t m = 0, point = 0; m < columns.size(); ++m) {
        const std::string r = csv_cell(columns[m]);
        for (std::size_t n = 0; n < rows.size(); ++n, ++point) {
            const MapPoint& p = map.points[point];
            const bool known = has_numbers(p.status);
            csv.append(r).append(beta[n]).append(known ? regimes[static_cast<std::size_t>(p.regime)] : none);
            csv.append(csv_cell(p.stops, known)).append(none).append(csv_cell(p.periods, known));
            for (std::size_t k = 0; k < masses; ++k) csv.append(none).append(csv_cell(map.amplitudes[point * masses + k]));
            for (std::size_t k = 0; k < masses && !map.phases.empty(); ++k)
                csv.append(none).append(csv_cell(map.phases[point * masses + k]));
            csv.append(statuses[static_cast<std::size_t>(p.status)]);
        }
    }
    return csv;
}

std::string map_npy(const MapGrid& grid, const RegimeMap& map) {
    const std::vector<double>&columns = grid.frequency.values, &rows = grid.rows.values;
    std::vector<NpyField> fields{
        {grid.frequency.name, "f8"}, {grid.rows.name, "f8"}, {"regime", "i1"}, {"stops_per_period", "i4"}, {"periods", "i4"}};
    for (const Mass k : grid.masses) fields.push_back({"amplitude_" + std::to_string(k.index + 1), "f8"});
    if (!map.phases.empty())
        for (const Mass k : grid.masses) fields.push_back({"phase_" + std::to_string(k.index + 1), "f8"});
    fields.push_back({"status", "i1"});
    std::string bytes = npy_header(fields, {columns.size(), rows.size()});
    const std::size_t masses = grid.masses.size();
    for (std::size_t point = 0; point < map.points.size(); ++point) {
        const MapPoint& p = map.points[point];
        const bool known = has_numbers(p.status);
        append(bytes, columns[point / rows.size()]);
        append(bytes, rows[point % rows.size()]);
        append(bytes, static_cast<std::int8_t>(known ? static_cast<int>(p.regime) : -1));
        append(bytes, known ? p.stops : std::int32_t(-1));
        append(bytes, known ? p.periods : std::int32_t(-1));
        for (std::size_t k = 0; k < masses; ++k) append(bytes, map.amplitudes[point * masses + k]);
        for (std::size_t k = 0; k < masses && !map.phases.empty(); ++k) append(bytes, map.phases[point * masses + k]);
        append(bytes, static_cast<std::int8_t>(p.status));
    }
    return bytes;
}

std::string curves_csv(const MapAxis& axis, const std::vector<BoundaryPoint>& curves) {
    const std::vector<double>& r = axis.values;
    std::string csv = axis.name + ",exact,paper,approximate,sticking,status\n";
    for (std::size_t n = 0; n < r.size(); ++n) {
        const BoundaryPoint& b = curves[n];
        const bool known = has_numbers(b.status);
        csv += csv_cell(r[n]);
        for (const double limit : {b.exact, b.paper, b.approximate, b.sticking.value_or(std::nan(""))})
            csv += "," + csv_cell(number(limit, known));
        csv += "," + denhartog::name(b.status) + "\n";
    }
    return csv;
}

std::string curves_npy(const MapAxis& axis, const std::vector<BoundaryPoint>& curves) {
    const std::vector<double>& r = axis.values;
    std::string bytes = npy_header(
        {{axis.name, "f8"}, {"exact", "f8"}, {"paper", "f8"}, {"approximate", "f8"}, {"sticking", "f8"}, {"status", "i1"}},
        {r.size()});
    for (std::size_t n = 0; n < r.size(); ++n) {
        const BoundaryPoint& b = curves[n];
        const bool known = has_numbers(b.status);
        append(bytes, r[n]);
        for (const double limit : {b.exact, b.paper, b.approximate, b.sticking.value_or(std::nan(""))})
            append(bytes, number(limit, known));
        append(bytes, static_cast<std::int8_t>(b.status));
    }
    return bytes;
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

namespace {

// The columns of a motion, and what each instant has in them.
struct MotionTable {
    std::vector<std::string> names;
    std::vector<double> numbers; // row by row
};

MotionTable motion_table(const SampledSolution& motion, const std::optional<MotionUnits>& units) {
    const double time = units ? 1 / units->omega : 1, length = units ? units->length : 1;
    const double velocity = units ? units->length * units->omega : 1;
    MotionTable table{{units ? "t" : "tau"}, {}};
    const std::size_t N = motion.x.size() / motion.tau.size();
    for (const char* letter : {"x", "v"})
        for (std::size_t k = 1; k <= N; ++k) table.names.push_back(std::string(letter) + "_" + std::to_string(k));
    const auto put = [&](double x) {
        if (!std::isfinite(x)) throw PrecisionError("the motion holds a number beyond the range of a double");
        table.numbers.push_back(x == 0 ? 0.0 : x);
    };
    for (std::size_t n = 0; n < motion.tau.size(); ++n) {
        put(time * motion.tau[n]);
        for (std::size_t k = 0; k < N; ++k) put(length * motion.x[n * N + k]);
        for (std::size_t k = 0; k < N; ++k) put(velocity * motion.x_prime[n * N + k]);
    }
    return table;
}

} // namespace

std::string motion_csv(const SampledSolution& motion, const std::optional<MotionUnits>& units,
                       const std::vector<int>& directions) {
    const MotionTable table = motion_table(motion, units);
    std::string csv;
    for (const std::string& name : table.names) csv += (csv.empty() ? "" : ",") + name;
    csv += directions.empty() ? "\n" : ",direction\n";
    const std::size_t columns = table.names.size();
    for (std::size_t n = 0; n < motion.tau.size(); ++n) {
        for (std::size_t c = 0; c < columns; ++c) csv += (c == 0 ? "" : ",") + number_to_text(table.numbers[n * columns + c]);
        csv += directions.empty() ? "\n" : "," + std::to_string(directions[n]) + "\n";
    }
    return csv;
}

std::string motion_npy(const SampledSolution& motion, const std::optional<MotionUnits>& units,
                       const std::vector<int>& directions) {
    const MotionTable table = motion_table(motion, units);
    std::vector<NpyField> fields;
    for (const std::string& name : table.names) fields.push_back({name, "f8"});
    if (!directions.empty()) fields.push_back({"direction", "i1"});
    std::string bytes = npy_header(fields, {motion.tau.size()});
    const std::size_t columns = table.names.size();
    for (std::size_t n = 0; n < motion.tau.size(); ++n) {
        for (std::size_t c = 0; c < columns; ++c) append(bytes, table.numbers[n * columns + c]);
        if (!directions.empty()) append(bytes, static_cast<std::int8_t>(directions[n]));
    }
    return bytes;
}

} // namespace denhartog::program
