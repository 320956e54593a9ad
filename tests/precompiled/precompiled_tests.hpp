#pragma once

// common/precompiled/precompiled.hpp for tests.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "common/precompiled/precompiled.hpp"
