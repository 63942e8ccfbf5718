// SPDX-License-Identifier: Apache-2.0
#include "render/texture_orders.h"

#include "foundation/base/whole_file.h"
#include "interface/ri/search_path.h"
#include "world/texture/texture_making.h"

namespace candela {

/// Names become files; false, and `problem` says why, if one of them is not there.
static bool findPictures(TextureOrder &order, std::vector<std::string> folders,
                         std::string &problem) {
    for (std::string &picture : order.pictures) {
        auto found = findFile(picture, folders);
        if (!found)
            found = findNamesake(picture, folders);
        if (!found) {
            problem = "there is no picture \"" + picture + "\"";
            return false;
        }
        picture = *found;
    }
    return true;
}

void makeOrderedTexture(TextureOrder order, const Options &options,
                        const TextureOrderSettings &settings, DiagnosticSink &diagnostics) {
    std::vector<std::string> folders = searchFolders(options, "texture");
    folders.insert(folders.end(), settings.folders.begin(), settings.folders.end());
    const std::string name = order.texture;
    const SourceLocation &where = order.parameters.where;
    std::string moved, problem;
    const auto path = outputPath(name, settings.output, moved, problem);
    if (!moved.empty())
        diagnostics.warning(where, order.request + ": \"" + name + "\": " + moved);
    if (path)
        order.texture = *path;
    if (!path || !canWriteFile(*path, problem) || !findPictures(order, folders, problem) ||
        !makeTexture(order, problem))
        diagnostics.error(where, order.request + ": " + problem + "; \"" + name + "\" is not made");
}

} // namespace candela
