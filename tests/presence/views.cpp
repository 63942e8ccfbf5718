// SPDX-License-Identifier: Apache-2.0
#include "tests/presence/views.h"

#include "tests/support/scratch_folder.h"

namespace candela::test {

Outcome run(const std::string &world, const std::string &integrator, const std::string &options) {
    ScratchFolder folder;
    const std::string rib = folder.write(
        "scene.rib", "Option \"radiometry\" \"string units\" [\"si\"]\nDisplay \"a.exr\" "
                     "\"openexr\" \"rgba\"\n" +
                         view(integrator) + options + "WorldBegin\n" + world + "WorldEnd\n");
    return runCandela({rib, "--quiet", "--spp", "1", "--output-dir", folder.path()});
}

} // namespace candela::test
