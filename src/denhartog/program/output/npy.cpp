#include "denhartog/program/output/npy.hpp"

namespace denhartog::program {

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
    append(header, std::uint8_t(1));
    append(header, std::uint8_t(0));
    append(header, static_cast<std::uint8_t>(dictionary.size() % 256));
    append(header, static_cast<std::uint8_t>(dictionary.size() / 256));
    return header + dictionary;
}

} // namespace denhartog::program
