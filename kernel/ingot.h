// SPDX-License-Identifier: MIT
// ingot: a rigid-body physics kernel of one fixed size. The only header a user includes.
//
//     struct Satellite : ingot::Scene {};                        // names one body that turns, and nothing else
//     static ingot::World<Satellite> world;
//     ...
//     ingot::BodyDef def;
//     def.mass = ingot::principal(ingot::with_mass(ingot::solid_box(1, {0.05f, 0.05f, 0.17025f}), 4)).value;
//     def.state.L = {0, 0.02f, 0.001f};
//     const ingot::BodyId id = world.add(def).value;
//     for (;;) (void)ingot::step(world, 1.0f / 60);
//
// Conventions. Right-handed axes; column vectors; SI units: m, kg, s, rad, N. A takes body axes to world axes, its columns
// are the body's axes seen from the world. The body frame has its origin at the centre of mass and lies along the principal
// axes of inertia. r_CM, v_CM, A and L are the primary state; omega and inv_I_world are derived from it. Equation numbers
// are those of Chris Hecker, "Physics, Part 4: The Third Dimension", Game Developer, June 1997.
//
// Valid ranges stand in base/limits.h and base/figure_limits.h. Refused calls answer with a Status and change nothing. Nothing allocates, throws,
// recurses, prints or reads a clock.
#pragma once

#include "base/floating_point.h"
#include "base/version.h"
#include "body/kinematics.h"
#include "body/mass_properties.h"
#include "body/user_frame.h"
#include "level/byte_heights_of.h"
#include "level/height_field_of.h"
#include "level/level_materials.h"
#include "level/mesh_of.h"
#include "shape/hull_of_points.h"
#include "math/quaternion.h"
#include "motion/force_fields.h"
#include "mover/solve_planes.h"
#include "impulse/impulse.h"
#include "world/draw.h"
#include "world/snapshot.h"
#include "world/step.h"
#include "world/world.h"
