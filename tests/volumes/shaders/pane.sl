// SPDX-License-Identifier: Apache-2.0
/* Passes light straight on, as if refracted by nothing. */
surface pane() { Oi = 1; Ci = trace(P, I); }
