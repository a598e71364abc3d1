#include "denhartog/program/sweep/netcdf.hpp"

#include <algorithm>
#include <cstring>
#include <filesystem>

#include "denhartog/number/errors.hpp"
#include "denhartog/program/output/files.hpp"
#include "denhartog/program/output/new_file.hpp"
#include "denhartog/program/sweep/merge.hpp"
#include "denhartog/program/sweep/store.hpp"

namespace denhartog::program {
namespace {

using nlohmann::ordered_json;
using sweep::Array;
using sweep::Stored;

// Types and tags of the format.
constexpr std::uint32_t of_char = 2, of_int = 4, dimensions_tag = 10, variables_tag = 11, attributes_tag = 12;

std::uint32_t type_of(Stored type) {
    switch (type) {
    case Stored::int8: return 1;
    case Stored::int32: return of_int;
    case Stored::int64: return 10;
    case Stored::float64: break;
    }
    return 6;
}

// Most significant byte first.
template <class T>
void put(std::string& out, T x) {
    for (std::size_t byte = sizeof(T); byte-- > 0;) out += static_cast<char>((x >> (8 * byte)) & 0xff);
}

void put_padded(std::string& out, const std::string& bytes) { out += bytes + std::string((4 - bytes.size() % 4) % 4, '\0'); }

void put_name(std::string& out, const std::string& name) {
    put(out, std::uint64_t(name.size()));
    put_padded(out, name);
}

void put_list(std::string& out, std::uint32_t tag, std::size_t count) {
    put(out, count == 0 ? 0 : tag);
    put(out, std::uint64_t(count));
}

void put_attributes(std::string& out, const ordered_json& attributes) {
    put_list(out, attributes_tag, attributes.size());
    for (const auto& [name, value] : attributes.items()) {
        put_name(out, name);
        const bool counts = value.is_array() && std::ranges::all_of(value, [](const auto& x) { return x.is_number_integer(); });
        put(out, counts ? of_int : of_char);
        if (counts) {
            put(out, std::uint64_t(value.size()));
            for (const auto& each : value) put(out, static_cast<std::uint32_t>(each.template get<std::int32_t>()));
        } else {
            const std::string text = value.is_string() ? value.template get<std::string>() : value.dump();
            put(out, std::uint64_t(text.size()));
            put_padded(out, text);
        }
    }
}

std::uint64_t size_of(const Array& array) {
    std::uint64_t bytes = bytes_of(array.type);
    for (const std::size_t each : array.shape) bytes *= each;
    return (bytes + 3) / 4 * 4;
}

std::string header_of(const StudyFolder& study, const std::vector<Array>& arrays) {
    std::vector<std::string> names;
    std::vector<std::size_t> lengths;
    for (const Array& array : arrays)
        for (std::size_t d = 0; d < array.shape.size(); ++d)
            if (std::ranges::find(names, array.dimensions[d]) == names.end()) {
                names.push_back(array.dimensions[d]);
                lengths.push_back(array.shape[d]);
            }
    const auto header = [&](std::uint64_t begin) {
        std::string out = "CDF\x05";
        put(out, std::uint64_t(0)); // records along an axis without end: there is none
        put_list(out, dimensions_tag, names.size());
        for (std::size_t n = 0; n < names.size(); ++n) {
            put_name(out, names[n]);
            put(out, std::uint64_t(lengths[n]));
        }
        put_attributes(out, json_of_store(study));
        put_list(out, variables_tag, arrays.size());
        for (const Array& array : arrays) {
            put_name(out, array.name);
            put(out, std::uint64_t(array.shape.size()));
            for (const std::string& each : array.dimensions)
                put(out, static_cast<std::uint64_t>(std::ranges::find(names, each) - names.begin()));
            put_attributes(out, array.attributes);
            put(out, type_of(array.type));
            put(out, size_of(array));
            put(out, begin);
            begin += size_of(array);
        }
        return out;
    };
    return header(header(0).size());
}

std::size_t product(const std::vector<std::size_t>& shape, std::size_t from) {
    std::size_t all = 1;
    for (std::size_t d = from; d < shape.size(); ++d) all *= shape[d];
    return all;
}

// Copies a chunk into the rows of the array that the chunks with the same first place make up.
void put_chunk(const Array& array, const std::vector<std::size_t>& place, const std::string& chunk, std::string& rows) {
    const std::size_t n = array.shape.size(), size = bytes_of(array.type);
    std::vector<std::size_t> at(n, 0), count(n);
    for (std::size_t d = 0; d < n; ++d) count[d] = std::min(array.chunk[d], array.shape[d] - place[d] * array.chunk[d]);
    for (bool more = true; more;) {
        std::size_t from = 0, to = 0;
        for (std::size_t d = 0; d < n; ++d) {
            from = from * array.chunk[d] + at[d];
            to = to * (d == 0 ? count[0] : array.shape[d]) + at[d] + (d == 0 ? 0 : place[d] * array.chunk[d]);
        }
        std::memcpy(rows.data() + to * size, chunk.data() + from * size, (n == 0 ? 1 : count.back()) * size);
        more = false;
        for (std::size_t d = n == 0 ? 0 : n - 1; d-- > 0 && !more;) {
            more = ++at[d] < count[d];
            if (!more) at[d] = 0;
        }
    }
}

void turn_bytes(std::string& bytes, std::size_t size) {
    for (std::size_t n = 0; n + size <= bytes.size(); n += size)
        std::reverse(bytes.begin() + static_cast<std::ptrdiff_t>(n), bytes.begin() + static_cast<std::ptrdiff_t>(n + size));
}

void write_array(const StudyFolder& study, const Array& array, const NewFile& file) {
    const std::vector<std::size_t> boxes = array.boxes();
    const std::size_t size = bytes_of(array.type), row = product(array.shape, 1) * size;
    const std::size_t first_boxes = boxes.empty() ? 1 : boxes[0], others = product(boxes, 1);
    std::uint64_t written = 0;
    for (std::size_t first = 0; first < first_boxes; ++first) {
        const std::size_t rows = boxes.empty() ? 1 : std::min(array.chunk[0], array.shape[0] - first * array.chunk[0]);
        std::string bytes(rows * row, '\0');
        for (std::size_t n = 0; n < others; ++n) {
            std::vector<std::size_t> place(boxes.size(), first);
            for (std::size_t d = boxes.size(), rest = n; d-- > 1; rest /= boxes[d]) place[d] = rest % boxes[d];
            put_chunk(
                array, place,
                read_input(study.file(std::string(sweep::result_folder) + "/" + array.name + "/" + sweep::chunk_name(place))),
                bytes);
        }
        turn_bytes(bytes, size);
        file.write(bytes);
        written += bytes.size();
    }
    file.write(std::string(size_of(array) - written, '\0'));
}

} // namespace

void write_netcdf(const StudyFolder& study, const std::string& path) {
    std::error_code fault;
    if (std::filesystem::exists(path, fault) && !std::filesystem::is_regular_file(path, fault))
        throw InputError("to", "must be a file, or a name that is free", path);
    const std::vector<Array> arrays = all_arrays(study.plan);
    NewFile file(path);
    file.write(header_of(study, arrays));
    for (const Array& each : arrays) write_array(study, each, file);
    file.flush();
    file.take_place();
}

} // namespace denhartog::program
