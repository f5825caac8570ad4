// SPDX-License-Identifier: MIT
// A contact scene without types of the kernel, and what runs it: a build of the kernel or another engine.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace report {

enum class Solid { ball, capsule, box, half_space };

/// A body as the scene places it. Vectors are world; A holds the columns c0, c1, c2.
struct SceneBody {
    Solid solid;
    double size[3];  ///< m: radius, 0, 0; radius, half length along c2, 0; half extents; or, of a half space, the outward normal
    double offset;   ///< m: a half space holds all points with normal . r <= offset
    bool immovable;
    double M, I[3];  ///< kg, kg m^2, principal
    double A[9], r[3];
    double mu, e;  ///< of every pair this body is in
};

/// Where a body is and how it moves.
struct BodyPose {
    double A[9], r[3], v[3], omega[3];
};

/// What the last step had to say; engines that say nothing leave it empty.
struct StepFigures {
    double residual = 0;  ///< m/s
    double sweeps = 0;    ///< over all contacts, in a step
    int lost = 0;         ///< bodies, pairs and contacts for which there was no room
    int frozen = 0;       ///< bodies driven out of range, which stand still from now on
};

/// A scene being run.
class ContactRun {
public:
    virtual ~ContactRun() = default;
    virtual void step(int rate) = 0;  ///< by 1/rate s
    virtual void read(std::vector<BodyPose>& poses) const = 0;
    virtual StepFigures figures() const { return {}; }
    virtual double bytes() const { return 0; }  ///< of the world; 0: not known
};

/// A scene, and how this build of the kernel runs it.
struct ContactCase {
    std::string name;
    double gravity[3];
    double seconds;  ///< for which its criterion asks
    std::vector<SceneBody> bodies;
    double push[3] = {0, 0, 0};  ///< N, world, on the centre of mass of body 1 in every step
    std::function<std::unique_ptr<ContactRun>()> begin;
    std::function<std::unique_ptr<ContactRun>()> begin_chosen;  ///< by the solver that picks itself; none where sweeps serve

    int moving_count() const {
        int count = 0;
        for (const SceneBody& body : bodies) count += body.immovable ? 0 : 1;
        return count;
    }
};

/// CPU time of this thread, us: what other work on the machine takes does not count.
double thread_us();

}  // namespace report
