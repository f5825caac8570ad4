// SPDX-License-Identifier: MIT
// Figures through a batch and its substeps: joints and the contacts of their bodies are solved as one.
#pragma once

#include "../../figure/build_figures.h"
#include "../../figure/close_loops.h"
#include "../../figure/cursor.h"
#include "../../figure/factor_figures.h"
#include "../../figure/factor_loops.h"
#include "../../figure/joint_drives.h"
#include "../../figure/joint_motions.h"
#include "../../figure/joint_rows.h"
#include "../../figure/keep_figures.h"
#include "../../figure/move_figures.h"
#include "../../figure/moving_joint.h"
#include "../../figure/respond_figures.h"
#include "../../figure/target_rows.h"
#include "jointed_visits.h"
#include "swept_contacts.h"

namespace ingot { inline namespace INGOT_ABI {

/// A solver as conduct_substeps asks for it, whose bodies may have joints. Contacts: SweptContacts.
template <class Contacts, class Whole>
struct SeesJoints : Contacts {
    explicit SeesJoints(Whole& of) : Contacts(of), jointed(of.jointed) {}

    void begin(const ContactStep& step, StepReport& report) {
        build_figures(jointed.figures, this->view.loops);
        if constexpr (closes && Whole::has_joint_rows) rows().loops = &this->view.loops;
        if constexpr (Whole::has_drives) name_driven_kinds(jointed.figures, rows());
        if constexpr (closes) count(report.joints_lost, find_loops(jointed.figures, this->view.loops));
        Contacts::begin(step, report);
    }
    bool next_batch(const ContactStep& step) {
        jointed.figures.h = step.h;
        if (!Contacts::next_batch(step)) return false;
        reach_contacts(this->view);
        if constexpr (Whole::has_joint_rows) reach_rows(jointed.figures, rows());
        if constexpr (Whole::has_joint_rows) begin_joint_motions(jointed.figures, rows());
        if constexpr (Whole::has_drives) {
            // Factored as Contacts has begun the batch.
            if (place_wheels()) {
                if constexpr (closes) place_loops(jointed.figures, this->view.loops);
                factor_placed(step.h / static_cast<scalar>(this->view.substeps));
            }
            if constexpr (closes) place_free_rows(jointed.figures, this->view.loops);
            begin_drives(jointed.figures, rows());
            jointed.is_fresh = false;
        }
        return true;
    }
    void refresh(const BodyView& bodies, scalar h) {
        // What next_batch has prepared is right for the first substep.
        const bool is_first = jointed.is_fresh;
        if constexpr (Whole::has_drives) {
            place();
            prepare_drives(jointed.figures, rows(), h);
            factor_figures(jointed.figures, rows(), h);
            respond_figures(jointed.figures, jointed.responses);
            if constexpr (closes) factor_loops(jointed.figures, this->view.loops);
        } else if (!is_first) {
            factor_jointed(this->view, jointed, this->view.loops);
        }
        Contacts::refresh(bodies, h);
        // Free bodies that turn far have the inertia of the middle of the substep in the first one, too: refresh_in_solve finds that.
        if (Whole::has_drives || !is_first || this->view.some_turn) refresh_jointed_blocks(this->view, bodies, false);
        jointed.is_fresh = false;
        if constexpr (Whole::has_joint_rows) list_joint_rows(jointed.figures, rows(), h);
    }
    void solve_velocities(const ContactStep& step, scalar h, StepReport&) {
        read_velocities(this->view, jointed);
        begin_solve(jointed.figures, this->view.loops, h);
        if constexpr (closes) forget_lacks(jointed.figures, this->view.loops);
        if constexpr (Whole::has_joint_rows) aim_joint_rows(jointed.figures, rows(), h);
        if constexpr (closes) open_machines(jointed.figures, this->view.loops);
        this->sweep_passively(step.bodies, h);
        if constexpr (closes) settle_machines(step.bodies, h);
        // Again where drives turn out to be at their largest torque: figures answer contacts otherwise then.
        if constexpr (Whole::has_drives)
            for (int round = 1; round < limits::drive_rounds && saturate_drives(jointed.figures, rows()); ++round) {
                solve_driven_again(step.bodies, h);
                if constexpr (closes) settle_machines(step.bodies, h);
            }
        if constexpr (closes) end_loops(jointed.figures, this->view.loops);
        if constexpr (closes) note_targets(jointed.figures, this->view.loops);
        if constexpr (closes || Whole::has_drives) open_batch();
        this->end_velocities(step.bodies, h);
        if constexpr (Whole::has_joint_rows) note_joint_rows(jointed.figures, rows(), h);
        end_solve(jointed.figures, h);
    }
    void drift(const BodyView& bodies, scalar h) {
        Contacts::drift(bodies, h);
        drift_figures(jointed.figures, h);
        jointed.figures.elapsed += h;
        // Pushes of loops meet their figures as they are, and so do those of contacts.
        if constexpr (closes) {
            if constexpr (Whole::has_joint_rows)
                factor_undriven(h);
            else
                factor_jointed(this->view, jointed, this->view.loops);
            refresh_jointed_blocks(this->view, bodies, true);
        }
        push_figures(jointed.figures, this->view.loops, false);
        if constexpr (closes) write_velocities(this->view, jointed);  // pushes may have slowed them
        if constexpr (Whole::has_joint_rows)
            if (is_limited()) measure_joints(jointed.figures, rows(), h);
        write_displacements(this->view, jointed, bodies);
    }
    void solve_positions(const ContactStep& step, scalar h) {
        begin_displacing(jointed.figures);
        if constexpr (closes) forget_lacks(jointed.figures, this->view.loops);
        Contacts::solve_positions(step, h);
        take_cursors_away(jointed.figures, jointed.responses);
        if constexpr (closes) close_all_loops(jointed.figures, this->view.loops);
        end_displacing(jointed.figures, h);
        push_figures(jointed.figures, this->view.loops, true);
        if constexpr (Whole::has_joint_rows) push_joint_rows(jointed.figures, rows(), h, is_limited() ? scalar(0) : h);
        write_displacements(this->view, jointed, step.bodies);
    }
    void end_batch(const ContactStep& step, StepReport& report) {
        if (is_of_joints(this->view.plan)) {
            const scalar h = step.h / static_cast<scalar>(this->view.effort.substeps);
            ask_for_doublings(jointed.figures, this->view.loops, h, doublings_of(this->view.plan));
            forget_doublings();
            spread_doublings(this->view, jointed);
            if constexpr (Whole::has_joint_rows) keep_joint_motions(jointed.figures, rows(), doublings_of(this->view.plan));
            if constexpr (Whole::has_drives) keep_drives(jointed.figures, rows(), doublings_of(this->view.plan));
            keep_figures(jointed.figures, doublings_of(this->view.plan));
            if constexpr (closes) keep_loops(jointed.figures, this->view.loops, doublings_of(this->view.plan));
        }
        Contacts::end_batch(step, report);
    }

private:
    static constexpr bool closes = decltype(Whole::loops)::closes;
    JointedBodies& jointed;

