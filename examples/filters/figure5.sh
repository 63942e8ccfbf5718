#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# Figure 5: one Monte-Carlo picture plain and under the energy-preserving filter. Pictures go to
# out/ or the folder that is named.
#
# usage: sh examples/filters/figure5.sh [FOLDER]
set -e
here=$(dirname "$0")
out=${1:-out}
candela=${CANDELA:-$here/../../build/bin/candela}
mkdir -p "$out"
"$candela" --output-dir "$out" "$here/figure5.rib"
"$candela" filter "$out/figure5.exr" "$out/figure5_filtered.png" -f energy_preserving \
    --exposure 1.1 2.2
