// SPDX-License-Identifier: MIT
#include "dynamics.h"

namespace ingot { inline namespace INGOT_ABI {

namespace {

using Twist = Spatial<scalar>;
using Load = Spatial<scalar>;

/// The six of a root that floats: its centre of mass, then its turns.
Twist unit_of_root(int direction_i) {
    const auto part = [&](int i) { return direction_i == i ? scalar(1) : scalar(0); };
    return {{part(3), part(4), part(5)}, {part(0), part(1), part(2)}};
}
Twist direction_of(const DynamicsBody& body, int i) { return body.joint == JointId{} ? unit_of_root(i) : body.s[i]; }

Spatial6<scalar> own_inertia(const DynamicsBody& body) { return {body.I, {}, {body.M, body.M, body.M, 0, 0, 0}}; }

/// What the joints give, from the loads that all bodies need; and their shares along the free directions.
void pass_loads_up(const Dynamics& of, scalar* torques) {
    for (int body_i = of.size.body_count - 1; body_i >= 0; --body_i) {  // bound: max_bodies of the figure
        const DynamicsBody& body = of.bodies[body_i];
        for (int i = 0; i < body.count; ++i) torques[body.first + i] = dot(direction_of(body, i), body.load);  // bound: 6
        if (body.parent < 0) continue;
        Load& of_parent = of.bodies[body.parent].load;
        of_parent = of_parent + impulse_from(body.load, body.d);
    }
}

void sum_inertias(const Dynamics& of) {
    if (of.size.inertias == DynamicsInertias::composite) return;
    for (int body_i = 0; body_i < of.size.body_count; ++body_i) of.bodies[body_i].inertia = own_inertia(of.bodies[body_i]);  // bound: max_bodies
    for (int body_i = of.size.body_count - 1; body_i >= 0; --body_i) {
        const DynamicsBody& body = of.bodies[body_i];
        if (body.parent < 0) continue;
        Spatial6<scalar>& of_parent = of.bodies[body.parent].inertia;
        of_parent = of_parent + inertia_from(body.inertia, body.d);
    }
    of.size.inertias = DynamicsInertias::composite;
}

/// Takes a direction out of an inertia, and out of a load that meets it. Returns 1 / D. whole: the inertia before any of the body's was taken out.
/// What they leave of a direction that is nearly one of them is rounding, of either sign: of a universal joint that was bent until its axes are one.
scalar eliminate(Spatial6<scalar>& M, const Spatial6<scalar>& whole, const Twist& s, Load& pulled) {
    pulled = M * s;
    const scalar inv_D = 1 / max(dot(s, pulled), epsilon * dot(s, whole * s));
    M = plus_square(M, pulled, -inv_D);
    return inv_D;
}

/// Inertias as they are where joints give way; of a root that floats, before its own six are taken out.
void articulate(const Dynamics& of) {
    if (of.size.inertias == DynamicsInertias::articulated) return;
    for (int body_i = 0; body_i < of.size.body_count; ++body_i) of.bodies[body_i].inertia = own_inertia(of.bodies[body_i]);  // bound: max_bodies
    for (int body_i = of.size.body_count - 1; body_i >= 0; --body_i) {
        DynamicsBody& body = of.bodies[body_i];
        if (body.joint == JointId{}) continue;
        Spatial6<scalar> M = body.inertia;
        for (int i = 0; i < body.count; ++i) body.inv_D[i] = eliminate(M, body.inertia, body.s[i], body.pulled[i]);  // bound: 3
        body.inertia = M;
        if (body.parent < 0) continue;
        Spatial6<scalar>& of_parent = of.bodies[body.parent].inertia;
        of_parent = of_parent + inertia_from(M, body.d);
    }
    of.size.inertias = DynamicsInertias::articulated;
}

}  // namespace

void direction_rates(const Dynamics& of, scalar* rates) {
    for (int body_i = 0; body_i < of.size.body_count; ++body_i) {  // bound: max_bodies of the figure
        const DynamicsBody& body = of.bodies[body_i];
        for (int i = 0; i < body.count && body.joint != JointId{}; ++i) rates[body.first + i] = body.rate[i];  // bound: 3
    }
    if (!of.size.floats) return;
    const Vector v = of.size.v, w = of.bodies[0].twist.w;
    const scalar of_root[6] = {v.x, v.y, v.z, w.x, w.y, w.z};
    for (int i = 0; i < 6; ++i) rates[i] = of_root[i];
}

void inverse_dynamics(const Dynamics& of, const scalar* accelerations, scalar* torques) {
    for (int body_i = 0; body_i < of.size.body_count; ++body_i) {  // bound: max_bodies of the figure
        DynamicsBody& body = of.bodies[body_i];
        // What it is tied to moves on as it does: at its centre of mass, where it is at rest, its twist does not change.
        Twist a = body.parent < 0 ? Twist{} : twist_at(of.bodies[body.parent].change, body.d);
        a = a + body.drift;
        for (int i = 0; i < body.count; ++i) a = a + direction_of(body, i) * accelerations[body.first + i];  // bound: 6
        body.change = a;
        const Vector w = body.twist.w, F = a.v + cross(w, body.twist.v);
        body.load = Load{body.I * a.w + cross(w, body.I * w), F * body.M - body.weight} - body.held;
    }
    pass_loads_up(of, torques);
}

void gravity_torques(const Dynamics& of, scalar* torques) {
    for (int body_i = 0; body_i < of.size.body_count; ++body_i) of.bodies[body_i].load = {{}, -of.bodies[body_i].weight};  // bound: max_bodies
    pass_loads_up(of, torques);
}

void transpose_torques(const Dynamics& of, int body_i, int up_to_i, const Vector& P, const Vector& F, const Vector& tau, scalar* torques) {
    for (int i = 0; i < of.size.direction_count; ++i) torques[i] = 0;  // bound: 3 max_bodies + 3
    Load load = impulse_from(Load{tau, F}, P - of.bodies[body_i].r);
    while (body_i != up_to_i) {  // bound: max_bodies
        const DynamicsBody& body = of.bodies[body_i];
        for (int i = 0; i < body.count; ++i) torques[body.first + i] = dot(direction_of(body, i), load);  // bound: 6
        load = impulse_from(load, body.d);
        body_i = body.parent;
    }
}

void mass_matrix(const Dynamics& of, scalar* matrix) {
    sum_inertias(of);
    const int n = of.size.direction_count;
    for (int i = 0; i < n * n; ++i) matrix[i] = 0;  // bound: the square of 3 max_bodies + 6, as long as the matrix of the user is
    for (int body_i = 0; body_i < of.size.body_count; ++body_i)  // bound: max_bodies
        for (int i = 0; i < of.bodies[body_i].count; ++i) {      // bound: 6
            const int row = of.bodies[body_i].first + i;
            Load load = of.bodies[body_i].inertia * direction_of(of.bodies[body_i], i);
            for (int on_way = body_i; on_way >= 0; on_way = of.bodies[on_way].parent) {  // bound: max_bodies
                const DynamicsBody& body = of.bodies[on_way];
                for (int k = 0; k < body.count; ++k) {  // bound: 6
                    const int column = body.first + k;
                    if (column > row) continue;  // of the same joint: its other half comes with it
                    matrix[row * n + column] = matrix[column * n + row] = dot(direction_of(body, k), load);
                }
                load = impulse_from(load, body.d);
            }
        }
}

/// With M = L^T D L, of which the passes up of articulated bodies are the factors, e^T M^-1 e is the sum of squares of D^-1/2 L^-T e.
scalar effective_inertia(const Dynamics& of, int direction_i) {
    articulate(of);
    int body_i = 0;
    while (direction_i >= of.bodies[body_i].first + of.bodies[body_i].count) ++body_i;  // bound: max_bodies
    Load P{};
    scalar sum = 0;
    bool begun = false;
    for (; body_i >= 0; body_i = of.bodies[body_i].parent) {  // bound: max_bodies
        const DynamicsBody& body = of.bodies[body_i];
        const bool is_root = body.joint == JointId{};
        Spatial6<scalar> M = body.inertia;
        for (int i = 0; i < body.count; ++i) {  // bound: 6
            const Twist s = direction_of(body, i);
            Load pulled = is_root ? Load{} : body.pulled[i];
            const scalar inv_D = is_root ? eliminate(M, body.inertia, s, pulled) : body.inv_D[i];
            const scalar t = dot(s, P) + (!begun && body.first + i == direction_i ? scalar(1) : scalar(0));
            sum += t * t * inv_D;
            P = P - pulled * (t * inv_D);
        }
        begun = true;
        P = impulse_from(P, body.d);
    }
    return 1 / sum;
}

}}  // namespace ingot::INGOT_ABI
