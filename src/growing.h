#pragma once

/// @file
/// Room in vectors before it is needed.
#include <algorithm>
#include <cstddef>
#include <vector>

namespace cyclone {
namespace detail {

/// Makes room for `size` items, and for twice as many as before if that is not enough: std::vector::reserve
/// called for one more each time would copy all of them each time. If memory runs out, nothing has changed.
template <class Item>
void reserveGrowing(std::vector<Item> &items, std::size_t size) {
    if (size > items.capacity()) items.reserve(std::max(size, 2 * items.capacity()));
}

}  // namespace detail
}  // namespace cyclone
