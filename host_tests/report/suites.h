// SPDX-License-Identifier: MIT
// What is measured, suite by suite; each adds its rows.
#pragma once

#include "progress.h"
#include "rows.h"
#include "settings.h"
#include "variant.h"

namespace report {

/// Free bodies of the tables, by every method, step and scalar; their cost; the order they show; an hour of the book case.
void run_rotation(const Settings& settings, const std::vector<Variant>& variants, Rows& rows);
/// Heavy tops and swinging torques, by every flight.
void run_driven(const Settings& settings, const std::vector<Variant>& variants, Rows& rows);
/// Energy and orthogonality against time.
void run_drift(const Settings& settings, const std::vector<Variant>& variants, Rows& rows);
/// The whole public step of 1 to 65536 bodies, and its floor.
void run_throughput(const Settings& settings, const std::vector<Variant>& variants, Rows& rows);
/// Stacks, piles, slopes and bounces: how wrong they are, and what a step costs.
void run_contact(const Settings& settings, const std::vector<Variant>& variants, Rows& rows);
/// Stacks and piles at several efforts, beside Box3D where the report is built with it.
void run_effort(const Settings& settings, Rows& rows);
/// SimBenchmark's tests: error and CPU time at steps from 1 to 10 ms.
void run_simbenchmark(const Settings& settings, const std::vector<Variant>& variants, Rows& rows);
/// Bodies over ground of triangles and of heights: beside a half space, and what it takes.
void run_levels(const Settings& settings, Rows& rows);
/// Walkers, and an arm that follows paths: how far they are off, and what a step takes.
void run_control(const Settings& settings, Rows& rows);
/// Instructions, flash and RAM on emulated cores, from the tables that the cross builds keep and check.
void run_mcu(Rows& rows);
/// Other engines in the same run; nothing in a build without any.
void run_peers(const Settings& settings, const std::vector<Variant>& variants, Rows& rows);

/// Free bodies through Bullet and ODE, and the cost of a body beside the kernel's; nothing in a build without them. Part of run_peers.
void fly_peers(const Settings& settings, const std::vector<Variant>& variants, Progress& progress, Rows& rows);
/// The contact scenes through the peers and the kernel side by side; part of run_peers.
void run_contact_peers(const Settings& settings, const std::vector<Variant>& variants, Progress& progress, Rows& rows);

/// A row for every error of a flight; `row` has the rest.
void add_errors(const FlightErrors& errors, Row row, Rows& rows);

/// Steps a second at which a contact scene is run.
std::vector<int> contact_rates(const std::string& name, bool quick, bool beside_peers);
/// s; for which a contact scene is timed.
double timed_seconds(const ContactCase& scene, bool quick);

/// Of the builds, those that give each result once: the bits do not depend on lanes.
std::vector<const Variant*> one_per_scalar(const std::vector<Variant>& variants);

}  // namespace report
