// SPDX-License-Identifier: Apache-2.0
volume lamplit(string category = "";) { color c = 0; illuminance (category, P, vector (0, 0, 1), PI) c += Cl; Ci += c; }
