// SPDX-License-Identifier: Apache-2.0
#include "language/semantics/front.h"

#include "language/semantics/shader_checker.h"
#include "language/syntax/parser.h"
#include "language/syntax/preprocessor.h"

namespace candela::sl {

static void checkShaders(const ast::File &file, const SourceFile &mainFile, Reporter &reporter,
                         CompiledFront &front) {
    for (const ast::Item &item : file.items) {
        const auto *syntax = std::get_if<ast::Shader>(&item);
        if (!syntax)
            continue;
        for (const auto &other : front.shaders)
            if (other->name == syntax->name)
                reporter.error(syntax->where,
                               "a shader named " + syntax->name + " stands in this file already");
        front.shaders.push_back(checkShader(*syntax, file, mainFile, reporter));
        front.shaders.back()->sources = front.sources;
    }
}

std::optional<CompiledFront> analyzeSource(const SourceText &source, const FrontOptions &options,
                                           DiagnosticSink &sink) {
    Reporter reporter(sink);
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

} // namespace candela::sl
