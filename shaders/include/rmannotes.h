// SPDX-License-Identifier: Apache-2.0
// The words of rmannotes.sl, under the name of a header.
#include "rmannotes.sl"
