"""One scene by the library: amplitude and phase of each mass. Usage: library_example.py LIBDENHARTOG.SO.0"""
import ctypes
import sys
from ctypes import byref, c_char_p, c_double, c_int, c_size_t, c_void_p


class Summary(ctypes.Structure):  # dh_summary
    _fields_ = [("size", c_size_t), ("regime", c_int), ("on_boundary", c_int), ("unique", c_int), ("symmetric", c_int),
                ("periods", c_int), ("rest_interval_exists", c_int), ("stops", c_size_t), ("rest_from", c_double),
                ("rest_to", c_double), ("rest_error", c_double), ("relative_error", c_double)]


class Mass(ctypes.Structure):  # dh_mass
    _fields_ = [("size", c_size_t), ("amplitude", c_double), ("error", c_double), ("phase", c_double),
                ("phase_error", c_double), ("moves", c_int)]


library = ctypes.CDLL(sys.argv[1])
numbers = ctypes.POINTER(c_double)
library.dh_last_message.restype = c_char_p
library.dh_system_from_ratios.argtypes = [c_size_t, numbers, numbers, numbers, c_size_t, c_size_t, c_void_p]
library.dh_solve.argtypes = [c_void_p, c_double, c_double, c_double, c_int, c_void_p]
library.dh_solution_summary.argtypes = [c_void_p, c_void_p]
library.dh_solution_mass.argtypes = [c_void_p, c_size_t, c_void_p]
library.dh_solution_destroy.argtypes = library.dh_system_destroy.argtypes = [c_void_p]
library.dh_solution_destroy.restype = library.dh_system_destroy.restype = None


def need(status):
    if status != 0:
        sys.exit(library.dh_last_message().decode())


masses, springs, damping = [1, 2.5], [1, 0.625], [0.0625, 0.125]
contact, load, r, beta, mu = 2, 1, 1.125, 0.125, 1.25

system, solution = c_void_p(), c_void_p()
array = c_double * len(masses)
need(library.dh_system_from_ratios(len(masses), array(*masses), array(*springs), array(*damping), contact, load, byref(system)))
need(library.dh_solve(system, r, beta, mu, 0, byref(solution)))
motion = Summary(size=ctypes.sizeof(Summary))
need(library.dh_solution_summary(solution, byref(motion)))
print(f"regime {motion.regime}, {motion.stops} stops in a period")
for k in range(1, len(masses) + 1):
    mass = Mass(size=ctypes.sizeof(Mass))
    need(library.dh_solution_mass(solution, k, byref(mass)))
    print(f"mass {k}: amplitude {mass.amplitude:.6f}, phase {mass.phase:.6f}")
library.dh_solution_destroy(solution)
library.dh_system_destroy(system)
