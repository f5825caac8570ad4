// SPDX-License-Identifier: MIT
#include "kinematic_contacts.h"

#include "../../body/auxiliary.h"
#include "../../constraint/contact.h"
#include "../../constraint/jointed_view.h"
#include "../../constraint/kinematic_levers.h"
#include "../../constraint/kinematic_motion_at.h"

namespace ingot { inline namespace INGOT_ABI {

namespace {

template <class View>
void see_rows(const View& solver, const KinematicContact& contact) {
    see_kinematic_rows(solver, contact.position / lanes, contact.position % lanes, contact.is_A != 0);
}

SolverBody& body_of(const SolverView& solver, const KinematicContacts& kinematic, int contact_i) {
    return solver.bodies[kinematic.body_begin + contact_i];
}

}  // namespace

template <class View>
void see_kinematic_bodies(const View& solver, KinematicContacts& kinematic, const BodyView& bodies, scalar h) {
    kinematic.count = 0;
    // bound: max_manifolds, rounded up to whole blocks
    for (int position = 0; position < solver.block_count * lanes; ++position) {
        ContactBlock& block = solver.blocks[position / lanes];
        const int lane_i = position % lanes;
        const Index manifold_i = block.manifold[lane_i];
        if (is_spare(manifold_i) || (block.body_A[lane_i] != 0) == (block.body_B[lane_i] != 0)) continue;
        const bool is_A = block.body_A[lane_i] == 0;
        const BodyPair& pair = solver.pairs[manifold_i];
        const int slot = is_A ? pair.body_A : pair.body_B;
        if (!shows_kinematic_motion(bodies, slot)) continue;
        const int contact_i = kinematic.count++;
        KinematicContact& contact = kinematic.contacts[contact_i];
        contact = kinematic_contact_of(bodies, kinematic.of_slots, h, slot, r_CM_of(bodies, is_A ? pair.body_B : pair.body_A));
        contact.position = static_cast<Index>(position);
        contact.partner = is_A ? block.body_B[lane_i] : block.body_A[lane_i];
        contact.is_A = is_A ? Index(1) : Index(0);
        const Index body_i = static_cast<Index>(kinematic.body_begin + contact_i);
        (is_A ? block.body_A : block.body_B)[lane_i] = body_i;
        solver.bodies[body_i] = {};
        solver.histories[body_i] = {};
        solver.colours_of_body[body_i] = 0;
        see_rows(solver, contact);
    }
}

template <class View>
void see_kinematic_levers(const View& solver, const KinematicContacts& kinematic) {
    // Blocks of figures are refreshed in every substep, those of free bodies where something turns far.
    if (!View::articulates && !solver.some_turn) return;
    for (int contact_i = 0; contact_i < kinematic.count; ++contact_i) see_rows(solver, kinematic.contacts[contact_i]);  // bound: max_manifolds
}

void begin_kinematic_substep(const SolverView& solver, const KinematicContacts& kinematic, scalar h) {
    for (int contact_i = 0; contact_i < kinematic.count; ++contact_i) {  // bound: max_manifolds
        KinematicContact& contact = kinematic.contacts[contact_i];
        SolverBody& body = body_of(solver, kinematic, contact_i);
        SolverBodyHistory& history = solver.histories[kinematic.body_begin + contact_i];
        begin_substep(contact, three_of(solver.bodies[contact.partner].dp));
        set_three(body.v_CM, velocity_at_begin(contact, h));
        set_three(body.L, contact.omega);
        set_three(history.v_begin, three_of(body.v_CM));
        set_three(history.L_begin, contact.omega);
        set_three(history.a, acceleration_at_begin(contact));
        set_three(history.tau, contact.alpha);
    }
}

void kick_kinematic_bodies(const SolverView& solver, const KinematicContacts& kinematic, scalar h) {
    for (int contact_i = 0; contact_i < kinematic.count; ++contact_i) {
        const KinematicContact& contact = kinematic.contacts[contact_i];
        SolverBody& body = body_of(solver, kinematic, contact_i);
        set_three(body.v_CM, velocity_at_end(contact, h));
        set_three(body.L, contact.omega + contact.alpha * h);
    }
}

template <class View>
void yield_islands(const View& solver, const KinematicContacts& kinematic) {
    bool some = false;
    const auto island_of = [&solver](int position) { return solver.blocks[position / lanes].island[position % lanes]; };
    for (int contact_i = 0; contact_i < kinematic.count; ++contact_i) {
        Island& island = solver.islands[island_of(kinematic.contacts[contact_i].position)];
        if (!island.at_bound || !asks_too_much(island.residual, three_of(body_of(solver, kinematic, contact_i).v_CM), solver.unit)) continue;
        island.residual = -island.residual;  // a mark
        some = true;
    }
    // bound: max_manifolds, rounded up to whole blocks
    for (int position = 0; some && position < solver.block_count * lanes; ++position) {
        const int lane_i = position % lanes;
        if (is_spare(solver.blocks[position / lanes].manifold[lane_i]) || !(solver.islands[island_of(position)].residual < 0)) continue;
        ContactConstraint<View>::Given::for_rows(solver, position / lanes, [lane_i](const SeenRow& row) { row.j[lane_i] *= scalar(0.5); });
    }
    for (int island_i = 0; some && island_i < solver.island_count; ++island_i)  // bound: max_bodies
        solver.islands[island_i].residual = max(solver.islands[island_i].residual, -solver.islands[island_i].residual);
}

void drift_kinematic_bodies(const SolverView& solver, KinematicContacts& kinematic, scalar h) {
    for (int contact_i = 0; contact_i < kinematic.count; ++contact_i) {
        KinematicContact& contact = kinematic.contacts[contact_i];
        SolverBody& body = body_of(solver, kinematic, contact_i);
        const Vector turn = mean_spin(contact, h) * h;
        set_three(body.dp, three_of(body.dp) + end_substep(contact, h));
        ContactBlock& block = solver.blocks[contact.position / lanes];
        const int lane_i = contact.position % lanes;
        // bound: 4: block_rows
        for (int row = 0; row < block.rows; ++row) {
            const Levers& levers = block.row[row].levers;
            block.row[row].separation[lane_i] += dot(turn, lane_of(contact.is_A != 0 ? levers.k_A : levers.k_B, lane_i));
        }
    }
}

template void yield_islands(const JointedView&, const KinematicContacts&);
template void yield_islands(const LoopedView&, const KinematicContacts&);
template void yield_islands(const JointedMaterialView&, const KinematicContacts&);
template void yield_islands(const LoopedMaterialView&, const KinematicContacts&);
template void see_kinematic_levers(const JointedView&, const KinematicContacts&);
template void see_kinematic_levers(const LoopedView&, const KinematicContacts&);
template void see_kinematic_bodies(const JointedView&, KinematicContacts&, const BodyView&, scalar);
template void see_kinematic_bodies(const LoopedView&, KinematicContacts&, const BodyView&, scalar);
template void see_kinematic_levers(const JointedMaterialView&, const KinematicContacts&);
template void see_kinematic_levers(const LoopedMaterialView&, const KinematicContacts&);
template void see_kinematic_bodies(const JointedMaterialView&, KinematicContacts&, const BodyView&, scalar);
template void see_kinematic_bodies(const LoopedMaterialView&, KinematicContacts&, const BodyView&, scalar);
// The linker takes the one that the scene calls.
template void yield_islands(const SolverView&, const KinematicContacts&);
template void yield_islands(const BallView&, const KinematicContacts&);
template void yield_islands(const RollingView&, const KinematicContacts&);
template void yield_islands(const BeltView&, const KinematicContacts&);
template void yield_islands(const RollingBeltView&, const KinematicContacts&);
template void see_kinematic_levers(const SolverView&, const KinematicContacts&);
template void see_kinematic_bodies(const SolverView&, KinematicContacts&, const BodyView&, scalar);
template void see_kinematic_levers(const BallView&, const KinematicContacts&);
template void see_kinematic_bodies(const BallView&, KinematicContacts&, const BodyView&, scalar);
template void see_kinematic_levers(const RollingView&, const KinematicContacts&);
template void see_kinematic_bodies(const RollingView&, KinematicContacts&, const BodyView&, scalar);
template void see_kinematic_levers(const BeltView&, const KinematicContacts&);
template void see_kinematic_bodies(const BeltView&, KinematicContacts&, const BodyView&, scalar);
template void see_kinematic_levers(const RollingBeltView&, const KinematicContacts&);
template void see_kinematic_bodies(const RollingBeltView&, KinematicContacts&, const BodyView&, scalar);

} }  // namespace ingot
