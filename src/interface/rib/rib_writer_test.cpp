// SPDX-License-Identifier: Apache-2.0
// What is written as RIB, ASCII or binary, makes the same calls when it is read.
#include "interface/rib/rib_writer.h"

#include "interface/ri/wide_integers.h"
#include "interface/rib/listing_sink.h"
#include "interface/rib/rib_stream.h"

#include <bit>
#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <limits>
#include <random>
#include <sstream>

namespace candela::testing {
namespace {

/// Requests by chance, with arguments by chance: the same from the same seed.
class RandomRequests {
public:
    explicit RandomRequests(unsigned seed) : random_(seed) {}

    void call(StreamSink &sink) {
        switch (RequestId(below(int(requestTable().size())))) {
#define RANDOM_ARGUMENT(type, name) , any<type>()
#define RANDOM(Name, handler, ...)                                                                 \
    case RequestId::Name:                                                                          \
        return sink.handler({} CANDELA_FOR_EACH(RANDOM_ARGUMENT, __VA_ARGS__));
#define REQUEST(Name, handler, scopes, ...) RANDOM(Name, handler, __VA_ARGS__)
#define REQUEST_OF_BLOCKS(Name, handler, scopes, ...) RANDOM(Name, handler, __VA_ARGS__)
#define REQUEST_OF_STREAM(Name, handler, scopes, ...) RANDOM(Name, handler, __VA_ARGS__)
#define REQUEST_LATER(Name, handler, scopes, consequence, ...) RANDOM(Name, handler, __VA_ARGS__)
#include "interface/ri/requests.def"
        }
    }

private:
    int below(int count) { return int(random_() % unsigned(count)); }

    template <class Type> Type any() {
        Type value{};
        fill(value);
        return value;
    }
    void fill(float &value) {
        const int kind = below(4);
        value = kind == 0   ? float(below(200) - 100)
                : kind == 1 ? float(below(20000) - 10000) / 64
                            : std::bit_cast<float>(std::uint32_t(random_()));
    }
    void fill(int &value) {
        const int sizes[] = {3, 200, 40000, 10000000, std::numeric_limits<int>::max()};
        value = below(sizes[below(5)]) * (below(2) ? 1 : -1);
    }
    void fill(bool &value) { value = below(2); }
    void fill(std::string &text) {
        const bool odd = below(4) == 0;
        text.resize(std::size_t(below(10) ? below(20) : below(2000)));
        for (char &c : text)
            c = odd ? char(below(256)) : char('a' + below(26));
    }
    void fill(Handle &handle) {
        handle.text = below(2) ? any<std::string>() : std::to_string(any<int>());
    }
    void fill(candela::Color &color) { fillAll(color.c); }
    void fill(Matrix4 &matrix) { fillAll(matrix.m); }
    void fill(BasisArgument &basis) {
        if (below(2))
            basis = any<std::string>();
        else
            fillAll(basis.emplace<1>());
    }
    void fill(LooseFloats &loose) { fill(loose.values); }
    void fill(SubdivisionTags &tags) {
        if (below(3))
            fill(tags.names), fill(tags.argumentCounts), fill(tags.integers), fill(tags.floats);
    }
    void fill(TokenValue &parameter) {
        // Some of the names come again.
        parameter.token = below(2) ? any<std::string>() : "P" + std::to_string(below(3));
        const int kind = below(3);
        if (kind == 0)
            fill(parameter.floats);
        else if (kind == 1)
            fill(parameter.strings);
        else
            fillWithIntegers(parameter);
    }
    void fillWithIntegers(TokenValue &parameter) {
        Integers integers;
        fill(integers);
        parameter.floats.assign(integers.begin(), integers.end());
        parameter.integers = wideIntegers(integers);
    }
    void fill(TokenList &list) {
        list.all.resize(std::size_t(below(4)));
        fillAll(list.all);
    }
    template <class Value> void fill(std::vector<Value> &values) {
        values.resize(std::size_t(below(10) ? below(12) : below(300)));
        fillAll(values);
    }
    template <class Values> void fillAll(Values &values) {
        for (auto &value : values)
            fill(value);
    }

