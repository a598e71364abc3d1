! The closed form answers the questions of `denhartog conform` in the plain dialect.
program adapter
  use, intrinsic :: iso_fortran_env, only: output_unit
  use, intrinsic :: ieee_arithmetic, only: ieee_is_finite
  use closed_form
  implicit none
  character(65536) :: line
  character(100) :: id, q
  character(20), parameter :: regimes(3) = [character(20) :: 'continuous', 'stick_slip', 'permanent_sticking']
  integer :: i, k, samples, fault
  real(dp) :: tau, start(2), at_tau(2), a(2); real(dp), allocatable :: x(:)
  logical :: good, slides, held
  read (*, '(a)') line; print '(a)', 'denhartog-conform 1 plain closed form in Fortran'
  do
    flush (output_unit); read (*, '(a)', iostat = fault) line
    if (fault /= 0) exit
    read (line, *) id, q, N
    gamma = [(0d0, i = 1, N)]; kappa = gamma; zeta = gamma; x = [real(dp) ::]; a = 0
    read (line, *, iostat = fault) id, q, N, j, l, k, samples, tau, mu, r, beta, gamma, kappa, zeta
    good = fault == 0 .and. count([(line(i:i) /= ' ' .and. line(i + 1:i + 1) == ' ', i = 1, len_trim(line))]) == 11 + 3 * N
    good = good .and. min(j, l) >= 1 .and. max(j, l, k) <= N .and. min(k, samples) >= 0
    good = good .and. mu >= 1 .and. r > 0 .and. beta >= 0 .and. mu + r + beta <= huge(1d0) .and. all(gamma > 0)
    good = good .and. all(kappa > 0) .and. all(zeta >= 0) .and. all(gamma + kappa + zeta <= huge(1d0))
    if (good) good = abs(gamma(1) - 1) + abs(kappa(1) - 1) <= 0
    if (index(line, '_matrix') + index(line, 'contact_with') + index(line, 'base_motion') + index(line, ' loads ') > 0) then
      print '(a)', trim(id) // ' skip not a scene of the paper'; cycle; end if
    if (.not. good) then; print '(a)', trim(id) // ' reject a ratio, a mass or mu, r, beta breaks its rule'; cycle; end if
    call solve_scene; k = max(k, 1); slides = regime == continuous; held = regime == permanent_sticking
    start = motion(k, 0d0); at_tau = motion(k, tau)
    if ((slides .or. held) .and. (q == 'amplitude' .or. q == 'phase')) a = amplitude(k)
    select case (q)
    case ('natural_frequency_ratios'); x = r_n; case ('modal_frequency_ratios'); x = R_i
    case ('mode_shape_products'); x = phi(k, :) / r * phi(j, :) / r; case ('complex_response'); x = [real(V_k(k)), aimag(V_k(k))]
    case ('first_damping_function'); x = [U_k(k)]; case ('second_damping_function'); x = [G_k(k)]
    case ('H_j'); x = [H_j]; case ('S_j'); x = [S_j]
    case ('beta_lim_exact'); x = [exact]; case ('beta_lim_approximate'); x = [approximate]
    case ('beta_lim_paper'); x = [(largest(demand, i, instants - 1), i = 1, N)]; x = [beta_lim(sum(x(1::3)))] ! (56)
    case ('beta_lim_sticking'); x = [sticking]; case ('beta_lim_high_frequency'); if (j == l) x = [1 / hypot(mu, pi / 2)] ! (86)
    case ('rest_interval'); if (held) x = [rest]
    case ('amplitude'); if (slides .or. held) x = [a(1)]; case ('phase'); if (a(1) > 0) x = [a(2)]
    case ('initial_displacement'); if (slides) x = [start(1)]; case ('initial_velocity'); if (slides) x = [start(2)]
    case ('displacement'); if (slides) x = [at_tau(1)]
    case ('amplitude_monoharmonic'); if (slides) x = [norm2(start)] ! (52)
    case ('phase_monoharmonic'); if (slides) x = [phi_j + atan2(start(2), start(1))] ! (53)
    case ('motion_under_force')
      if (slides) x = [(motion(k, 2 * pi * i / samples - phi_j), i = 0, samples - 1)]
      if (slides) x = x(1::2)
      if (held) x = [(real(X_held(k) * exp(cmplx(0, 2 * pi * i / samples, dp))), i = 0, samples - 1)]
    case ('regime')
      if (regime /= at_a_pole) print '(a)', trim(id) // ' value ' // trim(regimes(regime))
      if (regime /= at_a_pole) cycle
    end select
    if (index(q, 'phase') == 1) x = x - 2 * pi * ceiling((x - pi) / (2 * pi)) ! to (-pi, pi]
    if (.not. all(ieee_is_finite(x)) .or. size(x) == 0) then
      print '(a)', trim(id) // ' skip the closed form has no number here'
    else
      print '(a, *(1x, es24.16e3))', trim(id) // ' value', x
    end if
  end do
end program
