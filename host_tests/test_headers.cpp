// SPDX-License-Identifier: MIT
// Nothing: with it the headers that most tests include are read once for all of them (INGOT_TEST_PCH).
