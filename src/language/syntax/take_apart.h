// SPDX-License-Identifier: Apache-2.0
// Trees may be as high as texts are long, so they do not end by recursion.
#pragma once

#include <memory>
#include <vector>

namespace candela::sl {

/// Ends the nodes below a node, one after the other; it holds them in these lists.
template <class Node, class... Lists>
void takeApart(Node &node, std::vector<std::unique_ptr<Node>> Node::*first, Lists... others) {
    std::vector<std::unique_ptr<Node>> waiting;
    const auto take = [&waiting](std::vector<std::unique_ptr<Node>> &list) {
        for (std::unique_ptr<Node> &child : list)
            if (child)
                waiting.push_back(std::move(child));
        list.clear();
    };
    const auto takeAll = [&](Node &from) {
        take(from.*first);
        (take(from.*others), ...);
    };
    takeAll(node);
    while (!waiting.empty()) {
        const std::unique_ptr<Node> next = std::move(waiting.back());
        waiting.pop_back();
        takeAll(*next);
    }
}

} // namespace candela::sl
