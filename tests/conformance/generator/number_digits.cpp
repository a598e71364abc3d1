#include "tests/conformance/generator/number_digits.hpp"

#include <algorithm>
#include <cstdlib>

namespace denhartog::conformance::generator {

template <class T>
std::string text_of_digits(const T& x, int digits) {
    if (x == 0) return "0";
    const std::string text = x.str(digits - 1, std::ios_base::scientific); // so many after the point
    const std::size_t e = text.find('e');
    std::string mantissa = text.substr(0, e);
    while (mantissa.back() == '0') mantissa.pop_back();
    if (mantissa.back() == '.') mantissa.pop_back();
    const int exponent = std::atoi(text.c_str() + e + 1);
    return exponent == 0 ? mantissa : mantissa + "e" + std::to_string(exponent);
}

double two_digits(const Real50& x) { return std::strtod(x.str(1, std::ios_base::scientific).c_str(), nullptr); }

template <class T>
T scale_of(const std::vector<T>& x) {
    using std::abs;
    T largest(0);
    for (const T& each : x) largest = std::max(largest, T(abs(each)));
    return largest == T(0) ? T(1) : largest;
}

template <class T>
std::optional<int> agreement(const std::vector<T>& a, const std::vector<T>& b, bool angle) {
    using std::abs;
    if (a.empty() || a.size() != b.size()) return std::nullopt;
    const T largest = angle ? T(1) : scale_of(a), zero = 1024 * 1024 * largest * std::numeric_limits<T>::epsilon();
    T worst(0);
    for (std::size_t n = 0; n < a.size(); ++n) {
        T difference = a[n] - b[n];
        if (!(difference - difference == T(0))) return std::nullopt;
        if (angle) difference = atan2(T(sin(difference)), T(cos(difference)));
        const bool own = !angle && abs(a[n]) > zero;
        worst = std::max(worst, T(abs(difference) / (own ? T(abs(a[n])) : largest)));
    }
    if (worst == T(0)) return std::numeric_limits<T>::digits10;
    return std::clamp(static_cast<int>(floor(-log10(worst))), 0, std::numeric_limits<T>::digits10);
}

template std::string text_of_digits(const Real50&, int);
template std::string text_of_digits(const Real100&, int);
template Real50 scale_of(const std::vector<Real50>&);
template Real100 scale_of(const std::vector<Real100>&);
template std::optional<int> agreement(const std::vector<Real50>&, const std::vector<Real50>&, bool);
template std::optional<int> agreement(const std::vector<Real100>&, const std::vector<Real100>&, bool);

} // namespace denhartog::conformance::generator
