// SPDX-License-Identifier: Apache-2.0
// The encodings are listed in binary_tokens.cpp.
#include "interface/rib/rib_encoder.h"

#include <bit>
#include <cmath>
#include <cstdint>
#include <unordered_map>

namespace candela {

namespace {

class BinaryEncoder final : public RibEncoder {
public:
    void begin(std::string_view request, int) override {
        const auto [known, isNew] = requests_.try_emplace(request, int(requests_.size()));
        if (isNew) {
            put(0314), put(known->second);
            string(std::string(request));
        }
        put(0246), put(known->second);
    }
    void end() override {}
    void comment(const std::string &text) override { bytes += '#' + text + '\n'; }

    void number(float value) override {
        // What is short as an integer: most numbers that people write.
        if (value == std::floor(value) && std::fabs(value) < 32768 &&
            !(value == 0 && std::signbit(value)))
            return number(int(value));
        put(0244);
        putBigEndian(std::bit_cast<std::uint32_t>(value), 4);
    }
    void number(int value) override {
        const std::int64_t wide = value;
        int size = 1;
        while (wide < -(std::int64_t(1) << (8 * size - 1)) || wide >= std::int64_t(1)
                                                                          << (8 * size - 1))
            ++size;
        put(0200 + size - 1);
        putBigEndian(std::uint32_t(value), size);
    }
    void string(const std::string &text) override {
        if (text.size() < 16)
            put(0220 + int(text.size()));
        else
            putLength(0240, text.size());
        bytes += text;
    }
    void token(const std::string &text) override {
        constexpr std::size_t mostTokens = 1 << 16, longest = 1 << 10;
        auto known = tokens_.find(text);
        if (known == tokens_.end()) {
            if (tokens_.size() == mostTokens || text.size() > longest)
                return string(text);
            known = tokens_.emplace(text, int(tokens_.size())).first;
            putNumbered(0315, known->second);
            string(text);
        }
        putNumbered(0317, known->second);
    }
    void array(std::span<const float> values) override {
        putLength(0310, values.size());
        const std::size_t before = bytes.size();
        bytes.resize(before + 4 * values.size());
        char *to = bytes.data() + before;
        for (const float value : values) {
            const auto bits = std::bit_cast<std::uint32_t>(value);
            for (int shift = 24; shift >= 0; shift -= 8)
                *to++ = char(bits >> shift);
        }
    }
    void array(std::span<const int> values) override {
        bytes += '[';
        for (const int value : values)
            number(value);
        bytes += ']';
    }
    void array(const Strings &values) override {
        bytes += '[';
        for (const std::string &value : values)
            string(value);
        bytes += ']';
    }

private:
    void put(int byte) { bytes += char(byte); }
    void putBigEndian(std::uint32_t value, int size) {
        for (int shift = 8 * (size - 1); shift >= 0; shift -= 8)
            put(int(value >> shift));
    }
    void putLength(int code, std::size_t length) {
        int size = 1;
        while (size < 4 && length >> 8 * size)
            ++size;
        put(code + size - 1);
        putBigEndian(std::uint32_t(length), size);
    }
    void putNumbered(int code, int number) {
        const int size = number < 256 ? 1 : 2;
        put(code + size - 1);
        putBigEndian(std::uint32_t(number), size);
    }

    std::unordered_map<std::string_view, int> requests_; ///< Their codes; they are in the table.
    std::unordered_map<std::string, int> tokens_;
};

} // namespace

std::unique_ptr<RibEncoder> RibEncoder::binary() { return std::make_unique<BinaryEncoder>(); }

} // namespace candela
