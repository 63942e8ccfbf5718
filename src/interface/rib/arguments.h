// SPDX-License-Identifier: Apache-2.0
// The arguments of requests, each read by its type.
#pragma once

#include "interface/ri/request_types.h"
#include "interface/rib/argument_cursor.h"

#include <string>

namespace candela {

// One argument each: true if it was there; otherwise reported.
bool read(ArgumentCursor &, float &);
bool read(ArgumentCursor &, int &);
bool read(ArgumentCursor &, bool &);
bool read(ArgumentCursor &, std::string &);
bool read(ArgumentCursor &, Handle &);
bool read(ArgumentCursor &, Color &);
bool read(ArgumentCursor &, Matrix4 &);
bool read(ArgumentCursor &, BasisArgument &);
bool read(ArgumentCursor &, Floats &);
bool read(ArgumentCursor &, Integers &);
bool read(ArgumentCursor &, Strings &);
bool read(ArgumentCursor &, LooseFloats &);
bool read(ArgumentCursor &, SubdivisionTags &);
/// Bad parameters are reported and left out; the request stands.
bool read(ArgumentCursor &, TokenList &);

/// The one behind that which was read last.
template <class Value> bool readNext(ArgumentCursor &cursor, Value &value) {
    cursor.setArgument(cursor.argument() + 1);
    return read(cursor, value);
}

} // namespace candela
