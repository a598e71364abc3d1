// The system's exponential in place of the library's, which the linker gives every source of a program that must be found out.
#include <cmath>

extern "C" double __wrap__ZN9denhartog10elementary3expEd(double x) { return std::exp(x); }