    std::mt19937 random_;
};

struct Listed {
    std::string requests, comments, messages;
};

Listed listOf(const std::string &rib) {
    DiagnosticList found;
    ListingSink sink;
    readRibText(rib, "test.rib", sink, found);
    return {sink.list, sink.comments, found.text()};
}

template <class Requests> std::string written(RibEncoding encoding, Requests requests) {
    std::string text;
    const auto output = ByteOutput::toMemory(text);
    {
        RibWriter writer(*output, encoding);
        requests(writer);
    }
    EXPECT_EQ(output->close(), "");
    return text;
}

std::string rewritten(const std::string &rib, RibEncoding encoding) {
    return written(encoding, [&](RibWriter &writer) {
        DiagnosticList found;
        readRibText(rib, "test.rib", writer, found);
    });
}

TEST(RibWriter, whatIsWrittenMakesTheSameCalls) {
    for (unsigned seed = 0; seed < 1000; ++seed) {
        const auto requests = [&](StreamSink &sink) {
            RandomRequests random(seed);
            for (int i = 0; i < 20; ++i)
                random.call(sink);
        };
        ListingSink direct;
        requests(direct);
        const std::string ascii = written(RibEncoding::Ascii, requests);
        const std::string binary = written(RibEncoding::Binary, requests);
        const Listed ofAscii = listOf(ascii), ofBinary = listOf(binary);
        ASSERT_EQ(ofAscii.messages, "") << seed;
        ASSERT_EQ(ofBinary.messages, "") << seed;
        ASSERT_EQ(ofAscii.requests, direct.list) << seed;
        ASSERT_EQ(ofBinary.requests, direct.list) << seed;
        ASSERT_EQ(rewritten(rewritten(ascii, RibEncoding::Binary), RibEncoding::Ascii), ascii);
        ASSERT_LT(binary.size(), ascii.size());
    }
}

/// What stands in `values`, through both encodings.
void expectSameValues(const std::string &values, const std::string &expected) {
    for (const char *request :
         {"Attribute \"user\" \"uniform integer id\" ", "Attribute \"identifier\" \"id\" ",
          "Option \"user\" \"int n\" ", "Surface \"matte\" \"Kd\" ", "Points \"P\" "}) {
        const std::string ascii = rewritten(request + values, RibEncoding::Ascii);
        EXPECT_EQ(ascii, request + expected + "\n");
        const std::string binary = rewritten(request + values, RibEncoding::Binary);
        EXPECT_EQ(rewritten(binary, RibEncoding::Ascii), ascii);
        EXPECT_EQ(rewritten(rewritten(ascii, RibEncoding::Binary), RibEncoding::Binary), binary);
        EXPECT_EQ(listOf(binary).requests, listOf(request + values).requests);
    }
}

TEST(RibWriter, integersThatFloatsCannotHoldStayWhatTheyAre) {
    const std::pair<const char *, const char *> rows[] = {
        {"16777216", "[16777216]"},
        {"16777217", "[16777217]"},
        {"[-16777217]", "[-16777217]"},
        {"[1 2 123456789 -4 33554433 0]", "[1 2 123456789 -4 33554433 0]"},
        {"[2147483647 -2147483648]", "[2147483647 -2147483648]"},
        {"[16777217 3.0 1e3]", "[16777217 3 1000]"},
        {"[+16777217 007]", "[16777217 7]"},
        // With others beside them they are what floats make of them, as they are beyond ints.
        {"[16777217 .5]", "[16777216 0.5]"},
        {"[.5 16777217]", "[0.5 16777216]"},
        {"[16777217 -0.0]", "[16777216 -0]"},
        {"[16777217.0]", "[16777216]"},
        {"[16777217 1e30]", "[16777216 1e+30]"},
        {"[16777217 nan]", "[16777216 nan]"},
        {"[16777217 2147483648]", "[16777216 2147483648]"},
    };
    for (const auto &[values, expected] : rows)
        expectSameValues(values, expected);
}

/// Beyond what the lexer takes at once, with few and with many of them.
TEST(RibWriter, integersOfLongListsStayWhatTheyAre) {
    for (const int step : {1, 7, 40000}) {
        Integers integers(100000);
        for (int i = 0; i < 100000; ++i)
            integers[std::size_t(i)] = i % step == 0 ? 1000000007 - i : i;
        const auto request = [&](StreamSink &sink) {
            sink.attribute({}, "user",
                           {{{"ids", {}, Floats(integers.begin(), integers.end()), {}, integers}}});
        };
        ListingSink direct;
        request(direct);
        for (const RibEncoding encoding : {RibEncoding::Ascii, RibEncoding::Binary})
            EXPECT_TRUE(listOf(written(encoding, request)).requests == direct.list) << step;
    }
}

TEST(RibWriter, everyRibOfTheProjectGoesRound) {
    namespace fs = std::filesystem;
    int files = 0;
    for (const char *folder : {"examples", "tests", "bench"})
        for (const auto &entry :
             fs::recursive_directory_iterator(fs::path(CANDELA_SOURCE_DIR) / folder)) {
            if (entry.path().extension() != ".rib")
                continue;
            std::ifstream file(entry.path(), std::ios::binary);
            std::stringstream rib;
            rib << file.rdbuf();
            const Listed original = listOf(rib.str());
            const std::string ascii = rewritten(rib.str(), RibEncoding::Ascii);
            const std::string binary = rewritten(ascii, RibEncoding::Binary);
            const Listed ofAscii = listOf(ascii), ofBinary = listOf(binary);
            EXPECT_EQ(ofAscii.requests, original.requests) << entry.path();
            EXPECT_EQ(ofBinary.requests, original.requests) << entry.path();
            EXPECT_EQ(ofAscii.comments, original.comments) << entry.path();
            EXPECT_EQ(ofBinary.comments, original.comments) << entry.path();
            EXPECT_EQ(ofBinary.messages, "") << entry.path();
            EXPECT_EQ(rewritten(binary, RibEncoding::Ascii), ascii) << entry.path();
            ++files;
        }
    EXPECT_GT(files, 10);
}

TEST(RibWriter, asciiIsForPeople) {
    const std::string rib =
        "##RenderMan RIB\nversion 3.03\nFrameBegin 1 Format 640 480 -1\n"
        "WorldBegin # the world\nColor 1 .5 0.25 Surface \"mat\\\"te\" \"Kd\" .1\n"
        "IfBegin \"$a\" Sphere 1 -1 1 360 Else DepthOfField IfEnd\n"
        "Basis \"bezier\" 3 \"b-spline\" 1 LightSource \"l\" 1 LightSource \"l\" "
        "\"01\" WorldEnd FrameEnd";
    EXPECT_EQ(rewritten(rib, RibEncoding::Ascii), "##RenderMan RIB\n"
                                                  "version 3.03\n"
                                                  "FrameBegin 1\n"
                                                  "  Format 640 480 -1\n"
                                                  "  WorldBegin\n"
                                                  "# the world\n"
                                                  "    Color [1 0.5 0.25]\n"
                                                  "    Surface \"mat\\\"te\" \"Kd\" [0.1]\n"
                                                  "    IfBegin \"$a\"\n"
                                                  "      Sphere 1 -1 1 360\n"
                                                  "    Else\n"
                                                  "      DepthOfField\n"
                                                  "    IfEnd\n"
                                                  "    Basis \"bezier\" 3 \"b-spline\" 1\n"
                                                  "    LightSource \"l\" 1\n"
                                                  "    LightSource \"l\" \"01\"\n"
                                                  "  WorldEnd\n"
                                                  "FrameEnd\n");
}

} // namespace
} // namespace candela::testing
