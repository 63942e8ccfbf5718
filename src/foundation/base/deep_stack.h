// SPDX-License-Identifier: Apache-2.0
// A stack for passes that go down trees by recursion: a tree may be as high as a generated text is
// long, and the stacks of main and worker threads hold some megabytes.
#pragma once

#include <functional>

namespace candela {

/// Does the work on a stack of its own, which takes memory only as far as it is used, and waits for
/// it; within such work, at once. What it throws comes out of here. Throws std::bad_alloc if there
/// is no room for a stack.
void onDeepStack(const std::function<void()> &work);

} // namespace candela
