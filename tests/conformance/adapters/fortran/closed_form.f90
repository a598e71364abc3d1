! The steady motion of a chain with a Coulomb contact, where the contact slides throughout or rests for ever: the closed form of
! Marino & Cicirello, JSV 535 (2022) 117085, as corrected. Numbers in brackets are its equations.
module closed_form
  implicit none
  integer, parameter :: dp = kind(1d0), most = 64
  integer, parameter :: continuous = 1, stick_slip = 2, permanent_sticking = 3
  real(dp), parameter :: pi = 3.14159265358979323846_dp

  type scene
    integer :: N, j, l                                          ! number of masses, mass in contact, loaded mass
    real(dp) :: mu, r, beta                                     ! (3), (10), (11)
    real(dp), allocatable :: gamma(:), kappa(:), zeta(:)        ! m_i / m_1 (9), k_i / k_1 (73), modal damping ratios (18)
    real(dp), allocatable :: r_n(:), phi(:, :)                  ! omega_i sqrt(m_1 / k_1) (15); shapes, psi = phi / r (17)
    real(dp), allocatable :: R_i(:), u(:), g(:)                 ! (22), (28), (29)
    complex(dp), allocatable :: v(:), V_k(:), X_held(:)         ! (23), (33); amplitudes while the contact is held (88)
    real(dp), allocatable :: U_k(:), G_k(:)                     ! (34), (35)
    real(dp) :: H_j, S_j, exact, paper, approximate, sticking   ! (64), sum of (57), (69), (69) with (56), (67), (88)
    real(dp) :: root, X_j, phi_j, rest                          ! (38), (39); it may rest from minus to plus this (74)
    integer :: regime
  end type

