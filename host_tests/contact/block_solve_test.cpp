// SPDX-License-Identifier: MIT
// The block of four normals against brute force: all 16 sets of rows that may be out, one after another, in double.
#include <gtest/gtest.h>

#include <ingot/constraint/block_solve.h>

#include "contact/play.h"
#include "reference/random_input.h"

namespace {

using namespace ingot_contact;
using ingot::block_rows;
using ingot::lane;
using ingot::lanes;
using ingot::mask;
using ingot::Row4;
using ingot::Sym4;
using ingot_reference::RandomInput;
using Eigen::Matrix4d;
using Eigen::Vector4d;

constexpr double stiffening = 1.01;  // limits::block_diagonal

/// A manifold between two bodies, or a body and the ground, as the solver sees it.
struct Block {
    Matrix4d K = Matrix4d::Identity();          ///< compliance; 1 on the diagonal of rows without a point
    Matrix4d stiff = Matrix4d::Identity();      ///< what B is the inverse of
    Vector4d w = Vector4d::Zero(), before = Vector4d::Zero();
    int points = 4;
    bool pulls[4] = {};

    bool used(int row) const { return row < points; }
};

/// Up to four points around a middle, on a body of mass 1 and one of 1 to 100, or the ground.
Block random_block(RandomInput& random, int points) {
    Block block;
    block.points = points;
    const Eigen::Vector3d n = random.direction(), middle = random.vector(0.3);
    Eigen::Matrix<double, 3, 4> J[2];
    Matrix3d inv_I[2];
    double inv_M[2] = {1, random.integer(0, 1) == 0 ? 0 : 1 / random.real(1, 100)};
    const double size = std::exp(random.real(-3, 0));
    for (int point_i = 0; point_i < 4; ++point_i) {
        const Eigen::Vector3d at = middle + size * (Matrix3d::Identity() - n * n.transpose()) * random.vector(1);
        J[0].col(point_i) = at.cross(n);
        J[1].col(point_i) = -(at + n - random.vector(0.1)).cross(n);
    }
    for (int body_i = 0; body_i < 2; ++body_i) {
        const Matrix3d A = random.rotation();
        inv_I[body_i] = inv_M[body_i] * (A * random.moments(1).cwiseInverse().asDiagonal() * A.transpose());
    }
    Matrix4d K = (inv_M[0] + inv_M[1]) * Matrix4d::Ones();
    for (int body_i = 0; body_i < 2; ++body_i) K += J[body_i].transpose() * inv_I[body_i] * J[body_i];
    block.K.topLeftCorner(points, points) = K.topLeftCorner(points, points);
    block.stiff = block.K;
    if (points > 1)
        for (int row = 0; row < points; ++row) block.stiff(row, row) *= stiffening;
    const bool loaded = random.integer(0, 2) > 0;
    for (int row = 0; row < points; ++row) {
        block.w(row) = random.real(-1, random.integer(0, 1) == 0 ? 0.2 : 1);
        if (loaded && random.integer(0, 3) > 0) block.before(row) = random.real(0, 1);
    }
    return block;
}

/// Rounds what the kernel is given to what it keeps.
double kept(double x) { return static_cast<double>(static_cast<scalar>(x)); }
void round_to_scalar(Block& block) {
    block.K = block.K.unaryExpr([](double x) { return kept(x); });
    block.stiff = block.stiff.unaryExpr([](double x) { return kept(x); });
    block.w = block.w.unaryExpr([](double x) { return kept(x); });
    block.before = block.before.unaryExpr([](double x) { return kept(x); });
}

/// The rows of `in` solve their equations, the others are 0.
Vector4d with_rows(const Block& block, unsigned in) {
    Matrix4d M = Matrix4d::Identity();
    Vector4d rhs = Vector4d::Zero();
    const Vector4d free = block.w - block.stiff * block.before;  // w + stiff (l - before) at l = 0
    for (int row = 0; row < 4; ++row) {
        if ((in >> row & 1u) == 0) continue;
        for (int c = 0; c < 4; ++c)
            if ((in >> c & 1u) != 0) M(row, c) = block.stiff(row, c);
        rhs(row) = -free(row);
    }
    return M.fullPivLu().solve(rhs);
}

/// The solution: of all sets the one that misses the laws least.
Vector4d by_brute_force(const Block& block) {
    Vector4d best = Vector4d::Zero();
    double least_miss = 1e300;
    for (unsigned in = 0; in < 16; ++in) {
        bool allowed = true;
        for (int row = 0; row < 4; ++row)
            if (((in >> row & 1u) != 0) ? !block.used(row) : block.pulls[row] && block.used(row)) allowed = false;
        if (!allowed) continue;
        const Vector4d l = with_rows(block, in), u = block.w + block.stiff * (l - block.before);
        double miss = 0;
        for (int row = 0; row < block.points; ++row) {
            if (!block.pulls[row]) miss = std::max(miss, -l(row));
            if ((in >> row & 1u) == 0) miss = std::max(miss, -u(row));
        }
        if (miss < least_miss) {
            least_miss = miss;
            best = l;
        }
    }
    return best;
}

/// What is done where dropping the most negative leads astray: six rounds, row by row.
Vector4d by_rounds(const Block& block) {
    Vector4d l = block.before;
    for (int round_i = 0; round_i < 6; ++round_i) {
        for (int row = 0; row < block.points; ++row) {
            const double u = block.w(row) + block.K.row(row).dot(l - block.before);
            const double next = l(row) - u / block.K(row, row);
            l(row) = block.pulls[row] ? next : std::max(next, 0.0);
        }
    }
    return l;
}

/// Blocks of `lanes` problems, as the sweeps hold them.
struct Laid {
    ingot::LaneRow K[10] = {}, count = {}, cached[10] = {};
    Row4 w{}, before{};
    mask pulls[block_rows] = {};

