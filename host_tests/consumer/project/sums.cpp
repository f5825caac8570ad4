// SPDX-License-Identifier: MIT
double sum(double a, double b, double c);
double sum(double a, double b, double c) { return a * b + c; }
