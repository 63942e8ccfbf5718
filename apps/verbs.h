// SPDX-License-Identifier: Apache-2.0
// What the program can do; each verb adds its options to the command line and leaves its exit
// status behind.
#pragma once

namespace CLI {
class App;
}

namespace candela {

/// `candela scene.rib`
void addRender(CLI::App &, int &status);
/// `candela view scene.rib`, `candela view a.exr`
void addView(CLI::App &, int &status);
/// `candela diff a b`
void addDiff(CLI::App &, int &status);
/// `candela filter in.exr out.exr -f name ...`
void addFilter(CLI::App &, int &status);
/// `candela merge a.exr b.exr -o all.exr`
void addMerge(CLI::App &, int &status);
/// `candela compile shader.sl ...`
void addCompile(CLI::App &, int &status);
/// `candela tex in.png out.tx`
void addTex(CLI::App &, int &status);
/// `candela probe scene.rib points`
void addProbe(CLI::App &, int &status);
/// `candela cat in.rib -o out.rib`
void addCat(CLI::App &, int &status);

/// `candela help WORD`
void addHelp(CLI::App &, int &status);
/// `candela info shader ...`
void addInfo(CLI::App &, int &status);
/// `candela run shader PARAM=VALUE ...`
void addRun(CLI::App &, int &status);

} // namespace candela
