// SPDX-License-Identifier: GPL-3.0-or-later
// A refusal has to name what and where: checks the class of an error and that its sentence holds the given parts.
#pragma once

#include <initializer_list>
#include <string>
#include <typeinfo>

#include <gtest/gtest.h>

namespace dirichlet {

template <class Error, class Call>
testing::AssertionResult refuses(Call call, std::initializer_list<const char*> parts) {
  try {
    call();
  } catch (const Error& error) {
    if (typeid(error) != typeid(Error)) return testing::AssertionFailure() << "a class below: " << error.what();
    for (const char* part : parts)
      if (std::string(error.what()).find(part) == std::string::npos)
        return testing::AssertionFailure() << '"' << error.what() << "\" does not say \"" << part << '"';
    return testing::AssertionSuccess();
  } catch (const std::exception& error) {
    return testing::AssertionFailure() << "another error: " << error.what();
  }
  return testing::AssertionFailure() << "accepted";
}

} // namespace dirichlet

#define EXPECT_REFUSED(statement, Error, ...)                                                                          \
  EXPECT_TRUE(::dirichlet::refuses<Error>([&] { (void)(statement); }, {__VA_ARGS__}))
