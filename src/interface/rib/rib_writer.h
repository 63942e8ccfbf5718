// SPDX-License-Identifier: Apache-2.0
// Writes requests down as RIB: a sink that changes nothing. What it writes makes the same calls
// again, to the last bit of every float.
#pragma once

#include "interface/ri/stateless_sink.h"
#include "interface/rib/byte_output.h"

#include <memory>
#include <string>

namespace candela {

class RibEncoder;

enum class RibEncoding { Ascii, Binary };

class RibWriter final : public StatelessSink {
public:
    /// The output must outlive it.
    RibWriter(ByteOutput &, RibEncoding);
    ~RibWriter() override;

#define REQUEST(Name, handler, scopes, ...)                                                        \
    void handler(const SourceLocation &where CANDELA_PARAMETERS(__VA_ARGS__)) override;
#define REQUEST_OF_BLOCKS(Name, handler, scopes, ...)                                              \
    void handler(const SourceLocation &where CANDELA_PARAMETERS(__VA_ARGS__)) override;
#define REQUEST_OF_STREAM(Name, handler, scopes, ...)                                              \
    void handler(const SourceLocation &where CANDELA_PARAMETERS(__VA_ARGS__)) override;
#define REQUEST_LATER(Name, handler, scopes, consequence, ...)                                     \
    void handler(const SourceLocation &where CANDELA_PARAMETERS(__VA_ARGS__)) override;
#include "interface/ri/requests.def"

    void comment(const SourceLocation &, const std::string &text) override;
    bool wantsComments() const override { return true; }
    bool stopped() const override { return output_.failed(); }

    /// Hands all that has been written on to the output.
    void flush();

private:
    void begin(RequestId);
    void end(RequestId);

    ByteOutput &output_;
    std::unique_ptr<RibEncoder> encoder_;
    int depth_ = 0; ///< Blocks that are open.
};

} // namespace candela
