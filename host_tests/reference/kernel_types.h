// SPDX-License-Identifier: MIT
// The kernel's numbers as Eigen's and back. The references beside this file do not include it: they know no kernel.
#pragma once

#include <ingot/ingot.h>

#include <Eigen/Dense>

namespace ingot_reference {

template <class Real = double, class T>
Eigen::Matrix<Real, 3, 1> to_eigen(const ingot::Vec3<T>& v) {
    return {static_cast<Real>(v.x), static_cast<Real>(v.y), static_cast<Real>(v.z)};
}

template <class Real = double, class T>
Eigen::Matrix<Real, 3, 3> to_eigen(const ingot::Mat3<T>& a) {
    Eigen::Matrix<Real, 3, 3> m;
    m << to_eigen<Real>(a.c0), to_eigen<Real>(a.c1), to_eigen<Real>(a.c2);
    return m;
}

template <class Real = double, class T>
Eigen::Matrix<Real, 3, 3> to_eigen(const ingot::Sym3<T>& a) {
    const auto r = [](T x) { return static_cast<Real>(x); };
    Eigen::Matrix<Real, 3, 3> m;
    m << r(a.xx), r(a.xy), r(a.xz), r(a.xy), r(a.yy), r(a.yz), r(a.xz), r(a.yz), r(a.zz);
    return m;
}

template <class V>
ingot::Vector to_vector(const V& v) {
    return {static_cast<ingot::scalar>(v(0)), static_cast<ingot::scalar>(v(1)), static_cast<ingot::scalar>(v(2))};
}

template <class M>
ingot::Matrix to_matrix(const M& m) {
    return {to_vector(m.col(0)), to_vector(m.col(1)), to_vector(m.col(2))};
}

/// Mass and principal moments, the user's frame being the body's.
template <class V>
ingot::MassProperties to_mass(double M, const V& I_body) {
    return {static_cast<ingot::scalar>(M), to_vector(I_body), {}, ingot::identity_matrix<ingot::scalar>()};
}

/// A body of those, at rest at the origin unless more is said.
template <class V>
ingot::BodyDef definition(double M, const V& I_body) {
    ingot::BodyDef def{};
    def.mass = to_mass(M, I_body);
    return def;
}

}  // namespace ingot_reference
