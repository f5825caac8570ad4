// SPDX-License-Identifier: MIT
// Balls and bricks under gravity, friction and restitution in closed form: the motions of the tables bouncing_ball,
// brick_on_incline, sphere_on_incline and sphere_on_plane, and others like them that have no table. In long double; they share
// no code with the kernel.
#pragma once

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace ingot_reference {

/// A point that falls on z = 0 and comes back with e times its speed. Impact speeds are u e^k; for e < 1 it is at rest from
/// t_1 + 2 (u / g) e / (1 - e) on, after infinitely many impacts.
class BouncingBall {
public:
    using Real = long double;
    struct State {
        Real z, v;
    };
    struct Impact {
        Real t, speed_in, speed_out, apex_after;
    };

    /// At t = 0 it is at height h_0, m, with upward speed v_0, m/s.
    BouncingBall(Real g, Real h_0, Real v_0, Real e)
        : g_(g), h_0_(h_0), v_0_(v_0), e_(e), u_(std::sqrt(v_0 * v_0 + 2 * g * h_0)) {}

    Real t_first() const { return (v_0_ + u_) / g_; }

    Real t_rest() const {
        if (e_ >= 1) return std::numeric_limits<Real>::infinity();
        return t_first() + 2 * u_ / g_ * (e_ / (1 - e_));
    }

    /// The k-th impact, k = 1, 2, ...
    Impact impact(int k) const {
        const Real power = std::pow(e_, static_cast<Real>(k - 1));
        const Real flights = e_ < 1 ? e_ * (1 - power) / (1 - e_) : static_cast<Real>(k - 1);  // sum of e^i, i = 1 .. k - 1
        const Real out = u_ * power * e_;
        return {t_first() + 2 * u_ / g_ * flights, u_ * power, out, out * out / (2 * g_)};
    }

    State at(Real t) const {
        if (t < t_first()) return {h_0_ + (v_0_ - g_ * t / 2) * t, v_0_ - g_ * t};
        if (t >= t_rest()) return {0, 0};
        const Real since = t - t_first(), flight = 2 * u_ / g_;
        // Flights last flight * e^i: so many of them are over.
        int over = e_ < 1 ? static_cast<int>(std::log1p(-(since / flight) * (1 - e_) / e_) / std::log(e_))
                          : static_cast<int>(since / flight);
        while (over > 0 && impact(over + 1).t > t) --over;
        while (impact(over + 2).t <= t) ++over;
        const Impact last = impact(over + 1);
        const Real s = t - last.t;
        return {(last.speed_out - g_ * s / 2) * s, last.speed_out - g_ * s};
    }

private:
    Real g_, h_0_, v_0_, e_, u_;
};

/// A block that slides on an incline without tipping; s counts down the slope. Friction mu g cos(alpha) against the motion
/// until it stops; then it stays where tan(alpha) <= mu.
class BrickOnIncline {
public:
    using Real = long double;
    struct State {
        Real s, v;
    };

    BrickOnIncline(Real g, Real mu, Real sin_alpha, Real cos_alpha, Real v_0)
        : pull_(g * sin_alpha), friction_(mu * g * cos_alpha), v_0_(v_0) {}

    bool sticks() const { return pull_ <= friction_; }

    /// When it first comes to rest; infinite where it never does.
    Real t_stop() const {
        if (v_0_ == 0 && sticks()) return 0;
        const Real a = v_0_ < 0 ? pull_ + friction_ : pull_ - friction_;
        return v_0_ * a < 0 ? -v_0_ / a : std::numeric_limits<Real>::infinity();
    }

    State at(Real t) const {
        const Real a = v_0_ < 0 ? pull_ + friction_ : pull_ - friction_, stop = t_stop();
        if (t <= stop) return {(v_0_ + a * t / 2) * t, v_0_ + a * t};
        const Real s_stop = v_0_ * stop / 2;
        if (sticks()) return {s_stop, 0};
        const Real down = pull_ - friction_, later = t - stop;
        return {s_stop + down * later * later / 2, down * later};
    }

private:
    Real pull_, friction_, v_0_;
};

/// A ball of inertia k M r^2 let go on a rough incline: it rolls where tan(alpha) <= mu (1 + 1/k).
class SphereOnIncline {
public:
    using Real = long double;
    struct State {
        Real s, v, w;  ///< w: spin about the horizontal axis, rad/s
    };

    SphereOnIncline(Real g, Real mu, Real r, Real k, Real sin_alpha, Real cos_alpha)
        : rolls_(sin_alpha <= mu * (1 + 1 / k) * cos_alpha),
          a_(rolls_ ? g * sin_alpha / (1 + k) : g * (sin_alpha - mu * cos_alpha)),
          spin_(rolls_ ? a_ / r : mu * g * cos_alpha / (k * r)) {}

    bool rolls() const { return rolls_; }
    State at(Real t) const { return {a_ * t * t / 2, a_ * t, spin_ * t}; }

private:
    bool rolls_;
    Real a_, spin_;
};

/// A ball set down sliding and spinning on a rough plane. Its slip u = v + omega x (0, 0, -r) keeps its direction while
/// friction mu M g takes it away; from t_roll on it rolls.
class SphereOnPlane {
public:
    using Real = long double;
    using Vector3 = Eigen::Matrix<Real, 3, 1>;
    struct State {
        Vector3 r, v, omega;
    };

    SphereOnPlane(Real g, Real mu, Real r, Real k, const Vector3& v, const Vector3& omega)
        : friction_(mu * g), r_(r), k_(k), v_0_(v), omega_0_(omega), slip_(v + omega.cross(Vector3(0, 0, -r))) {}

    Real t_roll() const { return slip_.norm() / (friction_ * (1 + 1 / k_)); }

    State at(Real t) const {
        const Vector3 direction = slip_.norm() > 0 ? Vector3(slip_.normalized()) : Vector3(Vector3::Zero());
        const Real s = std::min(t, t_roll()), later = t - s;
        const Vector3 a = -friction_ * direction;
        const Vector3 v = v_0_ + a * s;
        // The torque of M a at (0, 0, -r), over k M r^2.
        const Vector3 omega = omega_0_ + Vector3(0, 0, -1).cross(a) * (s / (k_ * r_));
        return {(v_0_ + a * (s / 2)) * s + v * later, v, omega};
    }

private:
    Real friction_, r_, k_;
    Vector3 v_0_, omega_0_, slip_;
};

/// Balls on a line that meet two at a time: Newton's cradle, whose balls are a hair apart. Each impact keeps momentum and
/// leaves e times the speed of approach; between impacts nothing acts.
class BallsOnALine {
public:
    using Real = long double;

    /// Positions of the surfaces' gaps count: gap[i] is between ball i and i + 1.
    BallsOnALine(std::vector<Real> M, std::vector<Real> gap, std::vector<Real> v, Real e)
        : M_(std::move(M)), gap_(std::move(gap)), v_(std::move(v)), e_(e) {}

    const std::vector<Real>& v() const { return v_; }
    Real t() const { return t_; }

    /// Lets the balls go on to the next impact and through it; false where no two will ever meet again.
    bool next_impact() {
        Real soonest = std::numeric_limits<Real>::infinity();
        std::size_t meeting = 0;
        for (std::size_t i = 0; i + 1 < v_.size(); ++i) {
            const Real closing = v_[i] - v_[i + 1];
            if (closing > 0 && gap_[i] / closing < soonest) {
                soonest = gap_[i] / closing;
                meeting = i;
            }
        }
        if (std::isinf(soonest)) return false;
        for (std::size_t i = 0; i + 1 < v_.size(); ++i) gap_[i] -= soonest * (v_[i] - v_[i + 1]);
        gap_[meeting] = 0;
        t_ += soonest;
        const std::size_t a = meeting, b = meeting + 1;
        const Real j = (1 + e_) * (v_[a] - v_[b]) / (1 / M_[a] + 1 / M_[b]);
        v_[a] -= j / M_[a];
        v_[b] += j / M_[b];
        return true;
    }

private:
    std::vector<Real> M_, gap_, v_;
    Real e_, t_ = 0;
};

/// A box pushed over the ground with force F while balls ride on it: "rolling" of SimBenchmark. Its friction on the ground is
/// spent on the weight of all; every ball takes 1 / (1 + 1/k) of its mass times the acceleration of the box.
struct PushedBoxWithBalls {
    long double a_box, a_ball;  ///< m s^-2

    PushedBoxWithBalls(long double g, long double F, long double M_box, long double M_ball, int balls, long double k,
                       long double mu_ground)
        : a_box((F - mu_ground * (M_box + balls * M_ball) * g) / (M_box + balls * M_ball * k / (1 + k))),
          a_ball(a_box * k / (1 + k)) {}
};

// Thresholds of friction and balance.

/// Least mu under which a uniform plank, at an angle theta, rad, to the ground, leans on a smooth wall without slipping.
inline long double leaning_plank_mu(long double theta) { return 1 / (2 * std::tan(theta)); }

/// Least mu at the feet of two thin cards that lean on each other, each at an angle theta to the upright: card weight W, load V
/// on the ridge per card. The horizontal push is H = (W / 2 + V) tan(theta), the ground carries W + V.
inline long double leaning_cards_mu(long double theta, long double W, long double V) {
    return (W / 2 + V) * std::tan(theta) / (W + V);
}

/// A uniform thin rod that slides on its end can jam (Painleve) only where mu is above this: the least of
/// 1 + 3 cos(theta) (cos(theta) - mu sin(theta)) over theta is 5/2 - 3/2 sqrt(1 + mu^2).
inline constexpr long double painleve_rod_mu = 4.0L / 3;

}  // namespace ingot_reference