    explicit Laid(const std::vector<Block>& blocks) {
        scalar w_of[block_rows][lanes] = {}, before_of[block_rows][lanes] = {}, pulls_of[block_rows][lanes] = {};
        for (int lane_i = 0; lane_i < lanes; ++lane_i) {
            const Block& block = blocks[static_cast<std::size_t>(lane_i)];
            const Matrix4d inverse = block.stiff.inverse();
            for (int row = 0; row < block_rows; ++row) {
                for (int c = row; c < block_rows; ++c) {
                    K[Sym4::index(row, c)][lane_i] = static_cast<scalar>(block.K(row, c));
                    const bool used = block.used(row) && block.used(c);
                    cached[Sym4::index(row, c)][lane_i] = used ? static_cast<scalar>(inverse(row, c)) : 0;
                }
                if (block.used(row)) count[lane_i] += 1;
                w_of[row][lane_i] = static_cast<scalar>(block.w(row));
                before_of[row][lane_i] = static_cast<scalar>(block.before(row));
                pulls_of[row][lane_i] = block.pulls[row] ? scalar(1) : scalar(0);
            }
        }
        for (int row = 0; row < block_rows; ++row) {
            w.at[row] = ingot::load(w_of[row]);
            before.at[row] = ingot::load(before_of[row]);
            pulls[row] = ingot::load(pulls_of[row]) > lane{};
        }
    }

