// SPDX-License-Identifier: Apache-2.0
#include "language/semantics/front.h"

#include "foundation/base/deep_stack.h"
#include "language/semantics/shader_checker.h"
#include "language/syntax/parser.h"
#include "language/syntax/preprocessor.h"

namespace candela::sl {

/// What messages about unknown functions end with.
static std::string textOf(const std::vector<std::string> &headers) {
    if (headers.empty())
        return {};
    std::string list;
    for (const std::string &header : headers)
        list += (list.empty() ? "" : ", ") + header;
    return "; headers that were read: " + list;
}

static void checkShaders(const ast::File &file, const SourceFile &mainFile, Reporter &reporter,
                         CompiledFront &front) {
    const std::string headers = textOf(front.includedFiles);
    for (const ast::Item &item : file.items) {
        const auto *syntax = std::get_if<ast::Shader>(&item);
        if (!syntax)
            continue;
        for (const auto &other : front.shaders)
            if (other->name == syntax->name)
                reporter.error(syntax->where,
                               "a shader named " + syntax->name + " stands in this file already");
        front.shaders.push_back(checkShader(*syntax, file, mainFile, headers, reporter));
        front.shaders.back()->sources = front.sources;
    }
}

static std::optional<CompiledFront> analyze(const SourceText &source, const FrontOptions &options,
                                            DiagnosticSink &sink) {
    Reporter reporter(sink, options.hints);
    auto sources = std::make_shared<SourceSet>();
    sources->push_back(std::make_unique<SourceFile>(source.name, source.text));
    const SourceFile &mainFile = *sources->front();
    PreprocessorOptions preprocessing{options.includeDirectories, options.defines};
    PreprocessedFile words = preprocess(*sources, preprocessing, reporter);
    ast::File file = parse(words.tokens, reporter);

    CompiledFront front;
    front.includedFiles = std::move(words.includedFiles);
    front.sources = sources;
    checkShaders(file, mainFile, reporter, front);
    if (front.shaders.empty() && reporter.errorCount() == 0)
        reporter.error({&mainFile, 1, 1, 1}, "the file holds no shader");
    if (reporter.errorCount() > 0)
        return std::nullopt;
    return front;
}

std::optional<CompiledFront> analyzeSource(const SourceText &source, const FrontOptions &options,
                                           DiagnosticSink &sink) {
    std::optional<CompiledFront> front;
    onDeepStack([&] { front = analyze(source, options, sink); });
    return front;
}

} // namespace candela::sl
