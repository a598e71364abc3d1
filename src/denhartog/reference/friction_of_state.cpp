#include <acb_mat.h>

#include <memory>

#include "denhartog/number/effort.hpp"
#include "denhartog/reference/friction.hpp"

namespace denhartog::reference {
namespace {

// z' = A z + b between two turns of the contact, z = (x, x'); b is the acceleration by a unit force on the contact.
struct StateMatrix {
    BallMatrix A{}, rest{}; // rest: the static displacements by that force, with velocities zero
    BallMatrix stiffness{}, damping{}, mass{};
};

StateMatrix state_matrix(const SceneInBalls& s) {
    const slong N = s.N();
    StateMatrix m{BallMatrix(2 * N, 2 * N), BallMatrix(2 * N, 1)};
    m.mass = s.M * (s.r * s.r); // (7)
    m.damping = s.C * s.r;
    m.stiffness = s.K;
    BallMatrix of_stiffness, of_damping, at_rest;
    if (!solved(m.mass, m.stiffness, of_stiffness) || !solved(m.mass, m.damping, of_damping))
        throw Unproved("the mass matrix is not proved regular");
    if (!solved(m.stiffness, s.w, at_rest)) throw Unproved("the stiffness matrix is not proved regular");
    for (slong i = 0; i < N; ++i) {
        m.A(i, N + i) = Ball(1);
        m.rest(i) = at_rest(i);
        for (slong k = 0; k < N; ++k) {
            m.A(N + i, k) = -of_stiffness(i, k);
            m.A(N + i, N + k) = -of_damping(i, k);
        }
    }
    return m;
}

// The complex amplitudes X of (K - M + i C) X = force.
std::vector<Complex<Ball>> harmonic_response(const StateMatrix& m, const BallMatrix& force) {
    const slong N = m.mass.rows();
    BallMatrix A(2 * N, 2 * N), b(2 * N, 1), X;
    for (slong i = 0; i < N; ++i) {
        b(i) = force(i);
        for (slong k = 0; k < N; ++k) {
            A(i, k) = A(N + i, N + k) = m.stiffness(i, k) - m.mass(i, k);
            A(i, N + k) = -m.damping(i, k);
            A(N + i, k) = m.damping(i, k);
        }
    }
    if (!solved(A, b, X)) throw Unproved("the load may excite a resonance without damping");
    std::vector<Complex<Ball>> out;
    for (slong i = 0; i < N; ++i) out.push_back({X(i), X(N + i)});
    return out;
}

Complex<Ball> at_contact(const SceneInBalls& s, const std::vector<Complex<Ball>>& X) {
    Complex<Ball> sum{};
    for (slong k = 0; k < s.N(); ++k)
        if (!s.w(k).is_zero()) sum = sum + s.w(k) * X[static_cast<std::size_t>(k)];
    return sum;
}

// e^(A tau) z, where z is the state `begin` at tau = 0, 2 N x 1: by Taylor's series about the middle of a stretch.
class StateInTime {
public:
    StateInTime(const BallMatrix& A, const BallMatrix& begin) : A_(A), begin_(begin), size_(norm(A)) {}

