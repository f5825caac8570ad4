// SPDX-License-Identifier: MIT
// All of mass_properties.h is for the compiler to work out: this file holds every compiler that builds the library to it, and
// costs no flash.
#include "mass_properties.h"

namespace ingot { inline namespace INGOT_ABI {

namespace {

constexpr Vector corners[4] = {{0, 0, 0}, {6, 0, 0}, {0, 6, 0}, {0, 0, 6}};
constexpr MeshTriangle faces[4] = {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}};
constexpr Result<MassDistribution> mesh_of_tetrahedron = solid_mesh(1, corners, 4, faces, 4);
constexpr MassDistribution tetrahedron = solid_tetrahedron(1, corners[0], corners[1], corners[2], corners[3]);
static_assert(mesh_of_tetrahedron.ok() && mesh_of_tetrahedron.value.M == 36 && tetrahedron.M == 36, "base times height over 3");
static_assert(solid_mesh(1, corners, 4, faces, 3).status == Status::bad_shape, "a mesh of 4 faces is open without one");

constexpr MassDistribution cube = solid_box(1, {1, 1, 1});
constexpr MassDistribution two_cubes =
    combined(placed(cube, identity_matrix<scalar>(), {1, 0, 0}), placed(cube, identity_matrix<scalar>(), {-1, 0, 0}));
static_assert(two_cubes.M == solid_box(1, {2, 1, 1}).M, "two cubes are a box");
static_assert(without(two_cubes, cube).M == cube.M, "and less a cube a cube again");
static_assert(inertia_about(cube, {0, 0, 3}).zz == cube.I.zz, "a shift along an axis leaves its moment");

constexpr Result<MassProperties> turned = principal({1, {}, {2, 2, 2, 1, 0, 0}});
static_assert(turned.ok() && turned.value.I_body.z == 2, "1 and 3 in the plane, and 2 across it");
static_assert(principal(with_mass(two_cubes, 4)).value.M == 4, "principal axes are a constant of the program");
static_assert(principal(MassDistribution{}).status == Status::bad_mass, "nothing has no mass");

}  // namespace

} }  // namespace ingot