    Vector4d solved(const Row4& l, int lane_i) const {
        Vector4d values;
        for (int row = 0; row < block_rows; ++row) {
            scalar of_lanes[lanes];
            ingot::store(of_lanes, l.at[row]);
            values(row) = static_cast<double>(of_lanes[lane_i]);
        }
        return values;
    }
};

struct Tally {
    int exact = 0, within_slack = 0, by_rounds = 0;
};

/// l is the solution of the stiffened rows; or, where the search accepts it, a set whose rows that are out approach by no more than 1e-3 of
/// the largest w; or what six rounds come to. In no case is energy gained or a row pulled. Rows that are out may be so by the compliance as
/// it is, or as it is stiffened: the one is what bodies have, the other what rows that are in are solved with.
void expect_solved(const Block& block, const Vector4d& l, Tally& tally, const char* what) {
    const Vector4d exact = by_brute_force(block), rounds = by_rounds(block), d = l - block.before;
    const Matrix4d used = block.stiff.inverse();
    // Rounding of the inverse and of products with it: some units in the last place of what is summed.
    const Eigen::SelfAdjointEigenSolver<Matrix4d> eigen(block.stiff);
    const double condition = eigen.eigenvalues()(3) / eigen.eigenvalues()(0);
    const double size = block.before.norm() + (used.cwiseAbs() * block.w.cwiseAbs()).norm();
    const double tolerance = 16 * static_cast<double>(ingot::epsilon) * condition * size;
    for (int row = 0; row < 4; ++row) {
        if (!block.pulls[row]) {
            EXPECT_GE(l(row), 0) << what;
        }
        if (!block.used(row)) {
            EXPECT_EQ(l(row), 0) << what;
        }
    }
    const double gain = d.dot(block.w) + d.dot(block.K * d) / 2;
    EXPECT_LE(gain, tolerance * (block.w.norm() + block.K.norm() * d.norm())) << what;

    if ((l - exact).norm() <= tolerance) {
        ++tally.exact;
        return;
    }
    const Vector4d u = block.w + block.stiff * d, u_bare = block.w + block.K * d;
    bool accepted = true;
    for (int row = 0; row < block.points; ++row) {
        const bool out = l(row) == 0 && !block.pulls[row];
        const double u_tolerance = block.stiff.norm() * tolerance;
        accepted = accepted &&
                   (out ? std::max(u(row), u_bare(row)) >= -1e-3 * block.w.cwiseAbs().maxCoeff() - u_tolerance : std::abs(u(row)) <= u_tolerance);
    }
    if (accepted) {
        ++tally.within_slack;
    } else if ((l - rounds).norm() <= tolerance) {
        ++tally.by_rounds;
    } else {
        ADD_FAILURE() << what << ": l " << l.transpose() << " exact " << exact.transpose() << " rounds " << rounds.transpose() << "\nw "
                      << block.w.transpose() << " before " << block.before.transpose() << "\nK\n" << block.K << "\ntolerance " << tolerance;
    }
}

/// Problems one after another through the same block: the rows that were out are held over from one to the next.
void solve_many(int points_least, bool some_pull) {
    RandomInput random(static_cast<std::uint64_t>(points_least) * 2 + some_pull);
    Tally tally;
    const mask active = ingot::splat<lane>(1) > lane{};
    for (int problem_i = 0; problem_i < 4000 / lanes; ++problem_i) {
        std::vector<Block> blocks;
        for (int lane_i = 0; lane_i < lanes; ++lane_i) {
            blocks.push_back(random_block(random, points_least == 4 ? 4 : random.integer(points_least, 4)));
            if (some_pull)
                for (int row = 0; row < blocks.back().points; ++row) {
                    blocks.back().pulls[row] = random.integer(0, 1) == 1;
                    blocks.back().before(row) = 0;
                }
            round_to_scalar(blocks.back());
        }
        Laid laid(blocks);
        for (int visit_i = 0; visit_i < 3; ++visit_i) {
            const Row4 l = some_pull
                               ? ingot::solve_block<block_rows, false>(laid.K, laid.count, laid.cached, laid.w, laid.before, laid.pulls, 0, active)
                               : ingot::solve_block<block_rows, true>(laid.K, laid.count, laid.cached, laid.w, laid.before, laid.pulls, 0, active);
            for (int lane_i = 0; lane_i < lanes; ++lane_i)
                expect_solved(blocks[static_cast<std::size_t>(lane_i)], laid.solved(l, lane_i), tally, "block");
            if (::testing::Test::HasFailure()) return;
            // The next visit: the same bodies, other speeds, from the impulses found.
            for (int lane_i = 0; lane_i < lanes; ++lane_i) {
                Block& block = blocks[static_cast<std::size_t>(lane_i)];
                if (!some_pull) block.before = laid.solved(l, lane_i);
                for (int row = 0; row < block.points; ++row) block.w(row) = random.real(-1, 1) * (visit_i == 0 ? 1 : 0.01);
                round_to_scalar(block);
            }
            const Laid next(blocks);
            laid.w = next.w;
            laid.before = next.before;
        }
    }
    figure("exact", tally.exact);
    figure("within the slack of the search", tally.within_slack);
    figure("by rounds", tally.by_rounds);
    EXPECT_GT(tally.exact, 0);
}

TEST(BlockSolve, finds_what_brute_force_finds) { solve_many(4, false); }
TEST(BlockSolve, finds_it_with_fewer_points) { solve_many(2, false); }
TEST(BlockSolve, lets_rows_pull) { solve_many(4, true); }
TEST(BlockSolve, lets_rows_pull_with_fewer_points) { solve_many(2, true); }

/// Bodies at rest stay at rest: points that touch carry nothing, however fast others may approach because they are far off, up to 3 mm in 0.25 us.
TEST(BlockSolve, what_is_far_off_leaves_no_rounding) {
    RandomInput random(6);
    const mask active = ingot::splat<lane>(1) > lane{};
    for (int problem_i = 0; problem_i < 4000; ++problem_i) {
        std::vector<Block> blocks;
        for (int lane_i = 0; lane_i < lanes; ++lane_i) {
            Block block = random_block(random, random.integer(2, 4));
            const int touching = random.integer(1, block.points - 1);
            block.before.setZero();
            block.w.setZero();
            for (int row = touching; row < block.points; ++row) block.w(row) = std::exp(random.real(-3, 9.4));
            round_to_scalar(block);
            blocks.push_back(block);
        }
        Laid laid(blocks);
        for (int visit_i = 0; visit_i < 2; ++visit_i) {
            const Row4 l = ingot::solve_block<block_rows, true>(laid.K, laid.count, laid.cached, laid.w, laid.before, laid.pulls, 0, active);
            for (int lane_i = 0; lane_i < lanes; ++lane_i) ASSERT_EQ(laid.solved(l, lane_i), Vector4d(Vector4d::Zero()));
        }
    }
}

/// One row has a closed form: max(0, before - w / K).
TEST(BlockSolve, of_one_row_is_a_projection) {
    RandomInput random(1);
    const mask active = ingot::splat<lane>(1) > lane{};
    for (int problem_i = 0; problem_i < 1000; ++problem_i) {
        std::vector<Block> blocks;
        for (int lane_i = 0; lane_i < lanes; ++lane_i) {
            blocks.push_back(random_block(random, 1));
            round_to_scalar(blocks.back());
        }
        Laid laid(blocks);
        const Row4 l = ingot::solve_block<1, true>(laid.K, laid.count, laid.cached, laid.w, laid.before, laid.pulls, 0, active);
        for (int lane_i = 0; lane_i < lanes; ++lane_i) {
            const Block& block = blocks[static_cast<std::size_t>(lane_i)];
            const double exact = std::max(0.0, block.before(0) - block.w(0) / block.K(0, 0));
            EXPECT_NEAR(laid.solved(l, lane_i)(0), exact,
                        4 * static_cast<double>(ingot::epsilon) * (block.before(0) + std::abs(block.w(0) / block.K(0, 0))));
        }
    }
}

}  // namespace
