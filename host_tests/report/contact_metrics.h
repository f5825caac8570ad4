// SPDX-License-Identifier: MIT
// What is measured of a contact scene that runs: the same for the kernel and for its peers.
#pragma once

#include <Eigen/Dense>
#include <string>
#include <vector>

#include "contact_case.h"

namespace report {

inline Eigen::Vector3d vector(const double (&v)[3]) { return {v[0], v[1], v[2]}; }
inline Eigen::Matrix3d matrix(const double (&A)[9]) { return Eigen::Map<const Eigen::Matrix3d>(A); }

struct Metric {
    const char* name;
    double value;
    const char* unit;
};

/// How deep a pair of bodies is inside each other, m: the shortest way that parts them; not positive: apart.
double overlap_of(const SceneBody& a, const BodyPose& pose_a, const SceneBody& b, const BodyPose& pose_b);

/// Overlaps of all pairs at one moment.
struct Overlaps {
    double sum = 0, deepest = 0;  ///< m
    long count = 0;               ///< pairs that overlap
};
Overlaps overlaps_of(const ContactCase& scene, const std::vector<BodyPose>& poses);

/// Kinetic energy of all bodies, J.
double kinetic_energy(const ContactCase& scene, const std::vector<BodyPose>& poses);

/// Follows a scene from its start, step by step.
class ContactTally {
public:
    /// `seconds`: how long it will be followed; overlaps, residual and sweeps are of the later half.
    ContactTally(const ContactCase& scene, const std::vector<BodyPose>& start, double seconds);
    void see(const std::vector<BodyPose>& poses, const StepFigures& figures, double t);
    std::vector<Metric> metrics() const;

private:
    void see_displacements(const std::vector<BodyPose>& poses, double t);
    void see_energy(const std::vector<BodyPose>& poses);
    void see_overlaps(const std::vector<BodyPose>& poses, double t);
    double energy(const std::vector<BodyPose>& poses) const;
    bool is(const char* prefix) const { return scene_.name.rfind(prefix, 0) == 0; }
    void add_of_stack(std::vector<Metric>& list) const;
    void add_of_incline(std::vector<Metric>& list) const;
    void add_of_drop(std::vector<Metric>& list) const;

    const ContactCase& scene_;
    std::vector<BodyPose> start_, last_;
    double seconds_, t_ = 0;
    double shift_ = 0, settling_ = 0, settled_ = 0, top_shift_ = 0, top_sink_ = 0, stood_ = 0;  ///< m; s
    bool stands_ = true;
    double energy_begin_, energy_last_, energy_gain_ = 0, energy_error_ = 0;  ///< J; relative
    double last_moving_ = 0, spin_ = 0;                                       ///< s; rad/s
    double creep_ = 0, lift_ = 0;                                             ///< m
    Overlaps overlaps_;
    double overlaps_due_;
    double residual_ = 0, sweeps_ = 0;
    long later_steps_ = 0, lost_ = 0, frozen_ = 0;
};

}  // namespace report
