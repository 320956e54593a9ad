#pragma once

#include <string>
#include <vector>

#include "common/reflection/type_catalog.hpp"

namespace markservo::reflection {

// Our types and those that others' type files define: each path a file in LCM's type language, or a folder whose .lcm
// files are read, those in folders below too. The same definition may come twice. No paths: our types. Throws
// std::invalid_argument for what cannot be read, is no type file, contradicts another file, or nests a type that
// neither they nor we have; the text says where, what, and what is allowed.
TypeCatalog types_with(const std::vector<std::string>& paths);

}  // namespace markservo::reflection
