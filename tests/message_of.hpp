// What a call that has to be refused says.
#pragma once

#include <stdexcept>
#include <string>

namespace sh::test {

/// The message of the std::invalid_argument that `call` throws, or "nothing thrown". Any other exception goes through.
template <class Call>
std::string message_of(const Call& call) {
  try {
    call();
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "nothing thrown";
}

}  // namespace sh::test
