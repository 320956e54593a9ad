#include "common/precompiled/precompiled.hpp"
