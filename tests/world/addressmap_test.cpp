// The hash table behind registries and worlds, compared with std::map.
#include "../../src/addressmap.h"

#include <gtest/gtest.h>

#include <map>
#include <vector>

#include "random.h"

using cyclone::detail::AddressMap;

namespace {

TEST(AddressMap, KnowsWhatAMapKnows) {
    cyclone_test::Random random(1);
    std::vector<char> objects(3000);
    AddressMap map;
    std::map<const char *, std::uint64_t> model;
    for (std::uint64_t n = 0; n < 60000; ++n) {
        // Few addresses at first, so that they meet often; then many.
        const double range = n < 20000 ? 40 : 3000;
        const char *const object = &objects[static_cast<std::size_t>(random.between(0, range))];
        if (random.between(0, 1) < 0.5) {
            map.reserve(map.size() + 1);
            map.set(object, n);
            model[object] = n;
        } else {
            map.erase(object);
            model.erase(object);
        }
        ASSERT_EQ(map.size(), model.size());
        if (n % 500 != 0) continue;
        for (const char &each : objects) {
            const auto found = model.find(&each);
            ASSERT_EQ(map.find(&each), found == model.end() ? AddressMap::NONE : found->second);
        }
    }
}

TEST(AddressMap, TakesOverAnothersContentWhateverTheirSizes) {
    std::vector<char> objects(1000);
    AddressMap few, many;
    few.reserve(3);
    many.reserve(objects.size());
    for (std::size_t n = 0; n < 3; ++n) few.set(&objects[n], n);
    for (std::size_t n = 0; n < objects.size(); ++n) many.set(&objects[n], 2 * n);

    AddressMap roomy;
    roomy.reserve(many.capacity());
    roomy.set(&objects[500], 7);
    roomy.assign(few);
    EXPECT_EQ(roomy.size(), 3U);
    EXPECT_EQ(roomy.find(&objects[2]), 2U);
    EXPECT_EQ(roomy.find(&objects[500]), AddressMap::NONE);
    roomy.assign(many);
    for (std::size_t n = 0; n < objects.size(); ++n) ASSERT_EQ(roomy.find(&objects[n]), 2 * n);
    roomy.clear();
    EXPECT_EQ(roomy.size(), 0U);
    EXPECT_EQ(roomy.find(&objects[0]), AddressMap::NONE);
    AddressMap empty;
    empty.erase(&objects[0]);
    EXPECT_EQ(empty.find(&objects[0]), AddressMap::NONE);
}

}  // namespace
