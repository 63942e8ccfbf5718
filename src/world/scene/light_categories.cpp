// SPDX-License-Identifier: Apache-2.0
#include "world/scene/light_categories.h"

#include <algorithm>

namespace candela {

std::vector<std::string> categoryWords(const std::string &text) {
    constexpr const char *separators = ", \t|&";
    std::vector<std::string> words;
    for (std::size_t begin = 0;
         (begin = text.find_first_not_of(separators, begin)) < text.size();) {
        std::size_t end = std::min(text.find_first_of(separators, begin), text.size());
        words.push_back(text.substr(begin, end - begin));
        begin = end;
    }
    return words;
}

bool categoryAccepts(const std::string &expression, const LightTags &light) {
    auto has = [&](const std::string &word) {
        return std::find(light.categories.begin(), light.categories.end(), word) !=
               light.categories.end();
    };
    bool asksForOne = false, hasOne = false;
    for (const std::string &word : categoryWords(expression)) {
        if ((word == "!diffuse" && light.nonDiffuse) || (word == "!specular" && light.nonSpecular))
            return false;
        if (word[0] == '!')
            continue;
        if (word[0] == '-') {
            if (has(word.substr(1)))
                return false;
            continue;
        }
        asksForOne = true;
        hasOne |= has(word);
    }
    return !asksForOne || hasOne;
}

} // namespace candela
