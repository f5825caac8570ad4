// SPDX-License-Identifier: MIT
// A tyre by a slip law, for wheels without friction of their own: the ground carries them, and what grips is computed before each step.
//
// The tread is a brush: its bristles are carried along by V, the speed at which the tyre rolls, let go where it leaves the ground, and are bent on
// the way by the slip s, m/s. Their deflection z goes as z' = s - V z / L, L being the relaxation length, so that z = s L / V in a steady motion; at
// rest they are springs, and a car stands still on a slope. What they give is mu N (psi - psi^2/3 + psi^3/27), psi = |c z| / (mu L), along c z; above
// psi = 3 all of the tread slides, with mu N. c is the slope of force over load against slip, along and across.
//
// A wheel is light and its tyre stiff: r^2 c N / (I V) is 1000/s at 2 m/s, far beyond 60 steps a second. So the law is asked for the END of the step.
// What a force does to the slip is known, s_end = s - h K F, but for what others do: the engine, gravity, the other wheels. That is taken to be what
// it was in the last step, the part of s that went otherwise than was foretold. So a steady motion has no error whatever K is, and is stable for any
// K that is three quarters of the true one or more: see `tyre::Slip`.
//
// Source: Pacejka, "Tire and Vehicle Dynamics", 3.2, the brush with a parabolic load; Canudas de Wit, Tsiotras, "Dynamic tire friction models", 1999,
//         for z'; the end of the step and what is foretold are of here.
#pragma once

#include <ingot/ingot.h>

namespace scenes {

/// Of a tyre on a road.
struct TyreLaw {
    ingot::scalar mu = ingot::scalar(0.8);
    ingot::scalar along = 15, across = 12;             ///< c: of load a unit of slip
    ingot::scalar relaxation = ingot::scalar(0.3);     ///< m: L
    ingot::scalar damping_time = ingot::scalar(0.02);  ///< s, of bristles: what they give goes with z + this z'; nothing in a steady motion
};

/// What a tyre remembers between two steps, in its own axes: [0] forwards, [1] to the left.
struct Grip {
    ingot::scalar bent[2]{};      ///< m: z
    ingot::scalar slip[2]{};      ///< m/s, as the last step began
    ingot::scalar foretold[2]{};  ///< m/s, what was to be done to it by then
    bool touches = false;         ///< these are of a step that was
    bool parked = false;          ///< it stands, and friction holds it
};

namespace tyre {
using ingot::scalar;

/// Of mu N, over psi.
inline scalar share(scalar psi) { return psi < 3 ? 1 + psi * (psi / 27 - scalar(1) / 3) : 1 / psi; }

/// Where the law meets the end of the step: psi of |most_i / (1 + gain_i share(psi))| = psi. Of that the left side over psi falls, so there is one.
inline scalar meet(const scalar (&most)[2], const scalar (&gain)[2]) {
    scalar low = 0, high = ingot::sqrt(most[0] * most[0] + most[1] * most[1]);
    for (int i = 0; i < 24; ++i) {  // to the last bit but few
        const scalar middle = (low + high) / 2, of = share(middle);
        const scalar x = most[0] / (1 + gain[0] * of), y = most[1] / (1 + gain[1] * of);
        (x * x + y * y > middle * middle ? low : high) = middle;
    }
    return high;
}

/// How a tyre moves over the ground at its lowest point, forwards and to the left, and how easily that changes.
struct Slip {
    scalar now[2];       ///< m/s
    scalar driven[2];    ///< m/s, by how much the next step changes it by what is known, such as the motor
    scalar yielding[2];  ///< 1/kg, K: by how much a force changes it a second
};
/// N, on the wheel, forwards and to the left.
struct Push {
    scalar along, across;
};

/// Of the next step of h, s. load: N; V: m/s, at which it rolls.
inline Push push(const TyreLaw& law, Grip& grip, scalar load, scalar V, const Slip& slip, scalar h) {
    const scalar c[2] = {law.along, law.across}, theta = law.damping_time / h, beta = (1 + theta) / (1 + h * V / law.relaxation);
    scalar free[2], most[2], gain[2];
    for (int i = 0; i < 2; ++i) {
        const scalar others = grip.touches ? slip.now[i] - grip.slip[i] - grip.foretold[i] : 0;
        free[i] = beta * (grip.bent[i] + h * (slip.now[i] + slip.driven[i] + others)) - theta * grip.bent[i];
        most[i] = c[i] * free[i] / (law.mu * law.relaxation);
        gain[i] = beta * h * h * slip.yielding[i] * load * c[i] / law.relaxation;
    }
    const scalar psi = meet(most, gain), of = share(psi);
    const scalar kept = psi > 3 ? 3 / psi : 1;
    scalar F[2];
    for (int i = 0; i < 2; ++i) {
        const scalar z = free[i] / (1 + gain[i] * of);
        F[i] = -load * c[i] * of * z / law.relaxation;
        grip.bent[i] = (z + theta * grip.bent[i]) / (1 + theta) * kept;
        grip.slip[i] = slip.now[i];
        grip.foretold[i] = slip.driven[i] + h * slip.yielding[i] * F[i];
    }
    grip.touches = true;
    return {F[0], F[1]};
}

}  // namespace tyre
}  // namespace scenes
