// The system's exponential in place of the library's, for a program that must be found out: the linker gives every other source this one.
#include <cmath>

extern "C" double __wrap__ZN9denhartog10elementary3expEd(double x) { return std::exp(x); }
