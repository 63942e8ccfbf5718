// SPDX-License-Identifier: Apache-2.0
#include "language/ir/transform/light_services.h"

#include "language/ir/core/builder_arithmetic.h"
#include "language/ir/core/builder_control.h"
#include "language/ir/core/builder_services.h"
#include "language/ir/core/builder_sources.h"
#include "language/ir/core/builder_vectors.h"
#include "language/ir/core/regions.h"

#include <numbers>
#include <utility>

namespace candela::ir {

namespace {

class Rewriting {
public:
    Rewriting(Builder &b, const std::vector<LightRequest> &requests) : b_(b), requests_(requests) {}

    void write(Region &&region) {
        for (Instruction &i : region.body) {
            b_.setLine(i.line);
            b_.setFile(i.file);
            if (i.op == Op::LightLoop) {
                writeLoop(std::move(i));
                continue;
            }
            for (Region &inner : i.regions)
                inner = written(std::move(inner));
            b_.append(std::move(i));
        }
    }

private:
    Region written(Region &&region) {
        const Values yields = region.yields, arguments = region.arguments;
        return b_.region(arguments, [&] {
            write(std::move(region));
            return yields;
        });
    }

    /// Whether the classic cone has the direction in it.
    ValueId isInCone(const LightRequest &request, const std::vector<ValueId> &operands,
                     const Triple &L) {
        if (request.form != ConeForm::Classic)
            return boolean(b_, true);
        const Triple axis{operands[3], operands[4], operands[5]};
        const ValueId angle = min(b_, operands[6], number(b_, std::numbers::pi_v<float>));
        return lessEqual(b_, unary(b_, Op::Cos, angle), dot(b_, axis, normalize(b_, L)));
    }

    void writeLoop(Instruction &&old) {
        const LightRequest &request = requests_[std::size_t(old.immediate)];
        const Values light = query(b_, info(Service::gatherlight), {},
                                   {old.operands[0], old.operands[1], old.operands[2]}, 2);
        const ValueId which = light[0], count = light[1];
        const int given = int(givenArguments(old));
        Region body = std::move(old.regions[0]);
        const Values carried(body.arguments.begin() + given, body.arguments.end());
        const ValueId goesOn = b_.newValue(Type::Bool, Uniformity::Varying);
        const ValueId turn = b_.newValue(Type::Float, Uniformity::Varying);
        Values arguments{goesOn, turn};
        arguments.insert(arguments.end(), carried.begin(), carried.end());

        Region loop = b_.region(arguments, [&] {
            const Values sample =
                query(b_, info(Service::lightsample), {},
                      {which, turn, number(b_, float(request.category))}, 1 + given);
            give(body, sample);
            const Triple L{sample[1], sample[2], sample[3]};
            const ValueId heard = both(b_, notEqual(b_, sample[0], number(b_, 0)),
                                       isInCone(request, old.operands, L));
            Values results = where(heard, std::move(body), carried);
            const ValueId next = add(b_, turn, number(b_, 1));
            results.insert(results.begin(), {less(b_, next, count), next});
            return results;
        });

        Instruction now{Op::Loop, {}, {}, {}, 0, 0, old.line, old.file};
        const ValueId zero = number(b_, 0);
        now.operands = {less(b_, zero, count), zero};
        now.operands.insert(now.operands.end(), old.operands.end() - std::ptrdiff_t(carried.size()),
                            old.operands.end());
        now.results = {b_.newValue(Type::Bool, Uniformity::Varying),
                       b_.newValue(Type::Float, Uniformity::Varying)};
        now.results.insert(now.results.end(), old.results.begin(), old.results.end());
        now.regions.push_back(std::move(loop));
        b_.append(std::move(now));
    }

    /// The body's L, Cl and number of the light become those of the sample.
    static void give(Region &body, const Values &sample) {
        std::vector<std::pair<ValueId, ValueId>> names;
        for (std::size_t k = 1; k < sample.size(); ++k)
            names.emplace_back(body.arguments[k - 1], sample[k]);
        const auto rename = [&](std::vector<ValueId> &values) {
            for (ValueId &v : values)
                for (const auto &[from, to] : names)
                    v = v == from ? to : v;
        };
        forEachInstruction(body, [&](Instruction &i) {
            rename(i.operands);
            for (Region &inner : i.regions)
                rename(inner.yields);
        });
        rename(body.yields);
    }

    /// What the body yields, or what was carried.
    Values where(ValueId heard, Region &&body, const Values &carried) {
        body.arguments.clear();
        Instruction choice{Op::If, {heard}, {}, {}, 0, 0, b_.line(), b_.file()};
        for (ValueId v : carried)
            choice.results.push_back(b_.newValue(b_.type(v), Uniformity::Varying));
        choice.regions.push_back(written(std::move(body)));
        choice.regions.push_back(b_.region({}, [&] { return carried; }));
        const Values results = choice.results;
        b_.append(std::move(choice));
        return results;
    }

    Builder &b_;
    const std::vector<LightRequest> &requests_;
};

} // namespace

void askServicesForLight(Function &function) {
    if (!anyInstruction(function.body, [](const Instruction &i) { return i.op == Op::LightLoop; }))
        return;
    const std::vector<LightRequest> requests = function.requests;
    Region text = std::move(function.body);
    function.body = {};
    Builder b(function);
    Rewriting(b, requests).write(std::move(text));
    b.finish();
}

} // namespace candela::ir
