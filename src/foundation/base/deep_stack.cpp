// SPDX-License-Identifier: Apache-2.0
#include "foundation/base/deep_stack.h"

#include <pthread.h>

#include <cstddef>
#include <exception>
#include <new>

namespace candela {

namespace {

/// Room for 10,000 levels of three functions each, also as sanitizers make them.
constexpr std::size_t stackBytes = std::size_t(256) << 20;

thread_local bool isDeep = false;

struct Task {
    const std::function<void()> &work;
    std::exception_ptr thrown;
};

void *run(void *pointer) {
    Task &task = *static_cast<Task *>(pointer);
    isDeep = true;
    try {
        task.work();
    } catch (...) {
        task.thrown = std::current_exception();
    }
    return nullptr;
}

} // namespace

void onDeepStack(const std::function<void()> &work) {
    if (isDeep)
        return work();
    Task task{work, nullptr};
    pthread_attr_t attributes;
    pthread_t thread;
    pthread_attr_init(&attributes);
    pthread_attr_setstacksize(&attributes, stackBytes);
    const bool began = pthread_create(&thread, &attributes, run, &task) == 0;
    pthread_attr_destroy(&attributes);
    if (!began)
        throw std::bad_alloc();
    pthread_join(thread, nullptr);
    if (task.thrown)
        std::rethrow_exception(task.thrown);
}

} // namespace candela
