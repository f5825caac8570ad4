// SPDX-License-Identifier: MIT
// What the page calls, as functions of C: exported by name from the module, called by native_hashes.cpp on the host.
#pragma once

#include <stdint.h>

#ifdef __wasm__
#define VIEWER_EXPORT(name) __attribute__((export_name(#name)))
#else
#define VIEWER_EXPORT(name)
#endif

/// What is done in a world, between two steps: see viewer_input.
enum ViewerInput { VIEWER_GRAB, VIEWER_MOVE, VIEWER_RELEASE, VIEWER_SHOOT, VIEWER_STEER };

extern "C" {

// Scenes: 0 <= scene_i < viewer_scene_count().

VIEWER_EXPORT(scene_count) int viewer_scene_count();
VIEWER_EXPORT(kind_count) int viewer_kind_count();
/// which: 0 its word in links, 1 group, 2 title, 3 a sentence.
VIEWER_EXPORT(scene_text) const char* viewer_scene_text(int scene_i, int which);
/// Six numbers: where it looks, m; from how far, m; yaw and pitch, rad.
VIEWER_EXPORT(camera) const float* viewer_camera(int scene_i);
/// m: half of the side of the pit; 0: there is none.
VIEWER_EXPORT(wall) float viewer_wall(int scene_i);
/// Kind of world that it runs in unless asked otherwise, and bits of those it can run in.
VIEWER_EXPORT(kind_of) int viewer_kind_of(int scene_i);
VIEWER_EXPORT(kinds_of) unsigned viewer_kinds_of(int scene_i);

// Stages: 0 and 1.

/// 1: the scene stands there as it begins.
VIEWER_EXPORT(open) int viewer_open(int stage_i, int scene_i, int kind);
/// h: s. Returns the status of the step; 0: ok.
VIEWER_EXPORT(step) int viewer_step(int stage_i, float h);
VIEWER_EXPORT(hash) uint64_t viewer_hash(int stage_i);
/// All of a stage: bytes copied and put back are the past.
VIEWER_EXPORT(bytes) unsigned char* viewer_bytes(int stage_i);
VIEWER_EXPORT(size) unsigned viewer_size(int stage_i);
/// grab: P, m, and the number of a body; move: P; release; shoot: from where, m, and how fast, m/s; steer: throttle and
/// steering, -1 to 1; of a character the way along x and y.
VIEWER_EXPORT(input) void viewer_input(int stage_i, int what, float a, float b, float c, float d, float e, float f);

// Reads, into viewer_answer().

/// The number of the first body on a way, or -1. Answers: P, m; n; 1 if it can move.
VIEWER_EXPORT(pick) int viewer_pick(int stage_i, float x, float y, float z, float dx, float dy, float dz);
/// r_CM, A by columns, L, omega, v_CM, mass, kinetic energy. 0: there is no such body. -1: the character, and r alone.
VIEWER_EXPORT(body) int viewer_body(int stage_i, int slot);
/// Of the last step: contacts, sweeps, residual, unfinished, contacts lost, impacts deferred, spins clamped, frozen, direct, clean, joints lost; from
/// 16 on: bodies, awake, asleep, islands awake, islands asleep, joints.
VIEWER_EXPORT(report) int viewer_report(int stage_i);
/// J: of motion and height.
VIEWER_EXPORT(energy) double viewer_energy(int stage_i);
/// Draws by the kernel's draw(): how many shapes (20 numbers each: kind, size, r, A by columns, offset, colour, body, island), lines (7: from, to,
/// colour) and points (4: P, colour). colors: bits of ingot::DrawColor. scale: how large arrows are.
VIEWER_EXPORT(draw) const int32_t* viewer_draw(int stage_i, unsigned colors, float scale);
/// How many triangles (10 numbers each: corners, m, from the middle of the level, where its shape is, and material) the
/// level of a stage has.
VIEWER_EXPORT(level) int viewer_level(int stage_i);
VIEWER_EXPORT(triangles) const float* viewer_triangles();
VIEWER_EXPORT(shapes) const float* viewer_shapes();
VIEWER_EXPORT(lines) const float* viewer_lines();
VIEWER_EXPORT(points) const float* viewer_points();
VIEWER_EXPORT(answer) const float* viewer_answer();
VIEWER_EXPORT(moments) const float* viewer_moments();

}  // extern "C"