contains

  pure logical function keeps_rules(s)
    type(scene), intent(in) :: s
    keeps_rules = min(s%j, s%l) >= 1 .and. max(s%j, s%l) <= s%N .and. s%mu >= 1 .and. s%r > 0 .and. s%beta >= 0
    keeps_rules = keeps_rules .and. s%mu + s%r + s%beta <= huge(1d0)
    if (.not. keeps_rules) return
    keeps_rules = s%gamma(1) == 1 .and. s%kappa(1) == 1 .and. all(s%gamma > 0) .and. all(s%kappa > 0) .and. all(s%zeta >= 0)
    keeps_rules = keeps_rules .and. all(s%gamma + s%kappa + s%zeta <= huge(1d0))
  end function

  ! K = F^T F, where F takes displacements to the roots of the springs' energies. Jacobi's rotations Q make the columns of
  ! F gamma^(-1/2) orthogonal: their lengths are the natural frequency ratios and gamma^(-1/2) Q the mode shapes (15).
  subroutine modes(s)
    type(scene), intent(inout) :: s
    real(dp) :: F(s%N, s%N), Q(s%N, s%N), column(s%N), a, b, c, t, cosine
    integer :: i, k, sweep
    F = 0; Q = 0
    do i = 1, s%N
      Q(i, i) = 1; F(i, i) = sqrt(s%kappa(i) / s%gamma(i))
    end do
    do i = 2, s%N
      F(i, i - 1) = -sqrt(s%kappa(i) / s%gamma(i - 1))
    end do
    do sweep = 1, 40
      do i = 1, s%N
        do k = i + 1, s%N
          a = sum(F(:, i)**2); b = sum(F(:, k)**2); c = sum(F(:, i) * F(:, k))
          if (abs(c) <= 1d-17 * sqrt(a) * sqrt(b)) cycle
          t = 2 * c / (b - a + sign(hypot(b - a, 2 * c), b - a)); cosine = 1 / hypot(1d0, t)
          column = F(:, i); F(:, i) = cosine * (column - t * F(:, k)); F(:, k) = cosine * (t * column + F(:, k))
          column = Q(:, i); Q(:, i) = cosine * (column - t * Q(:, k)); Q(:, k) = cosine * (t * column + Q(:, k))
        end do
      end do
    end do
    s%r_n = [(norm2(F(:, i)), i = 1, s%N)]; s%phi = F
    do i = 1, s%N ! ascending: the place of a mode is one more than the number of lower ones
      k = 1 + count(s%r_n < s%r_n(i)) + count(s%r_n(:i - 1) == s%r_n(i))
      s%phi(:, k) = Q(:, i) / sqrt(s%gamma); column(k) = s%r_n(i)
    end do
    s%r_n = column
  end subroutine

  pure complex(dp) function complex_response(R, zeta) result(v) ! (23), divided so that no square overflows
    real(dp), intent(in) :: R, zeta
    real(dp) :: a, b
    a = (1 - R) * (1 + R); b = 2 * zeta * R
    if (abs(a) >= b) then
      v = cmplx(1d0, -b / a, dp) / (a + b * (b / a))
    else
      v = cmplx(a / b, -1d0, dp) / (b + a * (a / b))
    end if
  end function

  ! exp(x) - 1 without its cancellation.
  pure real(dp) function expm1(x)
    real(dp), intent(in) :: x
    expm1 = merge(2 * exp(x / 2) * sinh(x / 2), exp(x) - 1, abs(x) < 1)
  end function

  ! 1 - d, q (A.8) and R q' (A.9) of a mode at x = tau / R; from zeta = 1 on by its two rates of decay a and b = 1 / a.
  pure subroutine free_motion(x, zeta, one_less_d, q, R_q_prime)
    real(dp), intent(in) :: x, zeta
    real(dp), intent(out) :: one_less_d, q, R_q_prime
    real(dp) :: w, E, b
    w = sqrt(abs((1 - zeta) * (1 + zeta)))
    if (zeta < 1) then
      E = exp(-zeta * x); q = E * sin(w * x) / w; R_q_prime = E * cos(w * x) - zeta * q
      one_less_d = -expm1(-zeta * x) + 2 * E * sin(w * x / 2)**2 - zeta * q
    else
      b = zeta + w; q = x
      if (w > 0) q = -expm1(-2 * w * x) / (2 * w)
      q = exp(-x / b) * q; R_q_prime = exp(-b * x) - q / b; one_less_d = -expm1(-x / b) - q / b
    end if
  end subroutine

  ! [sinh(delta) / delta - sin(theta) / theta] / x^2 of (29), x = pi / R, which cancels at large R: the sum over n >= 1 of
  ! D_n / (2n+1)!, D_n = (X^n - Y^n) / (X - Y), X = delta^2, Y = -theta^2 (for zeta > 1 it is positive).
  pure real(dp) function bracket(x, zeta)
    real(dp), intent(in) :: x, zeta
    real(dp) :: delta_2, Y, term, power
    integer :: n
    delta_2 = (x * zeta)**2; Y = (zeta - 1) * x * ((zeta + 1) * x); bracket = 0; term = 1d0 / 6; power = Y / 6
    do n = 1, 40
      bracket = bracket + term
      term = (delta_2 * term + power) / ((2 * n + 2) * (2 * n + 3)); power = power * Y / ((2 * n + 2) * (2 * n + 3))
    end do
  end function

  ! u (28), g (29). Both are scaled by E = exp(-delta), so that nothing overflows at small R, and cosh(delta) + cos(theta) is a
  ! sum of squares, so that nothing cancels where it is nearly zero, with c = cos(theta / 2): 2 E (...) = (1 - E)^2 + 4 E c^2.
  pure subroutine damping_functions(R, zeta, u, g)
    real(dp), intent(in) :: R, zeta
    real(dp), intent(out) :: u, g
    real(dp) :: x, delta, E, F, w, y, si, c, D, a, b, rest, one_less_d, q, rate
    integer :: quarters
    x = pi / R; delta = zeta * x; E = exp(-delta); F = -expm1(-delta)
    if (zeta < 1) then
      w = sqrt((1 - zeta) * (1 + zeta)); y = zeta**2 / (1 + w) / (2 * R) ! (1 - w) / (2 R)
      si = sin(pi * (w / (2 * R))); c = cos(pi * (w / (2 * R)))
      if (zeta < 0.5_dp) then ! theta / 2 = pi / (2 R) - pi y: its quarter turns are taken off exactly, before pi comes in
        rest = mod(1d0, 4 * R)
        if (rest > 2 * R) rest = rest - 4 * R
        quarters = nint(rest / R); rest = pi * ((rest - quarters * R) / (2 * R) - y)
        si = sin(rest); c = cos(rest)
        if (mod(quarters, 2) /= 0) then
          rest = si; si = sign(c, c * quarters); c = -sign(rest, rest * quarters)
        else if (quarters /= 0) then
          si = -si; c = -c
        end if
      end if
      D = F**2 + 4 * E * c**2
      u = 4 * E * si * c / (R * w * D); g = (F * (1 + E) - 4 * E * (zeta / w) * si * c) / D
      if (R >= 1.25_dp) g = 2 * E * delta * x**2 * bracket(x, zeta) / D
    else ! cos(theta) and sin(theta) / w with w imaginary
      w = sqrt(zeta - 1) * sqrt(zeta + 1); b = zeta + w; a = 1 / b; D = (1 + exp(-a * x)) * (1 + exp(-b * x))
      call free_motion(x, zeta, one_less_d, q, rate)
      u = 2 * q / R / D; g = (F * (1 + E) - 2 * zeta * q) / D
      if (delta <= 4) then
        g = 2 * E * delta * x**2 * bracket(x, zeta) / D
      else if (w * x > 1 .and. a * x < 3) then
        g = (b * tanh(a * x / 2) - a * tanh(b * x / 2)) / (2 * w)
      end if
    end if
  end subroutine

  pure recursive real(dp) function s_i(tau, R, zeta, u, g) result(s) ! (57) as corrected; at 0 and pi its limits (71)
    real(dp), intent(in) :: tau, R, zeta, u, g
    real(dp) :: x, w, one_less_d, q, difference ! R q' - cos tau
    if (tau <= 0) then
      s = 1 + g + 2 * zeta * R * u
    else if (tau >= pi) then
      s = g + 2 * zeta * R * u - 1
    else if (tau > pi / 2 .and. zeta * pi / R < 1 .and. zeta < 1) then
      s = -s_i(pi - tau, R, -zeta, u, -g) ! from the end, backwards
    else
      x = tau / R
      call free_motion(x, zeta, one_less_d, q, difference)
      if (zeta < 1) then ! cos(w x) - cos(tau) as a product: near R = 1 it is small, and u large
        w = sqrt((1 - zeta) * (1 + zeta))
        difference = expm1(-zeta * x) * cos(w * x) - zeta * q
        difference = difference - 2 * sin((w * x + tau) / 2) * sin((1 - R - zeta**2 / (1 + w)) * x / 2)
      else
        w = zeta + sqrt(zeta - 1) * sqrt(zeta + 1); difference = expm1(-w * x) - q / w + 2 * sin(tau / 2)**2
      end if
      s = ((1 + g) * R * q - u * R * (R * difference)) / sin(tau)
    end if
  end function

  pure real(dp) function sum_of_s(s, mode, tau) ! psi_ji^2 s_i, of one mode, or with mode = 0 summed over all (56)
    type(scene), intent(in) :: s
    integer, intent(in) :: mode
    real(dp), intent(in) :: tau
    integer :: i
    sum_of_s = 0
    do i = 1, s%N
      if (mode == 0 .or. mode == i) &
        sum_of_s = sum_of_s + (s%phi(s%j, i) / s%r)**2 * s_i(tau, s%R_i(i), s%zeta(i), s%u(i), s%g(i))
    end do
  end function

  pure recursive subroutine displacement(s, k, tau, x, velocity) ! (46), tau = 0 at the maximum of x_j
    type(scene), intent(in) :: s
    integer, intent(in) :: k
    real(dp), intent(in) :: tau
    real(dp), intent(out) :: x, velocity
    complex(dp) :: Z
    real(dp) :: weight, one_less_d, q, R_q_prime
    integer :: i
    if (tau >= pi) then ! (25)
      call displacement(s, k, tau - pi, x, velocity)
      x = -x; velocity = -velocity
      return
    end if ! V_k exp i(tau + phi_j), where V_j exp(i phi_j) is root - i beta U_j (36), (37)
    Z = s%V_k(k) / s%V_k(s%j) * cmplx(s%root, -s%beta * s%U_k(s%j), dp) * exp(cmplx(0d0, tau, dp))
    x = real(Z); velocity = -aimag(Z)
    do i = 1, s%N
      weight = s%beta * s%phi(k, i) * s%phi(s%j, i) / s%r_n(i)**2 ! beta psi_ki psi_ji R_i^2
      call free_motion(tau / s%R_i(i), s%zeta(i), one_less_d, q, R_q_prime)
      x = x + weight * (one_less_d - s%g(i) * (1 - one_less_d) - s%u(i) * s%R_i(i) * q)
      velocity = velocity + weight * ((1 + s%g(i)) * q / s%R_i(i) - s%u(i) * R_q_prime)
    end do
  end subroutine

  pure real(dp) function size_of_x(s, k, tau)
    type(scene), intent(in) :: s
    integer, intent(in) :: k
    real(dp), intent(in) :: tau
    real(dp) :: velocity
    call displacement(s, k, merge(tau, 0d0, tau < pi), size_of_x, velocity)
    size_of_x = abs(size_of_x)
  end function

  ! Largest value over [0, pi]: samples, closer where the motions of modes start, then golden sections about every local one.
  subroutine maximum(f, s, which, best, instant)
    procedure(sum_of_s) :: f
    type(scene), intent(in) :: s
    integer, intent(in) :: which
    real(dp), intent(out) :: best, instant
    real(dp) :: before, middle, after, left, t, right, a, c, step, f_left, f_right
    integer :: n, samples
    samples = int(min(50000d0, 200 + 30 / s%R_i(s%N)))
    before = -huge(1d0); middle = f(s, which, 0d0); best = before; left = 0; t = 0
    do n = 1, samples + 1
      right = merge(pi * (real(n, dp) / samples)**2, pi, n < samples); after = -huge(1d0)
      if (n <= samples) after = f(s, which, right)
      if (middle > best) instant = t
      best = max(best, middle); a = left; c = right; step = c - a
      do while (middle >= before .and. middle >= after .and. step > min(1d-8, 1d-8 * s%R_i(s%N)))
        step = step * 0.61803398874989485_dp
        f_left = f(s, which, c - step); f_right = f(s, which, a + step)
        if (max(f_left, f_right) > best) instant = merge(c - step, a + step, f_left > f_right)
        best = max(best, f_left, f_right)
        if (f_left > f_right) then
          c = a + step
        else
          a = c - step
        end if
      end do
      left = t; t = right; before = middle; middle = after
    end do
  end subroutine

  pure real(dp) function wrapped(angle) ! to (-pi, pi]
    real(dp), intent(in) :: angle
    wrapped = angle - 2 * pi * ceiling((angle - pi) / (2 * pi))
  end function

  subroutine amplitude(s, k, size, phase) ! (38), (39), (47), or with the contact held
    type(scene), intent(in) :: s
    integer, intent(in) :: k
    real(dp), intent(out) :: size, phase
    real(dp) :: t, x, velocity, a, b, h, way
    integer :: n
    size = s%X_j; phase = s%phi_j
    if (s%regime == permanent_sticking) then
      size = abs(s%X_held(k)); phase = wrapped(-atan2(aimag(s%X_held(k)), real(s%X_held(k))))
    else if (k /= s%j) then
      call maximum(size_of_x, s, k, size, t)
      call displacement(s, k, min(t, pi * (1 - 1d-15)), x, velocity)
      h = min(1d-3, 1d-2 * s%R_i(s%N)); a = max(0d0, t - h); b = min(pi * (1 - 1d-15), t + h); way = sign(1d0, x)
      do n = 1, 60 ! the instant more sharply: zero velocity
        t = (a + b) / 2
        call displacement(s, k, t, x, velocity)
        if (way * velocity > 0) a = t
        if (way * velocity <= 0) b = t
      end do
      size = abs(x); phase = wrapped(s%phi_j + t + merge(pi, 0d0, way < 0))
    end if
  end subroutine

  real(dp) function motion_under_force(s, k, tau) result(x) ! tau = 0 at the maximum of the force
    type(scene), intent(in) :: s
    integer, intent(in) :: k
    real(dp), intent(in) :: tau
    real(dp) :: velocity
    if (s%regime == permanent_sticking) then
      x = real(s%X_held(k) * exp(cmplx(0d0, tau, dp)))
    else
      call displacement(s, k, modulo(tau - s%phi_j, 2 * pi), x, velocity)
    end if
  end function

  ! The masses under the load while the contact is held, (K - r^2 M + i C) X = P by elimination, where the unknown at the contact
  ! is not X_j, which is zero, but the force that holds it (75), (88). Its size is the load.
  subroutine hold_contact(s, load)
    type(scene), intent(inout) :: s
    real(dp), intent(out) :: load
    complex(dp) :: Z(s%N, s%N + 1), row(s%N + 1)
    integer :: k, m, pivot
    Z = 0
    do k = 1, s%N
      do m = 1, s%N ! (19)
        Z(k, m) = cmplx(0d0, sum(2 * s%zeta * s%r_n * s%r * s%gamma(k) * s%phi(k, :) * s%gamma(m) * s%phi(m, :)), dp)
      end do
    end do
    do k = 1, s%N
      Z(k, k) = Z(k, k) + s%kappa(k) - s%gamma(k) * s%r**2
    end do
    do k = 2, s%N
      m = k - 1
      Z(m, m) = Z(m, m) + s%kappa(k); Z(k, m) = Z(k, m) - s%kappa(k); Z(m, k) = Z(m, k) - s%kappa(k)
    end do
    Z(:, s%j) = 0; Z(s%j, s%j) = -1; Z(s%l, s%N + 1) = 1
    do k = 1, s%N
      if (k == s%j) cycle ! the force is in row j alone
      pivot = k - 1 + maxloc(abs(Z(k:, k)), 1, [(m /= s%j, m = k, s%N)])
      row = Z(pivot, :); Z(pivot, :) = Z(k, :); Z(k, :) = row / row(k)
      do m = 1, s%N
        if (m /= k) Z(m, :) = Z(m, :) - Z(m, k) * Z(k, :)
      end do
    end do
    s%X_held = Z(:, s%N + 1); load = abs(s%X_held(s%j)); s%X_held(s%j) = 0
  end subroutine

  subroutine solve_scene(s) ! all of a scene from its first three lines
    type(scene), intent(inout) :: s
    real(dp) :: S_paper, demand, size, load, S_mode, t, weight(s%N)
    integer :: i, k
    call modes(s)
    s%R_i = s%r / s%r_n; s%v = [(complex_response(s%R_i(i), s%zeta(i)), i = 1, s%N)]
    s%u = s%R_i; s%g = s%R_i; s%U_k = s%R_i; s%G_k = s%R_i; s%V_k = s%v; s%X_held = s%v
    do i = 1, s%N
      call damping_functions(s%R_i(i), s%zeta(i), s%u(i), s%g(i))
    end do
    do k = 1, s%N
      weight = s%phi(k, :) / s%r_n**2 ! psi_ki psi_ji R_i^2 = phi_ki phi_ji / r_n,i^2
      s%V_k(k) = sum(weight * s%phi(s%l, :) * s%v)
      s%U_k(k) = sum(weight * s%phi(s%j, :) * s%u); s%G_k(k) = sum(weight * s%phi(s%j, :) * s%g)
    end do
    s%H_j = sum((s%phi(s%j, :) / s%r)**2 * (s%g + 2 * s%zeta * s%R_i * s%u))
    call maximum(sum_of_s, s, 0, s%S_j, t)
    S_paper = 0
    do i = 1, s%N
      call maximum(sum_of_s, s, i, S_mode, t)
      S_paper = S_paper + S_mode
    end do
    call hold_contact(s, load)
    demand = s%H_j + s%mu / (s%gamma(s%j) * s%r**2); size = abs(s%V_k(s%j))
    s%exact = size / hypot(s%U_k(s%j), max(s%S_j, demand)); s%paper = size / hypot(s%U_k(s%j), max(S_paper, demand))
    s%approximate = size / hypot(s%U_k(s%j), demand); s%sticking = load / s%mu
    s%rest = (s%mu * s%beta - load) * sum(1 / s%kappa(:s%j))
    s%regime = merge(permanent_sticking, stick_slip, s%beta >= s%sticking)
    if (s%beta < s%exact) s%regime = continuous
    s%root = sqrt(max(0d0, (size - s%beta * abs(s%U_k(s%j))) * (size + s%beta * abs(s%U_k(s%j)))))
    s%X_j = s%root - s%beta * s%G_k(s%j)
    s%phi_j = wrapped(atan2(-s%beta * s%U_k(s%j), s%root) - atan2(aimag(s%V_k(s%j)), real(s%V_k(s%j))))
  end subroutine

end module
