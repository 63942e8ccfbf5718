// SPDX-License-Identifier: Apache-2.0
#include "render/reference.h"

#include "interface/ri/request_meanings.h"
#include "interface/ri/state_parameters.h"

#include <gtest/gtest.h>
#include <set>

namespace candela {
namespace {

TEST(Reference, HasEveryWordOfTheTables) {
    for (const std::string &word : referenceWords()) {
        const std::vector<std::string> entries = referenceOf(word);
        ASSERT_FALSE(entries.empty()) << word;
        for (const std::string &entry : entries)
            EXPECT_NE(entry.find(word), std::string::npos) << entry;
    }
    EXPECT_GT(referenceWords().size(), 300u);
}

TEST(Reference, ToldOfAKindTellsOfAllOfIt) {
    EXPECT_EQ(referenceOf("requests").size(), requestTable().size());
    EXPECT_EQ(referenceOf("options").size() + referenceOf("attributes").size(),
              stateParameters().size());
    EXPECT_GT(referenceOf("functions").size(), 100u);
    EXPECT_EQ(referenceOf("statements").size(), 4u);
    EXPECT_TRUE(referenceOf("no such word").empty());
}

/// A request without a sentence would be called one of other renderers.
TEST(Reference, HasASentenceForEveryRequestThatIsServed) {
    const std::pair<std::string_view, std::string_view> consequences[] = {
#define REQUEST_LATER(Name, handler, scopes, consequence, ...) {#Name, consequence},
#include "interface/ri/requests.def"
    };
    std::set<std::string_view> foreign;
    for (const auto &[name, consequence] : consequences)
        if (consequence.find("belongs to other renderers") != std::string_view::npos)
            foreign.insert(name);
    for (const RequestDescription &request : requestTable())
        EXPECT_EQ(meaningOf(RequestId(&request - requestTable().data())).empty(),
                  foreign.contains(request.name))
            << request.name;
}

} // namespace
} // namespace candela
