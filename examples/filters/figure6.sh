#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# Figure 6: the room under a lamp of 1, 2 and 4, by Tumblin and Rushmeier's operator, and for
# comparison by one factor for all three. Pictures go to out/ or the folder that is named.
#
# usage: sh examples/filters/figure6.sh [FOLDER]
set -e
here=$(dirname "$0")
out=${1:-out}
candela=${CANDELA:-$here/../../build/bin/candela}
mkdir -p "$out"
"$candela" --output-dir "$out" "$here/figure6.rib"
for light in low medium high; do
    "$candela" filter "$out/figure6_$light.exr" "$out/figure6_${light}_linear.png" \
        -f feature_regression -f linear_scale L_white=100 --exposure 1 2.2
done
