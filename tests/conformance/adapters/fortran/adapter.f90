! The closed form answers the questions of `denhartog conform` in the plain dialect.
program adapter
  use, intrinsic :: iso_fortran_env, only: output_unit
  use, intrinsic :: ieee_arithmetic, only: ieee_is_finite
  use closed_form
  implicit none
  character(65536) :: line
  character(100) :: id, q
  character(20), parameter :: regimes(3) = [character(20) :: 'continuous', 'stick_slip', 'permanent_sticking']
  type(scene) :: s
  integer :: k, samples, fault, n
  real(dp) :: tau, size, phase, x_0, v_0, x_tau, v
  real(dp), allocatable :: x(:)
  logical :: slides, moves
  read (*, '(a)') line; print '(a)', 'denhartog-conform 1 plain closed form in Fortran'
  do
    flush (output_unit); read (*, '(a)', iostat = fault) line
    if (fault /= 0) exit
    read (line, *) id, q, s%N
    n = max(s%N, 0); size = 0; x = [real(dp) ::]; s%gamma = [(0d0, k = 1, n)]; s%kappa = s%gamma; s%zeta = s%gamma
    read (line, *, iostat = fault) id, q, s%N, s%j, s%l, k, samples, tau, s%mu, s%r, s%beta, s%gamma, s%kappa, s%zeta
    if (fault /= 0 .or. .not. keeps_rules(s) .or. k < 0 .or. k > s%N .or. samples < 0) then
      print '(a)', trim(id) // ' reject a ratio, a mass or mu, r, beta breaks its rule'; cycle
    end if
    call solve_scene(s); k = max(k, 1); slides = s%regime == continuous; moves = s%regime /= stick_slip
    if (moves .and. (q == 'amplitude' .or. q == 'phase')) call amplitude(s, k, size, phase)
    call displacement(s, k, 0d0, x_0, v_0); call displacement(s, k, tau, x_tau, v)
    select case (q)
    case ('natural_frequency_ratios'); x = s%r_n
    case ('modal_frequency_ratios'); x = s%R_i
    case ('mode_shape_products'); x = s%phi(k, :) / s%r * s%phi(s%j, :) / s%r
    case ('complex_response'); x = [real(s%V_k(k)), aimag(s%V_k(k))]
    case ('first_damping_function'); x = [s%U_k(k)]
    case ('second_damping_function'); x = [s%G_k(k)]
    case ('H_j'); x = [s%H_j]
    case ('S_j'); x = [s%S_j]
    case ('beta_lim_exact'); x = [s%exact]
    case ('beta_lim_paper'); x = [s%paper]
    case ('beta_lim_approximate'); x = [s%approximate]
    case ('beta_lim_sticking'); x = [s%sticking]
    case ('beta_lim_high_frequency'); if (s%j == s%l) x = [1 / hypot(s%mu, pi / 2)] ! (86)
    case ('rest_interval'); if (s%regime == permanent_sticking) x = [s%rest]
    case ('amplitude'); if (moves) x = [size]
    case ('phase'); if (size > 0) x = [phase]
    case ('initial_displacement'); if (slides) x = [x_0]
    case ('initial_velocity'); if (slides) x = [v_0]
    case ('displacement'); if (slides) x = [x_tau]
    case ('amplitude_monoharmonic'); if (slides) x = [hypot(x_0, v_0)] ! (52)
    case ('phase_monoharmonic'); if (slides) x = [wrapped(s%phi_j + atan2(v_0, x_0))] ! (53)
    case ('motion_under_force'); if (moves) x = [(motion_under_force(s, k, 2 * pi * n / samples), n = 0, samples - 1)]
    end select
    if (q == 'regime') then
      print '(a)', trim(id) // ' value ' // trim(regimes(s%regime))
    else if (.not. all(ieee_is_finite(x)) .or. ubound(x, 1) == 0) then
      print '(a)', trim(id) // ' skip the closed form has no number here'
    else
      print '(a, *(1x, es24.16e3))', trim(id) // ' value', x
    end if
  end do
end program
