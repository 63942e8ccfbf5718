// SPDX-License-Identifier: Apache-2.0
// Binary RIB (RI 3.2, appendix C.2), alone and mixed with ASCII; truncated and senseless bytes.
#include "interface/rib/lexer.h"
#include "interface/rib/reading_fixture.h"

#include <cmath>
#include <random>

namespace candela::testing {

namespace {

/// The tokens as text, and the messages.
struct Decoded {
    std::string text;
    DiagnosticList found;

    explicit Decoded(const std::string &bytes, bool endAtMark = false) {
        Lexer lexer(ByteSource::fromMemory(bytes), "test.rib", found);
        if (endAtMark)
            lexer.endAtMark();
        RibToken token;
        for (lexer.next(token); token.kind != TokenKind::End; lexer.next(token))
            switch (token.kind) {
            case TokenKind::Request: text += "R(" + token.text + ")"; break;
            case TokenKind::Number:
                text += (token.whole ? "I(" : "N(") + std::to_string(token.number) + ")";
                break;
            case TokenKind::String: text += "S(" + token.text + ")"; break;
            case TokenKind::ArrayBegin: text += "["; break;
            case TokenKind::ArrayEnd: text += "]"; break;
            case TokenKind::End: break;
            }
    }
};

/// Bytes that may be zero.
template <std::size_t n> std::string bytes(const char (&literal)[n]) { return {literal, n - 1}; }

const std::string quarter = bytes("\244\076\200\000\000"), half = bytes("\244\077\000\000\000");

} // namespace

TEST(Binary, everyEncodingIsDecoded) {
    const struct {
        std::string bytes;
        const char *expected;
    } cases[] = {
        {bytes("\200\004"), "I(4.000000)"},
        {bytes("\200\377"), "I(-1.000000)"},
        {bytes("\201\001\002"), "I(258.000000)"},
        {bytes("\201\377\376"), "I(-2.000000)"},
        {bytes("\202\001\000\000"), "I(65536.000000)"},
        {bytes("\203\200\000\000\000"), "I(-2147483648.000000)"},
        {bytes("\204\200"), "N(-0.500000)"},    // One byte, all of it a fraction.
        {bytes("\205\001\200"), "N(1.500000)"}, // Two bytes, one of them.
        {bytes("\205\376\200"), "N(-1.500000)"},
        {bytes("\213\000\001\100\000"), "N(1.250000)"},  // Four bytes, two of them.
        {bytes("\217\100\000\000\000"), "N(64.000000)"}, // Four bytes, three of them.
        {bytes("\220"), "S()"},
        {bytes("\223abc"), "S(abc)"},
        {bytes("\237") + std::string(15, 'x'), "S(xxxxxxxxxxxxxxx)"},
        {bytes("\240\003abc"), "S(abc)"},
        {bytes("\241\000\003abc"), "S(abc)"},
        {bytes("\242\000\000\003abc"), "S(abc)"},
        {bytes("\243\000\000\000\003abc"), "S(abc)"},
        {bytes("\223\"\\\n"), "S(\"\\\n)"}, // Nothing is special in them.
        {bytes("\244\277\200\000\000"), "N(-1.000000)"},
        {bytes("\245\077\360\000\000\000\000\000\000"), "N(1.000000)"},
        {bytes("\314\007\226Sphere\246\007\200\001"), "R(Sphere)I(1.000000)"},
        {bytes("\314\000\"Disk\"\246\000"), "R(Disk)"}, // In ASCII quotes.
        {bytes("\314\001\226Sphere\314\001\224Disk\246\001"), "R(Disk)"},
        {bytes("\310\000"), "[]"},
        {bytes("\310\002\077\200\000\000\100\000\000\000"), "[N(1.000000)N(2.000000)]"},
        {bytes("\311\000\001\077\200\000\000"), "[N(1.000000)]"},
        {bytes("\312\000\000\001\077\200\000\000"), "[N(1.000000)]"},
        {bytes("\313\000\000\000\001\077\200\000\000"), "[N(1.000000)]"},
        {bytes("\315\005\221P\317\005\317\005"), "S(P)S(P)"},
        {bytes("\316\001\005\221Q\320\001\005"), "S(Q)"},
        {bytes("\315\005\221P\316\000\005\221Q\317\005"), "S(Q)"}, // One table.
        {bytes("\377\200\001\377"), "I(1.000000)"},
        {"Sphere\200\001[\200\002 3]\221P \"Q\"4",
         "R(Sphere)I(1.000000)[I(2.000000)I(3.000000)]S(P)S(Q)"
         "I(4.000000)"},
        {"# caf\351\n\200\001#\377\r\200\002", "I(1.000000)I(2.000000)"},
        {"\"caf\351\"", "S(caf\351)"},
    };
    for (const auto &each : cases) {
        const Decoded decoded(each.bytes);
        EXPECT_EQ(decoded.text, each.expected);
        EXPECT_EQ(decoded.found.text(), "") << each.expected;
    }
    EXPECT_EQ(Decoded(bytes("\200\001\377\200\002"), true).text, "I(1.000000)");
}

TEST(Binary, whatIsCutShortOrMeansNothingIsSaidOnce) {
    for (const std::string &whole :
         {bytes("\200\004"), bytes("\203\001\002\003\004"), bytes("\223abc"), bytes("\240\003abc"),
          bytes("\243\000\000\000\003abc"), quarter, bytes("\245\077\360\000\000\000\000\000\000"),
          bytes("\310\002\077\200\000\000\100\000\000\000"), bytes("\314\001\226Sphere"),
          bytes("\315\005\221P"), bytes("\316\001\005\221Q")})
        for (std::size_t length = 1; length < whole.size(); ++length)
            EXPECT_EQ(Decoded(whole.substr(0, length)).found.count(Severity::Error), 1)
                << int((unsigned char)whole[0]) << ", " << length;
    EXPECT_NE(Decoded("\317\001").found.text().find("no string has the number 1"),
              std::string::npos);
    EXPECT_EQ(Decoded("\247\260\307\321\376").found.count(Severity::Error), 1);
    EXPECT_EQ(Decoded("\246\003").text, "R(of code 3)");
    EXPECT_EQ(Decoded("\314\003\200\001 Disk").found.count(Severity::Error), 1);
}

// Lengths and counts that a file claims are worth what it holds.
TEST(Binary, claimsTakeNoMemory) {
    Decoded string(bytes("\243\377\377\377\377abc"));
    EXPECT_EQ(string.text, "S(abc)");
    EXPECT_EQ(string.found.count(Severity::Error), 1);
    Decoded array(bytes("\313\377\377\377\377\077\200\000\000"));
    EXPECT_EQ(array.text, "[N(1.000000)]");
    EXPECT_EQ(array.found.count(Severity::Error), 1);
}

TEST(Binary, referencesToStringsAreBounded) {
    std::string bomb = bytes("\315\001\241\377\377") + std::string(0xFFFF, 'x');
    for (int i = 0; i < 20000; ++i)
        bomb += "\317\001";
    DiagnosticList found;
    Lexer lexer(ByteSource::fromMemory(bomb), "test.rib", found);
    RibToken token;
    std::size_t sum = 0;
    for (lexer.next(token); token.kind != TokenKind::End; lexer.next(token))
        sum += token.text.size();
    EXPECT_LT(sum, std::size_t(80) << 20);
    EXPECT_EQ(found.count(Severity::Error), 1);
}

TEST(Binary, anyBytesEnd) {
    std::mt19937 random(1);
    for (int i = 0; i < 3000; ++i) {
        std::string any(random() % 200, ' ');
        for (char &byte : any)
            byte = char(random() % 4 ? 0200 + random() % 0200 : random());
        const Decoded decoded(any);
        EXPECT_LT(decoded.text.size(), 100000u);
    }
}

TEST_F(Reading, binaryScenesAreTheirAsciiOnes) {
    const std::string square = bytes("\310\014") + // -1 -1 1  -1 1 1  1 1 1  1 -1 1
                               bytes("\277\200\0\0\277\200\0\0\077\200\0\0") +
                               bytes("\277\200\0\0\077\200\0\0\077\200\0\0") +
                               bytes("\077\200\0\0\077\200\0\0\077\200\0\0") +
                               bytes("\077\200\0\0\277\200\0\0\077\200\0\0");
    read(bytes("\314\001\226Format\246\001\200\004\200\005\200\001WorldBegin Color[") + quarter +
         half + bytes("\200\001]\315\011\221PPolygon\317\011") + square +
         bytes("PointsPolygons[\200\004][\200\000\200\001\200\002\200\003]\317\011") + square +
         "WorldEnd");
    EXPECT_EQ(found.text(), "");
    const auto &world = builder.worlds.back();
    EXPECT_EQ(world.options.format.xResolution, 4);
    EXPECT_EQ(world.options.format.yResolution, 5);
    ASSERT_EQ(world.primitives.size(), 2u);
    EXPECT_EQ(world.primitives[0].attributes->color, Color(.25f, .5f, 1));
    for (const auto &primitive : world.primitives) {
        const Parameter *P = primitive.record->variables.find("P");
        ASSERT_TRUE(P);
        EXPECT_EQ(P->floats, (std::vector<float>{-1, -1, 1, -1, 1, 1, 1, 1, 1, 1, -1, 1}));
    }
}

TEST_F(Reading, requestsFollowBadBinaryOnes) {
    const auto seen = world(bytes("Sphere \200\001\246\007\200\001\221x\317\003 Disk 0 1 360"));
    EXPECT_TRUE(says("Sphere: expected a number for 'zMin' (argument 2), found 'of code 7'"));
    EXPECT_EQ(seen.primitives.size(), 1u);
}

} // namespace candela::testing