    auto& rows() { return this->whole.joint_rows; }
    /// Where nothing has limits, nobody asks between drift and pushes where joints are: they are measured once, after both.
    bool is_limited() { return rows().limits != nullptr; }

    /// All islands of the batch are in it.
    void open_batch() {
        jointed.some_stand = false;
        for (int island_i = 0; island_i < this->view.island_count; ++island_i)  // bound: max_bodies
            this->view.islands[island_i].in_batch = this->view.islands[island_i].plan == this->view.plan;
    }
    /// They leave it, and some are let in again: an island is solved as it would be alone.
    void close_batch() {
        jointed.some_stand = true;
        for (int island_i = 0; island_i < this->view.island_count; ++island_i) this->view.islands[island_i].in_batch = false;
    }
    Island& island_of(Index node) const { return island_of_node(this->view, node); }
    /// Where joints are now.
    void place() {
        place_joints(jointed.figures);
        (void)place_wheels();
        if constexpr (closes) {
            place_loops(jointed.figures, this->view.loops);
            place_free_rows(jointed.figures, this->view.loops);
        }
    }
    /// Figures as they are now, with their loops; as pushes meet them.
    void factor_undriven(scalar h) {
        place();
        factor_placed(h);
    }
    /// Wheels that are nearer to the root than what they carry. True: there are some.
    bool place_wheels() { return (!closes || rows().drives_of_joint > 0) && place_carriages(jointed.figures); }
    void factor_placed(scalar h) {
        factor_figures(jointed.figures, this->view.loops, h);
        respond_figures(jointed.figures, jointed.responses);
        if constexpr (closes) factor_loops(jointed.figures, this->view.loops);
    }
    /// Again where ropes come to their ends or are let go, and where targets are drawn to with all there is.
    void settle_machines(const BodyView& bodies, scalar h) {
        // bound: see settle_rows
        for (int round = 0; settle_rows(jointed.figures, this->view.loops, round); ++round) solve_loops_again(bodies, h);
    }
    /// Of islands whose ties are not as they were.
    void solve_loops_again(const BodyView& bodies, scalar h) {
        close_batch();
        for_looped_figures(jointed.figures, this->view.loops, [&](const LoopFigure& of) {
            if (!of.is_settled) island_of(of.first_node).in_batch = true;
        });
        refresh_in_solve(this->view, bodies);
        if constexpr (Whole::has_joint_rows) {
            stand_rows();
            aim_joint_rows(jointed.figures, rows(), h);
        }
        begin_rows_again(without_belts(this->view));
        this->sweep_passively(bodies, h);
    }
    /// Of islands that have a drive which has given way.
    void solve_driven_again(const BodyView& bodies, scalar h) {
        close_batch();
        for (int i = 0; i < rows().count; ++i)  // bound: rows_of_joint max_joints
            if (rows().list[i].gave_way) island_of(node_of(rows(), rows().list[i])).in_batch = true;
        stand_rows();
        factor_figures(jointed.figures, rows(), h);
        respond_figures(jointed.figures, jointed.responses);
        if constexpr (closes) {
            reopen_machines();
            factor_open_loops(jointed.figures, this->view.loops);
        }
        refresh_in_solve(this->view, bodies);
        if constexpr (closes)
            clear_solve(jointed.figures);
        else
            begin_solve(jointed.figures, this->view.loops, h);
        aim_joint_rows(jointed.figures, rows(), h);
        begin_rows_again(without_belts(this->view));
        this->sweep_passively(bodies, h);
    }
    /// Rows of islands that are not in the batch any more.
    void stand_rows() {
        for (int i = 0; i < rows().count; ++i)  // bound: rows_of_joint max_joints
            rows().list[i].stands = !island_of(node_of(rows(), rows().list[i])).in_batch;
    }
    /// Machines of the islands that are in it are not settled.
    void reopen_machines() {
        for_looped_figures(jointed.figures, this->view.loops, [&](LoopFigure& of) {
            of.is_settled = !island_of(of.first_node).in_batch;
        });
    }
    /// Of the islands of the batch: those of the others stand.
    void forget_doublings() {
        for (int island_i = 0; island_i < this->view.island_count; ++island_i)  // bound: max_bodies
            if (this->view.islands[island_i].in_batch) jointed.doublings_of[island_i] = 0;
    }
};

} }  // namespace ingot
