#include "html.hpp"

namespace denhartog::pages {

std::string between(const std::string& text, const std::string& open, const std::string& close, std::size_t from) {
    const std::size_t at = text.find(open, from);
    const std::size_t end = at == std::string::npos ? at : text.find(close, at + open.size());
    return end == std::string::npos ? "" : text.substr(at + open.size(), end - at - open.size());
}

std::vector<std::string> values_of(const std::string& page, const std::string& attribute) {
    const std::string open = " " + attribute + "=\"";
    std::vector<std::string> values;
    for (std::size_t at = page.find(open); at != std::string::npos; at = page.find(open, at + 1)) {
        const std::size_t from = at + open.size();
        values.push_back(page.substr(from, page.find('"', from) - from));
    }
    return values;
}

} // namespace denhartog::pages
