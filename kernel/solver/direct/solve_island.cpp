// SPDX-License-Identifier: MIT
#include "solve_island.h"

#include "../../base/limits.h"
#include "factor_rows.h"
#include "impact_of_island.h"
#include "misfit.h"
#include "normal_set.h"
#include "sliding.h"

namespace ingot { inline namespace INGOT_ABI {

namespace {

/// Sets the bodies to their motion without contacts.
template <bool displaces, class Direct>
void set_free(const Direct& island) {
    // bound: max_island + 2: manifolds join at most one body more than they are; and what cannot move
    for (int body_i = 1; body_i < island.body_count; ++body_i) {
        DirectBody& body = island.bodies[body_i];
        body.linear = displaces ? DirectVector{} : in_double(island.free_motion[body.body_i].v_CM);
        body.angular = displaces ? DirectVector{} : in_double(island.free_motion[body.body_i].L);
    }
}

/// Adds up the motion that the impulses make, from the free motion on: impulses that a search added and took back have left rounding in the sums.
template <bool displaces, class Direct>
void add_up(const Direct& island) {
    set_free<displaces>(island);
    for (int manifold_i = 0; manifold_i < island.manifold_count; ++manifold_i) {  // bound: max_island of HybridIslands: larger islands are swept
        const ManifoldOf<Direct>& manifold = island.manifolds[manifold_i];
        for (int row = 0; row < Direct::row_count; ++row) {  // bound: direct_rows_of: nine, with rolling
            if (!has(manifold.rows, row)) continue;
            DirectRow& at = island.rows[manifold_i * Direct::row_count + row];
            const wide_scalar j = at.j;
            at.j = 0;
            give<displaces>(island, manifold, at, j);
        }
    }
}

/// Bodies that move freely, and what normals want.
template <class Direct>
void begin_free(const SolverView& solver, Direct& island) {
    set_free<false>(island);
    for (int manifold_i = 0; manifold_i < island.manifold_count; ++manifold_i) {
        const ManifoldOf<Direct>& manifold = island.manifolds[manifold_i];
        const ContactBlock& block = solver.blocks[manifold.position / lanes];
        for (int row = 0; row < manifold.points; ++row)  // bound: 4: block_rows
            if (has(manifold.rows, row))
                island.rows[manifold_i * Direct::row_count + row].target = static_cast<wide_scalar>(block.row[row].target[manifold.position % lanes]);
    }
}

/// First guess: what the blocks hold, within the cone.
template <class View, class Direct>
void begin_solve(const View& solver, Direct& island) {
    for (int manifold_i = 0; manifold_i < island.manifold_count; ++manifold_i) {
        ManifoldOf<Direct>& manifold = island.manifolds[manifold_i];
        DirectRow* const rows = island.rows + manifold_i * Direct::row_count;
        manifold.pulls = 0;
        wide_scalar guess[Direct::row_count] = {}, N = 0;
        for_impulses(solver, manifold, [&](int row, scalar& j, scalar&) { guess[row] = static_cast<wide_scalar>(j); });
        for (int row = 0; row < manifold.points; ++row) {
            if (!has(manifold.rows, row)) continue;
            guess[row] = max(guess[row], 0);
            N += guess[row];
        }
        for (int pair_i = 0; pair_i < Direct::pair_count; ++pair_i) {
            wide_scalar* const pair = guess + row_of_pair(pair_i);
            const PairOfImpulses t = cut({{pair[0], pair[1]}}, manifold.bound_of(pair_i) * N);
            pair[0] = t.at[0];
            pair[1] = t.at[1];
        }
        guess[torsion_row] = clamp(guess[torsion_row], manifold.mu * manifold.radius * N);
        for (int row = 0; row < Direct::row_count; ++row) {
            if (!has(manifold.rows, row)) continue;
            rows[row].j = 0;
            give<false>(island, manifold, rows[row], guess[row]);
        }
    }
}

/// Takes friction, torsion or rolling resistance out or in. What carries nothing gives nothing.
template <class Direct>
void set_friction(const Direct& island, ManifoldOf<Direct>& manifold, DirectRow* rows, int first, int end, bool loaded,
                  bool slides) {
    for (int row = first; row < end; ++row) {  // bound: Direct::row_count
        set_bit(manifold.active, row, loaded);
        set_bit(manifold.sliding, row, loaded && slides);
        if (!loaded && rows[row].j != 0) give<false>(island, manifold, rows[row], -rows[row].j);
    }
}

/// Tells by the impulses whether friction, torsion and rolling resistance stick: an impulse on its cone slides.
template <class Direct>
void stick_or_slide(const Direct& island, ManifoldOf<Direct>& manifold, DirectRow* rows) {
    const wide_scalar N = load_of(manifold, rows), nearly = 1 - 1e-5;
    const bool loaded = active_normals(manifold) != 0;
    for (int pair_i = 0; pair_i < Direct::pair_count; ++pair_i) {
        const int first = row_of_pair(pair_i);
        if (!has(manifold.rows, first)) continue;
        const DirectRow* const t = rows + first;
        const wide_scalar length = square_root(t[0].j * t[0].j + t[1].j * t[1].j), limit = manifold.bound_of(pair_i) * N;
        set_friction(island, manifold, rows, first, first + 2, loaded, limit > 0 && length >= limit * nearly);
    }
    if (has(manifold.rows, torsion_row)) {
        const wide_scalar torsion_limit = manifold.mu * N * manifold.radius;
        set_friction(island, manifold, rows, torsion_row, torsion_row + 1, loaded,
                     torsion_limit > 0 && abs(rows[torsion_row].j) >= torsion_limit * nearly);
    }
}

/// m/s, that a solve may leave.
template <class Direct>
wide_scalar settled_speed_of(const Direct& island) {
    return limits::direct_settled_speed * island.unit;
}

/// Normals that push, or that do not separate: bodies that fall together are taken for a pile.
template <class Direct>
void choose_active(Direct& island) {
    for (int manifold_i = 0; manifold_i < island.manifold_count; ++manifold_i) {
        ManifoldOf<Direct>& manifold = island.manifolds[manifold_i];
        DirectRow* const rows = island.rows + manifold_i * Direct::row_count;
        manifold.active = 0;
        manifold.sliding = 0;
        for (int row = 0; row < manifold.points; ++row)
            if (has(manifold.rows, row) && (rows[row].j > 0 || row_motion<false>(island, manifold, rows[row]) <=
                                                                   rows[row].target + settled_speed_of(island)))
                set_bit(manifold.active, row, true);
        stick_or_slide(island, manifold, rows);
        if (active_normals(manifold) > normals_max) drop_least<false>(island, manifold, rows);
    }
}

/// What is left of the equation of an active row, m/s or m.
template <bool displaces, class Direct>
wide_scalar left_of(const Direct& island, int row_i) {
    const int row = row_i % Direct::row_count;
    const ManifoldOf<Direct>& manifold = island.manifolds[row_i / Direct::row_count];
    const DirectRow* const rows = island.rows + (row_i - row);
    if (displaces || !has(manifold.sliding, row)) return rows[row].target - row_motion<displaces>(island, manifold, rows[row]);
    const wide_scalar N = load_of(manifold, rows);
    if (row == torsion_row)
        return rows[row].K * (projected_torsion(island, manifold, rows, manifold.mu * N * manifold.radius) - rows[row].j);
    const int pair_i = row < torsion_row ? 0 : 1, first = row_of_pair(pair_i);
    const DirectRow* const pair = rows + first;
    return pair_compliance(pair) * (projected_pair(island, manifold, pair, manifold.bound_of(pair_i) * N).at[row - first] - rows[row].j);
}

/// Solves the equations of the active rows, by refinement: each pass takes the residuals from the motion of the bodies. Where something slides the
/// equations are not linear: then there are few passes, and the matrix is made anew. Returns the residual.
template <bool displaces, class Direct>
wide_scalar solve_active(const Direct& island, wide_scalar settled) {
    const int passes = island.some_slide ? limits::direct_refinements_of_sliding : limits::direct_refinements_max;
    // bound: limits::direct_refinements_max: left at pass_i == passes, which is that or less
    for (int pass_i = 0;; ++pass_i) {
        wide_scalar worst = 0;
        // bound: 6 max_island: three normals, two of friction and a twist of each manifold
        for (int i = 0; i < island.active_count; ++i) {
            DirectActive& active = island.active[i];
            active.x = left_of<displaces>(island, active.row);
            if (active.inv_pivot != 0) worst = max(worst, abs(active.x) * length_of_row(island, active.row % Direct::row_count));
        }
        if (worst <= settled / 16 || pass_i == passes) return worst;
        solve_factored(island);
        for (int i = 0; i < island.active_count; ++i)
            give<displaces>(island, island.manifolds[island.active[i].row / Direct::row_count], island.rows[island.active[i].row],
                            island.active[i].x);
    }
}

/// Sticking friction (torsion, rolling resistance) beyond its cone begins to slide, sliding friction within it sticks again; without load there is
/// none. True if something changed.
template <class Direct>
bool change_friction(const Direct& island, ManifoldOf<Direct>& manifold, DirectRow* rows, wide_scalar settled) {
    const auto active = manifold.active, sliding = manifold.sliding;
    const bool loaded = active_normals(manifold) != 0;
    const wide_scalar N = load_of(manifold, rows);
    const auto slides = [&](int row, wide_scalar length, wide_scalar most, wide_scalar K) {
        const wide_scalar slack = settled / length_of_row(island, row);
        return has(sliding, row) ? length >= most - slack / 16 / K : length > most + slack / K;
    };
    for (int pair_i = 0; pair_i < Direct::pair_count; ++pair_i) {
        const int first = row_of_pair(pair_i);
        if (!has(manifold.rows, first)) continue;
        const DirectRow* const pair = rows + first;
        const PairOfImpulses t = has(sliding, first) ? tried_pair(island, manifold, pair) : PairOfImpulses{{pair[0].j, pair[1].j}};
        const wide_scalar length = square_root(t.at[0] * t.at[0] + t.at[1] * t.at[1]);
        set_friction(island, manifold, rows, first, first + 2, loaded, slides(first, length, manifold.bound_of(pair_i) * N, pair_compliance(pair)));
    }
    if (has(manifold.rows, torsion_row)) {
        const DirectRow& row = rows[torsion_row];
        const wide_scalar torsion =
            abs(has(sliding, torsion_row) ? row.j - row_motion<false>(island, manifold, row) / row.K : row.j);
        set_friction(island, manifold, rows, torsion_row, torsion_row + 1, loaded,
                     slides(torsion_row, torsion, manifold.mu * N * manifold.radius, row.K));
    }
    return manifold.active != active || manifold.sliding != sliding;
}

/// Corrects the set by the solution; false: it stays. Correcting all manifolds at once finds most sets in a few rounds, but may go round in circles.
/// So after half of the rounds one manifold is corrected at a time, beginning with the one that changed last.
template <bool displaces, class Direct>
bool change_active(const Direct& island, wide_scalar settled, int set_i, int& begin) {
    bool differs = false;
    for (int step_i = 0; step_i < island.manifold_count; ++step_i) {
        const int manifold_i = (begin + step_i) % island.manifold_count;
        ManifoldOf<Direct>& manifold = island.manifolds[manifold_i];
        DirectRow* const rows = island.rows + manifold_i * Direct::row_count;
        bool here = change_normals<displaces>(island, manifold, rows, settled);
        if (!displaces) here = change_friction(island, manifold, rows, settled) || here;
        differs = differs || here;
        if (!here || set_i < limits::direct_sets_max / 2) continue;
        begin = manifold_i + 1;
        break;
    }
    return differs;
}

template <class View, class Direct>
void write_back(const View& solver, const Direct& island) {
    for (int manifold_i = 0; manifold_i < island.manifold_count; ++manifold_i) {
        const DirectRow* const rows = island.rows + manifold_i * Direct::row_count;
        for_impulses(solver, island.manifolds[manifold_i], [&](int row, scalar& j, scalar& j_sweep) {
            j = j_sweep = static_cast<scalar>(row < friction_row ? max(rows[row].j, 0) : rows[row].j);
        });
    }
    for (int body_i = 1; body_i < island.body_count; ++body_i) {
        const DirectBody& body = island.bodies[body_i];
        put_scalars(solver.bodies[body.body_i].v_CM, body.linear);
        put_scalars(solver.bodies[body.body_i].L, body.angular);
    }
}

}  // namespace

template <class View, class Direct>
IslandState solve_island(const View& solver, Direct& island, scalar h, bool after_sweeps) {
    island.paid = false;
    begin_free(solver, island);
    if constexpr (sees_kinematic<View>)
        for_kinematic(solver, island, [](const auto&, DirectBody& body, const SolverBody& moving) {
            body.linear = in_double(moving.v_CM);
            body.angular = in_double(moving.L);
        });
    if (has_impact(solver, island, h)) return IslandState::left_to_sweeps;
    begin_solve(solver, island);
    const wide_scalar merit_most = after_sweeps ? misfit(island).merit : 1e30;  // a NaN, which comparisons pass by, stays in the sum
    choose_active(island);
    int begin = 0;
    for (int set_i = 0; set_i < limits::direct_sets_max; ++set_i) {
        if (set_i != 0) add_up<false>(island);
        wide_scalar left = 1;
        for (int step_i = 0; step_i < limits::direct_newton_steps_max && left > settled_speed_of(island); ++step_i) {
            if (!factor_rows(island)) return IslandState::chosen;
            left = solve_active<false>(island, settled_speed_of(island));
            if (!island.some_slide) break;
        }
        if (!change_active<false>(island, settled_speed_of(island), set_i, begin) && left <= settled_speed_of(island))
            break;
    }
    add_up<false>(island);
    // Impulses have a grain, which for the lightest is a speed: what it leaves is taken off the motion.
    if (island.steep && island.factored) (void)solve_active<false>(island, settled_speed_of(island));
    const Misfit left = misfit(island);
    const wide_scalar bound = after_sweeps ? static_cast<wide_scalar>(limits::settled_speed) * island.unit : 4 * settled_speed_of(island);
    if (!(left.worst <= bound) || !(left.merit < merit_most)) return IslandState::chosen;
    write_back(solver, island);
    Island& solved = solver.islands[island.loaded_island];
    solved.at_bound = false;  // what the sweeps left is of no account
    const wide_scalar told = static_cast<wide_scalar>(limits::unsettled_speed) * island.unit;  // less than that is none
    solved.residual = left.grain > told ? static_cast<scalar>(left.grain) : scalar(0);
    return IslandState::solved;
}

namespace {

/// The displacement that each normal is to have, by the law of the position sweep. False: no normal is off.
template <class Direct>
bool begin_placing(const SolverView& solver, Direct& island, scalar h) {
    for (int body_i = 1; body_i < island.body_count; ++body_i) {
        DirectBody& body = island.bodies[body_i];
        body.linear = in_double(solver.bodies[body.body_i].dp);
        body.angular = in_double(solver.bodies[body.body_i].dth);
    }
    bool off = false;
    const wide_scalar deepest = -static_cast<wide_scalar>(limits::push_speed_max * h * solver.unit);
    for (int manifold_i = 0; manifold_i < island.manifold_count; ++manifold_i) {
        ManifoldOf<Direct>& manifold = island.manifolds[manifold_i];
        DirectRow* const rows = island.rows + manifold_i * Direct::row_count;
        const int lane_i = manifold.position % lanes;
        const ContactBlock& block = solver.blocks[manifold.position / lanes];
        const scalar inv_M = block.inv_M_A[lane_i] + block.inv_M_B[lane_i];
        manifold.active = 0;
        manifold.sliding = 0;
        manifold.pulls = 0;
        for (int row = 0; row < manifold.points; ++row) {
            if (!has(manifold.rows, row)) continue;
            const NormalRow& contact = block.row[row];
            const wide_scalar s = static_cast<wide_scalar>(contact.separation[lane_i]) + row_motion<true>(island, manifold, rows[row]);
            const bool pressed = presses(contact.j[lane_i], inv_M, solver.unit), lands = contact.landing[lane_i] < limits::unbounded;
            const wide_scalar share = s * static_cast<wide_scalar>(limits::position_share);
            const wide_scalar wanted = lands              ? s - static_cast<wide_scalar>(contact.landing[lane_i])
                                  : pressed || s < 0 ? max(share, deepest)
                                                     : s;
            rows[row].target = -wanted;
            rows[row].j = static_cast<wide_scalar>(contact.j[lane_i]);  // for choosing three
            set_bit(manifold.pulls, row, pressed || lands);
            set_bit(manifold.active, row, pressed || lands || wanted < 0);
            off = off || (pressed || lands ? abs(wanted) : -wanted) > static_cast<wide_scalar>(limits::settled_gap) * island.unit;
        }
    }
    return off;
}

/// The largest displacement, in units of length and rad; not finite if one is not.
template <class Direct>
wide_scalar farthest(const Direct& island) {
    const wide_scalar inv_unit = 1 / island.unit;
    wide_scalar most_sq = 0, sum = 0;
    for (int body_i = 1; body_i < island.body_count; ++body_i) {
        const wide_scalar moved = length_sq(island.bodies[body_i].linear * inv_unit), turned = length_sq(island.bodies[body_i].angular);
        most_sq = max(most_sq, max(moved, turned));
        sum += moved + turned;
    }
    return sum < 1e30 ? square_root(most_sq) : sum;
}

}  // namespace

template <class View, class Direct>
bool place_island(const View& solver, Direct& island, scalar h) {
    island.paid = false;
    if constexpr (sees_kinematic<View>)
        for_kinematic(solver, island, [](const auto&, DirectBody& body, const SolverBody& moved) { body.linear = in_double(moved.dp); });
    if (!begin_placing(solver, island, h)) return true;
    set_free<true>(island);
    if constexpr (sees_kinematic<View>)
        for_kinematic(solver, island, [](const auto&, DirectBody& body, const SolverBody&) { body.linear = body.angular = {}; });
    for (int manifold_i = 0; manifold_i < island.manifold_count; ++manifold_i) {
        ManifoldOf<Direct>& manifold = island.manifolds[manifold_i];
        DirectRow* const rows = island.rows + manifold_i * Direct::row_count;
        if (active_normals(manifold) > normals_max) {
            int least = 0;
            for (int row = 1; row < manifold.points; ++row) least = rows[row].j <= rows[least].j ? row : least;
            set_bit(manifold.active, least, false);
        }
        for (int row = 0; row < Direct::row_count; ++row) rows[row].j = 0;
    }
    bool settled = false;
    int begin = 0;
    for (int set_i = 0; set_i < limits::direct_sets_max && !settled; ++set_i) {
        if (!factor_rows(island)) return false;
        (void)solve_active<true>(island, limits::direct_settled_length * island.unit);
        settled = !change_active<true>(island, limits::direct_settled_length * island.unit, set_i, begin);
    }
    add_up<true>(island);
    const wide_scalar far = farthest(island), most = static_cast<wide_scalar>(limits::push_speed_max * h);
    if (!settled || !(far < 1)) return false;
    const wide_scalar share = far > most ? most / far : 1;  // none faster than a sweep pushes it, and all of them in proportion
    for (int body_i = 1; body_i < island.body_count; ++body_i) {
        const DirectBody& body = island.bodies[body_i];
        SolverBody& moved = solver.bodies[body.body_i];
        put_scalars(moved.dp, in_double(moved.dp) + body.linear * share);
        put_scalars(moved.dth, in_double(moved.dth) + body.angular * share);
    }
    return true;
}

// The linker takes those of the scene.
template IslandState solve_island(const SolverView&, DirectView&, scalar, bool);
template IslandState solve_island(const RollingView&, RollingDirectView&, scalar, bool);
template IslandState solve_island(const BeltView&, DirectView&, scalar, bool);
template IslandState solve_island(const RollingBeltView&, RollingDirectView&, scalar, bool);
template bool place_island(const SolverView&, DirectView&, scalar);
template bool place_island(const RollingView&, RollingDirectView&, scalar);
template bool place_island(const BeltView&, DirectView&, scalar);
template bool place_island(const RollingBeltView&, RollingDirectView&, scalar);
#define INGOT_KINEMATIC(View, Direct)                                                      \
    template IslandState solve_island(const KinematicViewOf<View>&, Direct&, scalar, bool); \
    template bool place_island(const KinematicViewOf<View>&, Direct&, scalar)
INGOT_KINEMATIC(SolverView, DirectView);
INGOT_KINEMATIC(RollingView, RollingDirectView);
INGOT_KINEMATIC(BeltView, DirectView);
INGOT_KINEMATIC(RollingBeltView, RollingDirectView);
#undef INGOT_KINEMATIC

} }  // namespace ingot
