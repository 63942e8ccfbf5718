// SPDX-License-Identifier: Apache-2.0
// From the codes of RiBlobby to a field.
#include "world/geometry/blob_field.h"

#include <cmath>
#include <string>

namespace candela {

class BlobField::Parser {
public:
    Parser(const BlobbyRecord &record, const SourceLocation &where, DiagnosticSink &sink)
        : record_(record), where_(where), sink_(sink) {}

    std::optional<BlobField> parse() {
        while (at_ < record_.codes.size() && error_.empty())
            parseInstruction();
        if (error_.empty() && field_.instructions_.empty())
            error_ = "has no codes";
        if (error_.empty() && leaves_ != record_.leaves)
            sink_.warning(where_, "the blobby says that it has " + std::to_string(record_.leaves) +
                                      " primitive blobs, but has " + std::to_string(leaves_));
        if (!error_.empty()) {
            sink_.error(where_, "the blobby " + error_ + "; it is dropped");
            return std::nullopt;
        }
        field_.leaves_ = record_.leaves;
        return std::move(field_);
    }

private:
    void fail(const std::string &why) {
        if (error_.empty())
            error_ = why;
    }

    int next() {
        if (at_ < record_.codes.size())
            return record_.codes[at_++];
        fail("ends within an instruction");
        return 0;
    }

    /// So many floats from a place that a code names; null if they are not all there.
    const float *floats(std::size_t count) {
        const int first = next();
        if (first < 0 || std::size_t(first) + count > record_.floats.size()) {
            fail("needs " + std::to_string(count) + " floats from number " + std::to_string(first) +
                 " on, but has " + std::to_string(record_.floats.size()));
            return nullptr;
        }
        for (std::size_t i = 0; i < count; ++i)
            if (!std::isfinite(record_.floats[std::size_t(first) + i]))
                fail("has floats that are not finite");
        return record_.floats.data() + first;
    }

    void parseInstruction() {
        const std::size_t where = at_;
        const int code = next();
        switch (code) {
        case 1000:
            if (const float *value = floats(1))
                add({Kind::Constant, *value, 0, leaves_++, 0, 0});
            return;
        case 1001:
            if (const float *matrix = floats(16))
                addBlob({0, 0, 0}, {0, 0, 0}, 1, matrix);
            return;
        case 1002:
            if (const float *f = floats(23))
                addBlob({f[0], f[1], f[2]}, {f[3], f[4], f[5]}, f[6], f + 7);
            return;
        case 1003:
            next(), floats(4);
            leaveOut("repelling planes");
            return;
        case 1004:
            for (int operand = 0; operand < 5; ++operand)
                next();
            leaveOut("implicit field plugins");
            return;
        default: break;
        }
        if (code >= 9000) { // Of other renderers' modules: how many codes follow, and these.
            const int arguments = next();
            if (arguments < 0 || std::size_t(arguments) > record_.codes.size() - at_)
                return fail("ends within an instruction");
            at_ += std::size_t(arguments);
            return leaveOut("fields of other renderers' modules");
        }
        constexpr Kind kinds[] = {Kind::Add,      Kind::Multiply, Kind::Maximum, Kind::Minimum,
                                  Kind::Subtract, Kind::Divide,   Kind::Negate,  Kind::Add};
        if (code < 0 || code > 7)
            return fail("has the unknown code " + std::to_string(code) + " at place " +
                        std::to_string(where));
        const int operands = code < 4 ? next() : code < 6 ? 2 : 1;
        if (operands < 1 || std::size_t(operands) > record_.codes.size())
            return fail("combines " + std::to_string(operands) + " fields at place " +
                        std::to_string(where));
        addCombination(kinds[code], operands);
    }

    void addCombination(Kind kind, int operands) {
        Instruction instruction{
            kind, 0, 0, -1, std::uint32_t(field_.operands_.size()), std::uint32_t(operands)};
        for (int i = 0; i < operands; ++i) {
            const int operand = next();
            if (operand < 0 || std::size_t(operand) >= field_.instructions_.size())
                return fail("combines field " + std::to_string(operand) +
                            ", which is not there yet");
            field_.operands_.push_back(std::uint32_t(operand));
        }
        add(instruction);
    }

    void addBlob(Vec3 from, Vec3 to, float radius, const float *matrix) {
        Matrix4 objectFromBlob;
        std::copy_n(matrix, 16, objectFromBlob.m.begin());
        const auto inverted = inverse(objectFromBlob);
        if (!inverted || !(radius > 0)) {
            sink_.warning(where_, "a blob without size is left out");
            return add({Kind::Constant, 0, 0, leaves_++, 0, 0});
        }
        Blob blob{from, to, radius, *inverted, {}};
        for (int corner = 0; corner < 8; ++corner)
            for (Vec3 end : {from, to})
                blob.bound.add(
                    transformPoint(objectFromBlob, end + Vec3{corner & 1 ? radius : -radius,
                                                              corner & 2 ? radius : -radius,
                                                              corner & 4 ? radius : -radius}));
        field_.blobs_.push_back(blob);
        add({Kind::BlobLeaf, 0, std::uint32_t(field_.blobs_.size() - 1), leaves_++, 0, 0});
    }

    void leaveOut(const char *what) {
        sink_.warning(where_, std::string(what) + " of blobbies have no effect");
        add({Kind::Constant, 0, 0, leaves_++, 0, 0});
    }

    void add(const Instruction &instruction) { field_.instructions_.push_back(instruction); }

    const BlobbyRecord &record_;
    const SourceLocation &where_;
    DiagnosticSink &sink_;
    BlobField field_;
    std::size_t at_ = 0;
    int leaves_ = 0;
    std::string error_;
};

std::optional<BlobField> BlobField::make(const BlobbyRecord &record, const SourceLocation &where,
                                         DiagnosticSink &sink) {
    return Parser(record, where, sink).parse();
}

} // namespace candela
