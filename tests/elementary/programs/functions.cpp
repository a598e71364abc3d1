// Prints, for each elementary function, how many values it gave and a number made of all their bits. The arguments are seeded and
// made without any function: the lines are the same from every compiler and on every machine.
#include <bit>
#include <cstdint>
#include <cstdio>

#include "denhartog/evaluation/detail/vector_functions.hpp"
#include "denhartog/model/detail/product_of_doubles.hpp"
#include "elementary/elementary.hpp"

using namespace denhartog;

namespace {

constexpr int count = 20000;

// splitmix64.
struct Draw {
    std::uint64_t state = 23;
    std::uint64_t operator()() {
        std::uint64_t z = state += 0x9e3779b97f4a7c15U;
        z = (z ^ z >> 30U) * 0xbf58476d1ce4e5b9U;
        z = (z ^ z >> 27U) * 0x94d049bb133111ebU;
        return z ^ z >> 31U;
    }
    double share() { return static_cast<double>((*this)() >> 11U) * 0x1p-53; }
};

// By turns anywhere among the doubles, from -50 to 50, and from -1 to 1.
double argument(Draw& draw, int n) {
    if (n % 3 == 0) return std::bit_cast<double>(draw());
    return (n % 3 == 1 ? 50 : 1) * (2 * draw.share() - 1);
}

struct Bits {
    std::uint64_t all = 0xcbf29ce484222325U;
    long values = 0;
    void take(double x) {
        const std::uint64_t bits = x == x ? std::bit_cast<std::uint64_t>(x) : 0x7ff8000000000000U; // no number has many forms
        all = (all ^ bits) * 0x100000001b3U;
        all ^= all >> 29U;
        ++values;
    }
    void print(const char* name) const { std::printf("%s,%ld,%016llx\n", name, values, static_cast<unsigned long long>(all)); }
};

template <class Function>
void show(const char* name, Function f) {
    Draw draw;
    Bits bits;
    for (int n = 0; n < count; ++n) bits.take(f(argument(draw, n)));
    bits.print(name);
}

template <class Function>
void show_of_two(const char* name, Function f) {
    Draw draw;
    Bits bits;
    for (int n = 0; n < count; ++n) {
        const double a = argument(draw, n), b = argument(draw, n);
        bits.take(f(a, b));
    }
    bits.print(name);
}

void show_products() {
    constexpr std::ptrdiff_t size = 13;
    double a[size * size], b[size * size], c[size * size];
    Draw draw;
    Bits bits;
    for (int n = 0; n < count / 169; ++n) {
        for (double& x : a) x = 2 * draw.share() - 1;
        for (double& x : b) x = 2 * draw.share() - 1;
        product_of_doubles({a, size, size, size}, {b, size, size, size}, c);
        for (const double x : c) bits.take(x);
    }
    bits.print("products of matrices");
}

void show_arrays() {
    Draw draw;
    Bits bits;
    for (int n = 0; n < count; ++n) {
        const auto e = evaluation::exponential_of_negative(-50 * draw.share());
        bits.take(e.head * e.tail);
        bits.take(e.E_minus_one);
        const double R = 0.1 + 3 * draw.share(), w = draw.share() * 0.9 + 0.05, late = draw.share() / 8;
        const auto products = evaluation::half_angle_products(R, 1 / (2 * R), w, late);
        bits.take(products.sine_cosine);
        bits.take(products.cosine_square);
    }
    bits.print("functions of arrays");
}

} // namespace

int main() {
    std::printf("function,values,bits\n");
    show("exp", elementary::exp);
    show("expm1", elementary::expm1);
    show("sinh", elementary::sinh);
    show("cosh", elementary::cosh);
    show("log", elementary::log);
    show("log10", elementary::log10);
    show("sin", elementary::sin);
    show("cos", elementary::cos);
    show("sin of half turns", elementary::sine_of_half_turns);
    show("cos of half turns", elementary::cosine_of_half_turns);
    show("atan", elementary::atan);
    show_of_two("atan2", elementary::atan2);
    show_of_two("hypot", elementary::hypot);
    show_products();
    show_arrays();
}
