// SPDX-License-Identifier: Apache-2.0
// The cache by itself, and as Jit uses it.
#include "language/ir/core/builder_arithmetic.h"
#include "language/ir/core/builder_effects.h"
#include "language/ir/core/builder_sources.h"
#include "language/jit/object_cache.h"

#include "language/ir/core/builder.h"
#include "language/ir/interpret/test_batch.h"
#include "language/jit/jit.h"

#include <gtest/gtest.h>

#include <chrono>
#include <fstream>
#include <thread>

namespace candela {
namespace {

namespace fs = std::filesystem;

class ObjectCacheTest : public testing::Test {
protected:
    ObjectCacheTest()
        : folder_(fs::path(CANDELA_BINARY_DIR) / "cache-test" /
                  testing::UnitTest::GetInstance()->current_test_info()->name()) {
        fs::remove_all(folder_);
    }
    ~ObjectCacheTest() override { fs::remove_all(folder_); }

    JitOptions options() const {
        JitOptions options;
        options.cacheFolder = folder_.string();
        return options;
    }
    std::vector<fs::path> files() const {
        std::vector<fs::path> found;
        for (const auto &entry : fs::directory_iterator(folder_))
            found.push_back(entry.path());
        return found;
    }
    static ir::Function adding(float term) {
        ir::Function function;
        ir::Builder b(function);
        output(b, "y", 0, add(b, input(b, ShaderInput::P), number(b, term)));
        b.finish();
        return function;
    }
    static void expectAdds(ShaderFunction code, float number) {
        ASSERT_NE(code, nullptr);
        const ir::Function function = adding(number);
        ir::TestBatch batch(function, 19, 1);
        const auto out =
            batch.run(function, [&](const ir::Function &, const ShaderArgs &args) { code(&args); });
        for (int i = 0; i < batch.count; ++i)
            EXPECT_EQ(out[0][i], batch.inputs[int(ShaderInput::P)][i] + number);
    }

