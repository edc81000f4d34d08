#pragma once
// Pages of two megabytes for large tables.
#include <cstddef>

namespace overstrike {

/// Asks the system to bring the room [begin, begin + size), before it is first written, in large
/// pages where it can: a picture that reads a table here and there waits for the addresses of small
/// ones. Nothing but time depends on it.
void prefer_large_pages(const void* begin, std::size_t size);

/// The room of a vector.
template <class Vector>
void prefer_large_pages(const Vector& vector) {
  prefer_large_pages(vector.data(), vector.capacity() * sizeof(typename Vector::value_type));
}

}  // namespace overstrike
