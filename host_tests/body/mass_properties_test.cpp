// SPDX-License-Identifier: MIT
// Mass, centre of mass and inertia against tables of 32 digits, and the laws that tie solids to each other.
//
// Tolerances count roundings, u = epsilon / 2 each: gamma(n) is what n of them in a row can reach, relative to the sum of the
// magnitudes of the terms. Inertia is compared relative to `extent`, which bounds those terms.
#include <ingot/body/check_body.h>
#include <ingot/body/mass_properties.h>

#include <gtest/gtest.h>

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <string>
#include <vector>

#include "reference/csv_table.h"
#include "reference/kernel_types.h"
#include "reference/measure.h"
#include "reference/random_input.h"

namespace {

using ingot::MassDistribution;
using ingot::MassProperties;
using ingot::Matrix;
using ingot::MeshTriangle;
using ingot::Result;
using ingot::scalar;
using ingot::Status;
using ingot::SymmetricMatrix;
using ingot::Vector;
using ingot_reference::CsvTable;
using ingot_reference::RandomInput;
using ingot_reference::to_eigen;
using ingot_reference::to_matrix;
using ingot_reference::to_vector;
using ingot_reference::ulps_off;
using Real = long double;
using Matrix3 = Eigen::Matrix<Real, 3, 3>;
using Vector3 = Eigen::Matrix<Real, 3, 1>;

constexpr scalar nan = std::numeric_limits<scalar>::quiet_NaN();
constexpr scalar infinity = std::numeric_limits<scalar>::infinity();
constexpr Matrix upright = ingot::identity_matrix<scalar>();

Real gamma(int roundings) { return ingot_reference::gamma<scalar>(roundings); }

scalar cast(double x) { return static_cast<scalar>(x); }

/// Bounds every term of the tensor of a solid seen from a point, and of its moves to and from the origin.
Real extent(const MassDistribution& solid, const Vector& point = {}) {
    const Real reach = to_eigen<Real>(solid.r_CM).norm() + to_eigen<Real>(point).norm();
    return to_eigen<Real>(solid.I).trace() + static_cast<Real>(solid.M) * reach * reach;
}

Real difference(const SymmetricMatrix& a, const SymmetricMatrix& b) {
    return (to_eigen<Real>(a) - to_eigen<Real>(b)).cwiseAbs().maxCoeff();
}

/// The two are the same solid but for roundings, relative to the extent of what they are made from.
void expect_same(const MassDistribution& a, const MassDistribution& b, Real size, int roundings, const std::string& what) {
    const Real M = static_cast<Real>(a.M);
    EXPECT_LE(std::abs(static_cast<Real>(b.M) - M), gamma(roundings) * M) << what;
    // r_CM is a mean of places within sqrt(extent / M).
    EXPECT_LE((to_eigen<Real>(a.r_CM) - to_eigen<Real>(b.r_CM)).cwiseAbs().maxCoeff(), gamma(roundings) * std::sqrt(size / M))
        << what;
    EXPECT_LE(difference(a.I, b.I), gamma(roundings) * size) << what;
}

MassDistribution random_primitive(RandomInput& random) {
    const auto size = [&] { return cast(random.real(0.25, 2)); };
    const scalar density = cast(random.real(0.1, 10)), a = size(), b = size(), c = size();
    switch (random.integer(0, 6)) {
        case 0: return ingot::solid_sphere(density, a);
        case 1: return ingot::solid_box(density, {a, b, c});
        case 2: return ingot::solid_cylinder(density, a, b);
        case 3: return ingot::solid_capsule(density, a, b);
        case 4: return ingot::solid_cone(density, a, b);
        case 5: return ingot::solid_ellipsoid(density, {a, b, c});
        default: return ingot::solid_hemisphere(density, a);
    }
}

MassDistribution random_part(RandomInput& random) {
    const MassDistribution solid = random_primitive(random);
    const Matrix A = to_matrix(random.rotation());
    return ingot::placed(solid, A, to_vector(random.vector(4)));
}

constexpr int many = 2000;

// ---------------------------------------------------------------------------------------------------------------- primitives

MassDistribution primitive(const CsvTable& table, std::size_t row) {
    const auto p = [&](const char* column) { return table.number<scalar>(row, column); };
    const std::string& shape = table.text(row, "shape");
    if (shape == "sphere") return ingot::solid_sphere(1, p("p1"));
    if (shape == "box") return ingot::solid_box(1, {p("p1"), p("p2"), p("p3")});
    if (shape == "cylinder") return ingot::solid_cylinder(1, p("p1"), p("p2"));
    if (shape == "capsule") return ingot::solid_capsule(1, p("p1"), p("p2"));
    if (shape == "cone") return ingot::solid_cone(1, p("p1"), p("p2"));
    if (shape == "ellipsoid") return ingot::solid_ellipsoid(1, {p("p1"), p("p2"), p("p3")});
    if (shape == "hemisphere") return ingot::solid_hemisphere(1, p("p1"));
    ADD_FAILURE() << "no function for a " << shape;
    return {};
}

TEST(Primitives, agree_with_the_table_within_4_ulps) {
    const CsvTable table("inertia_primitives.csv");
    ASSERT_EQ(table.row_count(), 14u);
    Real worst = 0;
    for (std::size_t row = 0; row < table.row_count(); ++row) {
        const MassDistribution solid = primitive(table, row);
        const auto expect_close = [&](scalar computed, const char* column) {
            const Real ulps = ulps_off<scalar>(computed, table.number<Real>(row, column));
            EXPECT_LE(ulps, 4) << table.text(row, "shape") << " in row " << row << ", " << column;
            worst = std::max(worst, ulps);
        };
        expect_close(solid.M, "mass_at_density_1");
        expect_close(solid.r_CM.z, "com_z");
        expect_close(solid.I.xx, "I1");
        expect_close(solid.I.yy, "I2");
        expect_close(solid.I.zz, "I3");
        EXPECT_EQ(Eigen::Vector2d(to_eigen(solid.r_CM).head(2)), Eigen::Vector2d::Zero());
        EXPECT_TRUE(to_eigen(solid.I).isDiagonal(0));
    }
    RecordProperty("worst_ulps", std::to_string(static_cast<double>(worst)));
}

/// The formulas of reference/README.md in long double: mass, height of the centre of mass, moments.
struct Exact {
    Real M, z, I_x, I_y, I_z;
};

void expect_exact(const MassDistribution& solid, const Exact& exact, const char* shape) {
    // The capsule's I_x takes the most roundings: 6 for the mass of its ends, 4 for the squares, 3 to join them.
    const auto expect_close = [&](scalar computed, Real value) {
        EXPECT_LE(std::abs(computed - value), gamma(13) * value) << shape;
    };
    expect_close(solid.M, exact.M);
    expect_close(solid.r_CM.z, exact.z);
    expect_close(solid.I.xx, exact.I_x);
    expect_close(solid.I.yy, exact.I_y);
    expect_close(solid.I.zz, exact.I_z);
}

TEST(Primitives, of_any_size_are_their_formulas_within_13_roundings) {
    constexpr Real pi = 3.14159265358979323846264338327950288L;
    RandomInput random(21);
    for (int i = 0; i < many; ++i) {
        const scalar density = cast(random.real(0.1, 10000)), p = cast(std::abs(random.of_any_size(-10, 10))),
                     q = cast(std::abs(random.of_any_size(-10, 10))), s = cast(std::abs(random.of_any_size(-10, 10)));
        const Real d = density, r = p, h = q, c = s;
        const Real ball = d * 4 * pi * r * r * r / 3, tube = d * pi * r * r * 2 * h, cone = tube / 6;
        const Real brick = d * 8 * r * h * c, egg = d * 4 * pi * r * h * c / 3;
        const Real tube_x = tube * (r * r / 4 + h * h / 3), cone_x = 3 * cone * (r * r / 20 + h * h / 80);
        const Real capsule_x = tube_x + ball * (2 * r * r / 5 + h * h + 3 * h * r / 4);
        expect_exact(ingot::solid_sphere(density, p), {ball, 0, 0.4L * ball * r * r, 0.4L * ball * r * r, 0.4L * ball * r * r},
                     "sphere");
        expect_exact(ingot::solid_box(density, {p, q, s}),
                     {brick, 0, brick * (h * h + c * c) / 3, brick * (r * r + c * c) / 3, brick * (r * r + h * h) / 3}, "box");
        expect_exact(ingot::solid_cylinder(density, p, q), {tube, 0, tube_x, tube_x, tube * r * r / 2}, "cylinder");
        expect_exact(ingot::solid_capsule(density, p, q),
                     {tube + ball, 0, capsule_x, capsule_x, tube * r * r / 2 + 0.4L * ball * r * r}, "capsule");
        expect_exact(ingot::solid_cone(density, p, q), {cone, h / 4, cone_x, cone_x, 0.3L * cone * r * r}, "cone");
        expect_exact(ingot::solid_ellipsoid(density, {p, q, s}),
                     {egg, 0, egg * (h * h + c * c) / 5, egg * (r * r + c * c) / 5, egg * (r * r + h * h) / 5}, "ellipsoid");
        expect_exact(ingot::solid_hemisphere(density, p),
                     {ball / 2, 3 * r / 8, 83 * ball * r * r / 640, 83 * ball * r * r / 640, 0.2L * ball * r * r},
                     "hemisphere");
    }
}

TEST(Primitives, scale_with_density_and_size_to_the_bit_by_powers_of_two) {
    const CsvTable table("inertia_primitives.csv");
    for (std::size_t row = 0; row < table.row_count(); ++row) {
        const std::string& shape = table.text(row, "shape");
        if (shape != "box" && shape != "ellipsoid") continue;
        const auto p = [&](const char* column) { return table.number<scalar>(row, column); };
        const Vector small = {p("p1"), p("p2"), p("p3")}, large = small * scalar(8);
        const auto solid = [&](scalar density, const Vector& size) {
            return shape == "box" ? ingot::solid_box(density, size) : ingot::solid_ellipsoid(density, size);
        };
        EXPECT_EQ(solid(4, large).M, 4 * 512 * solid(1, small).M);
        EXPECT_EQ(solid(4, large).I.xx, 4 * 32768 * solid(1, small).I.xx);
    }
}

TEST(Primitives, ellipsoid_of_equal_axes_is_the_sphere) {
    RandomInput random(1);
    for (int i = 0; i < many; ++i) {
        const scalar r = cast(random.real(0.01, 100)), density = cast(random.real(0.1, 10));
        const MassDistribution sphere = ingot::solid_sphere(density, r);
        expect_same(ingot::solid_ellipsoid(density, {r, r, r}), sphere, extent(sphere), 16, "8 products each");
    }
}

TEST(Primitives, two_hemispheres_make_the_sphere) {
    RandomInput random(2);
    constexpr Matrix upside_down = {{1, 0, 0}, {0, -1, 0}, {0, 0, -1}};
    for (int i = 0; i < many; ++i) {
        const scalar r = cast(random.real(0.01, 100)), density = cast(random.real(0.1, 10));
        const MassDistribution half = ingot::solid_hemisphere(density, r), sphere = ingot::solid_sphere(density, r);
        const MassDistribution whole = ingot::combined(half, ingot::placed(half, upside_down, {}));
        expect_same(whole, sphere, extent(sphere), 32, "9 products a solid, 10 roundings to join them");
    }
}

TEST(Primitives, cylinder_and_two_hemispheres_make_the_capsule) {
    RandomInput random(3);
    constexpr Matrix upside_down = {{1, 0, 0}, {0, -1, 0}, {0, 0, -1}};
    for (int i = 0; i < many; ++i) {
        const scalar r = cast(random.real(0.01, 10)), h = cast(random.real(0.01, 10)), density = cast(random.real(0.1, 10));
        const MassDistribution cap = ingot::solid_hemisphere(density, r);
        const MassDistribution ends =
            ingot::combined(ingot::placed(cap, upright, {0, 0, h}), ingot::placed(cap, upside_down, {0, 0, -h}));
        const MassDistribution capsule = ingot::solid_capsule(density, r, h);
        expect_same(ingot::combined(ingot::solid_cylinder(density, r, h), ends), capsule, extent(capsule), 48,
                    "9 products a solid, 10 roundings for each of two joints, 12 of the capsule");
    }
}

TEST(Primitives, capsule_without_a_straight_part_is_the_sphere) {
    const MassDistribution sphere = ingot::solid_sphere(3, scalar(0.7)), capsule = ingot::solid_capsule(3, scalar(0.7), 0);
    expect_same(capsule, sphere, extent(sphere), 16, "8 products each");
}

// ---------------------------------------------------------------------------------------------------------------- polyhedra

struct Mesh {
    std::vector<Vector> vertices;
    std::vector<MeshTriangle> triangles;