    std::vector<Series> operator()(const Ball& tau) const {
        const slong n = A_.rows();
        QuestionEffort::pay(n * n * n / 8);
        const Ball center = middle(tau), off = tau - center;
        const Ball reach = upper_bound_of(size_ * radius_of(off));
        if (!(reach < Ball(600))) throw Unproved("a mode is too fast for the state to be followed");
        BallMatrix term = exp(A_ * center) * begin_, sum = term;
        Ball left(norm(term)), enough = left; // left: (reach^k / k!) |z|, a bound of the last term taken
        arb_mul_2exp_si(enough.a, enough.a, -ball_bits);
        for (slong k = 1; !off.is_zero() && !(left < enough) && k < 10 * ball_bits; ++k) {
            term = A_ * term * (off / k);
            sum = sum + term;
            left *= reach / k;
        }
        const BallMatrix first = A_ * sum, second = A_ * first, third = A_ * second, fourth = A_ * third;
        std::vector<Series> z(static_cast<std::size_t>(n));
        // the terms after the last are at most the last times the sum of reach^n / n!
        const Ball open = off.is_zero() ? Ball(0) : left * exp(reach);
        for (slong i = 0; i < n; ++i) {
            Series& at = z[static_cast<std::size_t>(i)];
            at.c[0] = widened(sum(i), open);
            at.c[1] = widened(first(i), open * size_);
            at.c[2] = widened(second(i), open * size_ * size_) / 2;
            at.c[3] = widened(third(i), open * size_ * size_ * size_) / 6;
            at.c[4] = widened(fourth(i), open * size_ * size_ * size_ * size_) / 24;
        }
        return z;
    }

private:
    BallMatrix A_, begin_;
    Ball size_;
};

// A free motion a e^(lambda tau) of the state.
struct FreeMotionOfState {
    acb_t lambda;
    FreeMotionOfState() { acb_init(lambda); }
    FreeMotionOfState(const FreeMotionOfState& b) : FreeMotionOfState() { acb_set(lambda, b.lambda); }
    FreeMotionOfState& operator=(const FreeMotionOfState&) = delete;
    ~FreeMotionOfState() { acb_clear(lambda); }
};

Ball real_part(const acb_t z) {
    Ball r;
    arb_set(r.a, acb_realref(z));
    return r;
}
Ball imaginary_part(const acb_t z) {
    Ball r;
    arb_set(r.a, acb_imagref(z));
    return r;
}

// e^(lambda tau) and its derivatives over n!, real and imaginary parts.
std::pair<Series, Series> free_motion(const acb_t lambda, const Ball& tau) {
    acb_t z;
    acb_init(z);
    acb_mul_arb(z, lambda, tau.a, ball_bits);
    acb_exp(z, z, ball_bits);
    std::pair<Series, Series> out;
    for (slong n = 0; n < 5; ++n) {
        out.first.c[n] = real_part(z);
        out.second.c[n] = imaginary_part(z);
        acb_mul(z, z, lambda, ball_bits);
        acb_div_si(z, z, n + 1, ball_bits);
    }
    acb_clear(z);
    return out;
}

// The same over a stretch, from the middle.
std::pair<Series, Series> free_motion_over(const acb_t lambda, const Series& re, const Series& im, const Ball& tau) {
    const Ball rate = real_part(lambda), turn = imaginary_part(lambda), speed = root_of_positive(rate * rate + turn * turn);
    const Ball size = upper_bound_of(exp(larger(rate * Ball(tau.low()), rate * Ball(tau.high())))), off = tau - middle(tau);
    return {over_stretch(re, off, Ball(0), size, speed), over_stretch(im, off, Ball(0), size, speed)};
}

// The eigenvalues, right vectors and their inverse, where they are proved simple.
struct SimpleEigenvalues {
    acb_mat_t C, L, R;
    acb_ptr values;
    slong n;
    bool simple = false;

