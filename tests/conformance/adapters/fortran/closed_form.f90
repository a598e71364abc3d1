! The steady motion of a chain with one Coulomb contact, where it slides throughout or rests for ever, in closed form: Marino and
! Cicirello, JSV 535 (2022) 117085. Numbers in brackets are its equations, with the corrections in the ledger of denhartog.
! Modes with zeta >= 1, which the paper leaves out, obey them with w = i w_1: all stays real. One scene at a time, in the module.
module closed_form
  implicit none
  integer, parameter :: dp = kind(1d0), continuous = 1, stick_slip = 2, permanent_sticking = 3, at_a_pole = 4
  real(dp), parameter :: pi = 3.14159265358979323846_dp
  integer :: N, j, l                                        ! masses, mass in contact, loaded mass
  real(dp) :: mu, r, beta                                   ! (3), (10), (11)
  real(dp), allocatable, dimension(:) :: gamma, kappa, zeta ! m_i / m_1 (9), k_i / k_1 (73), damping ratios of the modes (18)
  real(dp), allocatable :: r_n(:), phi(:, :), D(:, :)       ! omega_i sqrt(m_1 / k_1) (15); shapes, psi = phi / r (17); stretches
  real(dp), allocatable, dimension(:) :: R_i, u, g          ! (22), (28), (29)
  real(dp), allocatable, dimension(:) :: U_k, G_k           ! (34), (35)
  complex(dp), allocatable, dimension(:) :: V_k, W, X_held  ! (33); V_k exp(i phi_j); amplitudes while the contact is held (88)
  real(dp) :: H_j, S_j, exact, approximate, sticking        ! (64), largest sum of (57), (69), (67), (88)
  real(dp) :: least, phi_j, rest ! what (67) demands; (39); a contact held may rest from minus to plus this
  integer :: regime, instants                               ! instants in half a period that follow the fastest mode