    fs::path folder_;
    DiagnosticList diagnostics_;
};

TEST_F(ObjectCacheTest, GivesBackWhatWasStored) {
    ObjectCache cache(folder_);
    EXPECT_FALSE(cache.load("key"));
    cache.store("key", std::string("a\0b\n", 4));
    EXPECT_EQ(cache.load("key"), std::string("a\0b\n", 4));
    EXPECT_FALSE(cache.load("other"));
}

TEST_F(ObjectCacheTest, RemovesTheOldestBeyondItsLimit) {
    ObjectCache cache(folder_, 1000);
    for (int k = 0; k < 10; ++k) {
        cache.store(std::to_string(k), std::string(300, 'x'));
        fs::last_write_time(folder_ / (std::to_string(k) + ".object"),
                            fs::file_time_type::clock::now() - std::chrono::hours(20 - k));
    }
    EXPECT_LE(files().size(), 3u);
    EXPECT_TRUE(cache.load("8"));
    EXPECT_FALSE(cache.load("0"));
}

/// One file of a size that nothing here has, as a damaged disk may show it, is neither read nor a
/// reason for others to go.
TEST_F(ObjectCacheTest, RemovesWhatIsTooLargeUnread) {
    ObjectCache cache(folder_, 1000);
    for (const char *key : {"large", "other"})
        cache.store(key, std::string(300, 'x'));
    fs::resize_file(folder_ / "large.object", std::uintmax_t(20) << 30); // Of holes.
    EXPECT_FALSE(cache.load("large"));
    EXPECT_FALSE(fs::exists(folder_ / "large.object"));
    cache.store("large", "x");
    fs::resize_file(folder_ / "large.object", std::uintmax_t(20) << 30);
    ObjectCache(folder_, 1000).store("new", "x"); // Measures the folder.
    EXPECT_FALSE(fs::exists(folder_ / "large.object"));
    EXPECT_TRUE(cache.load("other"));
}

TEST_F(ObjectCacheTest, ServesASecondJit) {
    for (int round = 0; round < 2; ++round) {
        Jit jit(options(), diagnostics_);
        expectAdds(jit.compile(adding(2)), 2);
        expectAdds(jit.compile(adding(2)), 2);
        expectAdds(jit.compile(adding(3)), 3);
        EXPECT_EQ(jit.statistics().compiled, round == 0 ? 2 : 0);
        EXPECT_EQ(jit.statistics().fromCache, round == 0 ? 0 : 2);
    }
    EXPECT_EQ(files().size(), 2u);
}

TEST_F(ObjectCacheTest, TellsWidthsAndCpusApart) {
    JitOptions narrow = options(), old = options();
    narrow.width = 1;
    old.cpu = "x86-64-v2";
    for (const JitOptions &each : {options(), narrow, old}) {
        Jit jit(each, diagnostics_);
        expectAdds(jit.compile(adding(1)), 1);
        EXPECT_EQ(jit.statistics().compiled, 1);
    }
}

TEST_F(ObjectCacheTest, CompilesAnewWhatIsDamaged) {
    const auto damage = [&](int kind) {
        const fs::path file = files().at(0);
        if (kind == 0)
            return fs::resize_file(file, fs::file_size(file) / 2);
        if (kind == 1)
            return fs::resize_file(file, 0);
        std::fstream stream(file, std::ios::in | std::ios::out | std::ios::binary);
        stream.seekp(400);
        stream.put('\x5a').put('\xa5');
    };
    for (int kind = -1; kind < 3; ++kind) {
        if (kind >= 0)
            damage(kind);
        Jit jit(options(), diagnostics_);
        expectAdds(jit.compile(adding(4)), 4);
        EXPECT_EQ(jit.statistics().compiled, 1);
    }
    Jit jit(options(), diagnostics_);
    expectAdds(jit.compile(adding(4)), 4);
    EXPECT_EQ(jit.statistics().fromCache, 1);
}

/// The key of the one object in the folder.
std::string onlyKey(const std::vector<fs::path> &files) { return files.at(0).stem().string(); }

TEST_F(ObjectCacheTest, CompilesAnewWhatIsNoObjectOfTheKeyThoughItsChecksumIsRight) {
    std::string other;
    {
        Jit jit(options(), diagnostics_);
        expectAdds(jit.compile(adding(5)), 5);
        const std::string key = onlyKey(files());
        other = *ObjectCache(folder_).load(key);
        fs::remove_all(folder_);
    }
    { Jit(options(), diagnostics_).compile(adding(6)); }
    const std::string key = onlyKey(files());
    const std::string good = *ObjectCache(folder_).load(key);
    // Not an object; half of one; one whose symbol has another name; one that calls what isn't.
    std::string calling = good;
    for (std::size_t at; (at = calling.find("shader_" + key)) != std::string::npos;)
        calling[at] = 'x';
    for (const std::string &bad :
         {std::string("not an object"), good.substr(0, good.size() / 2), other, calling}) {
        ObjectCache(folder_).store(key, bad);
        for (int round = 0; round < 2; ++round) {
            Jit jit(options(), diagnostics_);
            expectAdds(jit.compile(adding(6)), 6);
            EXPECT_EQ(jit.statistics().compiled, round == 0 ? 1 : 0);
            EXPECT_EQ(jit.statistics().fromCache, round);
        }
    }
    EXPECT_EQ(diagnostics_.text(), "");
}

TEST_F(ObjectCacheTest, TakesNoOtherKeysObject) {
    ObjectCache cache(folder_);
    cache.store("one", "bytes");
    fs::copy_file(folder_ / "one.object", folder_ / "two.object");
    fs::permissions(folder_ / "two.object", fs::perms::owner_read);
    EXPECT_TRUE(cache.load("one"));
    EXPECT_FALSE(cache.load("two"));
}

TEST_F(ObjectCacheTest, IsTheUsersOwn) {
    ObjectCache(folder_).store("key", "bytes");
    EXPECT_EQ(fs::status(folder_).permissions(), fs::perms::owner_all);
    EXPECT_EQ(fs::status(folder_ / "key.object").permissions(),
              fs::perms::owner_read | fs::perms::owner_write);
}

TEST_F(ObjectCacheTest, IsNotUsedIfOthersMayWriteToIt) {
    ObjectCache(folder_).store("key", "bytes");
    for (const fs::perms open : {fs::perms::group_write, fs::perms::others_write}) {
        fs::permissions(folder_, fs::perms::owner_all | open);
        ObjectCache cache(folder_);
        EXPECT_FALSE(cache.load("key"));
        cache.store("new", "bytes");
        EXPECT_NE(cache.takeObjection().find("can be written by others"), std::string::npos);
        EXPECT_EQ(cache.takeObjection(), "");
        EXPECT_EQ(files().size(), 1u);
    }
    fs::permissions(folder_, fs::perms::owner_all);
    EXPECT_TRUE(ObjectCache(folder_).load("key"));
    fs::permissions(folder_ / "key.object", fs::perms::owner_all | fs::perms::group_write);
    EXPECT_FALSE(ObjectCache(folder_).load("key"));
}

TEST_F(ObjectCacheTest, FollowsNoLinks) {
    const fs::path outside = folder_ / "outside";
    ObjectCache(outside).store("key", "bytes");
    ObjectCache cache(folder_ / "cache");
    cache.store("other", "bytes");
    fs::create_symlink(outside / "key.object", folder_ / "cache" / "key.object");
    EXPECT_TRUE(ObjectCache(outside).load("key"));
    EXPECT_FALSE(cache.load("key"));
    cache.store("key", "new"); // In place of the link.
    EXPECT_EQ(cache.load("key"), "new");
    EXPECT_EQ(ObjectCache(outside).load("key"), "bytes");
}

TEST_F(ObjectCacheTest, WarnsOnceOfAFolderThatIsNotUsed) {
    fs::create_directories(folder_);
    fs::permissions(folder_, fs::perms::all);
    Jit jit(options(), diagnostics_);
    expectAdds(jit.compile(adding(7)), 7);
    expectAdds(jit.compile(adding(8)), 8);
    EXPECT_EQ(diagnostics_.count(Severity::Warning), 1);
    EXPECT_TRUE(files().empty());
}

TEST_F(ObjectCacheTest, KeepsFunctionsThatAreCompiledTogether) {
    const ir::Function two[] = {adding(1), adding(2)};
    const ir::Function *const both[] = {&two[0], &two[1]};
    for (int round = 0; round < 2; ++round) {
        Jit jit(options(), diagnostics_);
        const auto codes = jit.compile(both, diagnostics_);
        ASSERT_EQ(codes.size(), 2u);
        expectAdds(codes[0], 1);
        expectAdds(codes[1], 2);
        EXPECT_EQ(jit.statistics().fromCache, 2 * round);
    }
    EXPECT_EQ(files().size(), 1u);
}

TEST_F(ObjectCacheTest, IsDoneWithoutWhereTheFolderCannotBe) {
    fs::create_directories(folder_);
    std::ofstream(folder_ / "file") << "no folder";
    JitOptions impossible = options();
    impossible.cacheFolder = (folder_ / "file" / "cache").string();
    Jit jit(impossible, diagnostics_);
    expectAdds(jit.compile(adding(5)), 5);
    EXPECT_EQ(diagnostics_.count(Severity::Error), 0);
}

TEST_F(ObjectCacheTest, ServesThreadsAndJitsAtOnce) {
    Jit first(options(), diagnostics_), second(options(), diagnostics_);
    std::vector<std::thread> threads;
    for (int t = 0; t < 8; ++t)
        threads.emplace_back([&, t] {
            for (int k = 0; k < 6; ++k) {
                const float number = float((t + k) % 6);
                expectAdds((t % 2 ? first : second).compile(adding(number)), number);
            }
        });
    for (std::thread &thread : threads)
        thread.join();
    for (Jit *jit : {&first, &second})
        EXPECT_EQ(jit->statistics().compiled + jit->statistics().fromCache, 6);
    EXPECT_EQ(files().size(), 6u);
    EXPECT_EQ(diagnostics_.text(), "");
}

} // namespace
} // namespace candela