    explicit SimpleEigenvalues(const BallMatrix& A) : n(A.rows()) {
        acb_mat_init(C, n, n);
        acb_mat_init(L, n, n);
        acb_mat_init(R, n, n);
        values = _acb_vec_init(n);
        QuestionEffort::pay(n * n * n * 60);
        acb_mat_set_arb_mat(C, A.a);
        acb_mat_t guess;
        acb_mat_init(guess, n, n);
        acb_ptr near = _acb_vec_init(n);
        acb_mat_approx_eig_qr(near, nullptr, guess, C, nullptr, 0, ball_bits);
        simple = acb_mat_eig_simple(values, L, R, C, near, guess, ball_bits) != 0;
        _acb_vec_clear(near, n);
        acb_mat_clear(guess);
    }
    ~SimpleEigenvalues() {
        _acb_vec_clear(values, n);
        acb_mat_clear(C);
        acb_mat_clear(L);
        acb_mat_clear(R);
    }
    SimpleEigenvalues(const SimpleEigenvalues&) = delete;
    SimpleEigenvalues& operator=(const SimpleEigenvalues&) = delete;
};

// Factors of e^(lambda_i tau) in F of each row: -2 (row of R_i) (L_i rest) / (1 + e^(lambda_i pi)).
void add_free_motions(const SceneInBalls& s, const SimpleEigenvalues& eigen, const BallMatrix& rest, FrictionInTime& f) {
    const slong N = s.N();
    acb_t share, at, pi_lambda;
    acb_init(share);
    acb_init(at);
    acb_init(pi_lambda);
    const auto lambdas = std::make_shared<std::vector<FreeMotionOfState>>(static_cast<std::size_t>(eigen.n));
    f.constant.assign(static_cast<std::size_t>(N) + 1, Ball(0));
    f.weight.assign(static_cast<std::size_t>(N) + 1, {});
    for (slong k = 0; k < N; ++k) {
        f.constant[static_cast<std::size_t>(k)] = rest(k);
        f.constant.back() += s.w(k) * rest(k);
    }
    for (slong i = 0; i < eigen.n; ++i) {
        acb_set((*lambdas)[static_cast<std::size_t>(i)].lambda, eigen.values + i);
        acb_zero(share);
        for (slong k = 0; k < eigen.n; ++k) {
            acb_mul_arb(at, acb_mat_entry(eigen.L, i, k), rest(k).a, ball_bits);
            acb_add(share, share, at, ball_bits);
        }
        acb_mul_arb(pi_lambda, eigen.values + i, pi<Ball>().a, ball_bits);
        acb_exp(pi_lambda, pi_lambda, ball_bits);
        acb_add_si(pi_lambda, pi_lambda, 1, ball_bits);
        acb_div(share, share, pi_lambda, ball_bits);
        acb_mul_si(share, share, -2, ball_bits);
        std::vector<Ball> re, im;
        for (slong k = 0; k < N; ++k) {
            acb_mul(at, acb_mat_entry(eigen.R, k, i), share, ball_bits);
            re.push_back(real_part(at));
            im.push_back(-imaginary_part(at)); // Re(a e) = Re a Re e - Im a Im e
        }
        Ball contact_re(0), contact_im(0);
        for (slong k = 0; k < N; ++k) {
            contact_re += s.w(k) * re[static_cast<std::size_t>(k)];
            contact_im += s.w(k) * im[static_cast<std::size_t>(k)];
        }
        re.push_back(contact_re);
        im.push_back(contact_im);
        for (std::size_t row = 0; row < re.size(); ++row) {
            f.weight[row].push_back(re[row]);
            f.weight[row].push_back(im[row]);
        }
    }
    acb_clear(share);
    acb_clear(at);
    acb_clear(pi_lambda);
    using All = std::vector<Series>;
    const auto add = [](All& e, std::pair<Series, Series> motion) {
        e.push_back(std::move(motion.first));
        e.push_back(std::move(motion.second));
    };
    f.shared = std::make_shared<Remembered<All>>(
        [=](const Ball& tau) {
            QuestionEffort::pay(static_cast<long>(20 * lambdas->size()));
            All e;
            for (const FreeMotionOfState& each : *lambdas) add(e, free_motion(each.lambda, tau));
            return e;
        },
        [=](const All& in_the_middle, const Ball& tau) {
            All e;
            for (std::size_t i = 0; i < lambdas->size(); ++i)
                add(e, free_motion_over((*lambdas)[i].lambda, in_the_middle[2 * i], in_the_middle[2 * i + 1], tau));
            return e;
        });
}

// The same by the exponential of the matrix, where eigenvalues may coincide.
void add_states(const SceneInBalls& s, const StateMatrix& m, FrictionInTime& f) {
    const slong N = s.N();
    BallMatrix begin;
    const BallMatrix once = unit_matrix(2 * N) + exp(m.A * pi<Ball>());
    if (!solved(once, m.rest, begin)) throw Unproved("a free motion may mirror itself after half a period");
    begin = begin * Ball(-2);
    f.constant.assign(static_cast<std::size_t>(N) + 1, Ball(0));
    f.weight.assign(static_cast<std::size_t>(N) + 1, std::vector<Ball>(static_cast<std::size_t>(2 * N)));
    for (slong k = 0; k < N; ++k) {
        const auto row = static_cast<std::size_t>(k);
        f.constant[row] = m.rest(k);
        f.constant.back() += s.w(k) * m.rest(k);
        f.weight[row][row] = Ball(1);
        f.weight.back()[row] = s.w(k);
    }
    const StateInTime z(m.A, begin);
    f.shared =
        std::make_shared<Remembered<std::vector<Series>>>(z, [z](const std::vector<Series>&, const Ball& tau) { return z(tau); });
}

} // namespace

ResponsesInBalls responses_of_state(const SceneInBalls& s) {
    const StateMatrix m = state_matrix(s);
    ResponsesInBalls r;
    r.modal = false;
    r.V = harmonic_response(m, s.p);
    r.V.push_back(at_contact(s, r.V));
    r.Y = at_contact(s, harmonic_response(m, s.w));
    const SimpleEigenvalues eigen(m.A);
    if (eigen.simple)
        add_free_motions(s, eigen, m.rest, r.friction);
    else
        add_states(s, m, r.friction);
    const std::vector<Series>& e = (*r.friction.shared)(Ball(0));
    for (std::size_t row = 0; row < r.V.size(); ++row) {
        const Series start = r.friction.of(row, e);
        r.G.push_back(-start.rate(0));
        r.U.push_back(-start.rate(1));
        if (!(start.rate(0).finite() && start.rate(1).finite()))
            throw Unproved("a free motion may mirror itself after half a period");
    }
    r.squares = acceleration_of_contact(s);
    r.H = r.friction.of(r.contact(), e).rate(2) - r.squares;
    return r;
}

} // namespace denhartog::reference
