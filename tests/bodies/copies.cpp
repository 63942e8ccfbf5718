// SPDX-License-Identifier: Apache-2.0
#include "tests/bodies/copies.h"

namespace candela::test {

namespace {

/// Where copies stand, one in each corner of the picture; the third stands within an object of its
/// own, of which there are two.
struct Copy {
    const char *outer, *inner, *turn;
};
constexpr Copy copies[] = {
    {"Translate -3 3 0 Rotate 40 1 2 3 Scale 1 .6 1.3", "", ""},
    {"Translate 3 3 0 Scale -1 1 .8 Rotate 70 1 0 0", "", "ReverseOrientation"},
    {"Translate -3 -3 0 Rotate 20 0 0 1 Scale .5 -.5 .5", "Rotate -50 1 1 0", ""},
    {"Translate 3 -3 0 Rotate 200 1 1 0", "Rotate -50 1 1 0", "Orientation \"inside\""},
};

} // namespace

std::string copied(const Body &body, bool instances, const std::string &look) {
    const std::string primitives = "TransformBegin\n" + body.rib + "TransformEnd\n";
    std::string rib;
    if (instances)
        rib = "ObjectBegin 1\n" + primitives +
              "ObjectEnd\nObjectBegin 2\nRotate -50 1 1 0\n"
              "ObjectInstance 1\nObjectEnd\n";
    for (const Copy &copy : copies) {
        const bool nested = copy.inner[0] != 0;
        rib += std::string("AttributeBegin\n") + look + copy.outer + "\n" + copy.turn + "\n";
        if (instances)
            rib += nested ? "ObjectInstance 2\n" : "ObjectInstance 1\n";
        else
            rib += copy.inner + ("\n" + primitives);
        rib += "AttributeEnd\n";
    }
    return rib;
}

} // namespace candela::test
