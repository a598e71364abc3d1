! One scene by the library: amplitude and phase of each mass.
program library_example
  use, intrinsic :: iso_c_binding
  implicit none

  type, bind(c) :: dh_summary
    integer(c_size_t) :: bytes
    integer(c_int) :: regime, on_boundary, unique, symmetric, periods, rest_interval_exists
    integer(c_size_t) :: stops
    real(c_double) :: rest_from, rest_to, rest_error, relative_error
  end type
  type, bind(c) :: dh_mass
    integer(c_size_t) :: bytes
    real(c_double) :: amplitude, error, phase, phase_error
    integer(c_int) :: moves
  end type

  interface
    integer(c_int) function dh_system_from_ratios(N, masses, springs, damping, contact, load, system) bind(c)
      import :: c_int, c_size_t, c_double, c_ptr
      integer(c_size_t), value :: N, contact, load
      real(c_double), intent(in) :: masses(*), springs(*), damping(*)
      type(c_ptr), intent(out) :: system
    end function
    integer(c_int) function dh_solve(system, r, beta, mu, digits, solution) bind(c)
      import :: c_int, c_double, c_ptr
      type(c_ptr), value :: system
      real(c_double), value :: r, beta, mu
      integer(c_int), value :: digits
      type(c_ptr), intent(out) :: solution
    end function
    integer(c_int) function dh_solution_summary(solution, summary) bind(c)
      import :: c_int, c_ptr, dh_summary
      type(c_ptr), value :: solution
      type(dh_summary), intent(inout) :: summary
    end function
    integer(c_int) function dh_solution_mass(solution, mass, answer) bind(c)
      import :: c_int, c_size_t, c_ptr, dh_mass
      type(c_ptr), value :: solution
      integer(c_size_t), value :: mass
      type(dh_mass), intent(inout) :: answer
    end function
    subroutine dh_solution_destroy(solution) bind(c)
      import :: c_ptr
      type(c_ptr), value :: solution
    end subroutine
    subroutine dh_system_destroy(system) bind(c)
      import :: c_ptr
      type(c_ptr), value :: system
    end subroutine
  end interface

  integer(c_size_t), parameter :: N = 2, contact = 2, load = 1
  real(c_double), parameter :: masses(N) = [1d0, 2.5d0], springs(N) = [1d0, 0.625d0], damping(N) = [0.0625d0, 0.125d0]
  real(c_double), parameter :: r = 1.125d0, beta = 0.125d0, mu = 1.25d0
  type(c_ptr) :: system, solution
  type(dh_summary) :: motion
  type(dh_mass) :: mass
  integer(c_size_t) :: k

  call need(dh_system_from_ratios(N, masses, springs, damping, contact, load, system))
  call need(dh_solve(system, r, beta, mu, 0_c_int, solution))
  motion%bytes = c_sizeof(motion)
  call need(dh_solution_summary(solution, motion))
  print '(a, i0, a, i0, a)', 'regime ', motion%regime, ', ', motion%stops, ' stops in a period'
  do k = 1, N
    mass%bytes = c_sizeof(mass)
    call need(dh_solution_mass(solution, k, mass))
    print '(a, i0, 4a)', 'mass ', k, ': amplitude ', text_of(mass%amplitude), ', phase ', text_of(mass%phase)
  end do
  call dh_solution_destroy(solution)
  call dh_system_destroy(system)

contains

  subroutine need(status)
    integer(c_int), intent(in) :: status
    if (status /= 0) error stop 'the library refused'
  end subroutine

  function text_of(x) result(text)
    real(c_double), intent(in) :: x
    character(:), allocatable :: text
    character(20) :: wide
    write (wide, '(f20.6)') x
    text = trim(adjustl(wide))
  end function

end program
