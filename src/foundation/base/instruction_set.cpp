// SPDX-License-Identifier: Apache-2.0
// Which clone of a CANDELA_HOT function runs is decided before main: the dynamic loader calls the
// resolver that GCC wrote beside it, the resolver has libgcc's __cpu_indicator_init ask the
// processor, and takes the best clone that __cpu_features2 allows. The linker's --wrap (base's
// CMakeLists.txt) sends that call here: libgcc looks first, then what lies above the level asked
// for is hidden. So one decision stands behind every clone, and what instructionSet() tells others
// cannot differ from what the loader did.
//
// Resolvers run while the program is being relocated. Nothing here may call a shared library, the
// C library among them, or need a relocation: the kernel is asked directly. The command line is
// read as well as the environment, so that no option needs a second start of the program, which
// would also leave an emulator.
#include "foundation/base/instruction_set.h"

#include <sys/syscall.h>

extern "C" {
/// libgcc's, for resolvers; its first word belongs to features 32 to 63.
extern unsigned __cpu_features2[] __attribute__((visibility("hidden")));
int __real___cpu_indicator_init();
int __wrap___cpu_indicator_init();
}

namespace candela {

namespace {

// Where GCC's enum processor_features has FEATURE_X86_64_V3 and _V4; instruction_set_test.cpp
// fails with a compiler that has them elsewhere.
constexpr int levelsWord = 2;
constexpr unsigned v3Bit = 1u << 1, v4Bit = 1u << 2;

bool decided = false;
InstructionSet host = InstructionSet::V2, inForce = InstructionSet::V2;

long systemCall(long number, long a, long b, long c) {
    long result;
    asm volatile("syscall"
                 : "=a"(result)
                 : "a"(number), "D"(a), "S"(b), "d"(c)
                 : "rcx", "r11", "memory");
    return result;
}

/// The bytes of a file, one after the other.
class Bytes {
public:
    explicit Bytes(const char *path) : file_(systemCall(SYS_open, long(path), 0, 0)) {}
    ~Bytes() {
        if (file_ >= 0)
            systemCall(SYS_close, file_, 0, 0);
    }
    Bytes(const Bytes &) = delete;
    Bytes &operator=(const Bytes &) = delete;

    /// -1 after the last, and where the file cannot be read.
    int next() {
        if (at_ == end_) {
            at_ = 0;
            end_ = file_ < 0 ? 0 : systemCall(SYS_read, file_, long(buffer_), sizeof buffer_);
            if (end_ <= 0)
                return end_ = 0, -1;
        }
        return static_cast<unsigned char>(buffer_[at_++]);
    }

private:
    long file_, at_ = 0, end_ = 0;
    char buffer_[1024];
};

/// Looks in a list of words that end with 0 for "key=v3" or "key", "v3". True if there is such a
/// key; a value that names no level asks for the best, and the program that reads its options
/// complains.
bool find(const char *path, const char *key, InstructionSet &level) {
    Bytes bytes(path);
    for (int c = bytes.next(); c >= 0; c = c == 0 ? bytes.next() : c) {
        const char *k = key;
        for (; *k && c == *k; ++k)
            c = bytes.next();
        if (!*k && (c == '=' || c == 0)) {
            const int letter = bytes.next(), digit = letter > 0 ? bytes.next() : 0;
            const bool named = letter == 'v' && digit >= '2' && digit <= '4' && bytes.next() <= 0;
            level = named ? InstructionSet(digit - '2') : InstructionSet::V4;
            return true;
        }
        while (c > 0)
            c = bytes.next();
    }
    return false;
}

void decide() {
    const unsigned levels = __cpu_features2[levelsWord];
    host = levels & v4Bit   ? InstructionSet::V4
           : levels & v3Bit ? InstructionSet::V3
                            : InstructionSet::V2;
    InstructionSet wanted = InstructionSet::V4;
    if (!find("/proc/self/cmdline", "--cpu", wanted))
        find("/proc/self/environ", "CANDELA_CPU", wanted);
    inForce = wanted < host ? wanted : host;
    if (inForce < InstructionSet::V4)
        __cpu_features2[levelsWord] &= ~v4Bit;
    if (inForce < InstructionSet::V3)
        __cpu_features2[levelsWord] &= ~v3Bit;
    decided = true;
}

} // namespace

InstructionSet hostInstructionSet() {
    __builtin_cpu_init();
    return host;
}

InstructionSet instructionSet() {
    __builtin_cpu_init();
    return inForce;
}

const char *nameOf(InstructionSet level) {
    return level == InstructionSet::V4 ? "v4" : level == InstructionSet::V3 ? "v3" : "v2";
}

std::optional<InstructionSet> instructionSetOf(std::string_view name) {
    for (InstructionSet level : {InstructionSet::V2, InstructionSet::V3, InstructionSet::V4})
        if (name == nameOf(level))
            return level;
    return std::nullopt;
}

} // namespace candela

int __wrap___cpu_indicator_init() {
    const int result = __real___cpu_indicator_init();
    if (!candela::decided)
        candela::decide();
    return result;
}
