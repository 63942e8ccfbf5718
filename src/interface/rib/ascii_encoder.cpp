// SPDX-License-Identifier: Apache-2.0
#include "interface/rib/rib_encoder.h"

#include <algorithm>
#include <array>
#include <charconv>

namespace candela {

namespace {

/// A request a line, blocks indented; long arrays go on in lines of their own. Floats have the
/// fewest digits that give them back.
class AsciiEncoder final : public RibEncoder {
public:
    void begin(std::string_view request, int depth) override {
        indentation_ = std::size_t(2 * std::min(depth, 20));
        lineStart_ = bytes.size();
        bytes.append(indentation_, ' ');
        bytes += request;
    }
    void end() override { bytes += '\n'; }
    void comment(const std::string &text) override {
        bytes += '#';
        bytes += text;
        bytes += '\n';
    }

    void number(float value) override { separate(), append(value); }
    void number(int value) override { separate(), append(value); }
    void string(const std::string &text) override { separate(), append(text); }
    void token(const std::string &text) override { string(text); }
    void array(std::span<const float> values) override { list(values); }
    void array(std::span<const int> values) override { list(values); }
    void array(const Strings &values) override { list(values); }

private:
    /// What is taken from `bytes` between two requests does not disturb.
    void separate() {
        constexpr std::size_t longest = 90;
        if (bytes.size() - lineStart_ < longest) {
            bytes += ' ';
            return;
        }
        bytes += '\n';
        lineStart_ = bytes.size();
        bytes.append(indentation_ + 4, ' ');
    }

    template <class Values> void list(const Values &values) {
        separate();
        bytes += '[';
        bool first = true;
        for (const auto &value : values) {
            if (!first)
                separate();
            first = false;
            append(value);
        }
        bytes += ']';
    }

    template <class Number> void append(Number value) {
        std::array<char, 32> digits;
        bytes.append(digits.data(),
                     std::to_chars(digits.begin(), digits.end(), value).ptr - digits.data());
    }

    void append(const std::string &text) {
        bytes += '"';
        for (const char c : text)
            appendEscaped((unsigned char)c);
        bytes += '"';
    }

    void appendEscaped(unsigned char c) {
        switch (c) {
        case '\n': bytes += "\\n"; break;
        case '\r': bytes += "\\r"; break;
        case '\t': bytes += "\\t"; break;
        case '\b': bytes += "\\b"; break;
        case '\f': bytes += "\\f"; break;
        case '"':
        case '\\': (bytes += '\\') += char(c); break;
        default:
            if (c >= ' ')
                bytes += char(c);
            else
                for (const int code :
                     {int('\\'), '0' + (c >> 6), '0' + (c >> 3 & 7), '0' + (c & 7)})
                    bytes += char(code);
        }
    }

    std::size_t lineStart_ = 0;
    std::size_t indentation_ = 0;
};

} // namespace

std::unique_ptr<RibEncoder> RibEncoder::ascii() { return std::make_unique<AsciiEncoder>(); }

} // namespace candela