contains
  ! K = D^T diag(kappa) D: rotations make the columns of kappa^(1/2) D gamma^(-1/2) orthogonal, their lengths are r_n.
  subroutine natural_modes
    real(dp) :: B(2 * N, N), lengths(N), pq, h, t
    integer :: sweep, p, q
    D = reshape([((merge(1, 0, p == q) - merge(1, 0, p == q + 1), p = 1, N), q = 1, N)], [N, N])
    B(:N, :) = spread(sqrt(kappa), 2, N) * D / spread(sqrt(gamma), 1, N)
    B(N + 1:, :) = merge(1, 0, D > 0) / spread(sqrt(gamma), 1, N) ! the shapes, turned with them
    do sweep = 1, 40
      do p = 1, N
        do q = p + 1, N
          pq = dot_product(B(:N, p), B(:N, q))
          if (abs(pq) <= 1d-17 * norm2(B(:N, p)) * norm2(B(:N, q))) cycle
          h = (sum(B(:N, q)**2) - sum(B(:N, p)**2)) / (2 * pq)
          t = sign(1d0, h) / (abs(h) + hypot(1d0, h))
          B(:, [p, q]) = matmul(B(:, [p, q]), reshape([1d0, -t, t, 1d0], [2, 2])) / hypot(1d0, t)
        end do
      end do
    end do
    lengths = norm2(B(:N, :), 1); r_n = lengths; phi = B(N + 1:, :)
    do p = 1, N ! ascending
      q = 1 + count(lengths(:p - 1) <= lengths(p)) + count(lengths(p + 1:) < lengths(p))
      r_n(q) = lengths(p); phi(:, q) = B(N + 1:, p)
    end do
  end subroutine
  elemental real(dp) function expm1(x) ! exp(x) - 1 without its cancellation
    real(dp), intent(in) :: x
    expm1 = merge(2 * exp(x / 2) * sinh(x / 2), exp(x) - 1, abs(x) < 1)
  end function
  ! 1 - d, q, R q' and R q' - cos(tau) of a mode from (A.8), (A.9), without cancellation for tau -> 0 and R -> infinity. From
  ! zeta = 1 on its free motion decays at two rates, a = zeta - w_1 and b = zeta + w_1 = 1 / a with w_1 = sqrt(zeta^2 - 1).
  elemental subroutine free_motion(tau, R, zeta, less_d, q, Rq_prime, difference)
    real(dp), intent(in) :: tau, R, zeta
    real(dp), intent(out) :: less_d, q, Rq_prime, difference
    real(dp) :: x, w, a, b, E, fast, before, term, next
    integer :: k
    x = tau / R; w = sqrt(abs(1 - zeta)) * sqrt(1 + zeta)
    b = zeta + w; a = merge(zeta, 1 / b, zeta < 1); E = exp(-a * x)
    q = E * merge(sin(w * x) / w, -expm1(-2 * w * x) / (2 * w), zeta < 1)
    if (w <= 0) q = E * x
    fast = merge(E * cos(w * x), exp(-b * x), zeta < 1)
    Rq_prime = fast - a * q
    less_d = merge(1 - (fast + a * q), -expm1(-a * x) - a * q, zeta < 1)
    difference = expm1(-b * x) + 2 * sin(tau / 2)**2 - a * q
    if (zeta < 1) difference = expm1(-zeta * x) * cos(w * x) - zeta * q &
      - 2 * sin((w * x + tau) / 2) * sin(((1 - R) - zeta**2 / (1 + w)) * x / 2) ! cos(w x) - cos(tau)
    if (max(1d0, 2 * zeta) * x >= 1) return
    less_d = 0; before = 0; term = x * x / 2 ! there 1 - d by its power series: m'' + 2 zeta m' + m = 1
    do k = 2, 21
      less_d = less_d + term
      next = -(2 * zeta * x * k * term + x * x * before) / (k * (k + 1))
      before = term; term = next
    end do
  end subroutine
  ! u (28), g (29), with C = 2 E (cosh delta + cos theta) as a sum of squares or a product: it is zero at a pole.
  elemental subroutine damping_functions(R, zeta, u, g)
    real(dp), intent(in) :: R, zeta
    real(dp), intent(out) :: u, g
    real(dp) :: x, delta, E, F, w, a, C, q, cos_half, half, power, term, others(3)
    integer :: quarters, k
    x = pi / R; delta = zeta * x; E = exp(-delta); F = -expm1(-delta)
    w = sqrt(abs(1 - zeta)) * sqrt(1 + zeta); a = 1 / (zeta + w); cos_half = cos(w * x / 2)
    call free_motion(pi, R, zeta, others(1), q, others(2), others(3)) ! q = E sin(theta) / w
    if (zeta < 0.5_dp) then ! theta / 2 = pi / (2 R) - pi (1 - w) / (2 R): its quarter turns are taken off before pi comes in
      quarters = nint(mod(1d0, 2 * R) / R)
      half = pi * (mod(1d0, 2 * R) - quarters * R - zeta**2 / (1 + w)) / (2 * R)
      q = E * sin(2 * half) / w * (-1)**quarters
      cos_half = merge(sin(half), cos(half), quarters == 1) ! but for its sign
    end if
    C = merge(F**2 + 4 * E * cos_half**2, (1 + exp(-a * x)) * (1 + exp(-x / a)), zeta < 1)
    u = 2 * q / (R * C); g = merge((F * (1 + E) - 2 * zeta * q) / C, tanh(a * x / 2) - a * R * u, zeta < 1)
    if (max(1d0, zeta) * x > 4) return
    term = x * x / 6; power = term; g = 0
    ! sinh(delta)/delta - sin(theta)/theta = sum of D_k x^2k/(2k+1)!, D_{k+1} = zeta^2 D_k + (-w^2)^k: nothing cancels
    do k = 4, 80, 2
      g = g + 2 * E * delta * term / C
      power = power * (zeta - 1) * x * ((zeta + 1) * x) / (k * (k + 1))
      term = delta**2 * term / (k * (k + 1)) + power
    end do
  end subroutine
  ! Sum over modes, or of one, of psi_ji^2 times (57) as corrected, 0 < tau < pi, or its limit (71) at 0; that at pi is less.
  function demand(mode, tau) result(f) ! and a number with the sign of its slope
    integer, intent(in) :: mode
    real(dp), intent(in) :: tau
    real(dp) :: f(2), psi_j_squared(N), less_d(N), q(N), Rq_prime(N), difference(N)
    integer :: i
    psi_j_squared = merge((phi(j, :) / r)**2, 0d0, mode == 0 .or. [(i == mode, i = 1, N)])
    call free_motion(tau, R_i, zeta, less_d, q, Rq_prime, difference)
    f(1) = sum(psi_j_squared * ((1 + g) * R_i * q - u * R_i**2 * difference)) ! times sin tau, and the derivative of that
    f(2) = sum(psi_j_squared * ((1 + g) * Rq_prime + u * R_i * (2 * zeta * Rq_prime + q - R_i * sin(tau))))
    f = merge([f(1) / sin(tau), f(2) * sin(tau) - f(1) * cos(tau)], [f(2), 0d0], tau > 0)
  end function
  function motion(k, time) result(x) ! x_k by (46) and its derivative, tau = 0 at the maximum of x_j
    integer, intent(in) :: k
    real(dp), intent(in) :: time
    real(dp) :: x(2), tau, weight(N), less_d(N), q(N), Rq_prime(N), difference(N)
    complex(dp) :: Z
    tau = max(0d0, time - floor(time / pi) * pi)
    Z = W(k) * exp(cmplx(0, tau, dp))
    weight = beta * phi(k, :) * phi(j, :) / r_n**2 ! beta psi_ki psi_ji R_i^2
    call free_motion(tau, R_i, zeta, less_d, q, Rq_prime, difference)
    x(1) = real(Z) + sum(weight * (less_d - g * (1 - less_d) - u * R_i * q))
    x(2) = -aimag(Z) + sum(weight * ((1 + g) * q / R_i - u * Rq_prime))
    if (modulo(floor(time / pi), 2) == 1) x = -x ! (25)
  end function
  function size_of_x(k, tau) result(f)
    integer, intent(in) :: k
    real(dp), intent(in) :: tau
    real(dp) :: f(2)
    f = motion(k, tau)
    f = [abs(f(1)), f(1) * f(2)]
  end function
  ! [value, slope, tau] where f is largest, by steps from 0 to pi that crowd at 0, as heavy damping is quick; bisecting the slope.
  function largest(f, which, steps) result(best)
    procedure(motion) :: f
    integer, intent(in) :: which, steps
    real(dp) :: best(3), before(3), after(3), middle(3), tau, ends(2)
    integer :: i, step
    before = [f(which, 0d0), 0d0]; best = before
    do step = 1, 199 + steps
      tau = merge(1d-9 * (pi / instants / 1d-9)**(step / 200d0), pi / instants * (step - 199), step < 200)
      after = [f(which, tau), tau]; middle = after; ends = [before(3), tau]
      do i = 1, merge(60, 0, before(2) > 0 .and. .not. after(2) > 0)
        middle = [f(which, sum(ends) / 2), sum(ends) / 2]
        ends(merge(1, 2, middle(2) > 0)) = middle(3)
      end do
      if (middle(1) > best(1)) best = middle
      before = after
    end do
  end function
  function amplitude(k) result(a) ! and its lag behind the force: (38), (39), (47), or with the contact held
    integer, intent(in) :: k
    real(dp) :: a(2), most(3), x(2)
    a = [abs(X_held(k)), -atan2(aimag(X_held(k)), real(X_held(k)))]; most = 0
    if (regime == permanent_sticking) return
    if (k /= j) most = largest(size_of_x, k, instants)
    x = motion(k, most(3))
    a = [abs(x(1)), phi_j + most(3) + merge(pi, 0d0, x(1) < 0)]
  end function
  ! Contact held, (88): (K - r^2 M + i C) X = P by elimination, the unknown at the contact being the force that holds it (75).
  subroutine hold_contact
    complex(dp) :: Z(N, N + 1), row(N + 1), column(N)
    real(dp) :: M_phi(N, N)
    integer :: c, k
    M_phi = spread(gamma, 2, N) * phi; Z = 0
    Z(:, :N) = cmplx(matmul(transpose(D), spread(kappa, 2, N) * D) - merge(spread(r**2 * gamma, 2, N), 0d0, D > 0), &
      matmul(M_phi * spread(2 * zeta * r_n * r, 1, N), transpose(M_phi)), dp) ! (19)
    Z(:, j) = 0; Z(j, j) = -1; Z(l, N + 1) = 1
    do c = 1, N
      if (c == j) cycle ! the force is in row j alone
      k = c - 1 + maxloc(abs(Z(c:, c)), 1, [(k /= j, k = c, N)])
      row = Z(k, :); Z(k, :) = Z(c, :); Z(c, :) = row / row(c)
      column = Z(:, c); column(c) = 0
      Z = Z - spread(column, 2, N + 1) * spread(Z(c, :), 1, N)
    end do
    X_held = Z(:, N + 1); sticking = abs(X_held(j)) / mu; X_held(j) = 0
    rest = mu * (beta - sticking) * sum(1 / kappa(:j))
  end subroutine
  pure real(dp) function beta_lim(S) ! (69)
    real(dp), intent(in) :: S
    beta_lim = abs(V_k(j)) / hypot(U_k(j), max(S, least))
  end function
  subroutine solve_scene ! from N, j, l, mu, r, beta, gamma, kappa and zeta, all the others
    real(dp) :: largest_sum(3), bU
    complex(dp) :: W_j
    integer :: k
    call natural_modes
    R_i = r / r_n; u = R_i; g = R_i
    call damping_functions(R_i, zeta, u, g)
    V_k = [(sum(phi(k, :) * phi(l, :) / r_n**2 / cmplx((1 - R_i) * (1 + R_i), 2 * zeta * R_i, dp)), k = 1, N)] ! by (23)
    U_k = matmul(phi, phi(j, :) / r_n**2 * u); G_k = matmul(phi, phi(j, :) / r_n**2 * g)
    H_j = sum((phi(j, :) / r)**2 * (g + 2 * zeta * R_i * u)); least = H_j + mu / (gamma(j) * r**2)
    instants = 64 * ceiling(min(4096d0, 2 + 1 / minval(R_i))) ! the fastest mode turns w / (2 R) times
    largest_sum = largest(demand, 0, instants - 1); S_j = largest_sum(1)
    call hold_contact
    exact = beta_lim(S_j); approximate = abs(V_k(j)) / hypot(U_k(j), least)
    regime = merge(permanent_sticking, stick_slip, beta >= sticking)
    if (.not. beta >= exact) regime = merge(continuous, at_a_pole, beta < exact)
    bU = beta * U_k(j); W_j = cmplx(sqrt((abs(V_k(j)) - bU) * (abs(V_k(j)) + bU)), -bU, dp) ! (36), (37)
    phi_j = atan2(-bU, real(W_j)) - atan2(aimag(V_k(j)), real(V_k(j)))
    W = V_k * (W_j / V_k(j)); W(j) = W_j
  end subroutine
end module