    Result<MassDistribution> solid(scalar density = 1) const {
        return ingot::solid_mesh(density, vertices.data(), static_cast<int>(vertices.size()), triangles.data(),
                                 static_cast<int>(triangles.size()));
    }
    Mesh moved(const Vector& by) const {
        Mesh mesh = *this;
        for (Vector& v : mesh.vertices) v += by;
        return mesh;
    }
    Mesh inside_out() const {
        Mesh mesh = *this;
        for (MeshTriangle& t : mesh.triangles) std::swap(t.b, t.c);
        return mesh;
    }
    Mesh with(const Mesh& other) const {
        Mesh mesh = *this;
        const int first = static_cast<int>(vertices.size());
        mesh.vertices.insert(mesh.vertices.end(), other.vertices.begin(), other.vertices.end());
        for (const MeshTriangle& t : other.triangles) mesh.triangles.push_back({t.a + first, t.b + first, t.c + first});
        return mesh;
    }
};

Mesh polyhedron(const std::string& name) {
    static const CsvTable table("inertia_polyhedra_geometry.csv");
    Mesh mesh;
    for (std::size_t row : table.rows_with("name", name)) {
        const std::vector<double> e = table.numbers(row, {"a", "b", "c"});
        if (table.text(row, "kind") == "v") mesh.vertices.push_back({cast(e[0]), cast(e[1]), cast(e[2])});
        else mesh.triangles.push_back({static_cast<int>(e[0]), static_cast<int>(e[1]), static_cast<int>(e[2])});
    }
    return mesh;
}

std::vector<std::string> polyhedra() {
    static const CsvTable table("inertia_polyhedra.csv");
    std::vector<std::string> names;
    for (std::size_t row = 0; row < table.row_count(); ++row) names.push_back(table.text(row, "name"));
    return names;
}

/// What rounding may do to the tensor of a mesh. A pyramid's volume is a product of three edges whose rounding is relative to
/// their lengths (8 u), its second moments add 6, the sum of n pyramids n, the factors 3 more.
struct MeshBounds {
    Real M, r_CM, I;
};
MeshBounds bounds_of(const Mesh& mesh, const Vector3& centre) {
    const auto vertex = [&](int index) { return to_eigen<Real>(mesh.vertices[static_cast<std::size_t>(index)]); };
    Real volume = 0, first = 0, second = 0;
    for (const MeshTriangle& t : mesh.triangles) {
        const Vector3 A = vertex(t.a), B = vertex(t.b), C = vertex(t.c);
        Real edges[3] = {(B - A).lpNorm<1>(), (C - B).lpNorm<1>(), (A - C).lpNorm<1>()};
        std::sort(edges, edges + 3);
        const Vector3 corners[3] = {A - centre, B - centre, C - centre};
        const Real size = corners[0].lpNorm<1>() * edges[0] * edges[1];
        const Real reach = std::max({corners[0].norm(), corners[1].norm(), corners[2].norm()});
        const Vector3 sum = corners[0] + corners[1] + corners[2];
        volume += size / 6;
        first += size / 24 * sum.norm();
        second += size / 120 * (3 * reach * reach + sum.squaredNorm());
    }
    const int roundings = 17 + static_cast<int>(mesh.triangles.size());
    return {gamma(roundings) * volume, gamma(roundings) * first, gamma(roundings) * second};
}

TEST(Meshes, of_the_table_agree_with_it) {
    const CsvTable table("inertia_polyhedra.csv");
    Real worst = 0;
    for (std::size_t row = 0; row < table.row_count(); ++row) {
        const std::string& name = table.text(row, "name");
        const auto exact = [&](const char* column) { return table.number<Real>(row, column); };
        const Mesh mesh = polyhedron(name);
        const Result<MassDistribution> solid = mesh.solid();
        ASSERT_EQ(solid.status, Status::ok) << name;

        Matrix3 I;
        I << exact("Ixx"), exact("Ixy"), exact("Ixz"), exact("Ixy"), exact("Iyy"), exact("Iyz"), exact("Ixz"), exact("Iyz"),
            exact("Izz");
        const Vector3 centre(exact("cx"), exact("cy"), exact("cz"));
        const MeshBounds bounds = bounds_of(mesh, centre);
        const Real largest = I.cwiseAbs().maxCoeff(), error = (to_eigen<Real>(solid.value.I) - I).cwiseAbs().maxCoeff();
        EXPECT_LE(error, bounds.I) << name;
        if constexpr (sizeof(scalar) == sizeof(double)) {
            EXPECT_LE(error / largest, 1e-12L) << name;
        }
        EXPECT_LE(std::abs(static_cast<Real>(solid.value.M) - exact("vol")), bounds.M) << name;
        // The centre is found from a vertex: the bound from there, and the rounding of the place itself.
        const MeshBounds from_vertex = bounds_of(mesh, to_eigen<Real>(mesh.vertices[0]));
        const Real r_bound = from_vertex.r_CM / exact("vol") + gamma(1) * centre.cwiseAbs().maxCoeff();
        EXPECT_LE((to_eigen<Real>(solid.value.r_CM) - centre).cwiseAbs().maxCoeff(), r_bound) << name;
        worst = std::max(worst, error / largest);
        RecordProperty(name + "_error_of_largest", std::to_string(static_cast<double>(error / largest / gamma(1))) + " u");
    }
    RecordProperty("worst_error_of_largest_in_u", std::to_string(static_cast<double>(worst / gamma(1))));
}

TEST(Meshes, far_from_the_origin_have_the_tensor_they_have_there_to_the_bit) {
    // Vertices on a grid that a shift of 2^16 keeps exact in float.
    RandomInput random(4);
    for (const std::string& name : polyhedra()) {
        if (name == "tetra_sliver") continue;  // 1000 across: its grid would be too fine for float
        const Mesh mesh = polyhedron(name);
        const Vector by = {65536, -32768, 49152};
        const MassDistribution near = mesh.solid().value, far = mesh.moved(by).solid().value;
        EXPECT_EQ(near.M, far.M) << name;
        EXPECT_EQ(to_eigen(near.I), to_eigen(far.I)) << name;
        const Vector3 shift = to_eigen<Real>(far.r_CM) - to_eigen<Real>(by) - to_eigen<Real>(near.r_CM);
        EXPECT_LE(shift.cwiseAbs().maxCoeff(), gamma(1) * 65536 + gamma(1) * 10) << name;
    }
}

TEST(Meshes, of_four_triangles_are_the_tetrahedron_in_any_order) {
    for (const std::string& name : polyhedra()) {
        const Mesh mesh = polyhedron(name);
        if (mesh.vertices.size() != 4) continue;
        const MassDistribution solid = mesh.solid(2).value;
        const MeshBounds bounds = bounds_of(mesh, to_eigen<Real>(solid.r_CM));
        int order[4] = {0, 1, 2, 3};
        do {
            const auto corner = [&](int i) { return mesh.vertices[static_cast<std::size_t>(order[i])]; };
            const MassDistribution tetrahedron = ingot::solid_tetrahedron(2, corner(0), corner(1), corner(2), corner(3));
            // The tetrahedron's volume is the product of any three edges: up to three times the terms of the mesh's.
            EXPECT_LE(difference(tetrahedron.I, solid.I), 2 * 4 * bounds.I) << name;
            EXPECT_LE(std::abs(static_cast<Real>(tetrahedron.M - solid.M)), 2 * 4 * bounds.M) << name;
        } while (std::next_permutation(order, order + 4));
    }
}

TEST(Meshes, box_of_tetrahedra_has_the_inertia_of_the_box) {
    RandomInput random(5);
    for (int i = 0; i < many; ++i) {
        const Vector half = {cast(random.real(0.1, 10)), cast(random.real(0.1, 10)), cast(random.real(0.1, 10))};
        const scalar density = cast(random.real(0.1, 10));
        // Kuhn: one tetrahedron for each order in which the edges lead from one corner to the opposite one.
        MassDistribution whole{};
        int order[3] = {0, 1, 2};
        do {
            Vector corners[4] = {-half, -half, -half, half};
            scalar* const second[3] = {&corners[1].x, &corners[1].y, &corners[1].z};
            scalar* const third[3] = {&corners[2].x, &corners[2].y, &corners[2].z};
            const scalar top[3] = {half.x, half.y, half.z};
            *second[order[0]] = *third[order[0]] = top[order[0]];
            *third[order[1]] = top[order[1]];
            whole = ingot::combined(whole, ingot::solid_tetrahedron(density, corners[0], corners[1], corners[2], corners[3]));
        } while (std::next_permutation(order, order + 3));
        const MassDistribution box = ingot::solid_box(density, half);
        expect_same(whole, box, 3 * extent(box), 80,
                    "20 roundings a tetrahedron, 10 for each of 6 joints; a tetrahedron reaches sqrt 3 of the box");
    }
}

/// A prism (or, with its top drawn together, a pyramid) over a regular polygon of n corners with radius r.
Mesh over_polygon(int n, double r, double bottom, double top, bool pointed) {
    Mesh mesh;
    for (int side = 0; side < 2; ++side)
        for (int k = 0; k < n; ++k) {
            const double angle = 2 * M_PI * k / n, across = side == 1 && pointed ? 0 : r;
            mesh.vertices.push_back(
                {cast(across * std::cos(angle)), cast(across * std::sin(angle)), cast(side == 0 ? bottom : top)});
        }
    for (int k = 0; k < n; ++k) {
        const int next = (k + 1) % n;
        mesh.triangles.push_back({k, next, n + next});
        mesh.triangles.push_back({k, n + next, n + k});
        if (k > 0 && next > 0) {
            mesh.triangles.push_back({0, next, k});
            mesh.triangles.push_back({n, n + k, n + next});
        }
    }
    return mesh;
}

TEST(Meshes, over_a_polygon_have_a_known_share_of_the_cylinder_and_the_cone) {
    for (int n : {3, 4, 7, 64, 1000}) {
        // A regular polygon has sin x / x of the area of its circle and sin x (2 + cos x) / (3 x) of its polar moment, with
        // x = 2 pi / n; slices of a pyramid are polygons too. The corners are rounded once, and so is each pyramid of the mesh.
        const double x = 2 * M_PI / n, area = std::sin(x) / x, polar = area * (2 + std::cos(x)) / 3;
        const MassDistribution cylinder = ingot::solid_cylinder(1, scalar(0.5), 2), cone = ingot::solid_cone(1, scalar(0.5), 4);
        for (const bool pointed : {false, true}) {
            const Mesh mesh = pointed ? over_polygon(n, 0.5, 0, 4, true) : over_polygon(n, 0.5, -2, 2, false);
            const MassDistribution solid = mesh.solid().value, &whole = pointed ? cone : cylinder;
            const MeshBounds bounds = bounds_of(mesh, to_eigen<Real>(whole.r_CM));
            const double rounded_corners = 8 * static_cast<double>(gamma(1));  // fifth degree, and the primitive's own
            EXPECT_NEAR(static_cast<double>(solid.M), area * static_cast<double>(whole.M),
                        static_cast<double>(bounds.M) + rounded_corners * static_cast<double>(whole.M)) << n;
            EXPECT_NEAR(static_cast<double>(solid.I.zz), polar * static_cast<double>(whole.I.zz),
                        static_cast<double>(bounds.I) + rounded_corners * static_cast<double>(whole.I.zz)) << n;
            // Along the axis the slices count by their area: I_x is half of I_z and the moment along the axis.
            const double along = static_cast<double>(whole.I.xx) - static_cast<double>(whole.I.zz) / 2;
            EXPECT_NEAR(static_cast<double>(solid.I.xx), area * along + polar * static_cast<double>(whole.I.zz) / 2,
                        static_cast<double>(bounds.I) + rounded_corners * static_cast<double>(whole.I.xx)) << n;
        }
    }
}

TEST(Meshes, with_a_cavity_are_the_solid_without_it) {
    const Mesh outer = polyhedron("box"), inner = polyhedron("octahedron").moved({scalar(0), scalar(0.5), scalar(-1)});
    const MassDistribution hollow = outer.with(inner.inside_out()).solid(3).value;
    const MassDistribution expected = ingot::without(outer.solid(3).value, inner.solid(3).value);
    expect_same(hollow, expected, 2 * extent(outer.solid(3).value), 17 + 20 + 20,
                "a mesh of 20 triangles, two of fewer, a joint");
}

TEST(Meshes, of_two_shells_are_both_solids) {
    const Mesh a = polyhedron("prism"), b = polyhedron("frustum").moved({20, 0, 0});
    const MassDistribution both = a.with(b).solid(3).value, parts = ingot::combined(a.solid(3).value, b.solid(3).value);
    expect_same(both, parts, extent(parts), 17 + 20 + 20, "a mesh of 20 triangles, two of fewer, a joint");
}

TEST(Meshes, slivers_askew_keep_the_digits_of_their_width) {
    // A box 1000:1:1 turned at will. What its vertices lose when they are rounded, u of 1000 against a width of 1, no method
    // can get back; what the mesh adds is bounded by the same.
    RandomInput random(6);
    Mesh mesh = polyhedron("box");
    for (int i = 0; i < many; ++i) {
        const Eigen::Matrix3d A = random.rotation();
        const double length = random.real(900, 1100);
        Mesh turned = mesh;
        for (Vector& v : turned.vertices)
            v = to_vector(A * Eigen::Vector3d(to_eigen(v)).cwiseProduct(Eigen::Vector3d(length / 2, 0.25, 1.0 / 6)));
        const Result<MassDistribution> solid = turned.solid();
        ASSERT_EQ(solid.status, Status::ok);
        const MeshBounds bounds = bounds_of(turned, Vector3::Zero());
        const double width_lost = 6 * static_cast<double>(gamma(1)) * length;  // each of two widths, by a vertex at each end
        EXPECT_NEAR(static_cast<double>(solid.value.M), length, static_cast<double>(bounds.M) + width_lost * length);
        EXPECT_NEAR(to_eigen(solid.value.I).trace(), length * (length * length + 2) / 6,
                    3 * static_cast<double>(bounds.I) + width_lost * length * length * length / 6);
        EXPECT_LE(bounds.M, 0.01L * length);  // and the bounds are of use in float
    }
}

/// A ring of n by m quadrilaterals: closed, with no corner that is special.
Mesh torus(int n, int m) {
    Mesh mesh;
    for (int i = 0; i < n; ++i)
        for (int j = 0; j < m; ++j) {
            const double u = 2 * M_PI * i / n, v = 2 * M_PI * j / m, r = 3 + std::cos(v);
            mesh.vertices.push_back({cast(r * std::cos(u)), cast(r * std::sin(u)), cast(std::sin(v))});
            const auto at = [&](int k, int l) { return (k % n) * m + l % m; };
            mesh.triangles.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
            mesh.triangles.push_back({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
        }
    return mesh;
}

TEST(Meshes, that_are_not_closed_are_refused) {
    std::vector<Mesh> meshes = {torus(12, 8)};
    for (const std::string& name : polyhedra()) meshes.push_back(polyhedron(name));
    for (const Mesh& closed : meshes) {
        ASSERT_EQ(closed.solid().status, Status::ok);
        for (std::size_t k = 0; k < closed.triangles.size(); ++k) {
            Mesh open = closed;
            if (open.triangles.size() > 4) {
                open.triangles.erase(open.triangles.begin() + static_cast<std::ptrdiff_t>(k));
                EXPECT_EQ(open.solid().status, Status::bad_shape);
            }
            Mesh flipped = closed;
            std::swap(flipped.triangles[k].a, flipped.triangles[k].c);
            EXPECT_EQ(flipped.solid().status, Status::bad_shape);
            Mesh doubled = closed;
            doubled.triangles.push_back(closed.triangles[k]);
            EXPECT_EQ(doubled.solid().status, Status::bad_shape);
            for (int vertex = 0; vertex < static_cast<int>(closed.vertices.size()); ++vertex) {
                if (vertex == closed.triangles[k].b) continue;
                Mesh torn = closed;
                torn.triangles[k].b = vertex;
                EXPECT_EQ(torn.solid().status, Status::bad_shape);
            }
        }
    }
}

TEST(Meshes, that_are_large_and_wrong_in_one_place_are_refused) {
    RandomInput random(7);
    const Mesh closed = torus(60, 40);
    ASSERT_EQ(closed.solid().status, Status::ok);
    for (int i = 0; i < 500; ++i) {
        Mesh torn = closed;
        MeshTriangle& t = torn.triangles[static_cast<std::size_t>(random.integer(0, 4799))];
        const int vertex = random.integer(0, 2399);
        if (vertex == t.a) continue;
        t.a = vertex;
        EXPECT_EQ(torn.solid().status, Status::bad_shape);
    }
}

TEST(Meshes, that_touch_along_an_edge_are_closed) {
    // Two tetrahedra on either side of a shared edge: four faces meet in it, and every directed edge still has its opposite.
    Mesh mesh = polyhedron("tetra_unit");
    mesh.vertices.push_back({0, -1, 0});
    mesh.vertices.push_back({0, 0, -1});
    const MeshTriangle other[4] = {{0, 4, 1}, {0, 1, 5}, {0, 5, 4}, {1, 4, 5}};
    mesh.triangles.insert(mesh.triangles.end(), other, other + 4);
    const Result<MassDistribution> solid = mesh.solid(6);
    ASSERT_EQ(solid.status, Status::ok);
    EXPECT_LE(std::abs(static_cast<Real>(solid.value.M) - 2), gamma(8 + 17) * 2);
}

TEST(Meshes, that_are_inside_out_or_flat_are_refused) {
    RandomInput random(8);
    for (const std::string& name : polyhedra())
        EXPECT_EQ(polyhedron(name).inside_out().solid().status, Status::bad_shape) << name;
    for (int i = 0; i < many; ++i) {
        Mesh flat = polyhedron("tetra_unit");
        const Vector u = to_vector(random.vector(1)), v = to_vector(random.vector(1)), from = to_vector(random.vector(10));
        for (Vector& corner : flat.vertices) corner = from + u * cast(random.real(-1, 1)) + v * cast(random.real(-1, 1));
        // Rounded corners lie off the plane, by u of their distance: the solid has that thickness or is refused.
        const Result<MassDistribution> solid = flat.solid();
        if (solid.ok()) {
            EXPECT_LE(static_cast<Real>(solid.value.M), gamma(8) * 10 * 8);
        } else {
            EXPECT_EQ(solid.status, Status::bad_shape);
        }
    }
    // Corners on a grid lie in a plane exactly, and the volume is then zero, whatever the roundings of its products say.
    constexpr int bits = sizeof(scalar) == sizeof(float) ? 20 : 30;
    for (int i = 0; i < many; ++i) {
        Mesh flat = polyhedron("tetra_unit");
        for (Vector& corner : flat.vertices) {
            const double x = random.integer(-(1 << bits), 1 << bits), y = random.integer(-(1 << bits), 1 << bits);
            corner = Vector{cast(x), cast(y), cast(3 * x - 7 * y)} * cast(std::ldexp(1.0, -bits));
        }
        EXPECT_EQ(flat.solid().status, Status::bad_shape);
    }
}

TEST(Meshes, of_bad_numbers_are_refused) {
    const Mesh mesh = polyhedron("prism");
    for (const scalar bad : {nan, infinity, -infinity}) {
        EXPECT_EQ(mesh.solid(bad).status, Status::not_finite);
        for (Vector v : {Vector{bad, 0, 0}, Vector{0, bad, 0}, Vector{0, 0, bad}}) {
            for (std::size_t vertex_i = 0; vertex_i < mesh.vertices.size(); ++vertex_i) {
                Mesh broken = mesh;
                broken.vertices[vertex_i] = v;
                EXPECT_EQ(broken.solid().status, Status::not_finite) << vertex_i;
            }
        }
    }
    EXPECT_EQ(mesh.solid(0).status, Status::bad_mass);
    EXPECT_EQ(mesh.solid(-1).status, Status::bad_mass);
    EXPECT_EQ(mesh.moved({0, 2 * ingot::limits::position_max, 0}).solid().status, Status::out_of_range);
    for (const int bad : {-1, 6, std::numeric_limits<int>::max(), std::numeric_limits<int>::min()}) {
        for (std::size_t triangle_i = 0; triangle_i < mesh.triangles.size(); ++triangle_i) {
            for (const int corner : {0, 1, 2}) {
                Mesh broken = mesh;
                MeshTriangle& t = broken.triangles[triangle_i];
                (corner == 0 ? t.a : corner == 1 ? t.b : t.c) = bad;
                EXPECT_EQ(broken.solid().status, Status::out_of_range) << triangle_i;
            }
        }
    }
    Mesh huge = mesh;
    for (Vector& v : huge.vertices) v = v * (ingot::limits::position_max / 8);
    EXPECT_EQ(huge.solid().status, sizeof(scalar) == sizeof(float) ? Status::out_of_range : Status::ok)
        << "1e9^5 is beyond float";
}

TEST(Meshes, without_triangles_are_refused) {
    const Mesh mesh = polyhedron("prism");
    const auto status = [&](const Vector* vertices, int vertex_count, const MeshTriangle* triangles, int triangle_count) {
        return ingot::solid_mesh(1, vertices, vertex_count, triangles, triangle_count).status;
    };
    EXPECT_EQ(status(nullptr, 6, mesh.triangles.data(), 8), Status::bad_shape);
    EXPECT_EQ(status(mesh.vertices.data(), 6, nullptr, 8), Status::bad_shape);
    for (const int count : {0, -1, 3, std::numeric_limits<int>::min()}) {
        EXPECT_EQ(status(mesh.vertices.data(), count, mesh.triangles.data(), 8), Status::bad_shape);
        EXPECT_EQ(status(mesh.vertices.data(), 6, mesh.triangles.data(), count), Status::bad_shape);
    }
}

// ---------------------------------------------------------------------------------------------------------------- compounds

TEST(Compounds, have_the_sum_of_the_tensors_about_any_point) {
    RandomInput random(9);
    for (int i = 0; i < many; ++i) {
        const MassDistribution a = random_part(random), b = random_part(random);
        const Vector point = to_vector(random.vector(10));
        const SymmetricMatrix sum = ingot::inertia_about(a, point) + ingot::inertia_about(b, point);
        EXPECT_LE(difference(ingot::inertia_about(ingot::combined(a, b), point), sum),
                  gamma(24) * (extent(a, point) + extent(b, point)))
            << "about 8 roundings for each of three moves";
    }
}

TEST(Compounds, do_not_depend_on_the_order_of_their_parts) {
    RandomInput random(10);
    for (int i = 0; i < many; ++i) {
        const MassDistribution a = random_part(random), b = random_part(random), c = random_part(random);
        const Real size = extent(a) + extent(b) + extent(c);
        expect_same(ingot::combined(ingot::combined(a, b), c), ingot::combined(a, ingot::combined(b, c)), size, 48,
                    "10 to 12 roundings for each of four joints");
        expect_same(ingot::combined(a, b), ingot::combined(b, a), size, 24, "and of two");
    }
}

TEST(Compounds, with_an_empty_part_are_the_other_part_to_the_bit) {
    RandomInput random(11);
    for (int i = 0; i < many; ++i) {
        const MassDistribution a = random_part(random), whole = ingot::combined(MassDistribution{}, a);
        EXPECT_EQ(whole.M, a.M);
        EXPECT_EQ(to_eigen(whole.r_CM), to_eigen(a.r_CM));
        EXPECT_EQ(to_eigen(whole.I), to_eigen(a.I));
    }
}

TEST(Compounds, without_a_part_are_what_they_were_before) {
    RandomInput random(12);
    for (int i = 0; i < many; ++i) {
        const MassDistribution a = random_part(random), b = random_part(random),
                               back = ingot::without(ingot::combined(a, b), b);
        // What is left is a difference: relative to both parts, and the centre to their ratio.
        const Real size = extent(a) + extent(b), M = static_cast<Real>(a.M + b.M), left = static_cast<Real>(a.M);
        EXPECT_LE(std::abs(static_cast<Real>(back.M - a.M)), gamma(3) * M);
        EXPECT_LE((to_eigen<Real>(back.r_CM) - to_eigen<Real>(a.r_CM)).cwiseAbs().maxCoeff(),
                  gamma(24) * std::sqrt(size * M) / left);
        EXPECT_LE(difference(back.I, a.I), gamma(48) * size * (M / left))
            << "a joint and its undoing, which divides by the rest";
    }
}

TEST(Compounds, far_from_the_origin_have_the_tensor_they_have_there) {
    RandomInput random(13);
    for (int i = 0; i < many; ++i) {
        // Places on a grid of 1/8, which a shift of 2^20 keeps exact in float.
        const auto place = [&] {
            return Vector{cast(random.integer(-32, 32) / 8.0), cast(random.integer(-32, 32) / 8.0),
                          cast(random.integer(-32, 32) / 8.0)};
        };
        const MassDistribution a = ingot::solid_box(1, {1, 2, 3}), b = ingot::solid_sphere(2, 1);
        const Vector r_a = place(), r_b = place(), far = {1048576, 0, -1048576};
        const MassDistribution near = ingot::combined(ingot::placed(a, upright, r_a), ingot::placed(b, upright, r_b));
        const MassDistribution away =
            ingot::combined(ingot::placed(a, upright, r_a + far), ingot::placed(b, upright, r_b + far));
        EXPECT_EQ(to_eigen(near.I), to_eigen(away.I));
    }
}

TEST(Compounds, turned_have_the_turned_tensor) {
    RandomInput random(14);
    for (int i = 0; i < many; ++i) {
        const MassDistribution part = random_part(random);
        const Matrix A = to_matrix(random.rotation());
        const Vector r = to_vector(random.vector(10));
        const MassDistribution moved = ingot::placed(part, A, r);
        const Matrix3 R = to_eigen<Real>(A), I = to_eigen<Real>(part.I);
        const Matrix3 magnitude = R.cwiseAbs() * I.cwiseAbs() * R.cwiseAbs().transpose();
        EXPECT_EQ(moved.M, part.M);
        EXPECT_LE(ingot_reference::worst_relative_error(to_eigen<Real>(moved.I), Matrix3(R * I * R.transpose()), magnitude),
                  gamma(6));
        const Vector3 centre = R * to_eigen<Real>(part.r_CM) + to_eigen<Real>(r);
        const Vector3 size = R.cwiseAbs() * to_eigen<Real>(part.r_CM).cwiseAbs() + to_eigen<Real>(r).cwiseAbs();
        EXPECT_LE(ingot_reference::worst_relative_error(to_eigen<Real>(moved.r_CM), centre, size), gamma(4));
    }
}

TEST(Compounds, moved_twice_are_moved_by_the_product) {
    RandomInput random(15);
    for (int i = 0; i < many; ++i) {
        const MassDistribution part = random_part(random);
        const Matrix A = to_matrix(random.rotation()), B = to_matrix(random.rotation());
        const Vector r = to_vector(random.vector(10)), s = to_vector(random.vector(10));
        const MassDistribution twice = ingot::placed(ingot::placed(part, A, r), B, s),
                               once = ingot::placed(part, B * A, B * r + s);
        const Real reach = 17 * std::sqrt(3.0L);
        // Sums of three products under a rotation reach sqrt 3 of what they turn, twice that for a tensor.
        expect_same(twice, once, 6 * (extent(part) + static_cast<Real>(part.M) * reach * reach), 24,
                    "6 roundings for each of four turns");
    }
}

TEST(Compounds, turned_keep_their_moments) {
    RandomInput random(16);
    for (int i = 0; i < many; ++i) {
        const MassDistribution part = random_primitive(random);
        const Matrix A = to_matrix(random.rotation());
        const Result<MassProperties> straight = ingot::principal(part),
                                     turned = ingot::principal(ingot::placed(part, A, {1, 2, 3}));
        ASSERT_EQ(straight.status, Status::ok);
        ASSERT_EQ(turned.status, Status::ok);
        Vector3 expected = to_eigen<Real>(straight.value.I_body), moments = to_eigen<Real>(turned.value.I_body);
        std::sort(expected.data(), expected.data() + 3);
        std::sort(moments.data(), moments.data() + 3);
        // Weyl: moments move by no more than the norm of what the tensor is off by. That is 50 u of principal_axes, 6 u of the
        // turn in each entry, whose terms are below 3 of the largest moment, and A itself, off by u in each entry, twice.
        EXPECT_LE((expected - moments).cwiseAbs().maxCoeff(), gamma(50 + 3 * 18 + 6) * expected.maxCoeff());
    }
}

TEST(Compounds, of_another_mass_have_the_same_shape) {
    RandomInput random(17);
    for (int i = 0; i < many; ++i) {
        const MassDistribution part = random_part(random);
        const scalar M = cast(random.real(0.01, 100));
        const MassDistribution heavy = ingot::with_mass(part, M);
        EXPECT_EQ(heavy.M, M);
        EXPECT_EQ(to_eigen(heavy.r_CM), to_eigen(part.r_CM));
        const Matrix3 expected = to_eigen<Real>(part.I) * (static_cast<Real>(M) / static_cast<Real>(part.M));
        EXPECT_LE(ingot_reference::worst_relative_error(to_eigen<Real>(heavy.I), expected, Matrix3(expected.cwiseAbs())),
                  gamma(2));
    }
}

// ------------------------------------------------------------------------------------------------------------ what is refused

/// All solids of one bad argument among good ones.
std::vector<MassDistribution> solids_of(scalar bad) {
    const Vector sizes[3] = {{bad, 1, 1}, {1, bad, 1}, {1, 1, bad}};
    // clang-format off
    std::vector<MassDistribution> solids = {
        ingot::solid_sphere(bad, 1), ingot::solid_sphere(1, bad),
        ingot::solid_box(bad, {1, 1, 1}), ingot::solid_ellipsoid(bad, {1, 1, 1}),
        ingot::solid_cylinder(bad, 1, 1), ingot::solid_cylinder(1, bad, 1), ingot::solid_cylinder(1, 1, bad),
        ingot::solid_capsule(bad, 1, 1), ingot::solid_capsule(1, bad, 1),
        ingot::solid_cone(bad, 1, 1), ingot::solid_cone(1, bad, 1), ingot::solid_cone(1, 1, bad),
        ingot::solid_hemisphere(bad, 1), ingot::solid_hemisphere(1, bad),
        ingot::solid_tetrahedron(bad, {}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1})};
    // clang-format on
    for (const Vector& size : sizes) {
        solids.push_back(ingot::solid_box(1, size));
        solids.push_back(ingot::solid_ellipsoid(1, size));
    }
    if (bad != 0) solids.push_back(ingot::solid_capsule(1, 1, bad));
    return solids;
}

TEST(Refusals, of_bad_arguments_reach_principal_through_every_compound) {
    const MassDistribution good = ingot::solid_sphere(100, 10);
    for (const scalar bad : {scalar(0), scalar(-1), -infinity, infinity, nan}) {
        const std::vector<MassDistribution> solids = solids_of(bad);
        for (std::size_t i = 0; i < solids.size(); ++i) {
            const MassDistribution& solid = solids[i];
            const auto expect_refused = [&](const MassDistribution& made) {
                EXPECT_EQ(ingot::principal(made).status, Status::not_finite) << "solid " << i << " of " << bad;
            };
            expect_refused(solid);
            expect_refused(ingot::combined(good, solid));
            expect_refused(ingot::combined(solid, good));
            expect_refused(ingot::without(good, solid));
            expect_refused(ingot::without(solid, good));
            expect_refused(ingot::placed(solid, upright, {1, 2, 3}));
            EXPECT_NE(ingot::principal(ingot::with_mass(solid, 1)).status, Status::ok) << "solid " << i << " of " << bad;
        }
    }
}

TEST(Refusals, of_two_negative_arguments_do_not_cancel) {
    EXPECT_FALSE(ingot::principal(ingot::solid_sphere(-1, -1)).ok());
    EXPECT_FALSE(ingot::principal(ingot::solid_box(1, {-1, -1, 1})).ok());
    EXPECT_FALSE(ingot::principal(ingot::solid_cylinder(-1, 1, -1)).ok());
    EXPECT_FALSE(ingot::principal(ingot::solid_ellipsoid(1, {-1, 1, -1})).ok());
    const MassDistribution inverted = {-1, {}, {-1, -1, -1, 0, 0, 0}};
    EXPECT_FALSE(ingot::principal(ingot::with_mass(inverted, 1)).ok());
    EXPECT_FALSE(ingot::principal(ingot::with_mass(inverted, -1)).ok());
}

TEST(Refusals, of_a_matrix_that_is_no_rotation) {
    const MassDistribution box = ingot::solid_box(1, {1, 2, 3});
    const Matrix mirror = {{1, 0, 0}, {0, 1, 0}, {0, 0, -1}}, twice = upright * scalar(2),
                 broken = {{1, 0, 0}, {0, nan, 0}, {0, 0, 1}};
    for (const Matrix& A : {mirror, twice, broken, Matrix{}})
        EXPECT_EQ(ingot::principal(ingot::placed(box, A, {})).status, Status::not_finite);
    EXPECT_EQ(ingot::principal(ingot::placed(box, upright, {0, infinity, 0})).status, Status::not_finite);
    EXPECT_EQ(ingot::principal(ingot::placed(box, upright, {0, nan, 0})).status, Status::not_finite);
}

TEST(Refusals, of_masses_and_tensors_that_no_solid_has) {
    const SymmetricMatrix ball = {1, 1, 1, 0, 0, 0};
    EXPECT_EQ(ingot::principal({1, {}, ball}).status, Status::ok);
    EXPECT_EQ(ingot::principal({0, {}, ball}).status, Status::bad_mass);
    EXPECT_EQ(ingot::principal({-1, {}, ball}).status, Status::bad_mass);
    EXPECT_EQ(ingot::principal({nan, {}, ball}).status, Status::not_finite);
    EXPECT_EQ(ingot::principal({1, {nan, 0, 0}, ball}).status, Status::not_finite);
    EXPECT_EQ(ingot::principal({1, {}, {1, 1, nan, 0, 0, 0}}).status, Status::not_finite);
    EXPECT_EQ(ingot::principal({1, {}, {1, 1, 1, 0, 0, -infinity}}).status, Status::not_finite);
    EXPECT_EQ(ingot::principal({1, {}, {1, 1, 3, 0, 0, 0}}).status, Status::bad_inertia) << "1 + 1 < 3";
    EXPECT_EQ(ingot::principal({1, {}, {1, 1, 0, 0, 0, 0}}).status, Status::bad_inertia) << "a rod without thickness";
    EXPECT_EQ(ingot::principal({1, {}, {1, 1, -1, 0, 0, 0}}).status, Status::bad_inertia);
    EXPECT_EQ(ingot::principal({1, {}, {1, 1, 1, 2, 0, 0}}).status, Status::bad_inertia) << "eigenvalues 3, 1 and -1";
    EXPECT_EQ(ingot::principal({1, {}, {1, 1, 2, 0, 0, 0}}).status, Status::ok) << "a flat plate";
    EXPECT_EQ(ingot::principal({1, {}, ball * ingot::limits::inertia_max}).status, Status::ok);
    EXPECT_EQ(ingot::principal({1, {}, ball * (2 * ingot::limits::inertia_max)}).status, Status::bad_inertia);
    EXPECT_EQ(ingot::principal({1, {}, ball * (ingot::limits::inertia_min / 2)}).status, Status::bad_inertia);
}

TEST(Refusals, of_a_hole_as_large_as_the_solid) {
    const MassDistribution box = ingot::solid_box(1, {1, 1, 1});
    EXPECT_FALSE(ingot::principal(ingot::without(box, box)).ok());
    EXPECT_EQ(ingot::principal(ingot::without(box, ingot::solid_box(1, {2, 2, 2}))).status, Status::bad_mass);
}

/// Found by fuzz_numbers: sizes so small that masses round to zero, which divided zero by zero.
TEST(Refusals, of_parts_without_mass) {
    constexpr MassDistribution nothing = ingot::combined(MassDistribution{}, MassDistribution{});
    static_assert(nothing.M == 0 && nothing.I.xx == 0, "and a constant, which no division by zero can be");
    EXPECT_EQ(ingot::principal(nothing).status, Status::bad_mass);
}

TEST(Refusals, of_flat_solids_never_give_a_number_that_is_not_finite) {
    RandomInput random(18);
    for (int i = 0; i < many; ++i) {
        // A plate as thick as rounding, and rods as thin, turned at will: accepted or refused, but never NaN.
        const scalar thin = cast(std::ldexp(1.0, random.integer(-60, -2)));
        const MassDistribution box = i % 2 == 0 ? ingot::solid_box(1, {1, 1, thin}) : ingot::solid_box(1, {1, thin, thin});
        const MassDistribution turned = ingot::placed(ingot::with_mass(box, 1), to_matrix(random.rotation()), {});
        const Result<MassProperties> mass = ingot::principal(turned);
        if (mass.ok()) {
            EXPECT_TRUE(ingot::is_finite(mass.value.I_body));
            EXPECT_TRUE(ingot::is_finite(mass.value.A_principal));
            EXPECT_GT(std::min({mass.value.I_body.x, mass.value.I_body.y, mass.value.I_body.z}), 0);
        } else {
            // Scaling the mass of a solid without volume overflows.
            EXPECT_TRUE(mass.status == Status::bad_inertia || mass.status == Status::not_finite);
        }
    }
}

TEST(Refusals, are_those_of_the_door) {
    RandomInput random(19);
    for (int i = 0; i < 20 * many; ++i) {
        const auto any = [&](int low, int high) { return cast(random.of_any_size(low, high)); };
        const auto moment = [&] { return i % 4 == 0 ? any(-66, 66) : std::abs(any(-2, 2)); };
        const scalar M = i % 3 == 0 ? any(-45, 45) : 1;
        const SymmetricMatrix I = {moment(), moment(), moment(), 0, 0, 0};
        const MassProperties as_given = {M, {I.xx, I.yy, I.zz}, {}, upright};
        const Result<MassProperties> mass = ingot::principal({M, {}, I});
        EXPECT_EQ(mass.status, ingot::check_mass_properties(as_given));
        if (mass.ok()) {
            EXPECT_EQ(to_eigen(mass.value.I_body), to_eigen(as_given.I_body));
        }
    }
}

TEST(Refusals, are_none_for_what_the_door_lets_in) {
    RandomInput random(20);
    for (int i = 0; i < many; ++i) {
        const MassDistribution a = random_part(random), b = random_part(random), part = ingot::combined(a, b);
        const Result<MassProperties> mass = ingot::principal(part);
        ASSERT_EQ(mass.status, Status::ok);
        EXPECT_EQ(ingot::check_mass_properties(mass.value), Status::ok);
        EXPECT_EQ(ingot::check_rotation(mass.value.A_principal), Status::ok);
        EXPECT_EQ(mass.value.M, part.M);
        EXPECT_EQ(to_eigen(mass.value.r_CM), to_eigen(part.r_CM));
    }
}

// ------------------------------------------------------------------------------------------------------------- at compile time

static_assert(ingot::solid_sphere(1, 1).M > 4 && ingot::solid_sphere(1, 1).M < scalar(4.2));
static_assert(ingot::solid_box(1, {1, 1, 1}).I.xx * 3 == 16);
static_assert(ingot::solid_cylinder(1, 1, 1).I.zz * 2 == ingot::solid_cylinder(1, 1, 1).M);
static_assert(ingot::solid_capsule(1, 1, 0).M == ingot::solid_sphere(1, 1).M);
static_assert(ingot::solid_cone(1, 1, 4).r_CM.z == 1);
static_assert(ingot::solid_ellipsoid(1, {1, 1, 1}).I.yy == ingot::solid_sphere(1, 1).I.yy);
static_assert(ingot::solid_hemisphere(1, 8).r_CM.z == 3);
static_assert(ingot::solid_tetrahedron(6, {}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}).M == 1);
static_assert(ingot::with_mass(ingot::solid_box(1, {1, 2, 3}), 5).M == 5);
static_assert(ingot::without(ingot::solid_box(1, {1, 1, 2}), ingot::placed(ingot::solid_box(1, {1, 1, 1}), upright, {0, 0, 1}))
                  .r_CM.z == -1);
static_assert(ingot::inertia_about(ingot::solid_box(1, {1, 1, 1}), {1, 0, 0}).xx == ingot::solid_box(1, {1, 1, 1}).I.xx);

constexpr MassDistribution hammer =
    ingot::combined(ingot::solid_cylinder(700, scalar(0.015), scalar(0.15)),
                    ingot::placed(ingot::solid_box(7850, {scalar(0.05), scalar(0.015), scalar(0.015)}),
                                  ingot::axis_angle({0, 1, 0}, scalar(0.1)), {0, 0, scalar(0.15)}));
constexpr Result<MassProperties> constant_hammer = ingot::principal(hammer);
static_assert(constant_hammer.ok(), "a compound and its principal axes are constants of the program");

TEST(CompileTime, gives_the_bits_of_run_time) {
    volatile scalar density = 700;
    const MassDistribution again =
        ingot::combined(ingot::solid_cylinder(density, scalar(0.015), scalar(0.15)),
                        ingot::placed(ingot::solid_box(7850, {scalar(0.05), scalar(0.015), scalar(0.015)}),
                                      ingot::axis_angle({0, 1, 0}, scalar(0.1)), {0, 0, scalar(0.15)}));
    const MassProperties mass = ingot::principal(again).value;
    EXPECT_EQ(again.M, hammer.M);
    EXPECT_EQ(to_eigen(again.I), to_eigen(hammer.I));
    EXPECT_EQ(to_eigen(mass.I_body), to_eigen(constant_hammer.value.I_body));
    EXPECT_EQ(to_eigen(mass.A_principal), to_eigen(constant_hammer.value.A_principal));
}

}  // namespace
