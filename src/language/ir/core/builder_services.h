// SPDX-License-Identifier: Apache-2.0
// Services (language/runtime/services.def). Equal queries are one where the first is visible: in
// its region and those within, that is where the lanes have asked already.
#pragma once

#include "language/ir/core/builder.h"

#include <string>

namespace candela::ir {

/// The results of a service without effects, `results` of them. The service's facts must outlive
/// the function.
Values query(Builder &, const ServiceInfo &, const std::vector<std::string> &texts,
             const Values &operands, int results);
/// The same with a first text that may be chosen at run time; `texts` are the rest.
Values queryNamed(Builder &, const ServiceInfo &, ValueId name,
                  const std::vector<std::string> &texts, Values operands, int results);
/// The same question to another service.
Values queryOther(Builder &, const ServiceInfo &, const ServiceUse &, const Values &operands,
                  int results);
/// Asks a service with effects.
void command(Builder &, const ServiceInfo &, const std::vector<std::string> &texts,
             const Values &operands);
void printValues(Builder &, const std::string &format, const Values &);

} // namespace candela::ir
