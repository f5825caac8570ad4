// SPDX-License-Identifier: MIT
// The unit of a user who gives no flags: sums of products of its own, by helpers of ingot, and by one that is not inlined at -Os.
#include <ingot/ingot.h>

float own(float a, float b, float c);
float by_helper(const ingot::Vector& a, const ingot::Vector& b);
ingot::Vector by_friend(const ingot::Sym3<float>& I, const ingot::Vector& a, const ingot::Vector& b);

float own(float a, float b, float c) { return a * b + c; }
float by_helper(const ingot::Vector& a, const ingot::Vector& b) { return ingot::dot(a, b); }
ingot::Vector by_friend(const ingot::Sym3<float>& I, const ingot::Vector& a, const ingot::Vector& b) { return I * a + I * b; }
